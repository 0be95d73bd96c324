// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: triangles and their angles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scene/types.h"

namespace bracket::scene {

inline double cross(const Vector<2>& a, const Vector<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

inline double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// The angles of a counter-clockwise triangle at its corners, in degrees; negative where it runs clockwise.
inline std::array<double, 3> angles(const std::array<Vector<2>, 3>& corners) {
  std::array<double, 3> result;
  for (int k = 0; k < 3; ++k) {
    const Vector<2> a = corners[(k + 1) % 3] - corners[k], b = corners[(k + 2) % 3] - corners[k];
    result[k] = std::atan2(cross(a, b), a.dot(b)) * 180 / std::numbers::pi;
  }
  return result;
}

inline double smallest_angle(const std::array<Vector<2>, 3>& corners) {
  const auto [a, b, c] = angles(corners);
  return std::min({a, b, c});
}

}  // namespace bracket::scene
