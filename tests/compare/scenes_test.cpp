// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/compare/admissible.h"
#include "tests/compare/scene_files.h"

namespace bracket::tests {
namespace {

class EveryScene : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(EveryScene, bounds_hold_with_all_degrees_and_are_no_worse_with_a_higher_one) {
  std::array<bounds::Bracket, 4> brackets;
  const bool coulomb = scene::has_coulomb(scene::read_scene<2>(GetParam()));
  for (const int degree : {1, 2, 3, 4}) {
    if (coulomb && degree > 2) continue;
    const auto scene = scene::read_scene<2>(
        GetParam(), {"solve.degree=" + std::to_string(degree), "refine.strategy=none", "refine.target=0"});
    const auto outcome = bounds::run(scene);
    EXPECT_EQ(outcome.status, scene::Status::done) << outcome.reason;
    expect_admissible(outcome);
    brackets[degree - 1] = outcome.levels.back().bracket;
  }
  if (coulomb) return;  // each degree has a bound of the shear of its own
  // Degrees 1 and 2 have one dual problem. Raised coefficients are means: cones of displacements and of pressures are
  // nested, as the spaces are.
  const double scale = std::max(std::abs(brackets[0].upper), std::abs(brackets[0].lower));
  EXPECT_NEAR(brackets[0].lower, brackets[1].lower, 1e-13 * scale);
  const double rounding = 1e-12 * scale;  // that certificate_test.cpp leaves a certificate
  for (std::size_t k = 1; k < brackets.size(); ++k) {
    EXPECT_LE(brackets[k].upper, brackets[k - 1].upper + rounding) << "degree " << k + 1;
    EXPECT_GE(brackets[k].lower, brackets[k - 1].lower - rounding) << "degree " << k + 1;
  }
}

TEST_P(EveryScene, bounds_hold_on_every_level) {
  const auto scene =
      scene::read_scene<2>(GetParam(), {"refine.strategy=adaptive", "refine.target=0", "refine.max_levels=4"});
  const auto outcome = bounds::run(scene);
  EXPECT_EQ(outcome.levels.size(), 4u);
  expect_admissible(outcome);
}

TEST_P(EveryScene, displacements_close_the_gap_where_stresses_press) {
  const auto outcome = bounds::run(scene::read_scene<2>(GetParam(), {"refine.strategy=none"}));
  const auto& problem = outcome.problem;
  if (problem.contact.empty()) GTEST_SKIP() << "no contact";
  // Where the stresses press, the displacements leave no gap: ∫ p (g − r) is part of the width, each facet's share ≥ 0.
  const auto& bracket = outcome.levels.back().bracket;
  const double rounding = 1e-13 * std::max(std::abs(bracket.lower), std::abs(bracket.upper));
  double contact = 0;
  for (const double share : outcome.indicator.contact) {
    EXPECT_GE(share, -rounding);
    contact += share;
  }
  EXPECT_LE(contact, outcome.indicator.sum + rounding);
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::ValuesIn(scene_files()),
                         [](const auto& file) { return file.param.stem().string(); });

}  // namespace
}  // namespace bracket::tests
