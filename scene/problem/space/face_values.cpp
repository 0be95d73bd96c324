// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: functions on a face.
#include "scene/problem/space/face_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/problem/space/face_difference.h"
#include "scene/quadrature.h"
#include "scene/range.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

double finite_on_face(const Function<3>& given, const Vector<3>& x, const std::string& where) {
  const double value = given(x);
  if (!std::isfinite(value)) fail(Status::input, where, fmt::format("the value at {} is not finite", point(x)));
  if (std::abs(value) > largest_size)
    fail(Status::input, where,
         fmt::format("the value at {} is {:g}; expected at most {:g} in size", point(x), value, largest_size));
  return value;
}

struct FaceSample {
  OnFace at;
  double weight;  ///< all together 1
  double value;
};

std::vector<FaceSample> sample(const Function<3>& given, const Face& face, const std::vector<FacePart>& parts,
                               const std::string& where) {
  std::vector<FaceSample> samples;
  for (const FacePart& part : parts)
    for (const FacePoint& point : points_in(part))
      samples.push_back(
          {point.at, share_of_face(part) * point.weight, finite_on_face(given, place(face, point.at), where)});
  return samples;
}

double largest_of(const std::vector<FaceSample>& samples) {
  double largest = 0;
  for (const FaceSample& at : samples) largest = std::max(largest, std::abs(at.value));
  return largest;
}

double distance(const std::vector<FaceSample>& samples, const std::array<double, 3>& corners) {
  double largest = 0;
  for (const FaceSample& at : samples) largest = std::max(largest, std::abs(at.value - value_on_face(corners, at.at)));
  return largest;
}

std::array<double, 3> projected(const std::vector<FaceSample>& samples) {
  std::array<double, 3> moment{};
  for (const auto& [at, weight, value] : samples) {
    moment[0] += weight * value * (1 - at[0] - at[1]);
    moment[1] += weight * value * at[0];
    moment[2] += weight * value * at[1];
  }
  const double sum = moment[0] + moment[1] + moment[2];
  return {12 * moment[0] - 3 * sum, 12 * moment[1] - 3 * sum, 12 * moment[2] - 3 * sum};
}

/// The values at the corners, just inside of the face.
std::array<double, 3> inside_corners(const Function<3>& given, const Face& face) {
  std::array<double, 3> corners;
  const std::array<OnFace, 3> inwards = {{{2, 1}, {-2, 1}, {1, -2}}};
  for (int i = 0; i < 3; ++i) {
    const Interval value = at_point(given, face, whole_face[i], inwards[i]).value();
    corners[i] = static_cast<double>(value.lower + (value.upper - value.lower) / 2);
  }
  return corners;
}

/// Not less than what the linear function misses on a face, whose parts are quartered until it is a twentieth above
/// what is found at points.
double largest_difference(const Function<3>& given, const Face& face, const std::vector<FacePart>& parts,
                          const std::array<double, 3>& corners, double found) {
  constexpr int quarterings = 64;
  std::vector<std::pair<double, FacePart>> all;  // a heap
  const auto add = [&](const FacePart& part) {
    all.emplace_back(difference(given, face, part, corners).largest, part);
    std::ranges::push_heap(all, {}, &std::pair<double, FacePart>::first);
  };
  for (const FacePart& part : parts) add(part);
  for (int i = 0; i < quarterings && all.front().first > 1.05 * found; ++i) {
    const FacePart worst = all.front().second;
    std::ranges::pop_heap(all, {}, &std::pair<double, FacePart>::first);
    all.pop_back();
    for (const FacePart& quarter : quarters(worst)) add(quarter);
  }
  return all.front().first;
}

/// Fills in how far the linear function is from the given one, and how large that is.
FacetValues<3> compared(const std::array<double, 3>& corners, const Function<3>& given, const Face& face,
                        const std::vector<FacePart>& parts, const std::vector<FaceSample>& samples) {
  FacetValues<3> result{corners, 0, largest_of(samples)};
  for (const double value : corners) result.largest = std::max(result.largest, std::abs(value));
  if (!given.is_enclosed()) {
    result.error = distance(samples, corners);
    return result;
  }
  result.error = largest_difference(given, face, parts, corners, distance(samples, corners));
  for (const FacePart& part : parts) {
    const Real value = over_part(given, face, part, across_face[0]).value().magnitude();
    if (std::isfinite(value)) result.largest = std::max(result.largest, upper(Interval(value)));
  }
  return result;
}

FacetValues<3> exact(const std::array<double, 3>& corners) {
  FacetValues<3> result{corners, 0, 0};
  for (const double value : corners) result.largest = std::max(result.largest, std::abs(value));
  return result;
}

/// Refuses what is not finite at the corners.
std::array<double, 3> at_corners(const Function<3>& given, const Face& face, const std::string& where) {
  return {finite_on_face(given, face[0], where), finite_on_face(given, face[1], where),
          finite_on_face(given, face[2], where)};
}

}  // namespace

FacetValues<3> project(const Function<3>& given, const Face& face, const std::string& where) {
  if (is_polynomial(given, face, 1)) {
    const std::array<double, 3> corners = inside_corners(given, face);
    sample(given, face, {whole_face}, where);  // refuses what is not finite or too large
    return exact(corners);
  }
  const std::vector<FacePart> parts = parts_of(given, face);
  const std::vector<FaceSample> samples = sample(given, face, parts, where);
  const double first = samples.front().value;
  if (std::ranges::all_of(samples, [&](const FaceSample& at) { return at.value == first; }))
    return compared({first, first, first}, given, face, parts, samples);
  const std::array<double, 3> corners = {given(face[0]), given(face[1]), given(face[2])};  // may be infinite
  const double rounding = 64 * std::numeric_limits<double>::epsilon() * largest_of(samples);
  if (distance(samples, corners) <= rounding) return compared(corners, given, face, parts, samples);
  return compared(projected(samples), given, face, parts, samples);
}

FacetValues<3> interpolate_linear(const Function<3>& given, const Face& face, const std::string& where) {
  const std::array<double, 3> corners = at_corners(given, face, where);
  if (is_polynomial(given, face, 1)) return exact(corners);
  const std::vector<FacePart> parts = parts_of(given, face);
  return compared(corners, given, face, parts, sample(given, face, parts, where));
}

FacetValues<6> interpolate_quadratic(const Function<3>& given, const Face& face, const std::string& where) {
  const std::array<double, 3> corners = at_corners(given, face, where);
  FacetValues<6> result{{corners[0], corners[1], corners[2]}, 0, 0};
  for (int e = 0; e < 3; ++e) {
    const auto& [i, k] = Simplex<2>::edges[e];
    const double value = finite_on_face(given, 0.5 * (face[i] + face[k]), where);
    result.value[3 + e] = value + ((value - corners[i]) + (value - corners[k])) / 2;
    result.largest = std::max(result.largest, std::abs(value));
  }
  const std::vector<FaceSample> samples = sample(given, face, parts_of(given, face), where);
  result.largest = std::max(result.largest, largest_of(samples));
  for (const auto& [at, weight, value] : samples) {
    const double quadratic = on_part(result.value, {at, at, at})[0];
    result.error = std::max(result.error, std::abs(value - quadratic));
  }
  for (const double value : corners) result.largest = std::max(result.largest, std::abs(value));
  return result;
}

}  // namespace bracket::scene
