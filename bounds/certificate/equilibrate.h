// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "bounds/certificate/corrections.h"
#include "bounds/certificate/tree.h"

/// Exact balance of edge loads: what computed loads lack is carried to where the bodies are held. This is also the
/// particular field λ̄ of HH81 (3.16)–(3.19), for loads that are zero inside.
namespace bracket::bounds {

template <class Number> struct Balanced {
  std::optional<EdgeLoads<Number>> loads;  ///< every cell in balance
  std::string reason;                      ///< if there are none
};

/// Loads that balance every cell exactly: reactions hold the bodies as wholes, then cells hand on what they lack.
/// \param corrections as corrected() has them
template <class Number, class Sum>
Balanced<Number> balanced(const scene::Problem<2>& problem, const std::vector<Corrected<Number>>& corrections,
                          PlainLoads given) {
  const std::vector<Reference> about = references(scene::first_of(problem).mesh);
  // A pressure that is rounding itself may be too small to take what is missing, a shear too near to its bound: then
  // another has to. Where no pressure can, all of its pair are rounding.
  constexpr std::size_t most = 20;
  std::vector<Reaction> barred;
  while (true) {
    const std::vector<Reaction> chosen = reactions(problem, about, given, barred);
    EdgeLoads<Number> loads = loads_of<Number>(problem, given, corrections);
    std::optional<std::vector<Number>> amounts;
    if (barred.size() < most && corrections_vanish(problem, chosen, carrying_pairs(problem, given)))
      amounts = amounts_that_hold<Number, Sum>(problem, about, chosen, loads);
    if (!amounts) {
      if (!drop_barred_pairs(problem, barred, given))
        return {{}, "no supports or contacts were found that take what rounding leaves of the loads"};
      barred.clear();
      continue;
    }
    add_reactions(problem, chosen, *amounts, loads);
    const std::optional<Reaction> beyond = beyond_law(problem, loads, chosen);
    if (!beyond) return {handed_on(problem, about, loads), ""};
    barred.push_back(*beyond);
  }
}

}  // namespace bracket::bounds
