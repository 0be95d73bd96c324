// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "scene/interval.h"

namespace bracket::scene {

/// A function of one parameter over a range of it: enclosures of its values there, of its derivative, half its second
/// and a sixth of its third. Where it is not smooth, or may not be (a branch that is not decided, |x| around 0, √x at
/// 0), these are unbounded, but its values stay enclosed. So a bounded first derivative means that the function is
/// continuously differentiable there, and so on. What is told of a comparison holds but for single points. A range may
/// be one point: then the values are the limits from that side of it that `side` names.
struct Jet {
  std::array<Interval, 4> c;  ///< coefficients of Taylor's series at any point of the range
  bool partial = false;       ///< perhaps not defined everywhere; where it is not, nothing is said of its values
  int side = 0;  ///< of a range that is one point: 1 just after it, −1 just before; 0: of a constant, a range

  Jet() = default;
  Jet(Real constant) : c{Interval(constant), {}, {}, {}} {}
  Jet(const Interval& value, const Interval& first, const Interval& second, const Interval& third)
      : c{value, first, second, third} {}

  const Interval& value() const { return c[0]; }
  /// All derivatives are known to be 0.
  bool is_constant() const { return c[1].is_zero() && c[2].is_zero() && c[3].is_zero(); }
  /// Some value, of which but the range is known.
  static Jet rough(const Interval& range) { return {range, Interval::whole(), Interval::whole(), Interval::whole()}; }
};

/// Linear from the value a at 0 to b at 1, over [from, to]; exact at 0 and 1.
Jet linear(double a, double b, double from, double to);
/// The same just after (side 1) or before (−1) a point.
Jet linear_beside(double a, double b, double at, int side);

/// u, with `partial` and `side` of what it is made of.
Jet made_of(Jet u, const Jet& v);

/// f(u), by f and its Taylor coefficients over the values of u.
Jet composed(const std::array<Interval, 4>& f, const Jet& u);

Jet operator-(const Jet& u);
Jet operator+(const Jet& u, const Jet& v);
Jet operator-(const Jet& u, const Jet& v);
Jet operator*(const Jet& u, const Jet& v);
Jet operator/(const Jet& u, const Jet& v);

Jet sqrt(const Jet& u);
Jet exp(const Jet& u);
Jet log(const Jet& u);
Jet log2(const Jet& u);
Jet log10(const Jet& u);
Jet sin(const Jet& u);
Jet cos(const Jet& u);
Jet tan(const Jet& u);
Jet asin(const Jet& u);
Jet acos(const Jet& u);
Jet atan(const Jet& u);
Jet atan2(const Jet& y, const Jet& x);
Jet sinh(const Jet& u);
Jet cosh(const Jet& u);
Jet tanh(const Jet& u);
Jet asinh(const Jet& u);
Jet acosh(const Jet& u);
Jet atanh(const Jet& u);
Jet pow(const Jet& u, const Jet& exponent);
Jet abs(const Jet& u);
Jet min(const Jet& u, const Jet& v);
Jet max(const Jet& u, const Jet& v);
Jet sign(const Jet& u);   ///< −1, 0 or 1
Jet round(const Jet& u);  ///< the largest whole number up to u + ½

/// 1: holds, 0: does not; rough where that is not decided.
Jet operator<(const Jet& u, const Jet& v);
Jet operator<=(const Jet& u, const Jet& v);
Jet operator>(const Jet& u, const Jet& v);
Jet operator>=(const Jet& u, const Jet& v);
Jet operator==(const Jet& u, const Jet& v);
Jet operator!=(const Jet& u, const Jet& v);
Jet both(const Jet& u, const Jet& v);    ///< u ≠ 0 and v ≠ 0
Jet either(const Jet& u, const Jet& v);  ///< u ≠ 0 or v ≠ 0

/// `condition` ? yes : no, as functions that are written once for points and for jets need it; && and ||.
Jet choose(const Jet& condition, const Jet& yes, const Jet& no);
inline double choose(bool condition, double yes, double no) { return condition ? yes : no; }
inline bool both(bool a, bool b) { return a && b; }
inline bool either(bool a, bool b) { return a || b; }

}  // namespace bracket::scene
