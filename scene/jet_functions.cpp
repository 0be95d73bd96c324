// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "scene/jet.h"

namespace bracket::scene {

namespace {

/// f(u) where f is smooth inside of `smooth` only and defined on that closed interval only.
/// \param derivatives f'(x), f''(x)/2, f'''(x)/6
template <class Derivatives>
Jet composed_within(const Interval& smooth, const Interval& value, const Derivatives& derivatives, const Jet& u) {
  const Interval& x = u.value();
  const bool inside = x.lower > smooth.lower && x.upper < smooth.upper;
  std::array<Interval, 4> f = {value, Interval::whole(), Interval::whole(), Interval::whole()};
  if (inside) {
    const std::array<Interval, 3> d = derivatives(x);
    std::copy(d.begin(), d.end(), f.begin() + 1);
  }
  Jet result = composed(f, u);
  result.partial = x.lower < smooth.lower || x.upper > smooth.upper;
  return made_of(result, u);
}

const Interval positive = {0, Interval::unbounded};

Jet scaled(const Jet& u, const Interval& by) {
  Jet result = u;
  for (Interval& c : result.c) c = c * by;
  return result;
}

/// Of the whole numbers: by repeated multiplication, so that polynomials keep their exact zeros.
Jet power(const Jet& u, int n) {
  if (n == 1) return u;
  const Jet half = power(u, n / 2);
  Jet result = half * half;
  result.c[0] = intersection(result.c[0], square(half.c[0]));
  return n % 2 == 0 ? result : result * u;
}

}  // namespace

Jet sqrt(const Jet& u) {
  const Interval root = sqrt(u.value());
  return composed_within(
      positive, root,
      [&](const Interval& x) {
        return std::array{Interval(0.5L) / root, Interval(-0.125L) / (x * root),
                          Interval(0.0625L) / (square(x) * root)};
      },
      u);
}

Jet exp(const Jet& u) {
  const Interval value = exp(u.value());
  return composed({value, value, value / 2, value / 6}, u);
}

Jet log(const Jet& u) {
  return composed_within(
      positive, log(u.value()),
      [](const Interval& x) {
        return std::array{Interval(1) / x, Interval(-0.5L) / square(x), Interval(1) / (Interval(3) * x * square(x))};
      },
      u);
}
Jet log2(const Jet& u) {
  Jet result = scaled(log(u), Interval(1) / log(Interval(2)));
  result.c[0] = log2(u.value());
  return result;
}
Jet log10(const Jet& u) {
  Jet result = scaled(log(u), Interval(1) / log(Interval(10)));
  result.c[0] = log10(u.value());
  return result;
}

Jet sin(const Jet& u) {
  const Interval s = sin(u.value()), c = cos(u.value());
  return composed({s, c, s / -2, c / -6}, u);
}
Jet cos(const Jet& u) {
  const Interval s = sin(u.value()), c = cos(u.value());
  return composed({c, -s, c / -2, s / 6}, u);
}
Jet tan(const Jet& u) {
  const Interval t = tan(u.value()), w = Interval(1) + square(t);
  if (!t.is_bounded()) return Jet::rough(t);
  return composed({t, w, t * w, w * (Interval(1) + Interval(3) * square(t)) / 3}, u);
}

namespace {

/// Derivatives of a function whose first one is w^(−½), with w = 1 − x² (bend = 1) or 1 + x² (bend = −1), or x² − 1.
std::array<Interval, 3> of_inverse_root(const Interval& x, const Interval& w, int bend, int sign_of_second) {
  const Interval root = sqrt(w);
  return {Interval(1) / root, Interval(sign_of_second) * x / (Interval(2) * w * root),
          (Interval(2) * square(x) + Interval(bend)) / (Interval(6) * square(w) * root)};
}

}  // namespace

Jet asin(const Jet& u) {
  return composed_within(
      {-1, 1}, asin(u.value()),
      [](const Interval& x) { return of_inverse_root(x, (Interval(1) - x) * (Interval(1) + x), 1, 1); }, u);
}
Jet acos(const Jet& u) {
  Jet result = -asin(u);
  result.c[0] = acos(u.value());
  return result;
}
Jet asinh(const Jet& u) {
  const auto d = of_inverse_root(u.value(), Interval(1) + square(u.value()), -1, -1);
  return composed({asinh(u.value()), d[0], d[1], d[2]}, u);
}
Jet acosh(const Jet& u) {
  return composed_within(
      {1, Interval::unbounded}, acosh(u.value()),
      [](const Interval& x) { return of_inverse_root(x, (x - Interval(1)) * (x + Interval(1)), 1, -1); }, u);
}
Jet atanh(const Jet& u) {
  return composed_within(
      {-1, 1}, atanh(u.value()),
      [](const Interval& x) {
        const Interval w = (Interval(1) - x) * (Interval(1) + x);
        return std::array{Interval(1) / w, x / square(w),
                          (Interval(1) + Interval(3) * square(x)) / (Interval(3) * w * square(w))};
      },
      u);
}
Jet atan(const Jet& u) {
  const Interval& x = u.value();
  const Interval w = Interval(1) + square(x);
  return composed({atan(x), Interval(1) / w, -x / square(w),
                   (Interval(3) * square(x) - Interval(1)) / (Interval(3) * w * square(w))},
                  u);
}

Jet atan2(const Jet& y, const Jet& x) {
  const auto least = [](const Interval& u) {
    return u.contains(0) ? 0 : std::min(std::abs(u.lower), std::abs(u.upper));
  };
  const Jet right_angle = {pi() / 2, {}, {}, {}};
  if (x.value().lower > 0 && least(x.value()) >= least(y.value())) return atan(y / x);
  if (y.value().lower > 0) return right_angle - atan(x / y);
  if (y.value().upper < 0) return -right_angle - atan(x / y);
  Jet result = Jet::rough({-pi().upper, pi().upper});
  if (x.value().is_empty() || y.value().is_empty()) result.c[0] = Interval::none();
  return made_of(made_of(result, x), y);
}

Jet sinh(const Jet& u) {
  const Interval s = sinh(u.value()), c = cosh(u.value());
  return composed({s, c, s / 2, c / 6}, u);
}
Jet cosh(const Jet& u) {
  const Interval s = sinh(u.value()), c = cosh(u.value());
  return composed({c, s, c / 2, s / 6}, u);
}
Jet tanh(const Jet& u) {
  const Interval t = tanh(u.value()), w = (Interval(1) - t) * (Interval(1) + t);
  return composed({t, w, -t * w, w * (Interval(3) * square(t) - Interval(1)) / 3}, u);
}

Jet pow(const Jet& u, const Jet& exponent) {
  constexpr int most = 1024;
  if (exponent.is_constant() && exponent.value().is_point() && !exponent.partial) {
    const Real p = exponent.value().lower;
    if (p == 0) return 1;
    if (p == std::floor(p) && std::abs(p) <= most) {
      const int n = static_cast<int>(p);
      return n > 0 ? power(u, n) : Jet(1) / power(u, -n);
    }
    if (p != std::floor(p))
      return composed_within(
          positive, pow(u.value(), p),
          [&](const Interval& x) {
            const Interval first = Interval(p) * pow(x, p) / x, second = first * (Interval(p) - Interval(1)) / x / 2;
            return std::array{first, second, second * (Interval(p) - Interval(2)) / x / 3};
          },
          u);
  }
  if (u.value().lower > 0) return exp(exponent * log(u));
  Jet result = Jet::rough(u.value().is_empty() || exponent.value().is_empty() ? Interval::none() : Interval::whole());
  result.partial = true;
  return result;
}

}  // namespace bracket::scene
