// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/corrections.h"

#include <algorithm>

#include "bounds/certificate/links.h"

namespace bracket::bounds {

double size_of_load(const scene::Problem<2>& problem, int facet) {
  const auto ends = scene::load(problem, facet);
  const auto higher = scene::higher_load(problem, facet);  // Legendre's polynomials are at most 1 in size
  return std::max(ends[0].norm(), ends[1].norm()) + (higher[0].norm() + higher[1].norm());
}

double largest_load(const scene::Problem<2>& problem) {
  const auto& mesh = problem.mesh;
  double largest = 0;
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (scene::is_loaded(problem.facets[f])) largest = std::max(largest, size_of_load(problem, static_cast<int>(f)));
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int cell = static_cast<int>(c);
    largest = std::max(largest, body_of(problem, cell).force.norm() * scene::volume(mesh, cell));
  }
  return largest;
}

PlainLoads assumed_loads(const scene::Problem<2>& first) {
  PlainLoads assumed = no_loads(first, 1);
  for (const auto& pair : first.contact)
    if (!first.carries[pair.pair]) assumed.along_normal[pair.first] = {0, 0};
  return assumed;
}

bool corrections_vanish(const scene::Problem<2>& problem, const std::vector<Reaction>& chosen,
                        const std::vector<char>& carrying) {
  const scene::Problem<2>& first = scene::first_of(problem);
  const auto corrections = std::count_if(chosen.begin(), chosen.end(), [](const Reaction& reaction) {
    return reaction.kind == Reaction::Kind::correction;
  });
  if (corrections == 0) return true;
  const int unheld = unheld_motions(first, carrying);
  std::vector<char> either = carrying;
  for (std::size_t pair = 0; pair < either.size(); ++pair) either[pair] |= first.carries[pair];
  return corrections == unheld && unheld == unheld_motions(first, either);
}

}  // namespace bracket::bounds
