// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "dual/local/frame.h"

namespace bracket::dual {

/// The loads on all facets of all cells, and the pressures that are among them, while stars change them.
template <int dim> class Loads {
 public:
  using Pressure = std::vector<std::array<double, std::size_t{dim}>>;
  using Frame = typename LocalSolver<dim>::Frame;

  /// As yet not in balance.
  /// \param frame, problem kept by reference   \param pressure, displacement as LocalSolver::solve() has them
  Loads(const Frame& frame, const scene::Problem<dim>& problem, Pressure pressure,
        const scene::Displacement<dim>& displacement);
  Loads(const Loads&) = delete;
  Loads& operator=(const Loads&) = delete;

  /// Stars one after the other hand the target's loads out such that cells and facets are in balance; each sees what
  /// those before it changed (docs/theory.md §12.2). To be called once, before all else.
  /// \throw NotDefinite, as do sweeps
  void equilibrate();
  /// Once around all stars: each gets the loads of least S that are in balance, those on other facets as they are.
  void sweep();

  const scene::Problem<dim>& problem() const { return problem_; }
  const Facets<dim>& facets() const { return frame_.facets; }
  const Star<dim>& star(int vertex) const { return frame_.stars[vertex]; }
  /// The frame's, or one of its own.
  std::shared_ptr<const StarSystem<dim>> system(const Star<dim>& star) const;
  /// Does work(pressed, systems) for each vertex in contact, by its number.
  void for_each_pressed(const std::function<void(const Pressed<dim>&, const Systems<dim>&)>& work) const;
  /// Changes of the loads on a star that leave all in balance, and what S would gain by them.
  StarData<dim> as_they_are(const Star<dim>& star) const;
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

  const Frame& frame_;
  const scene::Problem<dim>& problem_;
  Pressure pressure_;
  std::vector<FacetVector<dim>> given_;       ///< by the boundary, until equilibrate()
  std::vector<LinearStress<dim>> target_;     ///< σ* (docs/theory.md §12.3), likewise
  const std::vector<Energy<dim>> own_;        ///< of each cell; empty: the frame's are kept
  const std::vector<Energy<dim>>& energy_;    ///< of each cell
  std::vector<CellVector<dim>> loads_;        ///< of each cell
  std::vector<FacetVector<dim>> prescribed_;  ///< displacements of facets, by moments
};

}  // namespace bracket::dual
