// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/jet.h"

#include <cmath>
#include <optional>

namespace bracket::scene {

namespace {

std::optional<bool> decided(const Jet& condition) {
  if (condition.partial) return {};
  const Interval& x = condition.value();
  if (x.is_zero()) return false;
  const bool strictly_monotone = !condition.c[1].contains(0);
  if (!x.contains(0) || strictly_monotone) return true;
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
  result.partial = u.partial;
  return result;
}

Jet linear(double a, double b, double from, double to) {
  if (a == b) return a;
  const Interval slope = Interval(b) - Interval(a);
  const auto at = [&](double t) { return t == 1 ? Interval(b) : Interval(a) + Interval(t) * slope; };
  return {hull(at(from), at(to)), slope, {}, {}};
}

Jet operator-(const Jet& u) {
  Jet result = u;
  for (Interval& c : result.c) c = -c;
  return result;
}

Jet operator+(const Jet& u, const Jet& v) {
  Jet sum;
  for (std::size_t i = 0; i < sum.c.size(); ++i) sum.c[i] = u.c[i] + v.c[i];
  sum.partial = u.partial || v.partial;
  return sum;
}
Jet operator-(const Jet& u, const Jet& v) { return u + -v; }

Jet operator*(const Jet& u, const Jet& v) {
  Jet product{u.c[0] * v.c[0], u.c[0] * v.c[1] + u.c[1] * v.c[0], u.c[0] * v.c[2] + u.c[1] * v.c[1] + u.c[2] * v.c[0],
              u.c[0] * v.c[3] + u.c[1] * v.c[2] + u.c[2] * v.c[1] + u.c[3] * v.c[0]};
  product.partial = u.partial || v.partial;
  return product;
}

Jet operator/(const Jet& u, const Jet& v) {
  const Interval& y = v.value();
  if (v.is_constant() && !y.contains(0)) {
    Jet quotient = u;
    for (Interval& c : quotient.c) c = c / y;
    quotient.partial = u.partial || v.partial;
    return quotient;
  }
  const Interval inverse = Interval(1) / y;
  Jet result = y.contains(0)
                   ? Jet::rough(u.value() / y)
                   : u * composed({inverse, -square(inverse), inverse * square(inverse), -square(square(inverse))}, v);
  result.c[0] = u.value() / y;
  result.partial = u.partial || v.partial || y.contains(0);
  return result;
}

Jet abs(const Jet& u) {
  const Interval& x = u.value();
  if (x.lower >= 0) return u;
  if (x.upper <= 0) return -u;
  Jet result = Jet::rough(x.is_empty() ? x : Interval{0, x.magnitude()});
  result.partial = u.partial;
  return result;
}

Jet min(const Jet& u, const Jet& v) {
  if (comparable(u, v) && u.value().upper <= v.value().lower) return u;
  if (comparable(u, v) && v.value().upper <= u.value().lower) return v;
  const bool partial = !comparable(u, v);  // of what is not a number the C++ library takes either
  const Interval &x = u.value(), &y = v.value();
  Jet result = Jet::rough(partial ? hull(x, y) : Interval{std::min(x.lower, y.lower), std::min(x.upper, y.upper)});
  result.partial = partial;
  return result;
}
Jet max(const Jet& u, const Jet& v) { return -min(-u, -v); }

Jet sign(const Jet& u) {
  const Interval& x = u.value();
  if (u.partial || x.is_empty()) return Jet::rough({-1, 1});  // of what is not a number it is 0
  if (x.is_zero()) return 0;
  const bool monotone = !u.c[1].contains(0);
  if (x.lower > 0 || (x.lower == 0 && monotone)) return 1;
  if (x.upper < 0 || (x.upper == 0 && monotone)) return -1;
  return Jet::rough({x.lower < 0 ? -1.0L : 0.0L, x.upper > 0 ? 1.0L : 0.0L});
}

Jet round(const Jet& u) {
  const Jet shifted = u + Jet(0.5L);
  const Interval& x = shifted.value();
  if (x.is_empty()) return u;
  const Real from = std::floor(x.lower), to = std::floor(x.upper);
  const bool end_only = x.upper == to && from == to - 1 && !u.c[1].contains(0);
  Jet result = from == to || end_only ? Jet(from) : Jet::rough({from, to});
  result.partial = u.partial;
  return result;
}

Jet operator<(const Jet& u, const Jet& v) {
  if (!comparable(u, v)) return truth({});
  const Interval &x = u.value(), &y = v.value();
  if (x.lower >= y.upper) return 0;
  if (x.upper < y.lower) return 1;
  // Equal at single points only, if the difference is strictly monotone.
  return truth(x.upper == y.lower && !(u - v).c[1].contains(0) ? std::optional(true) : std::nullopt);
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
