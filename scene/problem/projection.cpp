// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: functions on an edge that is a facet.
#include "scene/problem/projection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "scene/problem/difference.h"
#include "scene/problem/stretch.h"
#include "scene/quadrature.h"
#include "scene/range.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

double finite_value(const Function<2>& given, const Vector<2>& x, const std::string& where) {
  const double value = given(x);
  if (!std::isfinite(value)) fail(Status::input, where, fmt::format("the value at {} is not finite", point(x)));
  if (std::abs(value) > largest_size)
    fail(Status::input, where,
         fmt::format("the value at {} is {:g}; expected at most {:g} in size", point(x), value, largest_size));
  return value;
}

struct Sample {
  double s;  // 0 at a, 1 at b
  double weight;
  double value;
};

/// At Gauss points, five in each panel: all inside of the edge.
std::vector<Sample> sample(const Function<2>& given, const Vector<2>& a, const Vector<2>& b, const std::string& where) {
  static const auto gauss = gauss_points<5>();
  std::vector<Sample> samples;
  for (const auto& [from, to] : panels_of(given, a, b))
    for (const auto& [x, weight] : gauss) {
      const double s = from + (0.5 + 0.5 * x) * (to - from);
      samples.push_back({s, 0.5 * weight * (to - from), finite_value(given, (1 - s) * a + s * b, where)});
    }
  return samples;
}

double largest_of(const std::vector<Sample>& samples) {
  double largest = 0;
  for (const Sample& at : samples) largest = std::max(largest, std::abs(at.value));
  return largest;
}

double distance(const std::vector<Sample>& samples, const std::array<double, 2>& ends) {
  double largest = 0;
  for (const Sample& at : samples) largest = std::max(largest, std::abs(at.value - between_ends(ends, at.s)));
  return largest;
}

EdgeCubic<double> projected(const std::vector<Sample>& samples, int degree) {
  double mean = 0, slope = 0, second = 0, third = 0;  // coefficients of the Legendre polynomials 1, 2s − 1, …
  for (const auto& [s, weight, value] : samples) {
    mean += weight * value;
    slope += 3 * weight * value * (2 * s - 1);
    if (degree > 1) second += 5 * weight * value * legendre_2(s);
    if (degree > 2) third += 7 * weight * value * legendre_3(s);
  }
  return {{mean - slope, mean + slope}, {second, third}};
}

/// The end values, just inside of the edge, of a function that is linear on it for sure.
std::optional<std::array<double, 2>> linear_ends(const Function<2>& given, const Vector<2>& a, const Vector<2>& b) {
  if (!given.is_enclosed()) return {};
  const Jet whole = along(given, a, b, 0, 1);
  if (whole.partial || !whole.c[2].is_zero() || !whole.c[3].is_zero() || !whole.value().is_bounded()) return {};
  const auto middle = [](const Interval& x) { return static_cast<double>(x.lower + (x.upper - x.lower) / 2); };
  return std::array{middle(beside(given, a, b, 0, 1).value()), middle(beside(given, a, b, 1, -1).value())};
}

/// Of a function that is linear to rounding its end values, of one that is constant inside that constant.
EdgeCubic<double> projected_or_ends(const Function<2>& given, const Vector<2>& a, const Vector<2>& b, int degree,
                                    const std::vector<Sample>& samples) {
  const std::array<double, 2> ends = {given(a), given(b)};  // may be infinite: then they are not used
  const double rounding = rounding_of_values(largest_of(samples), {ends, {0, 0}}, a, b);
  if (std::isfinite(rounding) && distance(samples, ends) <= rounding) return {ends, {0, 0}};
  const double first = samples.front().value;
  if (std::all_of(samples.begin(), samples.end(), [&](const Sample& at) { return at.value == first; }))
    return {{first, first}, {0, 0}};
  return projected(samples, degree);
}

/// Fills in how far the values are from the function, and how large that is.
EdgeLoad compared(const EdgeCubic<double>& value, const Function<2>& given, const Vector<2>& a, const Vector<2>& b,
                  const std::vector<Sample>& samples) {
  EdgeLoad result{value, 0, std::max({largest_of(samples), std::abs(value.linear[0]), std::abs(value.linear[1])})};
  const double reach = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()) / (b - a).norm();
  const double rounded = 4 * std::numeric_limits<double>::epsilon() * reach;
  for (const Difference& panel : difference(given, a, b, value)) {
    // Coordinates do not tell the points of a panel that is so narrow apart: a jump there is one at a vertex.
    if (panel.panel.to - panel.panel.from > rounded) result.error = std::max(result.error, panel.largest);
    if (std::isfinite(panel.value)) result.largest = std::max(result.largest, panel.value);
  }
  return result;
}

}  // namespace

EdgeLoad project(const Function<2>& given, const Vector<2>& a, const Vector<2>& b, int degree,
                 const std::string& where) {
  const std::vector<Sample> samples = sample(given, a, b, where);
  const auto ends = linear_ends(given, a, b);
  const EdgeCubic<double> value =
      ends ? EdgeCubic<double>{*ends, {0, 0}} : projected_or_ends(given, a, b, degree, samples);
  EdgeLoad result = compared(value, given, a, b, samples);
  if (!given.is_enclosed()) result.largest = largest_of(samples);
  return result;
}

FacetValues<2> interpolate_linear(const Function<2>& given, const Vector<2>& a, const Vector<2>& b,
                                  const std::string& where) {
  const std::array<double, 2> ends = {finite_value(given, a, where), finite_value(given, b, where)};
  const EdgeLoad values = compared({ends, {0, 0}}, given, a, b, sample(given, a, b, where));
  return {ends, values.error, values.largest};
}

FacetValues<3> interpolate_quadratic(const Function<2>& given, const Vector<2>& a, const Vector<2>& b,
                                     const std::string& where) {
  const std::array<double, 3> value = {finite_value(given, a, where), finite_value(given, b, where),
                                       finite_value(given, 0.5 * (a + b), where)};
  const EdgeLoad values =
      compared(cubic_of({value[0], value[2] + ((value[2] - value[0]) + (value[2] - value[1])) / 2, value[1]}), given, a,
               b, sample(given, a, b, where));
  return {value, values.error, values.largest};
}

}  // namespace bracket::scene
