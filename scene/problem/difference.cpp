// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: functions on an edge.
#include "scene/problem/difference.h"

#include <algorithm>
#include <cmath>

#include "scene/problem/stretch.h"
#include "scene/quadrature.h"

namespace bracket::scene {

namespace {

constexpr int uniform_panels = 8, halvings = 48;

std::vector<EdgePanel> uniform() {
  std::vector<EdgePanel> panels;
  for (int i = 0; i < uniform_panels; ++i)
    panels.push_back({static_cast<double>(i) / uniform_panels, (i + 1.0) / uniform_panels});
  return panels;
}

double double_above(Real x) { return upper(Interval(x)); }

/// The cubic over a stretch.
Jet fixed_over(const EdgeCubic<double>& fixed, double from, double to) {
  const auto& [second, third] = fixed.higher;
  Jet result = linear(fixed.linear[0], fixed.linear[1], from, to);
  if (second == 0 && third == 0) return result;
  const Jet s = linear(0, 1, from, to);
  return result + Jet(second) * legendre_2(s) + Jet(third) * legendre_3(s);
}

/// What is enclosed of a smooth function by its Taylor polynomial at the middle of a panel, the third derivative that
/// over the panel: values and slopes. Cubics that agree are seen to agree.
void narrow_by_expansion(const Jet& there, const Interval& reach, Jet& over) {
  const Interval second = there.c[2], third = over.c[3];
  over.c[0] = intersection(over.c[0], there.c[0] + (there.c[1] + (second + third * reach) * reach) * reach);
  over.c[1] = intersection(over.c[1], there.c[1] + (Interval(2.0L) * second + Interval(3.0L) * third * reach) * reach);
}

/// f − fixed over a panel, its values narrowed by those at the middle and the slope.
Jet enclosed_difference(const Function<2>& given, const Vector<2>& a, const Vector<2>& b,
                        const EdgeCubic<double>& fixed, const EdgePanel& on) {
  const double middle = on.from + (on.to - on.from) / 2;
  Jet left = along(given, a, b, on.from, on.to) - fixed_over(fixed, on.from, on.to);
  if (!left.c[1].is_bounded()) return left;
  const Jet there = beside(given, a, b, middle, 1) - fixed_over(fixed, middle, middle);
  const Interval reach = (Interval(on.to) - Interval(on.from)) * Interval(-0.5L, 0.5L);
  if (fixed.higher != std::array{0.0, 0.0} && left.c[3].is_bounded()) narrow_by_expansion(there, reach, left);
  left.c[0] = intersection(left.c[0], there.c[0] + left.c[1] * reach);
  return left;
}

std::vector<Difference> sampled_difference(const Function<2>& given, const Vector<2>& a, const Vector<2>& b,
                                           const EdgeCubic<double>& fixed) {
  std::vector<Difference> all;
  for (const EdgePanel& panel : uniform()) {
    Difference of{panel, 0, 0, 0};
    double before = 0, at_before = panel.from;
    for (const auto& [x, weight] : gauss_points<5>()) {
      const double s = panel.from + (1 + x) / 2 * (panel.to - panel.from);
      const double value = given((1 - s) * a + s * b), left = value - value_at(fixed, s);
      of.largest = std::max(of.largest, std::abs(left));
      of.value = std::max(of.value, std::abs(value));
      if (at_before > panel.from) of.slope = std::max(of.slope, std::abs(left - before) / (s - at_before));
      before = left;
      at_before = s;
    }
    all.push_back(of);
  }
  return all;
}

}  // namespace

std::vector<EdgePanel> panels_of(const Function<2>& given, const Vector<2>& a, const Vector<2>& b) {
  struct Rough {
    EdgePanel panel;
    Real left;  ///< what halving may gain; 0: the function is smooth there
  };
  std::vector<Rough> all;
  const auto rough = [&](const EdgePanel& panel) {
    if (!given.is_enclosed()) return Rough{panel, 0};
    const Jet over = along(given, a, b, panel.from, panel.to);
    return Rough{panel, over.c[3].is_bounded() ? 0 : (over.c[0].upper - over.c[0].lower) * (panel.to - panel.from)};
  };
  if (given.is_enclosed()) {
    const Jet whole = along(given, a, b, 0, 1);
    if (whole.c[2].is_zero() && whole.c[3].is_zero()) return {{0, 1}};
  }
  for (const EdgePanel& panel : uniform()) all.push_back(rough(panel));
  for (int i = 0; i < halvings; ++i) {
    const auto most =
        std::max_element(all.begin(), all.end(), [](const Rough& x, const Rough& y) { return x.left < y.left; });
    const auto [from, to] = most->panel;
    const double middle = from + (to - from) / 2;
    if (!(most->left > 0) || middle == from || middle == to) break;
    *most = rough({from, middle});
    all.insert(most + 1, rough({middle, to}));
  }
  std::vector<EdgePanel> panels;
  for (const Rough& one : all) panels.push_back(one.panel);
  return panels;
}

std::vector<Difference> difference(const Function<2>& given, const Vector<2>& a, const Vector<2>& b,
                                   const EdgeCubic<double>& fixed) {
  if (!given.is_enclosed()) return sampled_difference(given, a, b, fixed);
  std::vector<Difference> all;
  for (const EdgePanel& panel : panels_of(given, a, b)) {
    const Jet left = enclosed_difference(given, a, b, fixed, panel);
    const Interval value = along(given, a, b, panel.from, panel.to).value();
    if (left.value().is_empty() || value.is_empty()) continue;  // of no value; where one is needed that is refused
    all.push_back({panel, double_above(left.value().magnitude()), double_above(left.c[1].magnitude()),
                   double_above(value.magnitude())});
  }
  return all;
}

double rounding_of_values(double largest, const EdgeCubic<double>& fixed, const Vector<2>& a, const Vector<2>& b) {
  const double reach = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()) / (b - a).norm();
  const auto& [ends, higher] = fixed;
  // Legendre's polynomials are steepest at the ends: P_k' = k (k + 1).
  const double slope = std::abs(ends[1] - ends[0]) + 6 * std::abs(higher[0]) + 12 * std::abs(higher[1]);
  return 16 * std::numeric_limits<double>::epsilon() * (largest + slope * (1 + reach));
}

}  // namespace bracket::scene
