// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "contact/contact.h"
#include "dual/dual.h"
#include "dual/local/target.h"
#include "scene/parallel.h"

namespace bracket::dual {

/// The stars of a mesh and, where they are kept, the cells' forms and the repair: what neither loads nor gaps nor
/// prescribed displacements enter, but for the stars' factors, which are as large again. Refers to itself.
template <int dim> struct LocalSolver<dim>::Frame {
  Frame(const scene::Problem<dim>& problem, bool keep);
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

  Facets<dim> facets;
  std::vector<Star<dim>> stars;          ///< of each vertex
  std::vector<std::vector<int>> groups;  ///< of stars that have no cell in common

  // Empty: each solve makes its own.
  Energies<dim> energy;  ///< of each cell
  std::optional<Repair<dim>> repair;
  double seconds = 0;  ///< that these took

  /// Does work(star) for all stars, one after the other but for those that have no cell in common.
  template <class Work> void for_each_star(const Work& work) const {
    constexpr int at_once = 16;  // a star is as much work as some dozens of cells
    for (const std::vector<int>& together : groups)
      scene::for_each_index(
          static_cast<int>(together.size()), [&](int i) { work(stars[together[i]]); }, at_once);
  }
};

}  // namespace bracket::dual
