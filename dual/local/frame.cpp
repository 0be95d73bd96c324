// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/local/frame.h"

#include "contact/clock.h"

namespace bracket::dual {

namespace {

/// About how much the cells' forms and the factor of the repair take.
template <int dim> double memory(std::size_t n_cells) {
  constexpr double of_repair = dim == 3 ? 9.3e3 : 1e3;  // bytes a cell, by 100 000 of them; more where there are more
  return static_cast<double>(n_cells) * (sizeof(Energy<dim>) + of_repair);
}

}  // namespace

template <int dim>
LocalSolver<dim>::Frame::Frame(const scene::Problem<dim>& problem, bool keep) : facets(facets_of(problem)) {
  constexpr double share_of_memory = 0.25;
  const Clock clock;
  const Stars cells = stars_of(problem.mesh);
  for (std::size_t v = 0; v < problem.mesh.vertices.size(); ++v)
    stars.emplace_back(problem, facets, cells, static_cast<int>(v));
  groups = groups_apart(problem.mesh, stars);
  if (keep && memory<dim>(problem.mesh.cells.size()) < share_of_memory * contact::physical_memory()) {
    repair.emplace(problem, stars);
    energy = energies_of(problem);
  }
  seconds = clock.seconds();
}

template struct LocalSolver<2>::Frame;
template struct LocalSolver<3>::Frame;

}  // namespace bracket::dual
