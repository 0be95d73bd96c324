// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/certificate.h"

namespace bracket::bounds {

/// A part of a contact that is open in the computed displacements, and what it can carry at most in the solution:
/// guaranteed, without a further solve (docs/theory.md §10.5).
struct OpenContact {
  double length = 0;  ///< of its facets, in space their area; 0: none is open for sure
  double gap = 0;     ///< that the displacements, as certify() moves them, leave on all of it at least
  double force = 0;   ///< ∫ p over it is no more
};
/// The half of what is open of a pair, by length, on which most gap is left.
/// \param certificate of the problem, these displacements and some stress, valid   \param pair index into
/// Scene::contact
template <int dim>
OpenContact open_contact(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                         const Certificate& certificate, int pair);

/// What some contact facets carry together at most, if the displacements leave a gap on all of them; else infinite.
/// \param chosen of each of Problem::contact
template <int dim>
double force_at_most(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                     const Certificate& certificate, const std::vector<char>& chosen);

}  // namespace bracket::bounds
