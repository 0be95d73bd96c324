// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/contact.h"
#include "scene/scene.h"

/// Displacements: the upper bound. Lagrange elements on triangles, exactly admissible: u_h ∈ K (docs/theory.md §3).
namespace bracket::primal {

template <int dim> struct Result {
  contact::Outcome outcome = contact::Outcome::solved;
  std::string reason;  ///< if not solved: one line, with the body and the motion
  scene::Displacement<dim> displacement;
  std::vector<char> closed;  ///< per Problem::contact: 1 where one of its rows is active; to start the next mesh from
  int unknowns = 0;
  int rows = 0;
  int active_rows = 0;
  int iterations = 0;
  double imbalance = 0;  ///< see contact::Solution
  double assemble = 0;   ///< seconds
  contact::Seconds seconds;
};

/// What can be said of a contact without a solve: whether the displacements prescribed on both of its sides leave any
/// that are admissible, K_h ≠ ∅ there.
/// \param degree 1 or 2, as for solve()
/// \throw scene::Error (ill_posed) where they alone already close a gap by more than it has
template <int dim> void check_prescribed(const scene::Problem<dim>& problem, int degree);

/// Minimises the potential energy L over K_h ⊂ K. [HH81, (1.2)]; rows bound the Bernstein coefficients of r by those of
/// g on each contact facet.
/// \param degree 1 or 2
/// \param closed contact facets expected to be closed (as Result::closed, or empty: all)
/// \throw scene::Error as check_prescribed()
template <int dim>
Result<dim> solve(const scene::Problem<dim>& problem, int degree, const std::vector<char>& closed = {});

}  // namespace bracket::primal
