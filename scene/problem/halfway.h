// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "scene/text.h"

namespace bracket::scene {

/// Halfway between two points of a simplex, in its barycentric coordinates.
/// \throw Error (budget) if that needs more than 52 binary places
template <std::size_t d> std::array<double, d> halfway(const std::array<double, d>& a, const std::array<double, d>& b) {
  std::array<double, d> middle;
  for (std::size_t i = 0; i < d; ++i) {
    middle[i] = 0.5 * (a[i] + b[i]);
    // The coordinates are at most 1: a multiple of 2⁻⁵² shifted by one is one still.
    if ((1 + middle[i]) - 1 == middle[i]) continue;
    fail(Status::budget, "", "the mesh cannot be refined any further: its cells are 52 halvings small");
  }
  return middle;
}

}  // namespace bracket::scene
