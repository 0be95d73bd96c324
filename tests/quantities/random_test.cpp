// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/support/random_quantities.h"

namespace bracket::tests {
namespace {

// A slice of what bracket_random_quantities does.
TEST(RandomQuantities, never_exclude_each_other) {
  int both = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto verdict = judge_random_quantities(seed);
    both += verdict.both_ends;
    for (const auto& fault : verdict.faults) ADD_FAILURE() << "seed " << seed << "\n" << verdict.text << fault;
  }
  EXPECT_GE(both, 20);
}

}  // namespace
}  // namespace bracket::tests
