// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/jet.h"

#include <cmath>
#include <optional>

namespace bracket::scene {

namespace {

/// The sign that u has everywhere (but for single points), if it has one: −1, 0, 1.
std::optional<int> sign_of(const Jet& u) {
  const Interval &x = u.value(), &slope = u.c[1];
  if (u.partial || x.is_empty()) return {};
  const bool monotone = !slope.contains(0);
  if (x.is_zero() && monotone && u.side != 0) return slope.lower > 0 ? u.side : -u.side;
  if (x.lower > 0 || (x.lower == 0 && monotone)) return 1;
  if (x.upper < 0 || (x.upper == 0 && monotone)) return -1;
  if (x.is_zero() && u.is_constant()) return 0;
  return {};
}

std::optional<bool> decided(const Jet& condition) {
  if (condition.partial) return {};
  const bool strictly_monotone = !condition.c[1].contains(0);
  if (!condition.value().contains(0) || strictly_monotone) return true;
  if (condition.value().is_zero() && condition.is_constant()) return false;
  return {};
}

Jet truth(std::optional<bool> known) { return known ? Jet(*known ? 1 : 0) : Jet::rough({0, 1}); }

/// Of functions that are not defined everywhere no comparison is decided, nor of what is nowhere defined.
bool comparable(const Jet& u, const Jet& v) {
  return !u.partial && !v.partial && !u.value().is_empty() && !v.value().is_empty();
}

}  // namespace

Jet composed(const std::array<Interval, 4>& f, const Jet& u) {
  Jet result{f[0], f[1] * u.c[1], f[1] * u.c[2] + f[2] * square(u.c[1]),
             f[1] * u.c[3] + Interval(2) * f[2] * u.c[1] * u.c[2] + f[3] * u.c[1] * square(u.c[1])};
  return made_of(result, u);
}

Jet made_of(Jet u, const Jet& v) {
  u.partial = u.partial || v.partial;
  if (u.side == 0) u.side = v.side;
  return u;
}

Jet linear(double a, double b, double from, double to) {
  if (a == b) return a;
  const Interval slope = Interval(b) - Interval(a);
  const auto at = [&](double t) { return t == 1 ? Interval(b) : Interval(a) + Interval(t) * slope; };
  return {hull(at(from), at(to)), slope, {}, {}};
}

Jet linear_beside(double a, double b, double at, int side) {
  Jet result = linear(a, b, at, at);
  if (a != b) result.side = side;
  return result;
}

Jet operator-(const Jet& u) {
  Jet result = u;
  for (Interval& c : result.c) c = -c;
  return result;
}

Jet operator+(const Jet& u, const Jet& v) {
  Jet sum;
  for (std::size_t i = 0; i < sum.c.size(); ++i) sum.c[i] = u.c[i] + v.c[i];
  return made_of(made_of(sum, u), v);
}
Jet operator-(const Jet& u, const Jet& v) { return u + -v; }

Jet operator*(const Jet& u, const Jet& v) {
  Jet product{u.c[0] * v.c[0], u.c[0] * v.c[1] + u.c[1] * v.c[0], u.c[0] * v.c[2] + u.c[1] * v.c[1] + u.c[2] * v.c[0],
              u.c[0] * v.c[3] + u.c[1] * v.c[2] + u.c[2] * v.c[1] + u.c[3] * v.c[0]};
  return made_of(made_of(product, u), v);
}

Jet operator/(const Jet& u, const Jet& v) {
  const Interval& y = v.value();
  if (v.is_constant() && !y.contains(0)) {
    Jet quotient = u;
    for (Interval& c : quotient.c) c = c / y;
    return made_of(quotient, v);
  }
  const Interval inverse = Interval(1) / y;
  Jet result = y.contains(0)
                   ? Jet::rough(u.value() / y)
                   : u * composed({inverse, -square(inverse), inverse * square(inverse), -square(square(inverse))}, v);
  result.c[0] = u.value() / y;
  result.partial = y.contains(0);
  return made_of(made_of(result, u), v);
}

Jet abs(const Jet& u) {
  if (const auto known = sign_of(u)) return *known < 0 ? -u : u;
  const Interval& x = u.value();
  if (u.side == 0 && x.lower >= 0) return u;
  if (u.side == 0 && x.upper <= 0) return -u;
  return made_of(Jet::rough(x.is_empty() ? x : Interval{0, x.magnitude()}), u);
}

Jet min(const Jet& u, const Jet& v) {
  const Interval &x = u.value(), &y = v.value();
  if (comparable(u, v)) {
    if (const auto known = sign_of(u - v)) return *known > 0 ? v : u;
    const bool over_range = u.side == 0 && v.side == 0;
    if (over_range && x.upper <= y.lower) return u;
    if (over_range && y.upper <= x.lower) return v;
    return made_of(made_of(Jet::rough({std::min(x.lower, y.lower), std::min(x.upper, y.upper)}), u), v);
  }
  Jet result = Jet::rough(hull(x, y));  // of what is not a number the C++ library takes either
  result.partial = true;
  return made_of(made_of(result, u), v);
}
Jet max(const Jet& u, const Jet& v) { return -min(-u, -v); }

Jet sign(const Jet& u) {
  if (const auto known = sign_of(u)) return *known;
  const Interval& x = u.value();
  if (u.partial || x.is_empty()) return Jet::rough({-1, 1});  // of what is not a number it is 0
  return Jet::rough({x.lower < 0 ? -1.0L : 0.0L, x.upper > 0 ? 1.0L : 0.0L});
}

Jet round(const Jet& u) {
  const Jet shifted = u + Jet(0.5L);
  const Interval& x = shifted.value();
  if (x.is_empty()) return u;
  const Real from = std::floor(x.lower), to = std::floor(x.upper);
  const Jet steps = shifted - Jet(to);
  const auto above = sign_of(steps);  // of what reaches the upper step, if at all, at one end
  if (above && *above < 0 && from >= to - 1) return made_of(Jet(to - 1), u);
  return made_of(from == to && (x.lower > to || above) ? Jet(to) : Jet::rough({std::min(from, to - 1), to}), u);
}

Jet operator<(const Jet& u, const Jet& v) {
  if (!comparable(u, v)) return truth({});
  const Interval &x = u.value(), &y = v.value();
  if (x.upper < y.lower) return 1;
  if (x.lower > y.upper) return 0;
  if (const auto known = sign_of(u - v)) return *known < 0 ? 1 : 0;
  return truth(u.side == 0 && v.side == 0 && x.lower >= y.upper ? std::optional(false) : std::nullopt);
}
Jet operator<=(const Jet& u, const Jet& v) {
  if (!comparable(u, v)) return truth({});
  return Jet(1) - (v < u);
}
Jet operator>(const Jet& u, const Jet& v) { return v < u; }
Jet operator>=(const Jet& u, const Jet& v) { return v <= u; }
Jet operator==(const Jet& u, const Jet& v) {
  if (!comparable(u, v)) return truth({});
  return Jet(1) - (u != v);
}
Jet operator!=(const Jet& u, const Jet& v) {
  if (!comparable(u, v)) return truth({});
  if (intersection(u.value(), v.value()).is_empty()) return 1;
  return truth(decided(u - v));
}

Jet both(const Jet& u, const Jet& v) {
  const auto one = decided(u), other = decided(v);
  if ((one && !*one) || (other && !*other)) return 0;
  return truth(one && other ? std::optional(true) : std::nullopt);
}
Jet either(const Jet& u, const Jet& v) {
  const auto one = decided(u), other = decided(v);
  if ((one && *one) || (other && *other)) return 1;
  return truth(one && other ? std::optional(false) : std::nullopt);
}

Jet choose(const Jet& condition, const Jet& yes, const Jet& no) {
  if (const auto known = decided(condition)) return *known ? yes : no;
  Jet result = Jet::rough(hull(yes.value(), no.value()));
  result.partial = yes.partial || no.partial || yes.value().is_empty() || no.value().is_empty();
  return result;
}

}  // namespace bracket::scene
