// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dual/local/star.h"

namespace bracket::dual {

/// σ̄: at each vertex and for each body there, deviators are the means of the cells' own, by volume, pressures the
/// affine function closest to the cells' mean pressures. Both keep what is linear.
template <int dim>
std::vector<LinearStress<dim>> smoothed(const scene::Problem<dim>& problem, const std::vector<Star<dim>>& stars,
                                        const scene::Displacement<dim>& displacement);

}  // namespace bracket::dual
