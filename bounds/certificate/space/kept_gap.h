// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "bounds/certificate/space/supports.h"
#include "scene/problem/psi.h"

/// Gaps on contact facets, as FacetQuadratic has them.
namespace bracket::bounds::space {

template <class Number> std::array<Number, 6> numbers(const scene::FacetQuadratic<3>& c) {
  return {Number(c[0]), Number(c[1]), Number(c[2]), Number(c[3]), Number(c[4]), Number(c[5])};
}

/// The gap of a two-sided facet of the first mesh. Its bounds differ by rounding only, and neighbours agree by rounding
/// only; what is meant, by both bounds, is halfway between, one number at a node for each direction, and linear where
/// it may be, but for rounding.
struct KeptGap {
  scene::FacetQuadratic<3> lower, upper;
  bool is_linear = false;
  scene::Vector<3> d = scene::Vector<3>::Zero();
  scene::Perturbation<3>::Contact added = {};  ///< ψ
  double factor = 0;                           ///< times ψ; 0: nothing
  bool is_psi_linear = true;
};
template <class Number> std::array<Number, 6> kept_psi(const KeptGap& gap) {
  return scene::psi<Number>(gap.added, gap.d, scene::whole<2>(0));
}
template <class Number> std::array<Number, 6> kept_gap(const KeptGap& gap) {
  std::array<Number, 6> c;
  for (int k = 0; k < 6; ++k) c[k] = (Number(gap.lower[k]) + Number(gap.upper[k])) / Number(2);
  for (int e = 0; e < 3 && gap.is_linear; ++e) {
    const auto& [a, b] = scene::Simplex<2>::edges[e];
    c[3 + e] = (c[a] + c[b]) / Number(2);
  }
  if (gap.factor == 0) return c;
  const auto psi = kept_psi<Number>(gap);
  for (int k = 0; k < 6; ++k) c[k] += Number(gap.factor) * psi[k];
  return c;
}

struct KeptGaps {
  std::vector<int> of_facet = {};  ///< of each facet of the first mesh, its contact; empty: no contact is two-sided
  std::vector<KeptGap> kept = {};  ///< of each contact of the first mesh, likewise
  std::string fault = {};          ///< why r = g cannot be: one line
};
KeptGaps kept_gaps(const scene::Problem<3>& problem);

}  // namespace bracket::bounds::space
