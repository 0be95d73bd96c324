// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

/// Polynomials by their Bernstein coefficients, over any kind of number and value. On a segment coefficient k belongs
/// to n!/(k! (n−k)!) (1−t)^(n−k) t^k; on a triangle those of a degree are ordered by i_2, then by i_1 (they belong to
/// n!/(i_0! i_1! i_2!) φ_0^i_0 φ_1^i_1 φ_2^i_2): so the first n + 1 are those of the side from corner 0 to corner 1. On
/// a tetrahedron they are ordered by i_3, then as on a triangle: the first are those of the corners 0, 1, 2.
namespace bracket::scene {

/// How many there are on a simplex of dimension d.
template <int d = 2> constexpr int n_bernstein(int degree) {
  static_assert(1 <= d && d <= 3);
  if constexpr (d == 1) return degree + 1;
  if constexpr (d == 2) return (degree + 1) * (degree + 2) / 2;
  if constexpr (d == 3) return (degree + 1) * (degree + 2) * (degree + 3) / 6;
}

/// The place of the coefficient (degree − i_1 − i_2, i_1, i_2).
constexpr int bernstein_place(int degree, int i1, int i2) { return i2 * (2 * degree + 3 - i2) / 2 + i1; }

/// All (i_0, …, i_d) with this sum, in their order, on a triangle or a tetrahedron.
/// \param degree up to 6: twice that of stresses; on a tetrahedron up to 2
template <int d = 2> const std::vector<std::array<int, d + 1>>& bernstein_indices(int degree);
template <> const std::vector<std::array<int, 3>>& bernstein_indices<2>(int degree);
template <> const std::vector<std::array<int, 4>>& bernstein_indices<3>(int degree);
inline int bernstein_place(const std::array<int, 3>& i) { return bernstein_place(i[0] + i[1] + i[2], i[1], i[2]); }
inline int bernstein_place(const std::array<int, 4>& i) {
  const int degree = i[0] + i[1] + i[2];  // of the layer
  return n_bernstein<3>(degree + i[3]) - n_bernstein<3>(degree) + bernstein_place(degree, i[1], i[2]);
}

constexpr int binomial(int n, int k) {
  int result = 1;
  for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

/// n! / (i_0! i_1! i_2!), n their sum.
constexpr int trinomial(const std::array<int, 3>& i) {
  return binomial(i[0] + i[1] + i[2], i[0]) * binomial(i[1] + i[2], i[1]);
}
/// n! / (i_0! i_1! i_2! i_3!)
constexpr int quadrinomial(const std::array<int, 4>& i) {
  return binomial(i[0] + i[1] + i[2] + i[3], i[0]) * trinomial({i[1], i[2], i[3]});
}

/// v · part / whole, without rounding where that is v.
template <class Number, class Value> Value share(const Value& v, int part, int whole) {
  return part == whole ? v : Value((Number(part) / Number(whole)) * v);
}

/// A linear function's coefficient k on a segment, by its values at the ends.
template <class Number, class Value> Value linear_coefficient(const Value& at0, const Value& at1, int degree, int k) {
  if (k == 0) return at0;
  if (k == degree) return at1;
  return Value(share<Number>(at0, degree - k, degree) + share<Number>(at1, k, degree));
}

/// The same function of a segment, one degree higher.
template <class Number, class Value> std::vector<Value> raised(const std::vector<Value>& c) {
  const int degree = static_cast<int>(c.size());  // the new one
  std::vector<Value> result = {c.front()};
  for (int k = 1; k < degree; ++k) result.push_back(linear_coefficient<Number, Value>(c[k], c[k - 1], degree, k));
  result.push_back(c.back());
  return result;
}
template <class Number, class Value> std::vector<Value> raised_to(int degree, std::vector<Value> c) {
  while (static_cast<int>(c.size()) <= degree) c = raised<Number>(c);
  return c;
}

/// ∫ over the segment's parameter of coefficient i of one degree with k of another: part / whole.
struct Fraction {
  int part, whole;
};
constexpr Fraction bernstein_mass(int degree_of_i, int i, int degree_of_k, int k) {
  const int sum = degree_of_i + degree_of_k;
  return {binomial(degree_of_i, i) * binomial(degree_of_k, k), binomial(sum, i + k) * (sum + 1)};
}
/// Legendre's polynomial P_k on the segment (P_k(1) = 1), by its coefficient i of degree k.
constexpr int legendre_coefficient(int k, int i) { return ((k - i) % 2 == 0 ? 1 : -1) * binomial(k, i); }
template <class Number> Number number(const Fraction& f) { return Number(f.part) / Number(f.whole); }
/// ∫ of coefficient i of a degree with P_k: 0 where k is larger.
template <class Number> Number legendre_moment(int degree, int i, int k) {
  Number sum(0);
  for (int j = 0; k <= degree && j <= k; ++j)
    sum += Number(legendre_coefficient(k, j)) * number<Number>(bernstein_mass(degree, i, k, j));
  return sum;
}

/// ∫ f g over the segment's parameter.
template <class Number> Number bernstein_product(std::span<const Number> f, std::span<const Number> g) {
  const int m = static_cast<int>(f.size()) - 1, n = static_cast<int>(g.size()) - 1;
  Number sum(0);
  for (int i = 0; i <= m; ++i)
    for (int k = 0; k <= n; ++k) sum += number<Number>(bernstein_mass(m, i, n, k)) * (f[i] * g[k]);
  return sum;
}
template <class Number> Number bernstein_product(const std::vector<Number>& f, const std::vector<Number>& g) {
  return bernstein_product<Number>(std::span<const Number>(f), std::span<const Number>(g));
}

/// f g on the segment, of the sum of their degrees.
template <class Number>
std::vector<Number> bernstein_times(const std::vector<Number>& f, const std::vector<Number>& g) {
  const int m = static_cast<int>(f.size()) - 1, n = static_cast<int>(g.size()) - 1;
  std::vector<Number> result(m + n + 1, Number(0));
  for (int i = 0; i <= m; ++i)
    for (int k = 0; k <= n; ++k)
      result[i + k] += share<Number>(f[i] * g[k], binomial(m, i) * binomial(n, k), binomial(m + n, i + k));
  return result;
}

/// The same function of each half of the segment.
template <class Number> std::array<std::vector<Number>, 2> halves(std::vector<Number> c) {
  const std::size_t n = c.size();
  std::array<std::vector<Number>, 2> result = {c, c};
  for (std::size_t left = n; left-- > 0;) {
    result[0][n - 1 - left] = c[0];
    result[1][left] = c[left];
    for (std::size_t k = 0; k < left; ++k) c[k] = (c[k] + c[k + 1]) / Number(2);
  }
  return result;
}

/// The value at t of a function on the segment.
template <class Value> Value value_on_segment(std::vector<Value> c, double t) {
  for (std::size_t n = c.size() - 1; n > 0; --n)
    for (std::size_t k = 0; k < n; ++k) c[k] = (1 - t) * c[k] + t * c[k + 1];
  return c.front();
}

/// One step of de Casteljau's on a triangle, at a point by its barycentric coordinates: to degree n, from n + 1.
template <class Number, class Value>
void step_of_de_casteljau(std::vector<Value>& c, int n, const std::array<Number, 3>& point) {
  for (int i2 = 0; i2 <= n; ++i2)
    for (int i1 = 0; i1 + i2 <= n; ++i1)
      c[bernstein_place(n, i1, i2)] = point[0] * c[bernstein_place(n + 1, i1, i2)] +
                                      point[1] * c[bernstein_place(n + 1, i1 + 1, i2)] +
                                      point[2] * c[bernstein_place(n + 1, i1, i2 + 1)];
}

/// The value of a function on a triangle at a point, by its barycentric coordinates.
template <class Value> Value value_on_triangle(std::vector<Value> c, int degree, const std::array<double, 3>& point) {
  for (int n = degree - 1; n >= 0; --n) step_of_de_casteljau(c, n, point);
  return c.front();
}

/// The values of a degree's Bernstein polynomials at a point of a triangle, by its barycentric coordinates.
inline std::vector<double> bernstein_values(int degree, const std::array<double, 3>& point) {
  std::vector<double> values;
  for (const auto& i : bernstein_indices(degree)) {
    double value = trinomial(i);
    for (int corner = 0; corner < 3; ++corner)
      for (int k = 0; k < i[corner]; ++k) value *= point[corner];
    values.push_back(value);
  }
  return values;
}

/// The same function of a triangle, one degree higher.
template <class Number, class Value> std::vector<Value> raised_on_triangle(const std::vector<Value>& c, int degree) {
  std::vector<Value> result;
  for (const auto& i : bernstein_indices(degree + 1)) {
    Value sum{};
    bool first = true;
    for (int corner = 0; corner < 3; ++corner) {
      if (i[corner] == 0) continue;
      std::array<int, 3> below = i;
      --below[corner];
      const Value part = share<Number, Value>(c[bernstein_place(below)], i[corner], degree + 1);
      sum = first ? part : Value(sum + part);
      first = false;
    }
    result.push_back(sum);
  }
  return result;
}

/// The function on the part of a triangle between the side opposite to a corner and the centroid. The part's corners
/// are those after it, in their order, and the centroid.
template <class Number, class Value>
std::vector<Value> on_centroid_part(std::vector<Value> c, int degree, int opposite) {
  // Each step of de Casteljau's at the centroid makes one of the corners that a coefficient counts the new one.
  std::vector<Value> result(c.size());
  const auto take = [&](int step) {  // what counts the centroid so often, and the corner not at all
    for (int i = 0; i <= degree - step; ++i) {
      std::array<int, 3> from = {0, 0, 0};
      from[(opposite + 1) % 3] = degree - step - i;
      from[(opposite + 2) % 3] = i;
      result[bernstein_place(degree, i, step)] = c[bernstein_place(from)];
    }
  };
  take(0);
  for (int step = 1; step <= degree; ++step) {
    std::vector<Value> means;
    for (const auto& i : bernstein_indices(degree - step)) {
      std::array<std::array<int, 3>, 3> above = {i, i, i};
      for (int corner = 0; corner < 3; ++corner) ++above[corner][corner];
      const Value sum =
          Value(c[bernstein_place(above[0])] + c[bernstein_place(above[1])] + c[bernstein_place(above[2])]);
      means.push_back(share<Number, Value>(sum, 1, 3));
    }
    c = std::move(means);
    take(step);
  }
  return result;
}

/// The function on another triangle, given its corners in barycentric coordinates of this one.
template <class Number, class Value>
std::vector<Value> on_triangle(const std::vector<Value>& c, int degree,
                               const std::array<std::array<Number, 3>, 3>& corners) {
  std::vector<Value> result;
  for (const auto& of : bernstein_indices(degree)) {  // the polar form at each corner as often as its index says
    std::vector<Value> values = c;
    int n = degree;
    for (int corner = 0; corner < 3; ++corner)
      for (int step = 0; step < of[corner]; ++step) step_of_de_casteljau(values, --n, corners[corner]);
    result.push_back(values.front());
  }
  return result;
}

/// The mean over a triangle of the product of two of its Bernstein polynomials of a degree.
constexpr Fraction bernstein_mean(const std::array<int, 3>& i, const std::array<int, 3>& k) {
  const int degree = i[0] + i[1] + i[2];
  return {trinomial(i) * trinomial(k),
          trinomial({i[0] + k[0], i[1] + k[1], i[2] + k[2]}) * (2 * degree + 1) * (degree + 1)};
}

/// The mean of f² over a triangle is a sum of squares: Σ (Σ_i coefficient_i f_i)² / divisor, exactly (the mass matrix
/// is L D Lᵀ).
template <int degree> struct Square {
  int divisor;
  std::array<int, n_bernstein(degree)> coefficient;
};
template <int degree> inline constexpr std::array<Square<degree>, 0> squares{};
template <> inline constexpr std::array<Square<0>, 1> squares<0> = {{{1, {1}}}};
template <> inline constexpr std::array<Square<1>, 3> squares<1> = {{{24, {2, 1, 1}}, {72, {0, 3, 1}}, {9, {0, 0, 1}}}};
template <>
inline constexpr std::array<Square<2>, 6> squares<2> = {{{540, {6, 3, 1, 3, 1, 1}},
                                                         {900, {0, 5, 5, 1, 3, 1}},
                                                         {2700, {0, 0, 10, 0, 4, 1}},
                                                         {150, {0, 0, 0, 2, 1, 2}},
                                                         {450, {0, 0, 0, 0, 3, 2}},
                                                         {36, {0, 0, 0, 0, 0, 1}}}};
template <>
inline constexpr std::array<Square<3>, 10> squares<3> = {{{11200, {20, 10, 4, 1, 10, 4, 1, 4, 1, 1}},
                                                          {15680, {0, 14, 14, 7, 2, 8, 5, 2, 3, 1}},
                                                          {235200, {0, 0, 42, 63, 0, 12, 33, 2, 13, 3}},
                                                          {78400, {0, 0, 0, 35, 0, 0, 15, 0, 5, 1}},
                                                          {2940, {0, 0, 0, 0, 6, 3, 1, 6, 2, 3}},
                                                          {4900, {0, 0, 0, 0, 0, 5, 5, 2, 6, 3}},
                                                          {14700, {0, 0, 0, 0, 0, 0, 10, 0, 8, 3}},
                                                          {600, {0, 0, 0, 0, 0, 0, 0, 2, 1, 3}},
                                                          {200, {0, 0, 0, 0, 0, 0, 0, 0, 1, 1}},
                                                          {100, {0, 0, 0, 0, 0, 0, 0, 0, 0, 1}}}};

template <class Value> Value zero_value() {
  if constexpr (requires { Value::Zero(); })
    return Value::Zero();
  else
    return Value{};
}
template <class Value> void add_multiple(Value& sum, int factor, const Value& v) { sum += factor * v; }
template <class Number, std::size_t n>
void add_multiple(std::array<Number, n>& sum, int factor, const std::array<Number, n>& v) {
  for (std::size_t i = 0; i < n; ++i) sum[i] += factor == 1 ? v[i] : Number(factor) * v[i];
}

/// 1 / divisor of each.
template <class Number, int degree> const std::array<Number, n_bernstein(degree)>& weights_of_squares() {
  static const std::array<Number, n_bernstein(degree)> weights = [] {
    std::array<Number, n_bernstein(degree)> result;
    for (int i = 0; i < n_bernstein(degree); ++i) result[i] = Number(1) / Number(squares<degree>[i].divisor);
    return result;
  }();
  return weights;
}

/// The mean over a triangle of a quadratic form of a polynomial, given by its coefficients.
template <class Number, int degree, class Value, class Form>
Number mean_of_squares(const Form& form, std::span<const Value> c) {
  Number sum(0);
  const auto& weights = weights_of_squares<Number, degree>();
  for (int k = 0; k < n_bernstein(degree); ++k) {
    Value combined = zero_value<Value>();
    for (int i = k; i < n_bernstein(degree); ++i)
      if (const int factor = squares<degree>[k].coefficient[i]; factor != 0) add_multiple(combined, factor, c[i]);
    sum += weights[k] * form(combined);
  }
  return sum;
}
template <class Number, class Value, class Form> Number mean_of_squares(const Form& form, std::span<const Value> c) {
  switch (c.size()) {
    case n_bernstein(0): return mean_of_squares<Number, 0>(form, c);
    case n_bernstein(1): return mean_of_squares<Number, 1>(form, c);
    case n_bernstein(2): return mean_of_squares<Number, 2>(form, c);
    default: return mean_of_squares<Number, 3>(form, c);
  }
}

}  // namespace bracket::scene
