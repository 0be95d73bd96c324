// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/field/reference_cell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bracket::scene {

namespace {

/// One factor after the other of a product, with its derivative.
struct Factor {
  double value;
  Vector<2> gradient;
};

Factor operator*(const Factor& a, const Factor& b) {
  return {a.value * b.value, a.gradient * b.value + a.value * b.gradient};
}
Factor operator+(const Factor& a, const Factor& b) { return {a.value + b.value, a.gradient + b.gradient}; }
Factor operator*(double s, const Factor& a) { return {s * a.value, s * a.gradient}; }
Factor number(double s) { return {s, Vector<2>::Zero()}; }

void add(Basis& basis, const Factor& function) {
  basis.value.push_back(function.value);
  basis.gradient.push_back(function.gradient);
}

Basis on_triangle(std::size_t nodes, const Vector<2>& at) {
  const std::array<Factor, 3> hat = {Factor{1 - at[0] - at[1], {-1, -1}}, {at[0], {1, 0}}, {at[1], {0, 1}}};
  Basis basis;
  for (const Factor& h : hat) add(basis, nodes == 3 ? h : h * (2 * h + number(-1)));
  if (nodes == 6)
    for (int k = 0; k < 3; ++k) add(basis, 4 * hat[k] * hat[(k + 1) % 3]);
  return basis;
}

constexpr std::array<std::array<int, 2>, 9> places_on_square = {
    {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}}};

Basis on_square(std::size_t nodes, const Vector<2>& at) {
  const std::array<Factor, 2> x = {Factor{at[0], {1, 0}}, {at[1], {0, 1}}};
  Basis basis;
  for (std::size_t k = 0; k < nodes; ++k) {
    Factor product = number(1), sum = number(-1);
    for (int c = 0; c < 2; ++c) {
      const int place = places_on_square[k][c];
      const Factor linear = 0.5 * (number(1) + place * x[c]);
      const Factor bubble = number(1) + -1 * x[c] * x[c];
      sum = sum + place * x[c];
      if (place == 0)
        product = product * bubble;
      else
        product = product * (nodes == 9 ? linear * (place * x[c]) : linear);
    }
    add(basis, nodes == 8 && k < 4 ? product * sum : product);
  }
  return basis;
}

Vector<2> middle_of(int corners) { return corners == 3 ? Vector<2>(1. / 3, 1. / 3) : Vector<2>(0, 0); }

}  // namespace

Basis basis_at(int corners, std::size_t nodes, const Vector<2>& reference) {
  return corners == 3 ? on_triangle(nodes, reference) : on_square(nodes, reference);
}

// Newton's method from the middle: exact after one step where the sides are straight and nodes in their middles.
std::optional<Vector<2>> reference_point(int corners, const std::vector<Vector<2>>& nodes, const Vector<2>& x) {
  Vector<2> at = middle_of(corners);
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < 50; ++step) {
    const Basis basis = basis_at(corners, nodes.size(), at);
    Vector<2> left = x;
    Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero();
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      left -= basis.value[k] * nodes[k];
      jacobian += nodes[k] * basis.gradient[k].transpose();
    }
    const double determinant = jacobian.determinant();
    if (determinant == 0) return {};
    const Vector<2> by = jacobian.inverse() * left;
    const double length = by.norm();
    if (!(length < 1e3)) return {};
    at += by;
    // Quadratic convergence ends where rounding begins: the step is no longer smaller than the one before.
    if (length < 1e-8 && length >= last / 2) return at;
    if (length == 0) return at;
    last = length;
  }
  return {};
}

bool is_inside(int corners, const Vector<2>& reference) {
  if (corners == 4) return reference.cwiseAbs().maxCoeff() <= 1;
  return reference[0] >= 0 && reference[1] >= 0 && reference[0] + reference[1] <= 1;
}

double distance_from_sides(int corners, const std::vector<Vector<2>>& nodes, const Vector<2>& x) {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < corners; ++k) {
    const Vector<2>&a = nodes[k], &b = nodes[(k + 1) % corners];
    const bool second_order = nodes.size() > static_cast<std::size_t>(corners);
    // The side is a + t (b − a) + t (1 − t) bulge.
    const Vector<2> bulge = second_order ? Vector<2>(4 * nodes[corners + k] - 2 * (a + b)) : Vector<2>(0, 0);
    const auto from_side = [&](double t) { return Vector<2>(a + t * (b - a) + t * (1 - t) * bulge - x); };
    double t = std::clamp((x - a).dot(b - a) / (b - a).squaredNorm(), 0., 1.);
    for (int step = 0; step < 10; ++step) {  // towards the foot of the perpendicular, by Gauss and Newton
      const Vector<2> along = b - a + (1 - 2 * t) * bulge;
      if (along.squaredNorm() > 0) t = std::clamp(t - from_side(t).dot(along) / along.squaredNorm(), 0., 1.);
    }
    least = std::min(least, from_side(t).norm());
  }
  return least;
}

}  // namespace bracket::scene
