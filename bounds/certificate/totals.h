// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/admissible_stress.h"

/// What acts on the bodies as wholes.
namespace bracket::bounds {

/// The point about which moments of a body are counted, and the size of the body.
struct Reference {
  scene::Vector<2> point;
  double size;
};
/// Of each body.
std::vector<Reference> references(const scene::Mesh<2>& mesh);

/// Wrench of a facet's load on its body.
template <class Number>
Wrench<Number> facet_resultant(const scene::Problem<2>& problem, const std::vector<Reference>& references, int facet,
                               const SideLoad<Number>& load) {
  const auto& reference = references[problem.mesh.cell_component[problem.mesh.boundary[facet].cell]];
  return resultant(load, arm<Number>(problem, reference.point, facet), along<Number>(problem, facet));
}

/// A body's entries of Gᵀp = e: force, and moment by the size of the body.
template <class Number> std::array<Number, 3> entries(const Reference& reference, const Wrench<Number>& resultant) {
  return {resultant.force.x, resultant.force.y, resultant.moment / Number(reference.size)};
}

/// All that acts on the bodies from outside, as entries: the sum of what their cells lack.
template <class Number, class Sum>
std::vector<Number> totals(const scene::Problem<2>& problem, const std::vector<Reference>& references,
                           const EdgeLoads<Number>& loads) {
  const auto& mesh = problem.mesh;
  std::vector<Sum> sums(3 * mesh.components.size());
  const auto add = [&](int body, const Wrench<Number>& resultant) {
    const auto part = entries(references[body], resultant);
    for (int i = 0; i < 3; ++i) sums[3 * body + i].add(part[i]);
  };
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    const auto& facet = mesh.boundary[f];
    add(mesh.cell_component[facet.cell],
        facet_resultant(problem, references, static_cast<int>(f), oriented(loads.edge[facet.edge], forward(facet))));
  }
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int cell = static_cast<int>(c), component = mesh.cell_component[c];
    const int body = mesh.cell_body[c];
    if (!has_force(problem, body)) continue;
    const auto x = corners<Number>(problem, cell);
    const Vector2<Number> to_centroid =
        arm_of_cell<Number>(problem, references[component].point, cell) + (Number(1) / Number(3)) * (x[1] + x[2]);
    const Vector2<Number> weight = (doubled_area(x) / Number(2)) * body_force<Number>(problem, body);
    add(component, {weight, cross(to_centroid, weight)});
  }
  std::vector<Number> result;
  for (const Sum& sum : sums) result.push_back(sum.value());
  return result;
}

}  // namespace bracket::bounds
