// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "bounds/bounds.h"

namespace bracket::tests {

/// What must hold on every level of every scene: the bounds are ordered, the checks pass, and the sum of the indicators
/// is the width to 1e-10 of it or 1e-14 of the energy.
inline void expect_admissible(const bounds::Outcome<2>& outcome) {
  ASSERT_FALSE(outcome.levels.empty());
  const bool coulomb =
      std::ranges::any_of(outcome.problem.contact, [](const auto& pair) { return pair.law.coulomb > 0; });
  EXPECT_EQ(outcome.guarantee, coulomb                   ? "tresca-step"
                               : outcome.problem.sampled ? "discretisation"
                                                         : "rounding-safe")
      << outcome.reason;
  for (const auto& level : outcome.levels) {
    EXPECT_LE(level.bracket.lower, level.bracket.upper);
    EXPECT_TRUE(level.checks.passed());
    EXPECT_LE(level.plain.gap_identity, std::max(1e-10 * level.bracket.relative_width, 1e-14));
  }
}

/// lower ≤ exact ≤ upper, to `tolerance` of the energy and up to what fixing the data edgewise did to it.
inline void expect_between(const bounds::Level& level, double exact, double tolerance) {
  const double slack = tolerance * std::abs(exact) + level.oscillation_energy;
  EXPECT_LE(level.bracket.lower, exact + slack);
  EXPECT_GE(level.bracket.upper, exact - slack);
}

}  // namespace bracket::tests
