// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "scene/types.h"

namespace bracket::scene {

/// Tables of a segment, triangle or tetrahedron with the vertices x_0 … x_d and det(x_1 − x_0, …, x_d − x_0) > 0 (a
/// triangle counter-clockwise), and of the space it lies in. Facets carry tractions, continuity and contact; edges
/// carry the midpoints of quadratics and are what bisection cuts. Only in the plane are they the same.
template <int d> struct Simplex {
  static_assert(1 <= d && d <= 3);
  static constexpr int n_vertices = d + 1;
  static constexpr int n_facets = d + 1;
  static constexpr int n_edges = d * (d + 1) / 2;
  static constexpr int n_rotations = d * (d - 1) / 2;
  static constexpr int n_rigid_motions = d + n_rotations;

  /// Facet k lies opposite to vertex k. Its vertices, in an order in which its area_vector() points outward.
  static constexpr std::array<std::array<int, d>, n_facets> facets = [] {
    if constexpr (d == 1) return std::array<std::array<int, 1>, 2>{{{1}, {0}}};
    if constexpr (d == 2) return std::array<std::array<int, 2>, 3>{{{1, 2}, {2, 0}, {0, 1}}};
    if constexpr (d == 3) return std::array<std::array<int, 3>, 4>{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  }();

  /// The vertices of each edge; those of a triangle are its facets.
  static constexpr std::array<std::array<int, 2>, n_edges> edges = [] {
    if constexpr (d == 1) return std::array<std::array<int, 2>, 1>{{{0, 1}}};
    if constexpr (d == 2) return facets;
    if constexpr (d == 3) return std::array<std::array<int, 2>, 6>{{{1, 2}, {2, 0}, {0, 1}, {0, 3}, {1, 3}, {2, 3}}};
  }();
  /// The edge that joins two vertices, in either order.
  static constexpr int edge_between(int i, int j) {
    const auto joins = [&](const std::array<int, 2>& edge) {
      return (edge[0] == i && edge[1] == j) || (edge[0] == j && edge[1] == i);
    };
    return static_cast<int>(std::find_if(edges.begin(), edges.end(), joins) - edges.begin());
  }

  /// The components (i, j) of a symmetric tensor in the order of `Voigt`: first the diagonal.
  static constexpr std::array<std::array<int, 2>, n_voigt<d>> voigt = [] {
    if constexpr (d == 1) return std::array<std::array<int, 2>, 1>{{{0, 0}}};
    if constexpr (d == 2) return std::array<std::array<int, 2>, 3>{{{0, 0}, {1, 1}, {0, 1}}};
    if constexpr (d == 3) return std::array<std::array<int, 2>, 6>{{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};
  }();
  /// The planes (i, j) of the rotations: one by the angle 1 displaces x by u_i = −x_j, u_j = x_i.
  static constexpr std::array<std::array<int, 2>, n_rotations> rotations = [] {
    if constexpr (d == 1) return std::array<std::array<int, 2>, 0>{};
    if constexpr (d == 2) return std::array<std::array<int, 2>, 1>{{{0, 1}}};
    if constexpr (d == 3) return std::array<std::array<int, 2>, 3>{{{1, 2}, {2, 0}, {0, 1}}};
  }();

  // Moments are integers, which do not round; each is to be multiplied by the volume and divided by its `of`.

  /// ∫ φ_i φ_j of the hat functions of two vertices.
  static constexpr int hat_masses_of = (d + 1) * (d + 2);
  static constexpr int hat_mass(int i, int j) { return i == j ? 2 : 1; }

  /// Quadratics have the nodes 0 … d at the vertices and d + 1 + e at the middle of edge e, and basis functions ψ_k
  /// that are 1 at node k and 0 at the others.
  static constexpr int n_quadratic = n_vertices + n_edges;
  /// ∫ ψ_k
  static constexpr int quadratic_means_of = (d + 1) * (d + 2);
  static constexpr int quadratic_mean(int k) { return k <= d ? 2 - d : 4; }
  /// ∫ ψ_k φ_i
  static constexpr int quadratic_moments_of = (d + 1) * (d + 2) * (d + 3);
  static constexpr int quadratic_moment(int k, int i) {
    if (k <= d) return k == i ? 6 - 2 * d : 1 - d;
    const auto& [a, b] = edges[k - n_vertices];
    return i == a || i == b ? 8 : 4;
  }
};

/// The normal of a facet, as long as its area. \param x its vertices
template <int dim> Vector<dim> area_vector(const std::array<Vector<dim>, dim>& x) {
  static_assert(dim == 2 || dim == 3);
  const Vector<dim> along = x[1] - x[0];
  if constexpr (dim == 2) return {along[1], -along[0]};
  if constexpr (dim == 3) return 0.5 * along.cross(x[2] - x[0]);
}

/// The volume of a simplex, in the plane its area: positive in the order that Simplex asks for.
template <int dim> double volume(const std::array<Vector<dim>, dim + 1>& x) {
  Eigen::Matrix<double, dim, dim> sides;
  int factorial = 1;
  for (int i = 0; i < dim; ++i) {
    sides.col(i) = x[i + 1] - x[0];
    factorial *= i + 1;
  }
  return sides.determinant() / factorial;
}

/// The gradients of the hat functions of the vertices.
template <int dim> std::array<Vector<dim>, dim + 1> hat_gradients(const std::array<Vector<dim>, dim + 1>& x) {
  const double scaled_volume = dim * volume<dim>(x);
  std::array<Vector<dim>, dim + 1> gradients;
  for (int k = 0; k <= dim; ++k) {
    std::array<Vector<dim>, dim> facet;
    for (int i = 0; i < dim; ++i) facet[i] = x[Simplex<dim>::facets[k][i]];
    gradients[k] = -area_vector<dim>(facet) / scaled_volume;
  }
  return gradients;
}

/// ∫ φ_i f by the volume, for f linear on a simplex. \param f at the vertices
template <class Value, std::size_t n> Value hat_moment(const std::array<Value, n>& f, int i) {
  using Table = Simplex<static_cast<int>(n) - 1>;
  Value sum = Table::hat_mass(i, 0) * f[0];
  for (std::size_t j = 1; j < n; ++j) sum += Table::hat_mass(i, static_cast<int>(j)) * f[j];
  return sum / Table::hat_masses_of;
}

/// ∫ ψ_k f by the volume, for f linear on a simplex and the basis function of the quadratics' node k.
/// \param f at the vertices
template <class Value, std::size_t n> Value quadratic_moment(const std::array<Value, n>& f, int k) {
  using Table = Simplex<static_cast<int>(n) - 1>;
  Value sum = Table::quadratic_moment(k, 0) * f[0];
  for (std::size_t i = 1; i < n; ++i) sum += Table::quadratic_moment(k, static_cast<int>(i)) * f[i];
  return sum / Table::quadratic_moments_of;
}

/// ∫ f g for two functions linear on a simplex, given at its vertices.
template <std::size_t n>
double integral_of_product(const std::array<double, n>& f, const std::array<double, n>& g, double volume) {
  double f_sum = f[0], g_sum = g[0];
  for (std::size_t i = 1; i < n; ++i) {
    f_sum += f[i];
    g_sum += g[i];
  }
  double sum = f_sum * g_sum;
  for (std::size_t i = 0; i < n; ++i) sum += f[i] * g[i];
  return volume / Simplex<static_cast<int>(n) - 1>::hat_masses_of * sum;
}

}  // namespace bracket::scene
