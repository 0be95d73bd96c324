// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "scene/enclosure.h"

namespace bracket::scene {

/// All real numbers from `lower` to `upper`, in extended precision; unbounded where an end is infinite, empty where
/// lower > upper. Operations give enclosures of all values that their operands allow; what is exact stays exact: an end
/// is moved outwards only where its rounding error, which is computed, says so. No rounding mode is changed.
struct Interval {
  Real lower = 0;
  Real upper = 0;

  Interval() = default;
  Interval(Real exact) : lower(exact), upper(exact) {}
  Interval(Real from, Real to) : lower(from), upper(to) {}

  bool is_empty() const { return !(lower <= upper); }
  bool is_zero() const { return lower == 0 && upper == 0; }
  bool is_point() const { return lower == upper; }
  bool is_bounded() const { return std::isfinite(lower) && std::isfinite(upper); }
  bool contains(Real x) const { return lower <= x && x <= upper; }
  /// Not less than any |value|.
  Real magnitude() const { return std::max(std::abs(lower), std::abs(upper)); }

  static Interval whole() { return {-unbounded, unbounded}; }
  static Interval none() { return {unbounded, -unbounded}; }
  static constexpr Real unbounded = std::numeric_limits<Real>::infinity();
};

/// The smallest interval that holds both.
inline Interval hull(const Interval& x, const Interval& y) {
  if (x.is_empty()) return y;
  if (y.is_empty()) return x;
  return {std::min(x.lower, y.lower), std::max(x.upper, y.upper)};
}
inline Interval intersection(const Interval& x, const Interval& y) {
  const Interval both{std::max(x.lower, y.lower), std::min(x.upper, y.upper)};
  return both.is_empty() ? Interval::none() : both;
}

namespace rounding {

/// Not less than the number after x, and not much more.
inline Real above(Real x) {
  if (!std::isfinite(x)) return x < 0 ? std::numeric_limits<Real>::lowest() : x;
  return x + (std::abs(x) * std::numeric_limits<Real>::epsilon() + std::numeric_limits<Real>::denorm_min());
}

/// x · y = product + error, exactly where nothing under- or overflows [Dekker]. The number of bits is even.
inline Real product_error(Real x, Real y, Real product) {
  constexpr Real split = 4294967297.0L;  // 2³² + 1
  const Real cx = split * x, cy = split * y;
  const Real x1 = cx - (cx - x), x2 = x - x1, y1 = cy - (cy - y), y2 = y - y1;
  return ((x1 * y1 - product) + x1 * y2 + x2 * y1) + x2 * y2;
}
/// The error of a product is computed where its factors and itself are of these sizes.
inline constexpr Real smallest_split = 1e-2400L, largest_split = 1e2400L;
inline bool splits(Real x) { return smallest_split < std::abs(x) && std::abs(x) < largest_split; }

/// Not less than x + y, x · y, x / y. 0 · ∞ is 0: an end at infinity stands for finite numbers without a bound.
inline Real sum_above(Real x, Real y) {
  const auto [sum, error] = exact_sum(x, y);
  if (!std::isfinite(sum)) return std::isfinite(x) && std::isfinite(y) ? above(sum) : sum;
  return error > 0 ? above(sum) : sum;
}
inline Real product_above(Real x, Real y) {
  if (x == 0 || y == 0) return 0;
  const Real product = x * y;
  if (std::abs(x) == 1 || std::abs(y) == 1 || !std::isfinite(x) || !std::isfinite(y)) return product;
  const bool exact = splits(x) && splits(y) && splits(product) && product_error(x, y, product) <= 0;
  return exact ? product : above(product);
}
/// \pre y ≠ 0
inline Real quotient_above(Real x, Real y) {
  if (x == 0 || !std::isfinite(y)) return 0;
  const Real quotient = x / y;
  if (!std::isfinite(x)) return quotient;
  const bool exact =
      splits(quotient) && splits(x) && splits(y) && quotient * y == x && product_error(quotient, y, x) == 0;
  return exact ? quotient : above(quotient);
}

}  // namespace rounding

inline Interval operator-(const Interval& x) { return {-x.upper, -x.lower}; }

inline Interval operator+(const Interval& x, const Interval& y) {
  if (x.is_empty() || y.is_empty()) return Interval::none();
  return {-rounding::sum_above(-x.lower, -y.lower), rounding::sum_above(x.upper, y.upper)};
}
inline Interval operator-(const Interval& x, const Interval& y) { return x + -y; }

inline Interval operator*(const Interval& x, const Interval& y) {
  using rounding::product_above;
  if (x.is_empty() || y.is_empty()) return Interval::none();
  if (x.is_zero() || y.is_zero()) return {};
  if (x.upper <= 0) return -(-x * y);
  if (y.upper <= 0) return -(x * -y);
  if (x.lower >= 0) {
    const Real least = y.lower >= 0 ? x.lower : x.upper;
    return {-product_above(-least, y.lower), product_above(x.upper, y.upper)};
  }
  if (y.lower >= 0) return y * x;
  return {std::min(-product_above(-x.lower, y.upper), -product_above(-x.upper, y.lower)),
          std::max(product_above(x.lower, y.lower), product_above(x.upper, y.upper))};
}

/// Over the divisors other than 0; empty if there are none.
inline Interval operator/(const Interval& x, const Interval& y) {
  using rounding::quotient_above;
  if (x.is_empty() || y.is_empty() || y.is_zero()) return Interval::none();
  if (y.lower < 0 && y.upper > 0) return x.is_zero() ? Interval{} : Interval::whole();
  if (y.upper <= 0) return -x / -y;
  Interval quotient = Interval::none();
  for (const Real a : {x.lower, x.upper})
    for (const Real b : {y.lower, y.upper}) {
      if (b == 0) {  // the quotient grows without a bound
        if (a < 0) quotient.lower = -Interval::unbounded;
        if (a > 0) quotient.upper = Interval::unbounded;
        continue;
      }
      quotient.lower = std::min(quotient.lower, -quotient_above(-a, b));
      quotient.upper = std::max(quotient.upper, quotient_above(a, b));
    }
  return quotient;
}

inline Interval square(const Interval& x) {
  if (x.is_empty() || x.is_point()) return x * x;
  const Interval product = x * x;
  return {x.contains(0) ? 0 : std::max<Real>(0, product.lower), product.upper};
}

/// The elementary functions, over the part of x on which they are defined; empty if there is none. The C library's
/// values are widened by 16 units in the last place, four times the largest error that glibc documents for functions
/// in extended precision; at 0 (log, acosh and acos: at 1) those that are exact stay so.
Interval sqrt(const Interval& x);
Interval exp(const Interval& x);
Interval log(const Interval& x);
Interval log2(const Interval& x);
Interval log10(const Interval& x);
Interval sin(const Interval& x);
Interval cos(const Interval& x);
Interval tan(const Interval& x);
Interval asin(const Interval& x);
Interval acos(const Interval& x);
Interval atan(const Interval& x);
Interval sinh(const Interval& x);
Interval cosh(const Interval& x);
Interval tanh(const Interval& x);
Interval asinh(const Interval& x);
Interval acosh(const Interval& x);
Interval atanh(const Interval& x);
/// x to a power that is no integer, over the x ≥ 0.
Interval pow(const Interval& x, Real exponent);
/// π
Interval pi();

/// Not less than any value of x; not more.
inline double upper(const Interval& x) {
  const auto rounded = static_cast<double>(x.upper);
  return rounded < x.upper ? std::nextafter(rounded, std::numeric_limits<double>::infinity()) : rounded;
}
inline double lower(const Interval& x) { return -upper(-x); }

}  // namespace bracket::scene
