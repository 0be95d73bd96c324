// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/enclosure.h"

namespace bracket::bounds {

/// A real number known to lie within `radius` of `middle`, as scene::Enclosure has it, in doubles: some 2000 times as
/// wide, and several times as quick, as nothing branches and x87's stack is left alone. What cannot be enclosed has an
/// infinite or undefined radius here, too.
/// With u = 2⁻⁵³ and m the computed result of one operation, |m − the exact one| ≤ u |m| + 2⁻¹⁰⁷⁵, the second where it
/// underflows. A radius is a sum of at most ten non-negative terms and products, each computed operation of which loses
/// at most u of it and 2⁻¹⁰⁷⁵: `up` gives back more than both.
struct DoubleEnclosure {
  double middle = 0;
  double radius = 0;

  DoubleEnclosure() = default;
  DoubleEnclosure(double exact) : middle(exact) {}
  DoubleEnclosure(double about, double within) : middle(about), radius(within) {}
  /// All values of x. What a middle loses as a double is computed exactly.
  explicit DoubleEnclosure(const scene::Enclosure& x);

  operator scene::Enclosure() const { return {middle, radius}; }
};

namespace double_rounding {
inline constexpr double half_ulp = std::numeric_limits<double>::epsilon() / 2;
/// More than underflow can lose; so large that products with it do not become denormal, which would be slow.
inline constexpr double smallest = 0x1p-900;
/// Not less than the exact value of a sum of at most ten products and sums of non-negative numbers.
inline double up(double value) { return value * (1 + 32 * half_ulp) + smallest; }
}  // namespace double_rounding

inline DoubleEnclosure::DoubleEnclosure(const scene::Enclosure& x)
    : middle(static_cast<double>(x.middle)),
      radius(double_rounding::up(static_cast<double>(x.radius + std::abs(x.middle - scene::Real(middle))))) {}

inline DoubleEnclosure operator-(const DoubleEnclosure& x) { return {-x.middle, x.radius}; }

inline DoubleEnclosure operator+(const DoubleEnclosure& x, const DoubleEnclosure& y) {
  const double sum = x.middle + y.middle;
  return {sum, double_rounding::up(x.radius + y.radius + double_rounding::half_ulp * std::abs(sum))};
}
inline DoubleEnclosure operator-(const DoubleEnclosure& x, const DoubleEnclosure& y) { return x + -y; }

inline DoubleEnclosure operator*(const DoubleEnclosure& x, const DoubleEnclosure& y) {
  const double product = x.middle * y.middle;
  return {product, double_rounding::up(std::abs(x.middle) * y.radius + x.radius * (std::abs(y.middle) + y.radius) +
                                       double_rounding::half_ulp * std::abs(product))};
}

/// For divisors that do not contain zero: |x/y − m| ≤ (r_x + |m_x/m_y| r_y) / (|m_y| − r_y) + rounding.
inline DoubleEnclosure operator/(const DoubleEnclosure& x, const DoubleEnclosure& y) {
  using namespace double_rounding;
  const double quotient = x.middle / y.middle;
  const double least = (std::abs(y.middle) - y.radius) * (1 - 4 * half_ulp);
  if (!(least > smallest)) return {quotient, std::numeric_limits<double>::infinity()};
  const double by_operands = up((x.radius + up(std::abs(quotient)) * y.radius) / least);
  return {quotient, up(by_operands + half_ulp * std::abs(quotient))};
}

inline DoubleEnclosure& operator+=(DoubleEnclosure& x, const DoubleEnclosure& y) { return x = x + y; }
inline DoubleEnclosure& operator-=(DoubleEnclosure& x, const DoubleEnclosure& y) { return x = x - y; }

}  // namespace bracket::bounds
