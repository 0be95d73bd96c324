// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bounds/certificate/given_fields.h"

#include "tests/bounds/certificate/noise.h"

namespace bracket::tests {

using scene::Displacement;
using scene::Problem;
using scene::Vector;

namespace {

/// Moves each body by a motion of its own, a thousand times its displacements: strains drown in it.
Displacement<2> carried_away(const scene::Mesh<2>& mesh, Displacement<2> u) {
  std::vector<int> body(mesh.vertices.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const int v : mesh.cells[c]) body[v] = mesh.cell_body[c];
  const auto motion = [&](int of, const Vector<2>& x) -> Vector<2> {
    const double turn = of == 0 ? 1000 : -300;
    return {300 - turn * x[1], turn * x[0] - 1000};
  };
  for (std::size_t v = 0; v < u.vertex.size(); ++v) u.vertex[v] += motion(body[v], mesh.vertices[v]);
  for (std::size_t e = 0; e < u.edge.size(); ++e) {
    const auto& [a, b] = mesh.edges[e];
    u.edge[e] += motion(body[a], 0.5 * (mesh.vertices[a] + mesh.vertices[b]));
  }
  return u;
}

/// The first sides of contacts pushed in, as penalties do.
Displacement<2> sunk(const Problem<2>& problem, Displacement<2> u) {
  for (const auto& pair : problem.contact)
    for (const int v : problem.mesh.boundary[pair.first].vertices)
      u.vertex[v] += 0.25 * problem.facets[pair.first].normal;
  return u;
}

}  // namespace

std::vector<GivenField> given_fields(const Problem<2>& first, int degree, std::mt19937& generator) {
  const Displacement<2> own = primal::solve(first, degree).displacement;
  const Displacement<2> rough = noisy(own, 1, 0.5, generator);
  return {
      {"own", own}, {"rough", rough}, {"sunk", sunk(first, own)}, {"carried away", carried_away(first.mesh, rough)}};
}

Fields solved(const Problem<2>& problem, int degree) {
  return {primal::solve(problem, degree).displacement, dual::solve(problem, scene::stress_degree(degree)).stress};
}

}  // namespace bracket::tests
