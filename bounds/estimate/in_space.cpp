// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/estimate/on_mesh.h"

/// In space, what the sides of a contact do to each other.
namespace bracket::bounds {

template <>
std::vector<double> jump(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
                         const scene::ContactFacetOf<3>& pair, const scene::Vector<3>& direction) {
  const auto& mesh = problem.mesh;
  // The difference of the vertices first: a motion of both sides is none of it.
  std::array<scene::Vector<3>, 3> at_vertices;
  for (int i = 0; i < 3; ++i) {
    at_vertices[i] = displacement.vertex[mesh.boundary[pair.first].vertices[i]];
    if (pair.second >= 0) at_vertices[i] -= displacement.vertex[mesh.boundary[pair.second].vertices[pair.meets[i]]];
  }
  std::vector<double> result = along<3>(coefficients(at_vertices, 2), direction);
  if (displacement.degree == 1) return result;
  const auto offset = scene::offsets_on_facet(mesh, displacement, pair.first);
  const auto other = pair.second < 0 ? offset : scene::offsets_on_facet(mesh, displacement, pair.second);
  for (int e = 0; e < 3; ++e) {
    const auto& [a, b] = scene::Simplex<2>::edges[e];
    result[3 + e] += offset[3 + e].dot(direction);
    if (pair.second >= 0)
      result[3 + e] -= other[3 + scene::Simplex<2>::edge_between(pair.meets[a], pair.meets[b])].dot(direction);
  }
  return result;
}

}  // namespace bracket::bounds
