// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/bounds.h"
#include "bounds/quantities/evaluate.h"

namespace bracket::bounds {

/// Along each contact with Coulomb's friction, in tents that add up to one (four or five on a line, fewer where it has
/// fewer edges; less where both sides are held): what the solution of the step presses there, and what its bound
/// assumed (docs/theory.md §11.1). \param level of one of Coulomb's steps
template <int dim> std::vector<FrictionForce> friction_forces(const SolvedLevel<dim>& level);

}  // namespace bracket::bounds
