// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: functions on a face.
#include "scene/problem/space/face_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/problem/space/face_gap.h"
#include "scene/quadrature.h"

namespace bracket::scene {

namespace {

OnFace middle(const OnFace& a, const OnFace& b) { return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])}; }

double least_double_above(Real x) { return upper(Interval(x)); }

/// The largest gradient along the face whose components along the two directions are within these.
double largest_gradient(const Face& face, const std::array<double, 2>& along) {
  if (std::isinf(along[0]) || std::isinf(along[1])) return std::numeric_limits<double>::infinity();
  Eigen::Matrix2d products;
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 2; ++k) {
      const auto arm = [&](int j) {
        return Vector<3>(across_face[j][0] * (face[1] - face[0]) + across_face[j][1] * (face[2] - face[0]));
      };
      products(i, k) = arm(i).dot(arm(k));
    }
  const Eigen::Matrix2d inverse = products.inverse().cwiseAbs();
  return std::sqrt(inverse(0, 0) * along[0] * along[0] + 2 * inverse(0, 1) * along[0] * along[1] +
                   inverse(1, 1) * along[1] * along[1]);
}

/// A quadratic by its Bernstein coefficients, enclosed.
using Quadratic = std::array<Interval, 6>;

double value_at(const Quadratic& quadratic, const OnFace& at) {
  const Interval value = on_part(quadratic, {at, at, at})[0];
  return static_cast<double>(value.lower + (value.upper - value.lower) / 2);
}

/// Its change along a direction, at a point.
Interval slope_at(const Quadratic& q, const OnFace& at, const OnFace& direction) {
  const auto linear = [&](const Interval& a, const Interval& b, const Interval& c) {
    Interval x = a;
    if (at[0] != 0) x = x + Interval(at[0]) * (b - a);
    if (at[1] != 0) x = x + Interval(at[1]) * (c - a);
    return x;
  };
  const Interval first = linear(q[0], q[5], q[4]), second = linear(q[5], q[1], q[3]), third = linear(q[4], q[3], q[2]);
  return Interval(2) * (Interval(direction[0]) * (second - first) + Interval(direction[1]) * (third - first));
}

/// By the values at points, and how steeply they change from each to the next.
FaceDifference sampled_difference(const Function<3>& given, const Face& face, const FacePart& part,
                                  const Quadratic& quadratic) {
  FaceDifference result{part, 0, 0, 0};
  double before = 0;
  Vector<3> at_before = Vector<3>::Zero();
  bool first = true;
  for (const FacePoint& point : points_in(part)) {
    const Vector<3> x = place(face, point.at);
    const double value = given(x), left = value - value_at(quadratic, point.at);
    result.largest = std::max(result.largest, std::abs(left));
    result.value = std::max(result.value, std::abs(value));
    if (!first) result.slope = std::max(result.slope, std::abs(left - before) / (x - at_before).norm());
    before = left;
    at_before = x;
    first = false;
  }
  return result;
}

/// By its value in the middle and its slopes over the part.
FaceDifference difference(const Function<3>& given, const Face& face, const FacePart& part,
                          const Quadratic& quadratic) {
  if (!given.is_enclosed()) return sampled_difference(given, face, part, quadratic);
  Interval fixed = Interval::none();
  for (const Interval& c : on_part(quadratic, part)) fixed = hull(fixed, c);
  std::array<Jet, 2> jets;
  std::array<Interval, 2> slope;  // of the difference
  std::array<double, 2> steepest;
  for (int i = 0; i < 2; ++i) {
    jets[i] = over_part(given, face, part, across_face[i]);
    Interval of_fixed = Interval::none();
    for (const OnFace& corner : part) of_fixed = hull(of_fixed, slope_at(quadratic, corner, across_face[i]));
    slope[i] = jets[i].c[1] - of_fixed;
    steepest[i] = least_double_above(slope[i].magnitude());
  }
  const Interval value = jets[0].value();
  Interval left = value - fixed;
  if (!jets[0].partial && jets[0].c[1].is_bounded() && jets[1].c[1].is_bounded()) {
    const OnFace centre = middle(middle(part[0], part[1]), part[2]);  // any point of it
    const Jet there = at_point(given, face, centre, across_face[0]);
    // The difference at a point is its slopes somewhere times the way from the centre, a mean of the ways to the
    // corners.
    Interval change = Interval::none();
    for (const OnFace& corner : part) {
      const double s = corner[0] - centre[0], t = corner[1] - centre[1];
      change = hull(change, Interval(2 * s - t) / 3 * slope[0] + Interval(2 * t - s) / 3 * slope[1]);
    }
    left = intersection(left, there.value() - on_part(quadratic, {centre, centre, centre})[0] + change);
  }
  if (left.is_empty() || value.is_empty()) return {part, 0, 0, 0};  // of no value; where one is needed that is refused
  return {part, least_double_above(left.magnitude()), largest_gradient(face, steepest),
          least_double_above(value.magnitude())};
}

}  // namespace

