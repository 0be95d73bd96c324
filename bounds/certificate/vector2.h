// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "scene/enclosure.h"
#include "scene/problem/problem.h"

/// Vectors of the plane over any kind of number, for what is computed in enclosures, and exactly in the tests.
namespace bracket::bounds {

using scene::Enclosure;
using scene::LongSum;

inline double root(double x) { return std::sqrt(x); }

template <class Number> struct Vector2 { Number x = Number(0), y = Number(0); };

template <class Number> Vector2<Number> vector2(const scene::Vector<2>& v) { return {Number(v[0]), Number(v[1])}; }
template <class Number> Vector2<Number> vector2(const scene::TwofoldVector<2>& v) {
  return {Number(v.value[0]) + Number(v.rest[0]), Number(v.value[1]) + Number(v.rest[1])};
}
/// The same vector with another kind of number.
template <class To, class From> Vector2<To> as(const Vector2<From>& v) { return {To(v.x), To(v.y)}; }
/// The vector from a to b: exact, or with the rounding of one subtraction.
template <class Number> Vector2<Number> between(const scene::Vector<2>& a, const scene::Vector<2>& b) {
  return vector2<Number>(b) - vector2<Number>(a);
}

template <class Number> Vector2<Number> operator+(const Vector2<Number>& a, const Vector2<Number>& b) {
  return {a.x + b.x, a.y + b.y};
}
template <class Number> Vector2<Number> operator-(const Vector2<Number>& a, const Vector2<Number>& b) {
  return {a.x - b.x, a.y - b.y};
}
template <class Number> Vector2<Number> operator-(const Vector2<Number>& a) { return {-a.x, -a.y}; }
template <class Number> Vector2<Number> operator*(const Number& s, const Vector2<Number>& a) {
  return {s * a.x, s * a.y};
}
template <class Number> Number dot(const Vector2<Number>& a, const Vector2<Number>& b) { return a.x * b.x + a.y * b.y; }
template <class Number> Number cross(const Vector2<Number>& a, const Vector2<Number>& b) {
  return a.x * b.y - a.y * b.x;
}
/// a turned by 90° counter-clockwise.
template <class Number> Vector2<Number> turned(const Vector2<Number>& a) { return {-a.y, a.x}; }

/// ∫ a b over (0, 1) of two functions linear there, given at the ends.
template <class Number> Number linear_product(const Number& a0, const Number& a1, const Number& b0, const Number& b1) {
  return (a0 * (b0 + b0 + b1) + a1 * (b0 + b1 + b1)) / Number(6);
}
template <class Number>
Number linear_product(const std::array<Vector2<Number>, 2>& a, const std::array<Vector2<Number>, 2>& b) {
  return linear_product(a[0].x, a[1].x, b[0].x, b[1].x) + linear_product(a[0].y, a[1].y, b[0].y, b[1].y);
}

}  // namespace bracket::bounds
