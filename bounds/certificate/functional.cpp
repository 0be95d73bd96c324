// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/functional.h"

namespace bracket::bounds {

bool are_rounding(const scene::Problem<2>& alone, const std::vector<Corrected<Enclosure>>& corrections) {
  double most = 0;
  for (const auto& [facet, load] : corrections)
    for (const auto& end : load) most = std::max({most, magnitude(end.x), magnitude(end.y)});
  // Resultants of rounded data, of as many terms as there are facets and cells.
  const auto terms = static_cast<double>(alone.mesh.boundary.size() + alone.mesh.cells.size()) + 64;
  return most <= 4 * std::numeric_limits<double>::epsilon() * terms * terms * largest_load(alone);
}

}  // namespace bracket::bounds
