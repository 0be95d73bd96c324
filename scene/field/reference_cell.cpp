// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/field/reference_cell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scene/field/raw_field.h"

namespace bracket::scene {

namespace {

/// One factor after the other of a product, with its derivative.
template <int dim> struct Factor {
  double value;
  Vector<dim> gradient;
};

template <int dim> Factor<dim> operator*(const Factor<dim>& a, const Factor<dim>& b) {
  return {a.value * b.value, a.gradient * b.value + a.value * b.gradient};
}
template <int dim> Factor<dim> operator+(const Factor<dim>& a, const Factor<dim>& b) {
  return {a.value + b.value, a.gradient + b.gradient};
}
template <int dim> Factor<dim> operator*(double s, const Factor<dim>& a) { return {s * a.value, s * a.gradient}; }
template <int dim> Factor<dim> number(double s) { return {s, Vector<dim>::Zero()}; }

template <int dim> void add(Basis<dim>& basis, const Factor<dim>& function) {
  basis.value.push_back(function.value);
  basis.gradient.push_back(function.gradient);
}

template <int dim> Basis<dim> on_simplex(std::size_t nodes, const Vector<dim>& at) {
  std::array<Factor<dim>, dim + 1> hat;
  hat[0] = {1 - at.sum(), -Vector<dim>::Ones()};
  for (int k = 0; k < dim; ++k) hat[k + 1] = {at[k], Vector<dim>::Unit(k)};
  const bool quadratic = nodes > hat.size();
  Basis<dim> basis;
  for (const auto& h : hat) add(basis, quadratic ? h * (2. * h + number<dim>(-1)) : h);
  if (quadratic)
    for (const auto& [a, b] : edges_in_files<dim>()) add(basis, 4. * hat[a] * hat[b]);
  return basis;
}

constexpr std::array<std::array<int, 2>, 9> places_on_square = {
    {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}}};

Basis<2> on_square(std::size_t nodes, const Vector<2>& at) {
  const std::array<Factor<2>, 2> x = {Factor<2>{at[0], {1, 0}}, {at[1], {0, 1}}};
  Basis<2> basis;
  for (std::size_t k = 0; k < nodes; ++k) {
    Factor<2> product = number<2>(1), sum = number<2>(-1);
    for (int c = 0; c < 2; ++c) {
      const int place = places_on_square[k][c];
      const double sign = place;
      const Factor<2> linear = 0.5 * (number<2>(1) + sign * x[c]);
      const Factor<2> bubble = number<2>(1) + -1. * x[c] * x[c];
      sum = sum + sign * x[c];
      if (place == 0)
        product = product * bubble;
      else
        product = product * (nodes == 9 ? linear * (sign * x[c]) : linear);
    }
    add(basis, nodes == 8 && k < 4 ? product * sum : product);
  }
  return basis;
}

Vector<2> middle_of(int corners) { return corners == 3 ? Vector<2>(1. / 3, 1. / 3) : Vector<2>(0, 0); }

}  // namespace

Basis<2> basis_at(int corners, std::size_t nodes, const Vector<2>& reference) {
  return corners == 3 ? on_simplex<2>(nodes, reference) : on_square(nodes, reference);
}
Basis<3> basis_at(int, std::size_t nodes, const Vector<3>& reference) { return on_simplex<3>(nodes, reference); }

// Newton's method from the middle: exact after one step where the sides are straight and nodes in their middles.
std::optional<Vector<2>> reference_point(int corners, const std::vector<Vector<2>>& nodes, const Vector<2>& x) {
  Vector<2> at = middle_of(corners);
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < 50; ++step) {
    const Basis<2> basis = basis_at(corners, nodes.size(), at);
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

std::optional<Vector<3>> reference_point(int, const std::vector<Vector<3>>& nodes, const Vector<3>& x) {
  Eigen::Matrix3d sides;
  for (int k = 0; k < 3; ++k) sides.col(k) = nodes[k + 1] - nodes[0];
  if (sides.determinant() == 0) return {};
  const Vector<3> at = sides.inverse() * (x - nodes[0]);
  if (!(at.norm() < 1e3)) return {};
  return at;
}

bool is_inside(int, const Vector<3>& reference) { return reference.minCoeff() >= 0 && reference.sum() <= 1; }
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

namespace {

double distance_from_segment(const Vector<3>& a, const Vector<3>& b, const Vector<3>& x) {
  const Vector<3> along = b - a;
  return (a + std::clamp((x - a).dot(along) / along.squaredNorm(), 0., 1.) * along - x).norm();
}

double distance_from_triangle(const std::array<Vector<3>, 3>& corner, const Vector<3>& x) {
  const auto& [a, b, c] = corner;
  const Vector<3> normal = (b - a).cross(c - a);
  const double squared = normal.squaredNorm();
  const double second = normal.dot((x - a).cross(c - a)) / squared, third = normal.dot((b - a).cross(x - a)) / squared;
  if (second >= 0 && third >= 0 && second + third <= 1) return std::abs(normal.dot(x - a)) / std::sqrt(squared);
  return std::min({distance_from_segment(a, b, x), distance_from_segment(b, c, x), distance_from_segment(c, a, x)});
}

}  // namespace

double distance_from_sides(int, const std::vector<Vector<3>>& nodes, const Vector<3>& x) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : Simplex<3>::facets)
    least = std::min(least, distance_from_triangle({nodes[a], nodes[b], nodes[c]}, x));
  return least;
}

}  // namespace bracket::scene
