// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/problem/law.h"
#include "scene/problem/problem.h"
#include "scene/problem/space/face.h"
#include "scene/problem/stretch.h"

namespace bracket::scene {

/// What the sides' U add along a direction at the vertices of a contact facet.
template <class Number, int dim>
std::array<Number, std::size_t{dim}> approach(const typename Perturbation<dim>::Contact& added,
                                              const Vector<dim>& direction) {
  const auto along = [&](const TwofoldVector<dim>& x) {
    Number sum(0);
    for (int c = 0; c < dim; ++c) sum += (Number(x.value[c]) + Number(x.rest[c])) * Number(direction[c]);
    return sum;
  };
  std::array<Number, dim> linear;
  for (int i = 0; i < dim; ++i) linear[i] = along(added.first[i]) - along(added.second[i]);
  return linear;
}

/// A quadratic and the jump of U along a direction, on a piece of a contact facet of the first mesh.
template <class Number>
std::array<Number, 3> with_jump(const std::array<double, 3>& own, const Perturbation<2>::Contact& added,
                                const Vector<2>& direction, const Piece<1>& piece) {
  const std::array<Number, 2> linear = approach<Number, 2>(added, direction);
  const std::array<Number, 3> whole = {Number(own[0]) + linear[0], Number(own[1]) + (linear[0] + linear[1]) / Number(2),
                                       Number(own[2]) + linear[1]};
  return on_stretch(whole, piece.corner[0][0], piece.corner[1][0]);
}
template <class Number>
std::array<Number, 6> psi(const Perturbation<3>::Contact& added, const Vector<3>& d, const Piece<2>& piece) {
  const std::array<Number, 3> linear = approach<Number, 3>(added, d);
  std::array<Number, 6> whole;
  for (int i = 0; i < 3; ++i) whole[i] = Number(added.gap[i]) + linear[i];
  for (int e = 0; e < 3; ++e) {
    const auto& [i, k] = Simplex<2>::edges[e];
    whole[3 + e] = Number(added.gap[3 + e]) + (linear[i] + linear[k]) / Number(2);
  }
  return on_part(whole, piece.corner);
}

/// ψ of a perturbation on a piece of a contact facet of the first mesh, as Bernstein coefficients.
/// \param d the direction of the first side
template <class Number>
std::array<Number, 3> psi(const Perturbation<2>::Contact& added, const Vector<2>& d, const Piece<1>& piece) {
  return with_jump<Number>(added.gap, added, d, piece);
}
/// ψ_t likewise.
template <class Number>
std::array<Number, 3> psi_of_slip(const Perturbation<2>::Contact& added, const Vector<2>& d, const Piece<1>& piece) {
  return with_jump<Number>(added.slip, added, tangent(d), piece);
}

}  // namespace bracket::scene
