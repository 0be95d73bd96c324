// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: tetrahedra and their angles.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "scene/mesh/simplex.h"

namespace bracket::scene {

/// Whether an edge of a tetrahedron ends at a vertex of it.
constexpr bool has_end(int edge, int vertex) {
  return Simplex<3>::edges[edge][0] == vertex || Simplex<3>::edges[edge][1] == vertex;
}

/// The angles of a tetrahedron between the facets at each of its edges, in degrees, as Simplex<3>::edges has them.
inline std::array<double, 6> dihedral_angles(const std::array<Vector<3>, 4>& corners) {
  std::array<Vector<3>, 4> normal;
  for (int k = 0; k < 4; ++k) {
    const auto& [a, b, c] = Simplex<3>::facets[k];
    normal[k] = area_vector<3>({corners[a], corners[b], corners[c]});
  }
  std::array<double, 6> result;
  for (int e = 0; e < 6; ++e) {
    const auto& [i, j] = Simplex<3>::edges[e];
    std::array<int, 2> beside;  // the facets at the edge lie opposite to the other two vertices
    for (int k = 0, n = 0; k < 4; ++k)
      if (k != i && k != j) beside[n++] = k;
    const Vector<3>&one = normal[beside[0]], &other = normal[beside[1]];
    result[e] = 180 - std::atan2(one.cross(other).norm(), one.dot(other)) * 180 / std::numbers::pi;
  }
  return result;
}

/// 12 (3 |K|)^(2/3) / Σ |e|² over the edges: 1 of a regular tetrahedron, 0 of a flat one.
inline double shape(const std::array<Vector<3>, 4>& corners) {
  double sum = 0;
  for (const auto& [i, j] : Simplex<3>::edges) sum += (corners[j] - corners[i]).squaredNorm();
  const double root = std::cbrt(3 * volume<3>(corners));
  return 12 * root * root / sum;
}

}  // namespace bracket::scene
