// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: contact facets are edges.
#pragma once

#include "scene/problem/problem.h"
#include "scene/problem/stretch.h"

namespace bracket::scene {

/// ψ of a perturbation on a piece of a contact facet of the first mesh, as Bernstein coefficients.
/// \param d the direction of the first side
template <class Number>
std::array<Number, 3> psi(const Perturbation<2>::Contact& added, const Vector<2>& d, const Piece<1>& piece) {
  const auto along = [&](const TwofoldVector<2>& x) {
    Number sum(0);
    for (int c = 0; c < 2; ++c) sum += (Number(x.value[c]) + Number(x.rest[c])) * Number(d[c]);
    return sum;
  };
  std::array<Number, 2> linear;
  for (int i = 0; i < 2; ++i) linear[i] = along(added.first[i]) - along(added.second[i]);
  const std::array<Number, 3> whole = {Number(added.gap[0]) + linear[0],
                                       Number(added.gap[1]) + (linear[0] + linear[1]) / Number(2),
                                       Number(added.gap[2]) + linear[1]};
  return on_stretch(whole, piece.corner[0][0], piece.corner[1][0]);
}

}  // namespace bracket::scene
