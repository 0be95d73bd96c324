// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "scene/balanced_block.h"
#include "scene/enclosure.h"
#include "scene/problem/problem.h"

/// The certificate in space: what the folder above does in the plane, for tetrahedra. Vectors over any kind of number,
/// for what is computed in enclosures, and exactly in the tests.
namespace bracket::bounds::space {

using scene::Enclosure;
using scene::LongSum;

inline double root(double x) { return std::sqrt(x); }
inline double rounded(const Enclosure& x) { return static_cast<double>(x.middle); }
inline double rounded(double x) { return x; }

template <class Number> using Vector3 = scene::VectorOf<3, Number>;

template <class Number> Vector3<Number> vector3(const scene::Vector<3>& v) {
  return {Number(v[0]), Number(v[1]), Number(v[2])};
}

template <class Number> Vector3<Number> vector3(const scene::TwofoldVector<3>& v) {
  Vector3<Number> sum;
  for (int k = 0; k < 3; ++k) sum[k] = Number(v.value[k]) + Number(v.rest[k]);
  return sum;
}

template <class Number> Vector3<Number> operator+(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class Number> Vector3<Number> operator-(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class Number> Vector3<Number> operator-(const Vector3<Number>& a) { return {-a[0], -a[1], -a[2]}; }
template <class Number> Vector3<Number> operator*(const Number& s, const Vector3<Number>& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
template <class Number> Number dot(const Vector3<Number>& a, const Vector3<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Number> Vector3<Number> cross(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The vector from a to b: exact, or with the rounding of one subtraction.
template <class Number> Vector3<Number> between(const scene::Vector<3>& a, const scene::Vector<3>& b) {
  return vector3<Number>(b) - vector3<Number>(a);
}

/// Values at the three vertices of a facet, linear between.
template <class Number> using FacetVectors = std::array<Vector3<Number>, 3>;

template <class Number> Vector3<Number> sum(const FacetVectors<Number>& v) { return v[0] + v[1] + v[2]; }

/// The mean over a facet of the product of two functions linear there.
template <class Number> Number mean_product(const std::array<Number, 3>& a, const std::array<Number, 3>& b) {
  const Number own = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  return (own + (a[0] + a[1] + a[2]) * (b[0] + b[1] + b[2])) / Number(12);
}
template <class Number> Number mean_product(const FacetVectors<Number>& a, const FacetVectors<Number>& b) {
  const Number own = dot(a[0], b[0]) + dot(a[1], b[1]) + dot(a[2], b[2]);
  return (own + dot(sum(a), sum(b))) / Number(12);
}

/// The moments of a facet's six quadratic Bernstein polynomials, as FacetQuadratic has them, with a linear function:
/// ∫ f B_k by the area.
template <class Number, class Value> std::array<Value, 6> bernstein_moments(const std::array<Value, 3>& f) {
  const Number one30 = Number(1) / Number(30);
  const Value all = f[0] + f[1] + f[2];
  std::array<Value, 6> result;
  for (int k = 0; k < 3; ++k) result[k] = one30 * (all + f[k] + f[k]);  // ∫ φ_i φ_k² is 1/30, 1/10 for i = k
  for (int e = 0; e < 3; ++e) {                                         // 2 φ_a φ_b: 1/15, 1/30 for the third
    const auto& [a, b] = scene::Simplex<2>::edges[e];
    result[3 + e] = one30 * (all + f[a] + f[b]);
  }
  return result;
}
/// ∫ f g by the area, f linear, g by its Bernstein coefficients.
template <class Number> Number bernstein_product(const std::array<Number, 3>& f, const std::array<Number, 6>& g) {
  const auto moments = bernstein_moments<Number>(f);
  Number result(0);
  for (int k = 0; k < 6; ++k) result += moments[k] * g[k];
  return result;
}

}  // namespace bracket::bounds::space
