// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/interval.h"

#include <cmath>
#include <numbers>

namespace bracket::scene {

namespace {

/// A library value, widened.
Interval about(Real value) {
  if (!std::isfinite(value))
    return value > 0 ? Interval{std::numeric_limits<Real>::max(), Interval::unbounded}
                     : Interval{-Interval::unbounded, std::numeric_limits<Real>::lowest()};
  const Real radius =
      16 * (std::abs(value) * std::numeric_limits<Real>::epsilon() + std::numeric_limits<Real>::denorm_min());
  return {value - radius, value + radius};
}

using RealFunction = Real (*)(Real);

/// \param root where the value is 0, exactly
Interval at(RealFunction f, Real x, Real root) { return x == root ? Interval{} : about(f(x)); }

/// A function that grows on all of x.
Interval growing(RealFunction f, const Interval& x, Real root = 0) {
  if (x.is_empty()) return x;
  return {at(f, x.lower, root).lower, at(f, x.upper, root).upper};
}

constexpr Real no_root = std::numeric_limits<Real>::quiet_NaN();

/// Whether there is a whole number of the given parity between x.lower / π + shift and x.upper / π + shift; yes if
/// rounding leaves that open.
bool holds_multiple(const Interval& x, Real shift, bool odd) {
  constexpr Real pi_real = std::numbers::pi_v<Real>;
  const Real slack = 8 * std::numeric_limits<Real>::epsilon() * (1 + x.magnitude());
  const Real from = ((x.lower / pi_real + shift) - slack - (odd ? 1 : 0)) / 2;
  const Real to = ((x.upper / pi_real + shift) + slack - (odd ? 1 : 0)) / 2;
  return std::ceil(from) <= to;
}

/// A sine or cosine, whose maxima lie where x / π + shift is an even number, its minima where that is odd.
Interval wave(RealFunction f, const Interval& x, Real shift, Real root) {
  if (x.is_empty()) return x;
  constexpr Real largest = 1e9L;  // beyond, x / π has too few digits behind the point to be of use
  if (!(x.magnitude() < largest)) return {-1, 1};
  const Interval ends = hull(at(f, x.lower, root), at(f, x.upper, root));
  return {holds_multiple(x, shift, true) ? -1 : std::max<Real>(-1, ends.lower),
          holds_multiple(x, shift, false) ? 1 : std::min<Real>(1, ends.upper)};
}

}  // namespace

Interval pi() { return about(std::numbers::pi_v<Real>); }

Interval sqrt(const Interval& x) {
  const Interval defined = intersection(x, {0, Interval::unbounded});
  if (defined.is_empty()) return defined;
  const auto above = [](Real y) {  // correctly rounded, so that its square tells whether it is exact
    const Real root = std::sqrt(y);
    const bool exact =
        y == 0 || (rounding::splits(y) && root * root == y && rounding::product_error(root, root, y) == 0);
    return exact || !std::isfinite(root) ? root : rounding::above(root);
  };
  const auto below = [](Real y) {
    const Real root = std::sqrt(y);
    const bool exact =
        y == 0 || (rounding::splits(y) && root * root == y && rounding::product_error(root, root, y) == 0);
    return exact ? root : std::max<Real>(0, -rounding::above(-root));
  };
  return {below(defined.lower), above(defined.upper)};
}

Interval exp(const Interval& x) {
  if (x.is_zero()) return 1;
  const Interval value = growing(std::exp, x, no_root);
  return value.is_empty() ? value : Interval{std::max<Real>(0, value.lower), value.upper};
}
Interval log(const Interval& x) { return growing(std::log, intersection(x, {0, Interval::unbounded}), 1); }
Interval log2(const Interval& x) { return growing(std::log2, intersection(x, {0, Interval::unbounded}), 1); }
Interval log10(const Interval& x) { return growing(std::log10, intersection(x, {0, Interval::unbounded}), 1); }

Interval sin(const Interval& x) { return x.is_zero() ? Interval{} : wave(std::sin, x, -0.5L, 0); }
Interval cos(const Interval& x) { return x.is_zero() ? Interval(1) : wave(std::cos, x, 0, no_root); }
Interval tan(const Interval& x) {
  if (x.is_empty()) return x;
  constexpr Real largest = 1e9L;
  if (!(x.magnitude() < largest) || holds_multiple(x, 0.5L, true) || holds_multiple(x, 0.5L, false))
    return Interval::whole();
  return growing(std::tan, x);
}

Interval asin(const Interval& x) { return growing(std::asin, intersection(x, {-1, 1})); }
Interval acos(const Interval& x) {
  const Interval defined = intersection(x, {-1, 1});
  if (defined.is_empty()) return defined;
  return {std::max<Real>(0, at(std::acos, defined.upper, 1).lower), at(std::acos, defined.lower, 1).upper};
}
Interval atan(const Interval& x) { return growing(std::atan, x); }
Interval sinh(const Interval& x) { return growing(std::sinh, x); }
Interval cosh(const Interval& x) {
  if (x.is_empty()) return x;
  if (x.is_zero()) return 1;
  const Interval ends = hull(about(std::cosh(x.lower)), about(std::cosh(x.upper)));
  return {x.contains(0) ? 1 : std::max<Real>(1, ends.lower), ends.upper};
}
Interval tanh(const Interval& x) {
  const Interval value = growing(std::tanh, x);
  return value.is_empty() ? value : intersection(value, {-1, 1});
}
Interval asinh(const Interval& x) { return growing(std::asinh, x); }
Interval acosh(const Interval& x) {
  const Interval value = growing(std::acosh, intersection(x, {1, Interval::unbounded}), 1);
  return value.is_empty() ? value : Interval{std::max<Real>(0, value.lower), value.upper};
}
Interval atanh(const Interval& x) { return growing(std::atanh, intersection(x, {-1, 1})); }

Interval pow(const Interval& x, Real exponent) {
  const Interval defined = intersection(x, {0, Interval::unbounded});
  if (defined.is_empty()) return defined;
  const auto power = [exponent](Real base) {
    if (base == 1) return Interval(1);
    const Real value = std::pow(base, exponent);
    return value == 0 && base == 0 ? Interval{} : about(value);
  };
  const Interval from = power(defined.lower), to = power(defined.upper);
  return {std::max<Real>(0, std::min(from.lower, to.lower)), std::max(from.upper, to.upper)};
}

}  // namespace bracket::scene
