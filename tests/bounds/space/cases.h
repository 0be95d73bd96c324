// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bounds/space/problems.h"

/// Small problems in space with all kinds of data, and fields near which their solutions might be.
namespace bracket::tests {

struct SpaceCase {
  const char* name;
  scene::Problem<3> problem;    ///< on its first mesh
  scene::Voigt<3> mean_stress;  ///< about what the loads cause
};

/// A block pressed on one that is clamped, with data that vary linearly: its sides slide, contact, weight,
/// interference.
SpaceCase clamped();
/// A block in a corner: on a body and two walls, held by contact alone; its gaps are quadratics.
SpaceCase cornered(const Warp& warp = [](const Vector<3>& x) { return x; });
/// Two blocks on each other and on a plane, both free to move along it; loads in balance but for rounding.
SpaceCase floating();
/// Blocks that keep together and a wall from which one does not lift off. \param bend of the gap
SpaceCase together(double bend);
std::vector<SpaceCase> all_cases();

/// A turn by no special angle about no special axis, far away.
Warp turned_away();
/// As many facets of a support.
int facet_with(const scene::Problem<3>& problem, scene::Support support);

}  // namespace bracket::tests
