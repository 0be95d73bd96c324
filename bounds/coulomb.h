// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/level.h"

/// Coulomb's friction, |τ| ≤ μ p, as the last of a sequence of problems whose shear has a given bound (docs/theory.md
/// §11.1). Only these have an energy, and bounds.
namespace bracket::bounds {

template <int dim> bool has_coulomb(const scene::Problem<dim>& problem);

/// The problem with the bounds μ p of the first step, p of the stress that minimises S under |τ| ≤ μ p; as it is where
/// no contact has Coulomb's law. \param degree of the displacements \throw scene::Error (ill_posed) where no such
/// stress balances the loads
template <int dim> scene::Problem<dim> with_first_friction(scene::Problem<dim> problem, int degree);

/// Takes steps (of displacements of degree 1 or 2, whose stresses are linear) until the residual η of Coulomb's law is
/// at most twice the width of the step's own bracket, at most 30: the bound of each is μ times the pressure of the one
/// before at the ends of each facet, linear between. \param meshed on a mesh of its own, with the bounds of some step;
/// what a contact facet was found to do is updated \return the same with the bounds of the last step, its fields,
/// Meshed::friction
template <int dim> Meshed<dim> with_friction_settled(Meshed<dim> meshed, int degree, const Observer<dim>& observer);

}  // namespace bracket::bounds
