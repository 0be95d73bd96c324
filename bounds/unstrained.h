// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/estimate/estimate.h"

namespace bracket::bounds {

/// Whether there are no loads and the bodies but follow the prescribed displacements and gaps, rigidly: u_h has no more
/// strain energy than the rounding of those data makes. Then L(u) is 0, as 0 ≤ L(u) ≤ L(u_h); and so is the best
/// stress, λ = 0, which is in K⁺_{0,0}.
template <int dim> bool is_unstrained(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement);

/// The strain energy that displacements of a degree make which are anything, but no larger than `size`, at every node:
/// a polynomial's slope is up to its degree squared times that of a line [Markov].
template <int dim> double energy_of_noise(const scene::Problem<dim>& problem, int degree, double size);

/// λ = 0 \param degree of it
template <int dim> scene::Stress<dim> no_stress(const scene::Mesh<dim>& mesh, int degree);
/// u = `translation` everywhere
template <int dim>
scene::Displacement<dim> translated(const scene::Mesh<dim>& mesh, int degree, const scene::Vector<dim>& translation);

}  // namespace bracket::bounds