std::array<FacePart, 4> quarters(const FacePart& part) {
  const auto& [a, b, c] = part;
  const OnFace bc = middle(b, c), ca = middle(c, a), ab = middle(a, b);
  return {{{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {bc, ca, ab}}};
}

std::vector<FacePart> parts_of(const Function<3>& given, const Face& face) {
  constexpr int quarterings = 32;
  if (is_polynomial(given, face, 1)) return {whole_face};
  struct Rough {
    FacePart part;
    Real left;  ///< what quartering may gain; 0: the function is smooth there
  };
  std::vector<Rough> all;
  const auto add = [&](const FacePart& part) {
    Real left = 0;
    if (given.is_enclosed()) {
      const Jet jet = over_part(given, face, part, across_face[0]);
      if (!jet.c[3].is_bounded()) left = (jet.c[0].upper - jet.c[0].lower) * share_of_face(part);
    }
    all.push_back({part, left});
  };
  for (const FacePart& quarter : quarters(whole_face))
    for (const FacePart& part : quarters(quarter)) add(part);
  for (int i = 0; i < quarterings; ++i) {
    const auto most = std::ranges::max_element(all, {}, &Rough::left);
    if (!(most->left > 0)) break;
    const FacePart part = most->part;
    all.erase(most);
    for (const FacePart& quarter : quarters(part)) add(quarter);
  }
  std::vector<FacePart> parts;
  for (const Rough& one : all) parts.push_back(one.part);
  return parts;
}

std::vector<FacePoint> points_in(const FacePart& part) {
  static const auto gauss = gauss_points<5>();
  std::vector<FacePoint> points;
  for (const auto& [x, x_weight] : gauss)
    for (const auto& [y, y_weight] : gauss) {
      const double s = (1 + x) / 2, t = (1 - s) * (1 + y) / 2;
      OnFace at;
      for (int i = 0; i < 2; ++i) at[i] = part[0][i] + s * (part[1][i] - part[0][i]) + t * (part[2][i] - part[0][i]);
      points.push_back({at, x_weight * y_weight * (1 - s) / 2});
    }
  return points;
}

FaceDifference difference(const Function<3>& given, const Face& face, const FacePart& part,
                          const std::array<double, 3>& corners) {
  Quadratic quadratic = {corners[0], corners[1], corners[2]};
  for (int e = 0; e < 3; ++e) {
    const auto& [i, k] = Simplex<2>::edges[e];
    quadratic[3 + e] = (Interval(corners[i]) + Interval(corners[k])) / 2;
  }
  return difference(given, face, part, quadratic);
}

namespace {

/// Of a function that is a quadratic, too: by the coefficients of the difference.
FaceDifference difference(const FaceGapBounds& given, const Face& face, const Quadratic& quadratic) {
  FaceDifference result{whole_face, 0, 0, 0};
  Quadratic left;
  for (int k = 0; k < 6; ++k) {
    const Interval own(given.lower[k], given.upper[k]);
    left[k] = own - quadratic[k];
    result.largest = std::max(result.largest, least_double_above(left[k].magnitude()));
    result.value = std::max(result.value, least_double_above(own.magnitude()));
  }
  std::array<double, 2> steepest{};
  for (int i = 0; i < 2; ++i)
    for (const OnFace& corner : whole_face)
      steepest[i] = std::max(steepest[i], least_double_above(slope_at(left, corner, across_face[i]).magnitude()));
  result.slope = largest_gradient(face, steepest);
  return result;
}

}  // namespace

std::vector<FaceDifference> difference(const Function<3>& given, const Face& face,
                                       const std::array<double, 6>& quadratic) {
  Quadratic enclosed;
  std::copy(quadratic.begin(), quadratic.end(), enclosed.begin());
  if (const auto bounds = given.is_enclosed() ? quadratic_gap(given, face) : std::nullopt)
    return {difference(*bounds, face, enclosed)};
  std::vector<FaceDifference> all;
  for (const FacePart& part : parts_of(given, face)) all.push_back(difference(given, face, part, enclosed));
  return all;
}

double rounding_of_values(double largest, const std::array<double, 6>& quadratic, const Face& face) {
  double reach = 0;
  for (const auto& x : face) reach = std::max(reach, x.cwiseAbs().maxCoeff());
  const double area = (face[1] - face[0]).cross(face[2] - face[0]).norm() / 2;
  const double longest = std::max({(face[1] - face[0]).norm(), (face[2] - face[1]).norm(), (face[0] - face[2]).norm()});
  const double height = 2 * area / longest;  // the least
  const auto [least, most] = std::ranges::minmax(quadratic);
  return 16 * std::numeric_limits<double>::epsilon() * (largest + 2 * (most - least) * (1 + reach / height));
}

}  // namespace bracket::scene
