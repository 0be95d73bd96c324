// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: functions on an edge that is a facet, by its parameter: 0 at vertex 0, 1 at vertex 1.
#pragma once

#include <array>

namespace bracket::scene {

/// a + t (b − a), exact at both ends.
template <class Value> Value between_ends(const Value& a, const Value& b, double t) {
  if (t == 0) return a;
  if (t == 1) return b;
  return a + t * (b - a);
}
template <class Value> Value between_ends(const std::array<Value, 2>& ends, double t) {
  return between_ends(ends[0], ends[1], t);
}

/// The Bernstein coefficients of a quadratic on the stretch [from, to] of its edge, by those on the whole: its blossom.
template <class Number> std::array<Number, 3> on_stretch(const std::array<Number, 3>& whole, double from, double to) {
  const auto blossom = [&](double s, double t) {
    return between_ends(between_ends(whole[0], whole[1], s), between_ends(whole[1], whole[2], s), t);
  };
  return {blossom(from, from), blossom(from, to), blossom(to, to)};
}

/// A polynomial of degree 3 on an edge.
template <class Value> struct EdgeCubic {
  std::array<Value, 2> linear;  ///< the values at the ends of the linear function to which the rest is orthogonal
  std::array<Value, 2> higher;  ///< the coefficients of P_2 = 6 t² − 6 t + 1 and P_3 = (2 t − 1)(10 t² − 10 t + 1)
};
template <class Number> Number legendre_2(const Number& t) { return Number(6) * t * (t - Number(1)) + Number(1); }
template <class Number> Number legendre_3(const Number& t) {
  return (Number(2) * t - Number(1)) * (Number(10) * t * (t - Number(1)) + Number(1));
}

template <class Value> Value value_at(const EdgeCubic<Value>& f, double t) {
  return between_ends(f.linear, t) + (legendre_2(t) * f.higher[0] + legendre_3(t) * f.higher[1]);
}

/// A quadratic by its Bernstein coefficients. Its P_2 has a sixth of the second difference.
inline EdgeCubic<double> cubic_of(const std::array<double, 3>& quadratic) {
  const double sixth = ((quadratic[0] - quadratic[1]) + (quadratic[2] - quadratic[1])) / 6;
  return {{quadratic[0] - sixth, quadratic[2] - sixth}, {sixth, 0}};
}

/// A cubic on the stretch [from, to] of its edge, of which P_2 and P_3 have linear parts: by comparison of the
/// coefficients of t³ and t², and of values at the ends.
template <class Number, class Value>
EdgeCubic<Value> on_stretch(const EdgeCubic<Value>& whole, double from, double to) {
  if (from == 0 && to == 1) return whole;
  const Number a(from), b(to), width = b - a, square = width * width, cube = square * width;
  const Number skew = Number(5) * (a + b - Number(1)) * square;
  const auto& [second, third] = whole.higher;
  const auto sum = [&](const Number& x, const Number& y) { return Value(x * second + y * third); };
  const Value at_from = between_ends(whole.linear, from), at_to = between_ends(whole.linear, to);
  return {{Value(at_from + sum(legendre_2(a) - square, legendre_3(a) - skew + cube)),
           Value(at_to + sum(legendre_2(b) - square, legendre_3(b) - skew - cube))},
          {sum(square, skew), Value(cube * third)}};
}

}  // namespace bracket::scene
