// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dual/dual.h"

namespace bracket::tests {

inline scene::Stress<2> no_stress(const scene::Problem<2>& problem) {
  return {1, {problem.mesh.cells.size(), std::vector<scene::Voigt<2>>(9, scene::Voigt<2>::Zero())}};
}

/// ‖a − b‖ in the norm of the complementary energy, √∫ (a − b) : C⁻¹ (a − b): exact at midpoints of edges.
inline double stress_distance(const scene::Problem<2>& problem, const scene::Stress<2>& a, const scene::Stress<2>& b) {
  double sum = 0;
  for (std::size_t c = 0; c < a.cell.size(); ++c) {
    const auto& compliance = problem.bodies[problem.mesh.cell_body[c]].material.compliance();
    const double ninth = scene::volume(problem.mesh, static_cast<int>(c)) / 9;
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i) {
        const int j = 3 * k + i, next = 3 * k + (i + 1) % 3;
        const scene::Voigt<2> middle = (a.cell[c][j] - b.cell[c][j] + a.cell[c][next] - b.cell[c][next]) / 2;
        sum += ninth * middle.dot(compliance * middle);
      }
  }
  return std::sqrt(sum);
}

}  // namespace bracket::tests
