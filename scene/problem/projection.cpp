// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: functions on an edge that is a facet.
#include "scene/problem/projection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/problem/stretch.h"
#include "scene/quadrature.h"
#include "scene/range.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

constexpr int panels = 8;
constexpr int samples = 5 * panels;

struct Sample {
  double s;  // 0 at a, 1 at b
  double weight;
};

/// Gauss points, five in each of eight panels: all inside of the edge.
const std::array<Sample, samples>& quadrature() {
  static const std::array<Sample, samples> points = [] {
    const auto gauss = gauss_points<5>();
    std::array<Sample, samples> result{};
    for (int i = 0; i < samples; ++i)
      result[i] = {(i / 5 + 0.5 + 0.5 * gauss[i % 5].x) / panels, 0.5 * gauss[i % 5].weight / panels};
    return result;
  }();
  return points;
}

double finite_value(const Function<2>& given, const Vector<2>& x, const std::string& where) {
  const double value = given(x);
  if (!std::isfinite(value)) fail(Status::input, where, fmt::format("the value at {} is not finite", point(x)));
  if (std::abs(value) > largest_size)
    fail(Status::input, where,
         fmt::format("the value at {} is {:g}; expected at most {:g} in size", point(x), value, largest_size));
  return value;
}

std::array<double, samples> sample(const Function<2>& given, const Vector<2>& a, const Vector<2>& b,
                                   const std::string& where) {
  std::array<double, samples> values;
  std::transform(quadrature().begin(), quadrature().end(), values.begin(),
                 [&](const Sample& at) { return finite_value(given, (1 - at.s) * a + at.s * b, where); });
  return values;
}

double largest_of(const std::array<double, samples>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

double distance(const std::array<double, samples>& values, const std::array<double, 2>& ends) {
  double largest = 0;
  for (int i = 0; i < samples; ++i)
    largest = std::max(largest, std::abs(values[i] - between_ends(ends, quadrature()[i].s)));
  return largest;
}

std::array<double, 2> projected(const std::array<double, samples>& values) {
  double mean = 0, slope = 0;  // coefficients of the Legendre polynomials 1 and 2s − 1
  for (int i = 0; i < samples; ++i) {
    const auto& [s, weight] = quadrature()[i];
    mean += weight * values[i];
    slope += 3 * weight * values[i] * (2 * s - 1);
  }
  return {mean - slope, mean + slope};
}

}  // namespace

EdgeValues<2> project(const Function<2>& given, const Vector<2>& a, const Vector<2>& b, const std::string& where) {
  const std::array<double, samples> values = sample(given, a, b, where);
  EdgeValues<2> result;
  result.largest = largest_of(values);
  const std::array<double, 2> ends = {given(a), given(b)};  // may be infinite: then they are not used
  // Rounding of the values, and of the points at which they are taken.
  const double reach = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()) / (b - a).norm();
  const double rounding =
      16 * std::numeric_limits<double>::epsilon() * (result.largest + std::abs(ends[1] - ends[0]) * (1 + reach));
  if (std::isfinite(rounding) && distance(values, ends) <= rounding) {
    result.value = ends;
  } else if (std::all_of(values.begin(), values.end(), [&](double value) { return value == values[0]; })) {
    result.value = {values[0], values[0]};
  } else {
    result.value = projected(values);
  }
  result.error = distance(values, result.value);
  return result;
}

EdgeValues<2> interpolate_linear(const Function<2>& given, const Vector<2>& a, const Vector<2>& b,
                                 const std::string& where) {
  EdgeValues<2> result;
  result.value = {finite_value(given, a, where), finite_value(given, b, where)};
  const std::array<double, samples> values = sample(given, a, b, where);
  result.largest = std::max({largest_of(values), std::abs(result.value[0]), std::abs(result.value[1])});
  result.error = distance(values, result.value);
  return result;
}

EdgeValues<3> interpolate_quadratic(const Function<2>& given, const Vector<2>& a, const Vector<2>& b,
                                    const std::string& where) {
  EdgeValues<3> result;
  const auto& [start, end, middle] = result.value = {finite_value(given, a, where), finite_value(given, b, where),
                                                     finite_value(given, 0.5 * (a + b), where)};
  const std::array<double, samples> values = sample(given, a, b, where);
  result.largest = std::max({largest_of(values), std::abs(start), std::abs(end), std::abs(middle)});
  const double bulge = middle - 0.5 * (start + end);
  for (int i = 0; i < samples; ++i) {
    const double s = quadrature()[i].s;
    result.error = std::max(result.error, std::abs(values[i] - between_ends(start, end, s) - 4 * s * (1 - s) * bulge));
  }
  return result;
}

}  // namespace bracket::scene
