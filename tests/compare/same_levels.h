// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bounds/bounds.h"

namespace bracket::tests {

/// The two runs have as many levels, with the same bounds within `tolerance` of the smaller of their sizes.
inline void expect_same_levels(const bounds::Outcome<2>& one, const bounds::Outcome<2>& other, double tolerance) {
  ASSERT_EQ(one.levels.size(), other.levels.size());
  for (std::size_t i = 0; i < one.levels.size(); ++i) {
    const bounds::Bracket &a = one.levels[i].bracket, &b = other.levels[i].bracket;
    const double near = tolerance * std::min(std::abs(a.lower), std::abs(a.upper));
    EXPECT_NEAR(a.lower, b.lower, near) << "level " << i;
    EXPECT_NEAR(a.upper, b.upper, near) << "level " << i;
  }
}

}  // namespace bracket::tests
