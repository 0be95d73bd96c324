// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/estimate/left_out.h"

#include <algorithm>

#include "scene/problem/difference.h"
#include "scene/problem/space/face_difference.h"

namespace bracket::bounds {

namespace {

double rounding_of(double largest, const Fixed<2>& fixed, const Corners<2>& x) {
  return scene::rounding_of_values(largest, fixed, x[0], x[1]);
}
double rounding_of(double largest, const Fixed<3>& fixed, const Corners<3>& x) {
  return scene::rounding_of_values(largest, fixed, x);
}

}  // namespace

Panels<2> left_out(const scene::Function<2>& given, const Corners<2>& x, const Fixed<2>& fixed) {
  Panels<2> panels;
  const double length = (x[1] - x[0]).norm();
  for (const auto& [on, largest, slope, value] : scene::difference(given, x[0], x[1], fixed))
    panels.push_back({on.to - on.from,
                      largest,
                      slope / length,
                      value,
                      {on.from, (on.from + on.to) / 2, on.to},
                      {1.0 / 6, 4.0 / 6, 1.0 / 6}});
  return panels;
}
Panels<3> left_out(const scene::Function<3>& given, const Corners<3>& x, const Fixed<3>& fixed) {
  Panels<3> panels;
  for (const auto& [part, largest, slope, value] : scene::difference(given, x, fixed)) {
    Panel<3> panel{scene::share_of_face(part), largest, slope, value, {}, {1.0 / 3, 1.0 / 3, 1.0 / 3}};
    for (int e = 0; e < 3; ++e) {
      const auto& [i, k] = scene::Simplex<2>::edges[e];
      panel.at[e] = {(part[i][0] + part[k][0]) / 2, (part[i][1] + part[k][1]) / 2};
    }
    panels.push_back(panel);
  }
  return panels;
}

template <int dim> bool is_rounding(const Panels<dim>& panels, const Fixed<dim>& fixed, const Corners<dim>& x) {
  double left = 0, largest = 0;
  for (const auto& panel : panels) {
    left = std::max(left, panel.largest);
    largest = std::max(largest, panel.value);
  }
  return left <= rounding_of(largest, fixed, x);
}

template bool is_rounding(const Panels<2>&, const Fixed<2>&, const Corners<2>&);
template bool is_rounding(const Panels<3>&, const Fixed<3>&, const Corners<3>&);

}  // namespace bracket::bounds
