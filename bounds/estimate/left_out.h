// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "scene/on_facet.h"
#include "scene/problem/problem.h"
#include "scene/problem/space/face.h"
#include "scene/problem/stretch.h"

/// What is left out of a function that was fixed on a facet, part by part.
namespace bracket::bounds {

/// A place on a facet: in the plane 0 at vertex 0 and 1 at vertex 1.
template <int dim> using Place = std::conditional_t<dim == 2, double, scene::OnFace>;
/// What a function was fixed to on a facet.
template <int dim> using Fixed = std::conditional_t<dim == 2, scene::EdgeCubic<double>, scene::FacetQuadratic<3>>;
template <int dim> using Corners = std::array<scene::Vector<dim>, std::size_t{dim}>;

/// The value of a polynomial with these Bernstein coefficients, in the order of scene/on_facet.h.
template <class Value> Value value_on_facet(const std::vector<Value>& c, double at) {
  return scene::value_on_segment(c, at);
}
template <class Value> Value value_on_facet(const std::vector<Value>& c, const scene::OnFace& at) {
  const std::array<double, 3> weight = {1 - at[0] - at[1], at[0], at[1]};
  const bool linear = c.size() == 3;
  Value sum = (linear ? 1 : weight[0]) * weight[0] * c[0];
  for (int i = 1; i < 3; ++i) sum += (linear ? 1 : weight[i]) * weight[i] * c[i];
  for (int e = 0; e < 3 && !linear; ++e) {
    const auto& [i, k] = scene::Simplex<2>::edges[e];
    sum += 2 * weight[i] * weight[k] * c[3 + e];
  }
  return sum;
}

/// A part of a facet, and what is left out there of a function that was fixed.
template <int dim> struct Panel {
  double share;                  ///< by the facet
  double largest, slope, value;  ///< as scene::Difference, the slope per length
  std::array<Place<dim>, 3> at;  ///< of a rule of integration …
  std::array<double, 3> weight;  ///< … for means over the panel: Simpson's; of the midpoints of the sides
};
template <int dim> using Panels = std::vector<Panel<dim>>;

/// \param x the vertices of the facet
Panels<2> left_out(const scene::Function<2>& given, const Corners<2>& x, const Fixed<2>& fixed);
Panels<3> left_out(const scene::Function<3>& given, const Corners<3>& x, const Fixed<3>& fixed);
/// Whether that is nothing but rounding of values and places.
template <int dim> bool is_rounding(const Panels<dim>& panels, const Fixed<dim>& fixed, const Corners<dim>& x);

/// The mean of largest · weight over the facet.
template <int dim, class Weight> double against(const Panels<dim>& panels, const Weight& weight) {
  double sum = 0;
  for (const auto& panel : panels) {
    if (panel.largest == 0) continue;
    double mean = 0;
    for (int i = 0; i < 3; ++i) mean += panel.weight[i] * weight(panel.at[i]);
    if (mean > 0) sum += panel.share * panel.largest * mean;
  }
  return sum;
}

/// The mean of a square.
template <int dim> double squares(const Panels<dim>& panels, double Panel<dim>::*what) {
  double sum = 0;
  for (const auto& panel : panels)
    if (panel.largest > 0) sum += panel.share * (panel.*what) * (panel.*what);
  return sum;
}

}  // namespace bracket::bounds
