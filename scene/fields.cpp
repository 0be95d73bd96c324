// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/fields.h"

namespace bracket::scene {

namespace {

std::vector<ControlPoint> make_control_points(int degree) {
  std::vector<ControlPoint> points;
  int inside = 0;
  for (const auto& i : bernstein_indices(degree)) {
    int zero = -1, whole = -1;
    for (int corner = 0; corner < 3; ++corner) {
      if (i[corner] == 0) zero = corner;
      if (i[corner] == degree) whole = corner;
    }
    if (whole >= 0)
      points.push_back({ControlPoint::On::vertex, whole, 0});
    else if (zero >= 0)
      points.push_back({ControlPoint::On::edge, zero, i[Simplex<2>::edges[zero][1]]});
    else
      points.push_back({ControlPoint::On::cell, 0, inside++});
  }
  return points;
}

}  // namespace

const std::vector<ControlPoint>& control_points(int degree) {
  static const std::array<std::vector<ControlPoint>, largest_degree + 1> points = {
      std::vector<ControlPoint>{}, make_control_points(1), make_control_points(2), make_control_points(3),
      make_control_points(4)};
  return points.at(degree);
}

}  // namespace bracket::scene
