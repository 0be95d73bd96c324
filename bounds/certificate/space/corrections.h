// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "bounds/certificate/space/hold.h"

/// The true amounts of the corrections that bring the loads into balance.
namespace bracket::bounds::space {

/// How many corrections held() is to take so that its multiples of them are zero exactly once the loads carry their
/// own: as many as there are motions on which no support and no pair that carries acts. Each such motion gains nothing
/// from the loads and meets the corrections alone, as long as on none of them acts a pair that the corrections counted
/// on. \return nothing where one does, or where there are not as many
std::optional<int> vanishing_corrections(const scene::Problem<3>& problem, const std::vector<char>& carrying);

/// The loads on the first mesh that held() may spread: unit pressures where the corrections count on a pair.
PlainLoads assumed_loads(const scene::Problem<3>& first);

template <class Number> struct Corrections {
  std::vector<Corrected<Number>> loads;
  std::string reason;  ///< if they cannot be had: one line
};

/// The corrections of a problem's loads by their true amounts, of those that are on Γ_τ (others are zero): those with
/// which the loads are in balance along all motions on which neither supports nor the pairs that carry act at all.
/// \param first on its first mesh
template <class Number, class Sum> Corrections<Number> corrected(const scene::Problem<3>& first) {
  if (first.corrections.empty()) return {};
  const PlainLoads assumed = assumed_loads(first);
  const Rows rows = rows_of(first);
  const std::vector<Reference> about = references(first.mesh);
  const std::vector<Spread> all = spreads(first, rows, assumed, 0, {});
  const auto count = vanishing_corrections(first, carrying_pairs(first, assumed));
  const std::vector<int> taken = chosen_corrections(first, about, rows, all, count.value_or(0));
  const auto found = held<Number, Sum>(first, about, rows, all, taken, loads_of<Number>(first, no_loads(first), {}));
  if (!found || !count) return {{}, "the corrections of the loads do not bring a body that nothing holds into balance"};
  Corrections<Number> result;
  for (std::size_t k = 0; k < taken.size(); ++k) {
    const auto& [facet, unit] = first.corrections[taken[k]];
    const Number& own = found->correction[k];
    if (first.facets[facet].support == scene::Support::traction) {
      FacetVectors<Number> load;
      for (int i = 0; i < 3; ++i) load[i] = own * vector3<Number>(unit[i]);
      result.loads.push_back({facet, load});
    } else if (!certainly_non_negative(own) || !certainly_non_negative(-own)) {  // not zero
      return {{}, "the weight of a body that nothing but contacts holds is not in balance to the last bit"};
    }
  }
  return result;
}

}  // namespace bracket::bounds::space
