// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "scene/mesh/simplex.h"

/// The block element of tetrahedra in closed form (docs/theory.md §12): from the loads on its faces, linear on each,
/// the one stress that is linear on the four parts of the cell, symmetric, with continuous tractions inside, div λ =
/// −F, and has them. Over any kind of number.
namespace bracket::scene {

template <class Number> using Vector3Of = std::array<Number, 3>;
/// A symmetric tensor, in the order of Simplex<3>::voigt.
template <class Number> using TensorOf = std::array<Number, 6>;

/// [i][k]: load density times area at vertex Simplex<3>::facets[i][k] of facet i, from outside on the cell.
template <class Number> using FaceLoads = std::array<std::array<Vector3Of<Number>, 3>, 4>;

/// [i][k]: the stress of part i at the vertices of its facet i, as Simplex<3>::facets has them, and, k = 3, at the
/// centroid: Stress<3>::cell.
template <class Number> using BlockStress3 = std::array<std::array<TensorOf<Number>, 4>, 4>;

/// What is the same for all loads on a cell.
template <class Number> struct BlockGeometry {
  std::array<Vector3Of<Number>, 4> x;         ///< its vertices, from any origin
  std::array<Vector3Of<Number>, 4> gradient;  ///< G_i of the hat functions
  Number volume6;                             ///< six times its volume, positive
};

namespace block {
template <class Number> Vector3Of<Number> minus(const Vector3Of<Number>& a, const Vector3Of<Number>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class Number> Number dot(const Vector3Of<Number>& a, const Vector3Of<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Number> Vector3Of<Number> cross(const Vector3Of<Number>& a, const Vector3Of<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// t v
template <class Number> Vector3Of<Number> times(const TensorOf<Number>& t, const Vector3Of<Number>& v) {
  return {t[0] * v[0] + t[5] * v[1] + t[4] * v[2], t[5] * v[0] + t[1] * v[1] + t[3] * v[2],
          t[4] * v[0] + t[3] * v[1] + t[2] * v[2]};
}
/// s (a ⊗ b + b ⊗ a) / 2 added to t, twice that where a = b is meant: a ⊗ b is symmetric by itself then.
template <class Number>
void add(TensorOf<Number>& t, const Number& s, const Vector3Of<Number>& a, const Vector3Of<Number>& b) {
  for (int k = 0; k < 6; ++k) {
    const auto [i, j] = Simplex<3>::voigt[k];
    t[k] += s * (a[i] * b[j] + a[j] * b[i]);
  }
}
}  // namespace block

template <class Number> BlockGeometry<Number> block_geometry(const std::array<Vector3Of<Number>, 4>& x) {
  BlockGeometry<Number> result{x, {}, Number(0)};
  const auto a = block::minus(x[1], x[0]), b = block::minus(x[2], x[0]), c = block::minus(x[3], x[0]);
  std::array<Vector3Of<Number>, 4> normal = {};  // 6 |K| G_i
  normal[1] = block::cross(b, c);
  normal[2] = block::cross(c, a);
  normal[3] = block::cross(a, b);
  result.volume6 = block::dot(a, normal[1]);
  for (int k = 0; k < 3; ++k) normal[0][k] = -(normal[1][k] + normal[2][k] + normal[3][k]);
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 3; ++k) result.gradient[i][k] = normal[i][k] / result.volume6;
  return result;
}

/// \param force F, per volume
/// \return the stress; where loads and F are not in balance λ(c) is the symmetric part of the closed form's
template <class Number>
BlockStress3<Number> block_stress(const BlockGeometry<Number>& cell, const FaceLoads<Number>& load,
                                  const Vector3Of<Number>& force) {
  const auto& G = cell.gradient;
  const Number half = Number(1) / Number(2), quarter = Number(1) / Number(4);
  BlockStress3<Number> stress;
  std::array<Vector3Of<Number>, 4> w;
  for (int i = 0; i < 4; ++i)
    for (int c = 0; c < 3; ++c) w[i][c] = -force[c];
  for (int j = 0; j < 4; ++j) {
    const auto& others = Simplex<3>::facets[j];
    // s[a][b] = G_b · T_a(V_j), T_a = −f_a / (3 |K|), of the three facets at V_j.
    std::array<std::array<Number, 3>, 3> s;
    std::array<Vector3Of<Number>, 3> e;
    for (int a = 0; a < 3; ++a) {
      const auto& corners = Simplex<3>::facets[others[a]];
      const auto at = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), j) - corners.begin());
      for (int b = 0; b < 3; ++b)
        s[a][b] = -((Number(2) / cell.volume6) * block::dot(G[others[b]], load[others[a]][at]));
      e[a] = block::minus(cell.x[others[a]], cell.x[j]);
    }
    for (int a = 0; a < 3; ++a) {  // part i = others[a]
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      TensorOf<Number> t;
      t.fill(Number(0));
      block::add(t, half * s[a][a], e[a], e[a]);
      block::add(t, s[a][b], e[a], e[b]);
      block::add(t, s[a][c], e[a], e[c]);
      block::add(t, half * (s[b][b] + s[a][b] - s[b][a]), e[b], e[b]);
      block::add(t, half * (s[c][c] + s[a][c] - s[c][a]), e[c], e[c]);
      block::add(t, half * (s[a][b] + s[c][b] + s[a][c] + s[b][c] - s[b][a] - s[c][a]), e[b], e[c]);
      const int i = others[a];
      const auto& corners = Simplex<3>::facets[i];
      stress[i][std::find(corners.begin(), corners.end(), j) - corners.begin()] = t;
      const auto part = block::times(t, block::minus(G[i], G[j]));
      for (int k = 0; k < 3; ++k) w[i][k] += part[k];
    }
  }
  TensorOf<Number> centre;
  centre.fill(Number(0));
  for (int i = 1; i < 4; ++i) block::add(centre, half * quarter, w[i], block::minus(cell.x[i], cell.x[0]));
  for (auto& part : stress) part[3] = centre;
  return stress;
}

}  // namespace bracket::scene
