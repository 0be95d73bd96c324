// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dual/dual.h"
#include "dual/local/star_system.h"
#include "dual/local/target.h"

namespace bracket::dual {

/// The loads on all facets of all cells, and the pressures that are among them, while stars change them.
template <int dim> class Loads {
 public:
  using Pressure = typename LocalSolver<dim>::Pressure;

  /// As yet not in balance.
  /// \param facets kept by reference, as the problem is   \param start as LocalSolver::solve() has it
  Loads(const Facets<dim>& facets, const std::vector<Star<dim>>& stars, const Repair<dim>& repair,
        const typename LocalSolver<dim>::Start& start);
  Loads(const Loads&) = delete;
  Loads& operator=(const Loads&) = delete;

  /// One star hands the target's loads out such that cells and facets are in balance when all have, one after the
  /// other; it sees what those before it changed (docs/theory.md §12.2). To be called once for each star, before all
  /// else.
  void hand_out(const StarSystem<dim>& system);
  /// To be called once, after all stars.
  void end_handing_out();
  /// A star gets the loads of least S that are in balance, those on other facets as they are.
  void sweep(const StarSystem<dim>& system) { add(system.star(), system.solve(as_they_are(system)).loads); }

  const scene::Problem<dim>& problem() const { return problem_; }
  const Facets<dim>& facets() const { return facets_; }
  /// Changes of the loads on a star that leave all in balance, and what S would gain by them.
  StarData<dim> as_they_are(const StarSystem<dim>& system) const;
  /// Adds to the loads on the spokes of a star, cell by cell.
  void add(const Star<dim>& star, const std::vector<SpokeVector<dim>>& change) { add(star, change, loads_); }

  const Pressure& pressure() const { return pressure_; }
  void add_pressure(int contact, int vertex, double change) { pressure_[contact][vertex] += change; }

  /// How many loads are to be found.
  int unknowns() const;
  scene::Stress<dim> stress() const;

 private:
  static void add(const Star<dim>& star, const std::vector<SpokeVector<dim>>& change,
                  std::vector<CellVector<dim>>& loads);

  const Facets<dim>& facets_;
  const scene::Problem<dim>& problem_;
  Pressure pressure_;
  std::vector<CellVector<dim>> loads_;        ///< of each cell
  std::vector<FacetVector<dim>> prescribed_;  ///< displacements of facets, by moments

  // Until all stars have handed out, σ* being the target (docs/theory.md §12.3):
  std::vector<FacetVector<dim>> lacking_;  ///< of facets: what has to be there, less what σ* has
  std::vector<scene::Vector<dim>> force_;  ///< of cells: F + div σ*
  std::vector<CellVector<dim>> change_;    ///< of cells: what was handed out
  std::vector<int> done_;                  ///< of cells: how many stars have
};

}  // namespace bracket::dual
