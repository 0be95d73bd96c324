// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfloat>
#include <cmath>
#include <limits>

namespace bracket::scene {

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "enclosures need the arithmetic of IEEE 754 as it is written: compile without -ffast-math and its parts"
#endif

/// Extended precision: more digits make the enclosures narrower.
using Real = long double;
static_assert(std::numeric_limits<Real>::is_iec559 && std::numeric_limits<Real>::digits >= 64 &&
                  std::numeric_limits<Real>::min_exponent10 < -4000,
              "enclosures need a long double of IEEE extended precision or more");
static_assert(FLT_EVAL_METHOD == 0, "enclosures need doubles that are computed as doubles");

/// A real number known to lie within `radius` of `middle`. Every operation gives an enclosure of all values that its
/// operands allow, rounding of its own included; no rounding mode is changed. What cannot be enclosed (a divisor around
/// zero, overflow) has an infinite or undefined radius.
/// Rounding errors of sums are computed exactly [Knuth's TwoSum], those of products are bounded by ½ ulp; a radius
/// itself is rounded a few times, which `up` makes good.
struct Enclosure {
  Real middle = 0;
  Real radius = 0;

  Enclosure() = default;
  Enclosure(Real exact) : middle(exact) {}
  Enclosure(Real about, Real within) : middle(about), radius(within) {}

  bool is_zero() const { return middle == 0 && radius == 0; }
  bool is_unit() const { return std::abs(middle) == 1 && radius == 0; }
};

namespace rounding {
inline constexpr Real half_ulp = std::numeric_limits<Real>::epsilon() / 2;
/// More than underflow can lose; so large that products of radii do not become denormal, which would be slow.
inline constexpr Real smallest = 1e-1200L;
/// Not less than the exact value of a sum of at most ten products and sums of non-negative numbers.
inline Real up(Real value) { return value * (1 + 32 * half_ulp) + smallest; }
}  // namespace rounding

/// Not less than any value of x.
inline double upper(const Enclosure& x) {
  const Real bound =
      x.radius == 0 ? x.middle : std::nextafter(x.middle + x.radius, std::numeric_limits<Real>::infinity());
  const auto rounded = static_cast<double>(bound);
  return rounded < bound ? std::nextafter(rounded, std::numeric_limits<double>::infinity()) : rounded;
}
/// Not more than any value of x.
inline double lower(const Enclosure& x) { return -upper({-x.middle, x.radius}); }
/// Whether no value of x is below zero.
inline bool certainly_non_negative(const Enclosure& x) { return x.middle >= x.radius; }
/// Not less than any |value| of x.
inline double magnitude(const Enclosure& x) { return upper({std::abs(x.middle), x.radius}); }

/// The exact sum is the rounded one and the error.
struct ExactSum {
  Real sum, error;
};
inline ExactSum exact_sum(Real a, Real b) {
  const Real sum = a + b, b_in_sum = sum - a;
  return {sum, (a - (sum - b_in_sum)) + (b - b_in_sum)};
}

inline Enclosure operator-(const Enclosure& x) { return {-x.middle, x.radius}; }

inline Enclosure operator+(const Enclosure& x, const Enclosure& y) {
  const auto [sum, error] = exact_sum(x.middle, y.middle);
  const Real radius = x.radius + y.radius + std::abs(error);
  return {sum, radius == 0 ? 0 : rounding::up(radius)};
}
inline Enclosure operator-(const Enclosure& x, const Enclosure& y) { return x + -y; }

inline Enclosure operator*(const Enclosure& x, const Enclosure& y) {
  if (x.is_zero() || y.is_zero()) return {};
  if (x.is_unit() && y.radius == 0) return x.middle * y.middle;  // along an axis components are exact
  if (y.is_unit() && x.radius == 0) return x.middle * y.middle;
  const Real product = x.middle * y.middle;
  return {product, rounding::up(std::abs(x.middle) * y.radius + x.radius * (std::abs(y.middle) + y.radius) +
                                rounding::half_ulp * std::abs(product))};
}

/// For divisors that do not contain zero.
inline Enclosure operator/(const Enclosure& x, const Enclosure& y) {
  if (x.is_zero() && std::abs(y.middle) > y.radius) return {};
  const Real quotient = x.middle / y.middle;
  const Real least = (std::abs(y.middle) - y.radius) * (1 - 4 * rounding::half_ulp);
  if (!(least > 0)) return {quotient, std::numeric_limits<double>::infinity()};
  const Real by_operands = rounding::up((x.radius + rounding::up(std::abs(quotient)) * y.radius) / least);
  return {quotient, rounding::up(by_operands + rounding::half_ulp * std::abs(quotient))};
}

inline Enclosure& operator+=(Enclosure& x, const Enclosure& y) { return x = x + y; }
inline Enclosure& operator-=(Enclosure& x, const Enclosure& y) { return x = x - y; }

/// √x for x > 0: |√y − √m| ≤ |y − m| / √m.
inline Enclosure root(const Enclosure& x) {
  const Real value = std::sqrt(x.middle);
  return {value,
          rounding::up(rounding::up(x.radius / (value * (1 - 4 * rounding::half_ulp))) + rounding::half_ulp * value)};
}

/// A sum of many terms whose own rounding does not grow with their number.
class LongSum {
 public:
  void add(const Enclosure& term) {
    const auto [sum, error] = exact_sum(high_, term.middle);
    high_ = sum;
    rest_ = rest_ + Enclosure(error, term.radius);
  }
  Enclosure value() const { return Enclosure(high_) + rest_; }

 private:
  Real high_ = 0;
  Enclosure rest_;
};

}  // namespace bracket::scene
