// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: all of the stress is known.
#include "apps/report/von_mises.h"

#include "apps/report/space/cell_values.h"
#include "apps/report/stresses.h"

namespace bracket::apps {

template <> LargestVonMisesOf<3> largest_von_mises(const bounds::Outcome<3>& outcome, scene::Plane) {
  const scene::Mesh<3>& mesh = outcome.problem.mesh;
  LargestVonMisesOf<3> largest;
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    const auto sigma = bounds::displacement_stress(outcome.problem, outcome.displacement, cell);
    const auto x = scene::positions(mesh, mesh.cells[cell]);
    for (int part = 0; part < 4; ++part)
      for (int corner = 0; corner < 4; ++corner) {  // both are linear on a part, and largest at a corner
        InCell in_part = {};
        in_part[corner] = 1;
        const double own = von_mises(mean_stress(sigma, outcome.stress, cell, part, in_part));
        if (own <= largest.value) continue;
        largest.value = own;
        largest.at = value_in(in_cell(part, in_part), x);
      }
  }
  return largest;
}

}  // namespace bracket::apps
