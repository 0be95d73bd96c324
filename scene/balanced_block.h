// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "scene/mesh/simplex.h"

/// The block element in closed form (docs/theory.md §12): from the loads on the facets of a triangle or tetrahedron,
/// linear on each, the one stress that is linear on the parts of the cell, symmetric, with continuous tractions inside,
/// div λ = −F, and has them. Over any kind of number.
namespace bracket::scene {

template <int dim, class Number> using VectorOf = std::array<Number, dim>;
/// A symmetric tensor, in the order of Simplex::voigt.
template <int dim, class Number> using TensorOf = std::array<Number, n_voigt<dim>>;

/// [i][k]: load density times length or area at vertex Simplex::facets[i][k] of facet i, from outside on the cell.
template <int dim, class Number> using FacetLoads = std::array<std::array<VectorOf<dim, Number>, dim>, dim + 1>;

/// [i][k]: the stress of part i at the vertices of its facet i, as Simplex::facets has them, and, k = dim, at the
/// centroid: Stress::cell.
template <int dim, class Number> using BalancedStress = std::array<std::array<TensorOf<dim, Number>, dim + 1>, dim + 1>;

/// What is the same for all loads on a cell.
template <int dim, class Number> struct BlockGeometry {
  std::array<VectorOf<dim, Number>, dim + 1> x;         ///< its vertices, from any origin
  std::array<VectorOf<dim, Number>, dim + 1> gradient;  ///< G_i of the hat functions
  Number scaled_volume;                                 ///< dim! times its volume, positive
};

namespace block {
template <int dim, class Number>
VectorOf<dim, Number> minus(const VectorOf<dim, Number>& a, const VectorOf<dim, Number>& b) {
  VectorOf<dim, Number> result;
  for (int k = 0; k < dim; ++k) result[k] = a[k] - b[k];
  return result;
}
template <int dim, class Number> Number dot(const VectorOf<dim, Number>& a, const VectorOf<dim, Number>& b) {
  Number sum = a[0] * b[0];
  for (int k = 1; k < dim; ++k) sum += a[k] * b[k];
  return sum;
}
template <class Number> VectorOf<3, Number> cross(const VectorOf<3, Number>& a, const VectorOf<3, Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// t v
template <int dim, class Number>
VectorOf<dim, Number> times(const TensorOf<dim, Number>& t, const VectorOf<dim, Number>& v) {
  VectorOf<dim, Number> result;
  for (int i = 0; i < dim; ++i) result[i] = t[i] * v[i];
  for (int k = dim; k < n_voigt<dim>; ++k) {
    const auto [i, j] = Simplex<dim>::voigt[k];
    result[i] += t[k] * v[j];
    result[j] += t[k] * v[i];
  }
  return result;
}
/// Adds s (a ⊗ b + b ⊗ a).
template <int dim, class Number>
void add(TensorOf<dim, Number>& t, const Number& s, const VectorOf<dim, Number>& a, const VectorOf<dim, Number>& b) {
  for (int k = 0; k < n_voigt<dim>; ++k) {
    const auto [i, j] = Simplex<dim>::voigt[k];
    t[k] += s * (a[i] * b[j] + a[j] * b[i]);
  }
}
/// Where vertex `corner` of the cell is among those of facet i.
template <int dim> constexpr int place_on_facet(int i, int corner) {
  const auto& corners = Simplex<dim>::facets[i];
  return static_cast<int>(std::find(corners.begin(), corners.end(), corner) - corners.begin());
}
}  // namespace block

/// \param x in an order as Simplex has it
template <int dim, class Number>
BlockGeometry<dim, Number> block_geometry(const std::array<VectorOf<dim, Number>, dim + 1>& x) {
  BlockGeometry<dim, Number> result{x, {}, Number(0)};
  std::array<VectorOf<dim, Number>, dim + 1> normal;  // dim! |K| G_i
  const auto a = block::minus<dim>(x[1], x[0]), b = block::minus<dim>(x[2], x[0]);
  if constexpr (dim == 2) {
    normal[1] = {b[1], -b[0]};
    normal[2] = {-a[1], a[0]};
  } else {
    const auto c = block::minus<dim>(x[3], x[0]);
    normal[1] = block::cross(b, c);
    normal[2] = block::cross(c, a);
    normal[3] = block::cross(a, b);
  }
  result.scaled_volume = block::dot<dim>(a, normal[1]);
  for (int k = 0; k < dim; ++k) {
    Number sum = normal[1][k];
    for (int i = 2; i <= dim; ++i) sum += normal[i][k];
    normal[0][k] = -sum;
  }
  for (int i = 0; i <= dim; ++i)
    for (int k = 0; k < dim; ++k) result.gradient[i][k] = normal[i][k] / result.scaled_volume;
  return result;
}

/// The loads at vertex j: [a] of the facet opposite to Simplex::facets[j][a].
template <int dim, class Number> using CornerLoads = std::array<VectorOf<dim, Number>, dim>;

/// \return [a] at vertex j, the stress of the part at that facet
template <int dim, class Number>
std::array<TensorOf<dim, Number>, dim> corner_stress(const BlockGeometry<dim, Number>& cell, int j,
                                                     const CornerLoads<dim, Number>& load) {
  const auto& G = cell.gradient;
  const auto& others = Simplex<dim>::facets[j];
  const Number half = Number(1) / Number(2);
  // T_a = −f_a / (dim |K|)
  const Number by_load = Number(dim == 2 ? -1 : -2) / cell.scaled_volume;
  std::array<std::array<Number, dim>, dim> s;  // s[a][b] = G_b · T_a(V_j), T_a of the facets at V_j
  std::array<VectorOf<dim, Number>, dim> e;
  for (int a = 0; a < dim; ++a) {
    for (int b = 0; b < dim; ++b) s[a][b] = by_load * block::dot<dim>(G[others[b]], load[a]);
    e[a] = block::minus<dim>(cell.x[others[a]], cell.x[j]);
  }
  std::array<TensorOf<dim, Number>, dim> stress;
  for (int a = 0; a < dim; ++a) {
    TensorOf<dim, Number>& t = stress[a];
    t.fill(Number(0));
    block::add<dim>(t, half * s[a][a], e[a], e[a]);
    for (int m = 0; m < dim; ++m) {
      if (m == a) continue;
      block::add<dim>(t, s[a][m], e[a], e[m]);
      block::add<dim>(t, half * (s[m][m] + s[a][m] - s[m][a]), e[m], e[m]);
    }
    if constexpr (dim == 3) {
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      block::add<dim>(t, half * (s[a][b] + s[c][b] + s[a][c] + s[b][c] - s[b][a] - s[c][a]), e[b], e[c]);
    }
  }
  return stress;
}

/// What the stress at vertex j of the part at facet i has in (d + 1) w_i.
template <int dim, class Number>
VectorOf<dim, Number> share_in_centre(const BlockGeometry<dim, Number>& cell, int i, int j,
                                      const TensorOf<dim, Number>& stress) {
  return block::times<dim>(stress, block::minus<dim>(cell.gradient[i], cell.gradient[j]));
}
/// λ(c), symmetrised. \param w (d + 1) w_i
template <int dim, class Number>
TensorOf<dim, Number> centre_stress(const BlockGeometry<dim, Number>& cell,
                                    const std::array<VectorOf<dim, Number>, dim + 1>& w) {
  TensorOf<dim, Number> centre;
  centre.fill(Number(0));
  const Number share = Number(1) / Number(2 * (dim + 1));
  for (int i = 1; i <= dim; ++i) block::add<dim>(centre, share, w[i], block::minus<dim>(cell.x[i], cell.x[0]));
  return centre;
}

/// \param force F, per volume
/// \return the stress; where loads and F are not in balance λ(c) is the symmetric part of the closed form's
template <int dim, class Number>
BalancedStress<dim, Number> balanced_stress(const BlockGeometry<dim, Number>& cell, const FacetLoads<dim, Number>& load,
                                            const VectorOf<dim, Number>& force) {
  BalancedStress<dim, Number> stress;
  std::array<VectorOf<dim, Number>, dim + 1> w;
  for (auto& of_part : w)
    for (int c = 0; c < dim; ++c) of_part[c] = -force[c];
  for (int j = 0; j <= dim; ++j) {
    const auto& others = Simplex<dim>::facets[j];
    CornerLoads<dim, Number> at_corner;
    for (int a = 0; a < dim; ++a) at_corner[a] = load[others[a]][block::place_on_facet<dim>(others[a], j)];
    const auto parts = corner_stress<dim, Number>(cell, j, at_corner);
    for (int a = 0; a < dim; ++a) {
      const int i = others[a];
      stress[i][block::place_on_facet<dim>(i, j)] = parts[a];
      const auto part = share_in_centre<dim, Number>(cell, i, j, parts[a]);
      for (int k = 0; k < dim; ++k) w[i][k] += part[k];
    }
  }
  const TensorOf<dim, Number> centre = centre_stress<dim, Number>(cell, w);
  for (auto& part : stress) part[dim] = centre;
  return stress;
}

}  // namespace bracket::scene
