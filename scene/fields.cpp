// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/fields.h"

namespace bracket::scene {

namespace {

template <int dim> std::vector<ControlPoint> make_control_points(int degree) {
  std::vector<ControlPoint> points;
  int inside = 0;
  for (const auto& i : bernstein_indices<dim>(degree)) {
    std::vector<int> corners;  // that it counts
    for (int corner = 0; corner <= dim; ++corner)
      if (i[corner] > 0) corners.push_back(corner);
    if (corners.size() == 1) {
      points.push_back({ControlPoint::On::vertex, corners[0], 0});
    } else if (corners.size() == 2) {
      const int edge = Simplex<dim>::edge_between(corners[0], corners[1]);
      points.push_back({ControlPoint::On::edge, edge, i[Simplex<dim>::edges[edge][1]]});
    } else {
      points.push_back({ControlPoint::On::cell, 0, inside++});
    }
  }
  return points;
}

}  // namespace

template <int dim> const std::vector<ControlPoint>& control_points(int degree) {
  static const auto of_degrees = [] {
    std::array<std::vector<ControlPoint>, largest_degree_in<dim>() + 1> points;
    for (int n = 1; n < static_cast<int>(points.size()); ++n) points[n] = make_control_points<dim>(n);
    return points;
  }();
  return of_degrees.at(degree);
}

template const std::vector<ControlPoint>& control_points<2>(int);
template const std::vector<ControlPoint>& control_points<3>(int);

}  // namespace bracket::scene
