// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function.h"

namespace bracket::scene {

/// A function on a stretch [from, to] of the edge from a to b.
struct Stretch {
  const Function<2>& function;  ///< enclosed
  const Vector<2>& a;
  const Vector<2>& b;
  double from, to;
  const std::string& where;  ///< for messages
};

/// Bernstein coefficients of a quadratic below the function: of those that are at least `at_least` at the ends and
/// nowhere below the least value of the function, as far as that is known, the one found with the largest mean; if none
/// admits `at_least`, of those that are nowhere below that value.
/// \throw Error (input) if the function has no value at some point, or no bound
std::array<double, 3> quadratic_below(const Stretch& stretch, const std::array<double, 2>& at_least);

}  // namespace bracket::scene
