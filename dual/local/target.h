// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dual/local/star.h"

namespace bracket::dual {

/// The stress σ* that stars hand out (docs/theory.md §12.3): linear on each cell, close to that of a displacement, with
///     ∫ σ* : ε(ψ_a ρ) = ∫ F · ψ_a ρ + Σ ∫ ψ_a t · ρ   for every vertex a and every motion ρ that its supports leave,
/// t the given loads: σ* = σ̄ + C′ ε(w) with σ̄ smoothed and w = Σ ψ_a ρ_a, six unknowns a vertex (three in the plane),
/// C′ compressible whatever the material is. \param displacement of degree 1 or 2 \pre the given loads and F are in
/// balance along all motions that the supports leave
template <int dim>
std::vector<LinearStress<dim>> target_stress(const scene::Problem<dim>& problem, const Facets<dim>& facets,
                                             const std::vector<Star<dim>>& stars,
                                             const std::vector<FacetVector<dim>>& given,
                                             const scene::Displacement<dim>& displacement);

}  // namespace bracket::dual
