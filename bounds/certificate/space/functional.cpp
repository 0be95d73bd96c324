// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/space/functional.h"

#include <limits>

namespace bracket::bounds::space {

bool are_rounding(const scene::Problem<3>& alone, const std::vector<Corrected<Enclosure>>& corrections) {
  double most = 0;
  for (const auto& [facet, load] : corrections)
    for (const auto& at : load)
      for (const Enclosure& one : at) most = std::max(most, magnitude(one));
  double largest = 0;  // of all loads
  for (int f = 0; f < static_cast<int>(alone.facets.size()); ++f)
    if (has_perturbing_load(alone, f))
      for (const auto& at : perturbing_load<double>(alone, f)) largest = std::max(largest, root(dot(at, at)));
  for (int cell = 0; cell < static_cast<int>(alone.mesh.cells.size()); ++cell)
    largest = std::max(largest, body_of(alone, cell).force.norm() * volume6(corners<double>(alone, cell)) / 6);
  // Resultants of rounded data, of as many terms as there are facets and cells.
  const auto terms = static_cast<double>(alone.mesh.boundary.size() + alone.mesh.cells.size()) + 64;
  return most <= 4 * std::numeric_limits<double>::epsilon() * terms * terms * largest;
}

}  // namespace bracket::bounds::space
