// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bracket::tests {

/// What was found of one problem on three meshes.
struct SidesVerdict {
  std::vector<std::string> faults;
  int bracketed = 0;  ///< of the three meshes
};

/// One or two blocks on a long one, that overhang it, at a distance or touching it, with an interference or a gap, as
/// pairs of their own or as one side of several parts: one problem, whose sides three meshes cut in different edges.
/// Faults are bounds that cross, intervals of two meshes that exclude each other, and energies that change by more than
/// 1e-12 where the two sides are swapped. A seed gives the same problem everywhere.
SidesVerdict judge_random_sides(std::uint64_t seed);

}  // namespace bracket::tests
