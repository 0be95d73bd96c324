// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "bounds/certificate/reactions.h"

/// The true amounts of the corrections that bring the loads into balance.
namespace bracket::bounds {

/// Whether the corrections among the reactions are zero exactly once the loads carry their own corrections: there are
/// as many as motions on which no support and no pair that carries acts, and on none of these acts a pair that the
/// corrections counted on. Then each such motion gains nothing from the loads and meets the corrections alone.
bool corrections_vanish(const scene::Problem<2>& problem, const std::vector<Reaction>& chosen,
                        const std::vector<char>& carrying);

/// Not less than the load on a facet is anywhere on it, per unit of its parameter: what its rounding goes by. The load
/// may have much beside its linear part.
double size_of_load(const scene::Problem<2>& problem, int facet);
/// The largest of all: of the facets' loads, and of the weights of cells.
double largest_load(const scene::Problem<2>& problem);

/// Those on the first mesh, with unit pressures where the corrections count on a pair: what reactions() chooses from.
PlainLoads assumed_loads(const scene::Problem<2>& first);

template <class Number> struct Corrections {
  std::vector<Corrected<Number>> loads;
  std::string reason;  ///< if they cannot be had: one line
};

/// The corrections of a problem's loads by their true amounts, of those that are on Γ_τ (others are zero): those with
/// which the loads are in balance along all motions on which neither supports nor the pairs that carry act at all.
/// \param first on its first mesh; perturbed, its loads are the sums
template <class Number, class Sum> Corrections<Number> corrected(const scene::Problem<2>& first) {
  if (first.corrections.empty()) return {};
  const std::vector<Reference> about = references(first.mesh);
  const PlainLoads assumed = assumed_loads(first);
  const std::vector<Reaction> chosen = reactions(first, about, assumed, {});
  const EdgeLoads<Number> loads = loads_of<Number>(first, no_loads(first), {});
  const auto amounts = amounts_that_hold<Number, Sum>(first, about, chosen, loads);
  if (!amounts || !corrections_vanish(first, chosen, carrying_pairs(first, assumed)))
    return {{}, "the corrections of the loads do not bring a body that nothing holds into balance"};
  Corrections<Number> result;
  for (std::size_t j = 0; j < chosen.size(); ++j) {
    if (chosen[j].kind != Reaction::Kind::correction) continue;
    const auto& [facet, unit] = first.corrections[chosen[j].which];
    const Number& own = (*amounts)[j];
    if (first.facets[facet].support == scene::Support::traction)
      result.loads.push_back({facet, {own * vector2<Number>(unit[0]), own * vector2<Number>(unit[1])}});
    else if (!certainly_non_negative(own) || !certainly_non_negative(-own))  // not zero
      return {{}, "the weight of a body that nothing but contacts holds is not in balance to the last bit"};
  }
  return result;
}

}  // namespace bracket::bounds
