// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/bounds.h"

namespace bracket::apps {

/// u_h and σ(u_h) = C ε(u_h) at a point of a cell.
template <int dim> struct Sample {
  scene::Vector<dim> displacement;
  scene::Voigt<dim> stress;
};

/// \param at barycentric coordinates with respect to the vertices of the cell
template <int dim>
Sample<dim> sample(const scene::Problem<dim>& problem, const primal::Displacement<dim>& displacement, int cell,
                   const scene::Vector<dim + 1>& at);

}  // namespace bracket::apps
