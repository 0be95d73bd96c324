// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bracket::tests {

/// What was found of some quantities of one scene on three meshes.
struct QuantitiesVerdict {
  std::vector<std::string> faults;
  std::string text;   ///< the scene and what was asked
  int asked = 0;      ///< quantities that the scene has
  int refused = 0;    ///< as not determined, or none that the scene has
  int both_ends = 0;  ///< with two finite bounds on the last mesh
  int one_end = 0;
};

/// A random scene (random_scenes.h, or with laws random_laws.h) with up to three quantities of random kinds, parts,
/// directions and weights, and with the shear force and the slip of each contact with Tresca's friction, on three
/// nested meshes with both degrees. Faults are intervals that cross or exclude each other, and endings that are none.
QuantitiesVerdict judge_random_quantities(std::uint64_t seed, bool laws = false);

}  // namespace bracket::tests
