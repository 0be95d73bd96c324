// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dual/local/star_system.h"

namespace bracket::dual {

/// A vertex in contact: the stars there, of one side or both, and what pressures on the contact facets at it do to
/// them.
template <int dim> struct Pressed {
  /// The loads of a unit pressure at a vertex of a contact facet, on one side or both.
  struct Unit {
    struct On {
      std::size_t star;  ///< place in `stars`
      int spoke;
      FacetVector<dim> load;
    };
    std::vector<On> on;
    int contact, vertex;
  };
  std::vector<int> stars;  ///< their vertices
  std::vector<Unit> units;
  Eigen::MatrixXd form;    ///< F: S gains ½ xᵀF x, and what is linear, by changes x of the pressures
  Eigen::MatrixXd motion;  ///< of each unit along the motions of the stars
};

template <int dim> using Systems = std::vector<StarSystem<dim>>;
/// Without forms. \param contacts those whose first facet has the vertex
template <int dim>
Pressed<dim> pressed_at(const scene::Problem<dim>& problem, const Facets<dim>& facets,
                        const std::vector<Star<dim>>& stars, int vertex, const std::vector<int>& contacts);
/// \param stars of all vertices   \param systems of those of `pressed`
template <int dim>
Pressed<dim> with_forms(Pressed<dim> pressed, const std::vector<Star<dim>>& stars, const Systems<dim>& systems);

/// Of each vertex the contacts whose first facet has it.
template <int dim> std::vector<std::vector<int>> contacts_by_vertex(const scene::Problem<dim>& problem);

}  // namespace bracket::dual
