// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/functional.h"

namespace bracket::bounds {

scene::Problem<2> perturbation_alone(const scene::Problem<2>& problem, std::vector<char> carrying) {
  scene::Problem<2> bare = scene::first_of(problem);
  bare.carries = std::move(carrying);
  for (auto& body : bare.bodies) body.force.setZero();
  for (auto& facet : bare.facets) {
    facet.traction = scene::at_vertices<2>(scene::Vector<2>(scene::Vector<2>::Zero()));
    facet.pressure = {0, 0};
    facet.correction = facet.traction;
  }
  return scene::perturbed(bare, problem.perturbed.by, 1, 0);
}

bool are_rounding(const scene::Problem<2>& alone, const std::vector<Corrected<Enclosure>>& corrections) {
  double size = 0, most = 0;
  for (std::size_t f = 0; f < alone.facets.size(); ++f)
    for (const auto& end : scene::load(alone, static_cast<int>(f))) size = std::max(size, end.norm());
  for (std::size_t c = 0; c < alone.mesh.cells.size(); ++c)
    size = std::max(size,
                    body_of(alone, static_cast<int>(c)).force.norm() * scene::volume(alone.mesh, static_cast<int>(c)));
  for (const auto& [facet, load] : corrections)
    for (const auto& end : load) most = std::max({most, magnitude(end.x), magnitude(end.y)});
  // Resultants of rounded data, of as many terms as there are facets and cells.
  const auto terms = static_cast<double>(alone.mesh.boundary.size() + alone.mesh.cells.size()) + 64;
  return most <= 4 * std::numeric_limits<double>::epsilon() * terms * terms * size;
}

}  // namespace bracket::bounds
