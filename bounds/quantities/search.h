// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/quantities/pair.h"

/// The choice of s (docs/theory.md §10.3).
namespace bracket::bounds {

/// What is known of a functional's s from the level before.
struct Guess {
  double s = 0;        ///< 0: nothing; any positive number
  bool moves = false;  ///< whether the contact of the pair moved so that its width showed it
  std::array<Closed, 2> closed = {};
};

/// The factors that are tried: powers of two, down to where rounding drowns the perturbation.
inline constexpr double smallest_factor = 0x1p-120;
double power_of_two(double x);  ///< the nearest by its logarithm. \pre x > 0

/// The pair with the least width that was found among powers of two. An s for which one of the four problems has no
/// solution is too large, and is made smaller.
/// \param a what A is of the unperturbed fields: the sum of their indicators, contact twice
/// \param most pairs to be solved at most, those without a solution not counted
template <int dim>
Attempt<dim> best_pair(const scene::Problem<dim>& problem, const Solvers<dim>& solvers,
                       const std::shared_ptr<const scene::Perturbation<dim>>& by, const Guess& guess, double a,
                       int most);

}  // namespace bracket::bounds
