// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "contact/contact.h"
#include "dual/dual.h"
#include "dual/local/pressed.h"
#include "dual/local/target.h"
#include "scene/parallel.h"

namespace bracket::dual {

/// The stars of a mesh and, where they are kept, what solves them: all that neither loads nor gaps nor prescribed
/// displacements enter. Refers to itself.
template <int dim> struct LocalSolver<dim>::Frame {
  Frame(const scene::Problem<dim>& problem, bool keep);
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

  Facets<dim> facets;
  std::vector<Star<dim>> stars;          ///< of each vertex
  std::vector<std::vector<int>> groups;  ///< of stars that have no cell in common

  // Empty: each solve makes its own.
  std::vector<Energy<dim>> energy;                              ///< of each cell
  std::vector<std::unique_ptr<const StarSystem<dim>>> systems;  ///< of each star
  std::vector<Pressed<dim>> pressed;                            ///< of each vertex in contact
  std::optional<Repair<dim>> repair;
  std::optional<NotDefinite> not_definite;  ///< why there are no systems
  contact::Phases seconds;

  /// One of the systems, not owned.
  std::shared_ptr<const StarSystem<dim>> kept(const Star<dim>& star) const {
    return {std::shared_ptr<void>(), systems[star.vertex()].get()};
  }
  /// Does work(star) for all stars, one after the other but for those that have no cell in common.
  template <class Work> void for_each_star(const Work& work) const {
    constexpr int at_once = 16;  // a star is as much work as some dozens of cells
    for (const std::vector<int>& together : groups)
      scene::for_each_index(
          static_cast<int>(together.size()), [&](int i) { work(stars[together[i]]); }, at_once);
  }

 private:
  void keep(const scene::Problem<dim>& problem);
};

}  // namespace bracket::dual
