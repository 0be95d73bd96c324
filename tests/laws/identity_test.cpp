// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// The gap identity of each law: the width is the sum of the indicators, and none of them is negative.
#include <gtest/gtest.h>

#include <algorithm>

#include "bounds/estimate/estimate.h"
#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/laws/pairs.h"

namespace bracket::tests {
namespace {

void expect_identity(const scene::Problem<2>& problem, int degree) {
  const auto primal = primal::solve(problem, degree);
  const auto dual = dual::solve(problem, scene::stress_degree(degree));
  ASSERT_EQ(primal.reason + dual.reason, "");
  const auto indicator = bounds::indicator(problem, primal.displacement, dual.stress);
  const auto plain = bounds::plain_energies(problem, primal.displacement, dual.stress, indicator);
  const double energy = std::max(std::abs(plain.lower), std::abs(plain.upper)), width = plain.upper - plain.lower;
  EXPECT_NEAR(indicator.sum, width, std::max(1e-10 * width, 1e-14 * energy));
  EXPECT_GT(width, -1e-14 * energy);
  EXPECT_GE(std::ranges::min(indicator.contact), -1e-14 * energy);
  const auto checks = bounds::admissibility(problem, primal.displacement, dual.stress);
  EXPECT_TRUE(checks.passed()) << checks.worst().name << " " << checks.worst().value;
  EXPECT_LT(width, 0.3 * energy) << plain.lower << " " << plain.upper;
}

TEST(Laws, TheWidthIsTheSumOfIndicators) {
  for (const NamedLaw& law : laws())
    for (const int degree : {1, 2, 3, 4})
      for (const bool lift_off : {true, false}) {
        SCOPED_TRACE(testing::Message() << law.name << ", degree " << degree << (lift_off ? ", lift-off" : ""));
        expect_identity(problem(with_law(two_blocks(4, lift_off ? 0.09 : 0.02), law)), degree);
      }
}

}  // namespace
}  // namespace bracket::tests
