// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

/// Small scenes that a judge in rational arithmetic can follow, each with something of its own.
namespace bracket::tests {

/// Scenes whose boundary facets have rational lengths where they carry tractions, along axes or after map().
struct Case {
  std::string name;
  scene::Scene<2> scene;
  bool inclined = false;
  double disturb = 0;  ///< how far inner vertices are moved
};
std::vector<Case> cases();

/// Exact arithmetic is slow where addresses are looked at: there one scene in five, with degrees and kinds in turn,
/// goes the same ways.
inline const int one_in = sanitized ? 5 : 1;

/// A block whose prescribed end just touches the wall.
scene::Scene<2> touching_end(double down);

/// On its first mesh, with its loads in balance.
scene::Problem<2> problem_of(const Case& c);

}  // namespace bracket::tests
