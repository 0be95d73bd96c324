// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/local/frame.h"

#include "contact/clock.h"

namespace bracket::dual {

namespace {

/// About how much the cells' forms and the stars' factors take.
template <int dim> double memory(std::size_t n_cells) {
  constexpr double blocks = dim == 3 ? 30 : 7;  // of the factors, a cell: docs/theory.md §12.5
  return static_cast<double>(n_cells) * (sizeof(Energy<dim>) + (blocks + dim + 1) * sizeof(FacetBlock<dim>));
}

}  // namespace

template <int dim>
LocalSolver<dim>::Frame::Frame(const scene::Problem<dim>& problem, bool keep) : facets(facets_of(problem)) {
  constexpr double share_of_memory = 0.25;
  const Stars cells = stars_of(problem.mesh);
  for (std::size_t v = 0; v < problem.mesh.vertices.size(); ++v)
    stars.emplace_back(problem, facets, cells, static_cast<int>(v));
  groups = groups_apart(problem.mesh, stars);
  if (keep && memory<dim>(problem.mesh.cells.size()) < share_of_memory * contact::physical_memory())
    this->keep(problem);
}

template <int dim> void LocalSolver<dim>::Frame::keep(const scene::Problem<dim>& problem) {
  constexpr int at_once = 16;
  Clock clock;
  repair.emplace(problem, stars);
  energy = energies_of(problem);
  seconds.assemble = clock.lap();
  systems.resize(stars.size());
  try {
    scene::for_each_index(
        static_cast<int>(stars.size()),
        [&](int v) { systems[v] = std::make_unique<const StarSystem<dim>>(stars[v], energy); }, at_once);
  } catch (const NotDefinite& star) {
    not_definite = star;
    return;
  }
  seconds.factorise = clock.lap();
  const auto contacts = contacts_by_vertex(problem);
  for (std::size_t v = 0; v < contacts.size(); ++v) {
    if (contacts[v].empty()) continue;
    Pressed<dim> one = pressed_at(problem, facets, stars, static_cast<int>(v), contacts[v]);
    Systems<dim> own;
    for (const int star : one.stars) own.push_back(kept(stars[star]));
    pressed.push_back(with_forms(std::move(one), stars, own));
  }
  seconds.contact = clock.lap();
}

template struct LocalSolver<2>::Frame;
template struct LocalSolver<3>::Frame;

}  // namespace bracket::dual
