// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/admissible_stress.h"

#include <algorithm>

#include "scene/voigt.h"

namespace bracket::bounds {

using scene::Support;
using scene::Vector;

namespace {

/// A pressure below this part of the largest traction on either body is rounding of their stresses. It has to go: on a
/// body that nothing holds it would be a load, which the data do not have.
constexpr double noise = 1e-11;

void drop_noise(const scene::Problem<2>& problem, PlainLoads& loads) {
  const auto& mesh = problem.mesh;
  std::vector<double> largest(mesh.components.size(), 0);  // traction in each body
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const int edge : mesh.cell_edges[c]) {
      const double length = (mesh.vertices[mesh.edges[edge][1]] - mesh.vertices[mesh.edges[edge][0]]).norm();
      for (const Vector<2>& load : loads.edge[edge])
        largest[mesh.cell_component[c]] = std::max(largest[mesh.cell_component[c]], load.norm() / length);
    }
  for (const auto& pair : problem.contact) {
    double traction = largest[mesh.cell_component[mesh.boundary[pair.first].cell]];
    if (pair.second >= 0) traction = std::max(traction, largest[mesh.cell_component[mesh.boundary[pair.second].cell]]);
    for (double& p : loads.along_normal[pair.first])
      if (p <= noise * traction * scene::length(mesh, pair.first)) p = 0;
  }
}

}  // namespace

PlainLoads plain_loads(const scene::Problem<2>& problem, const scene::Stress<2>& stress) {
  const auto& mesh = problem.mesh;
  PlainLoads loads;
  loads.edge.assign(mesh.edges.size(), {Vector<2>::Zero(), Vector<2>::Zero()});
  std::vector<char> sides(mesh.edges.size(), 0);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int k = 0; k < 3; ++k) {
      const int edge = mesh.cell_edges[c][k];
      const auto ends = scene::facet_vertices(mesh, static_cast<int>(c), k);
      const Vector<2> normal = scene::area_vector<2>(scene::positions(mesh, ends));
      const auto corners = scene::stress_of_part(stress, static_cast<int>(c), k);
      const Vector<2> begin = scene::traction<2>(corners[0], normal), end = scene::traction<2>(corners[1], normal);
      const bool along = mesh.edges[edge][0] == ends[0];
      loads.edge[edge][0] += along ? begin : Vector<2>(-end);
      loads.edge[edge][1] += along ? end : Vector<2>(-begin);
      ++sides[edge];
    }
  for (std::size_t e = 0; e < sides.size(); ++e)
    for (Vector<2>& load : loads.edge[e]) load /= sides[e];

  loads.along_normal.assign(problem.facets.size(), {0, 0});
  const auto on_facet = [&](int facet) {
    const auto& edge = loads.edge[mesh.boundary[facet].edge];
    const Vector<2>& n = problem.facets[facet].normal;
    return forward(mesh.boundary[facet]) ? std::array{edge[0].dot(n), edge[1].dot(n)}
                                         : std::array{-edge[1].dot(n), -edge[0].dot(n)};
  };
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (problem.facets[f].support == Support::sliding) loads.along_normal[f] = on_facet(static_cast<int>(f));
  for (const auto& pair : problem.contact) {
    auto& pressure = loads.along_normal[pair.first];
    pressure = on_facet(pair.first);
    if (pair.second >= 0) {
      const auto across = on_facet(pair.second);
      for (int i = 0; i < 2; ++i) pressure[i] = (pressure[i] + across[1 - i]) / 2;
    }
    const auto opening = opening_load<double>(problem, pair);
    for (int i = 0; i < 2; ++i) pressure[i] = std::max(0.0, problem.perturbed.loads * opening[i] - pressure[i]);
  }
  drop_noise(problem, loads);
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (problem.facets[f].support != Support::fixed)
      loads.edge[mesh.boundary[f].edge] = {Vector<2>::Zero(), Vector<2>::Zero()};
  return loads;
}

PlainLoads no_loads(const scene::Problem<2>& problem) {
  PlainLoads none;
  none.edge.assign(problem.mesh.edges.size(), {Vector<2>::Zero(), Vector<2>::Zero()});
  none.along_normal.assign(problem.facets.size(), {0, 0});
  return none;
}

std::vector<char> carrying_pairs(const scene::Problem<2>& problem, const PlainLoads& loads) {
  std::vector<char> carrying;
  for (const auto& pair : problem.contact) {
    carrying.resize(std::max<std::size_t>(carrying.size(), pair.pair + 1), 0);
    for (const double p : loads.along_normal[pair.first]) carrying[pair.pair] |= p > 0;
  }
  return carrying;
}

}  // namespace bracket::bounds
