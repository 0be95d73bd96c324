// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/particular.h"

#include "bounds/certificate/corrections.h"
#include "bounds/certificate/tree.h"

namespace bracket::bounds {

namespace {

/// The loads of the data alone, with reactions; pressures may be taken anywhere.
EdgeLoads<Enclosure> held(const scene::Problem<2>& problem, const std::vector<Reference>& about) {
  const auto [corrections, reason] = corrected<Enclosure, LongSum>(scene::first_of(problem));
  EdgeLoads<Enclosure> loads = loads_of<Enclosure>(problem, no_loads(problem), corrections);
  const std::vector<Reaction> chosen = reactions(problem, about, no_loads(problem, 1), {});
  const auto amounts = amounts_that_hold<Enclosure, LongSum>(problem, about, chosen, loads);
  if (!reason.empty() || !amounts)
    throw scene::Error(scene::Status::not_guaranteed,
                       "solve.dual = \"uzawa\": no supports or contacts were found that hold the bodies, as its "
                       "particular stress needs; write solve.dual = \"hybrid\"");
  add_reactions(problem, chosen, *amounts, loads);
  return loads;
}

}  // namespace

template <int dim> scene::Stress<dim> particular_stress(const scene::Problem<dim>& problem) {
  const std::vector<Reference> about = references(scene::first_of(problem).mesh);
  const EdgeLoads<Enclosure> loads = handed_on(problem, about, held(problem, about));
  scene::Stress<dim> stress;
  stress.cell.resize(problem.mesh.cells.size());
  for (std::size_t c = 0; c < stress.cell.size(); ++c) {
    const int cell = static_cast<int>(c);
    stress.cell[c].resize(9);
    const auto parts = block_stress(problem, loads, loaded_cell(problem, loads, cell), cell);
    for (int i = 0; i < 3; ++i)  // the side i → i + 1 lies opposite to corner i + 2
      for (int corner = 0; corner < 3; ++corner)
        for (int k = 0; k < 3; ++k)
          stress.cell[c][3 * ((i + 2) % 3) + corner][k] = static_cast<double>(parts[i][corner][k].middle);
  }
  return stress;
}

template scene::Stress<2> particular_stress(const scene::Problem<2>&);

}  // namespace bracket::bounds
