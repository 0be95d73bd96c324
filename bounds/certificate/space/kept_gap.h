// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "bounds/certificate/space/supports.h"

/// Gaps on contact facets, as FacetQuadratic has them.
namespace bracket::bounds::space {

/// The same quadratic on a piece of its facet: its blossom.
template <class Number>
std::array<Number, 6> on_piece(const std::array<Number, 6>& whole, const scene::Piece<2>& piece) {
  const auto blossom = [&](const std::array<double, 2>& p, const std::array<double, 2>& q) {
    const std::array<double, 3> a = {(1 - p[0]) - p[1], p[0], p[1]}, b = {(1 - q[0]) - q[1], q[0], q[1]};
    Number sum(0);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        if (a[i] != 0 && b[k] != 0)
          sum += Number(a[i]) * Number(b[k]) * whole[i == k ? i : 3 + scene::Simplex<2>::edge_between(i, k)];
    return sum;
  };
  std::array<Number, 6> result;
  for (int k = 0; k < 3; ++k) result[k] = blossom(piece.corner[k], piece.corner[k]);
  for (int e = 0; e < 3; ++e) {
    const auto& [a, b] = scene::Simplex<2>::edges[e];
    result[3 + e] = blossom(piece.corner[a], piece.corner[b]);
  }
  return result;
}

template <class Number> std::array<Number, 6> numbers(const scene::FacetQuadratic<3>& c) {
  return {Number(c[0]), Number(c[1]), Number(c[2]), Number(c[3]), Number(c[4]), Number(c[5])};
}

/// The gap of a two-sided facet of the first mesh. Its bounds differ by rounding only, and neighbours agree by rounding
/// only; what is meant, by both bounds, is halfway between, one number at a node for each direction, and linear where
/// it may be, but for rounding.
struct KeptGap {
  scene::FacetQuadratic<3> lower, upper;
  bool is_linear = false;
};
template <class Number> std::array<Number, 6> kept_gap(const KeptGap& gap) {
  std::array<Number, 6> c;
  for (int k = 0; k < 6; ++k) c[k] = (Number(gap.lower[k]) + Number(gap.upper[k])) / Number(2);
  for (int e = 0; e < 3 && gap.is_linear; ++e) {
    const auto& [a, b] = scene::Simplex<2>::edges[e];
    c[3 + e] = (c[a] + c[b]) / Number(2);
  }
  return c;
}

struct KeptGaps {
  std::vector<int> of_facet = {};  ///< of each facet of the first mesh, its contact; empty: no contact is two-sided
  std::vector<KeptGap> kept = {};  ///< of each contact of the first mesh, likewise
  std::string fault = {};          ///< why r = g cannot be: one line
};
KeptGaps kept_gaps(const scene::Problem<3>& first);

/// Of each facet, the contact of which it is the first side: index into Problem::contact, −1: none.
std::vector<int> contacts_by_first(const scene::Problem<3>& problem);

}  // namespace bracket::bounds::space
