// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/space/cell_values.h"

#include "scene/offsets.h"

namespace bracket::apps {

using scene::Simplex;
using scene::Vector;

InCell in_cell(int part, const InCell& in_part) {
  InCell point;
  point.fill(in_part[3] / 4);
  for (int i = 0; i < 3; ++i) point[Simplex<3>::facets[part][i]] += in_part[i];
  return point;
}

Vector<3> way_drawn(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
                    const DrawnShapeOf<3>& shape, int cell, const InCell& point, int facet) {
  Vector<3> way = shape.factor * scene::displacement_at(problem.mesh, displacement, cell, point);
  for (int i = 0; i < 4; ++i) way += point[i] * shape.shift[problem.mesh.cells[cell][i]];
  if (facet < 0) return way;
  const auto& corners = Simplex<3>::facets[problem.mesh.boundary[facet].local];
  const auto& coefficients = shape.beside[facet];
  double beside = 0;
  for (int i = 0; i < 3; ++i) beside += coefficients[i] * point[corners[i]] * point[corners[i]];
  for (int e = 0; e < 3; ++e) {
    const auto& [a, b] = Simplex<2>::edges[e];
    beside += 2 * coefficients[3 + e] * point[corners[a]] * point[corners[b]];
  }
  return way + beside * problem.facets[facet].normal;
}

scene::Voigt<3> mean_stress(const std::vector<scene::Voigt<3>>& displacement_stress, const scene::Stress<3>& stress,
                            int cell, int part, const InCell& in_part) {
  return (value_in(in_cell(part, in_part), displacement_stress) +
          value_in(in_part, scene::stress_of_part(stress, cell, part))) /
         2;
}

}  // namespace bracket::apps
