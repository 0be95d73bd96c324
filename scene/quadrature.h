// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <boost/math/quadrature/gauss.hpp>

namespace bracket::scene {

struct GaussPoint {
  double x;  ///< in (−1, 1)
  double weight;
};

/// The n points of Gauss and Legendre, from left to right. \pre n is odd
template <int n> std::array<GaussPoint, n> gauss_points() {
  static_assert(n % 2 == 1);
  using Rule = boost::math::quadrature::gauss<long double, n>;  // not tabled but computed: rounded afterwards
  std::array<GaussPoint, n> points;
  for (int k = 0; k <= n / 2; ++k) {  // the rule has the right half
    const auto x = static_cast<double>(Rule::abscissa()[k]), weight = static_cast<double>(Rule::weights()[k]);
    points[n / 2 - k] = {-x, weight};
    points[n / 2 + k] = {x, weight};
  }
  return points;
}

}  // namespace bracket::scene
