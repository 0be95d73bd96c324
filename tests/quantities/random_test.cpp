// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/support/random_functionals.h"
#include "tests/support/random_quantities.h"

namespace bracket::tests {
namespace {

// A slice of what bracket_random_quantities does.
TEST(RandomQuantities, never_exclude_each_other) {
  int both = 0;
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    const auto verdict = judge_random_quantities(seed);
    both += verdict.both_ends;
    for (const auto& fault : verdict.faults) ADD_FAILURE() << "seed " << seed << "\n" << verdict.text << fault;
  }
  EXPECT_GE(both, 12);
}

// A slice of what bracket_random_functionals does.
TEST(RandomFunctionals, bounds_are_on_their_side) {
  int pairs = 0;
  double least = 1;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const auto verdict = judge_random_functionals(seed);
    pairs += verdict.pairs;
    least = std::min(least, verdict.least);
    for (const auto& fault : verdict.faults) ADD_FAILURE() << fault;
  }
  EXPECT_GE(pairs, 400);
  EXPECT_LE(least, 1e-3);  // some are sharp: a wrong sign would be seen
}

}  // namespace
}  // namespace bracket::tests
