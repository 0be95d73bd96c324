// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bounds/bounds.h"
#include "tests/space/scenes.h"
#include "tests/support/sanitized.h"

namespace bracket {
namespace {

using namespace tests::space;

/// What holds on every level of every run.
void expect_sound(const bounds::Outcome<3>& outcome, double identity = 1e-10) {
  ASSERT_FALSE(outcome.levels.empty()) << outcome.reason;
  EXPECT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
  for (const bounds::Level& level : outcome.levels) {
    EXPECT_TRUE(level.certificate.valid) << level.certificate.reason;
    EXPECT_LE(level.bracket.lower, level.bracket.upper);
    EXPECT_LE(level.checks.gap_identity, identity) << level.cells << " cells";
    EXPECT_TRUE(level.checks.passed()) << level.checks.worst().name << " " << level.checks.worst().value;
  }
}

/// \param least, most between which the exact energy lies
void expect_contains(const bounds::Outcome<3>& outcome, double least, double most) {
  for (const bounds::Level& level : outcome.levels) {
    EXPECT_LE(level.bracket.lower, least) << level.cells << " cells";
    EXPECT_GE(level.bracket.upper, most) << level.cells << " cells";
  }
}

scene::Scene<3> refined(scene::Scene<3> scene, scene::Strategy strategy, int levels) {
  scene.refine.strategy = strategy;
  scene.refine.max_levels = levels;
  return scene;
}

TEST(RunInSpace, what_is_in_both_spaces_is_found_exactly) {
  for (const double poisson : {0.3, 0.49, 0.4999})
    for (const auto& [scene, exact] :
         {std::pair(linear_pressure(2, poisson), linear_pressure_energy), std::pair(patch(2, poisson), patch_energy)}) {
      const auto outcome = bounds::run(refined(scene, scene::Strategy::uniform, 2));
      expect_sound(outcome);
      for (const bounds::Level& level : outcome.levels) {
        EXPECT_LE(level.bracket.lower, exact);
        EXPECT_GE(level.bracket.upper, exact);
        EXPECT_NEAR(level.bracket.lower, exact, 1e-9 * std::abs(exact)) << poisson;
        EXPECT_NEAR(level.bracket.upper, exact, 1e-9 * std::abs(exact)) << poisson;
      }
    }
}

TEST(RunInSpace, partial_lift_off_extruded_contains_what_the_plane_knows) {
  if (tests::sanitized) GTEST_SKIP();
  scene::Scene<3> scene = refined(two_blocks(2), scene::Strategy::adaptive, 30);
  scene.refine.target = 0.03;
  const auto outcome = bounds::run(scene);
  expect_sound(outcome);
  expect_contains(outcome, two_blocks_least, two_blocks_most);
  EXPECT_EQ(outcome.status, scene::Status::done);
  EXPECT_LE(outcome.levels.back().cells, 3500);
  const auto &first = outcome.levels.front(), &last = outcome.levels.back();
  const auto width = [](const bounds::Level& level) { return level.bracket.upper - level.bracket.lower; };
  EXPECT_LE(std::log(width(last) / width(first)) / std::log(static_cast<double>(last.cells) / first.cells), -1.0);
  double before = std::numeric_limits<double>::infinity();
  for (const bounds::Level& level : outcome.levels) {
    EXPECT_LE(level.plain.upper, before + 1e-12 * std::abs(before));  // K_h are nested
    before = level.plain.upper;
  }
}

TEST(RunInSpace, everything_at_once_is_sound_on_every_level) {
  const auto outcome = bounds::run(refined(everything(2), scene::Strategy::adaptive, 5));
  expect_sound(outcome);
  double lower = -std::numeric_limits<double>::infinity(), upper = -lower;
  for (const bounds::Level& level : outcome.levels) {
    lower = std::max(lower, level.bracket.lower);
    upper = std::min(upper, level.bracket.upper);
  }
  EXPECT_LE(lower, upper);
  const auto finer = bounds::run(refined(everything(tests::sanitized ? 3 : 4), scene::Strategy::none, 1));
  expect_sound(finer);
  EXPECT_LE(std::max(lower, finer.lower), std::min(upper, finer.upper));
}

TEST(RunInSpace, linear_displacements_have_bounds_too) {
  scene::Scene<3> scene = refined(two_blocks(2), scene::Strategy::uniform, 3);
  scene.solve.degree = 1;
  const auto outcome = bounds::run(scene);
  expect_sound(outcome);
  expect_contains(outcome, two_blocks_least, two_blocks_most);
}

TEST(RunInSpace, a_body_on_a_wall_lifts_off_whatever_its_poisson_s_ratio) {
  for (const double poisson : {0.3, 0.4999}) {
    const auto outcome = bounds::run(refined(on_a_wall(2, poisson), scene::Strategy::adaptive, 4));
    expect_sound(outcome, poisson < 0.49 ? 1e-10 : 3e-8);
    EXPECT_LT(outcome.levels.back().primal.active_rows, outcome.levels.back().primal.rows);
    EXPECT_GT(outcome.levels.back().primal.active_rows, 0);
  }
}

// Contacts press that no load asks for: they hold the body all the same. A bar shortened by 0.03.
TEST(RunInSpace, a_body_squeezed_between_walls_is_held_by_them) {
  scene::Scene<3> s;
  s.blocks = {block("bar", {0, 1}, {0, 1}, {0, 1}, {2, 1, 1})};
  s.bodies = {{"bar", isotropic(1, 0.3)}};
  s.contact = {{"bar.left", "rigid", -0.01, ""}, {"bar.right", "rigid", -0.02, ""}};
  const auto outcome = bounds::run(refined(s, scene::Strategy::uniform, 3));
  expect_sound(outcome);
  expect_contains(outcome, 0.03 * 0.03 / 2, 0.03 * 0.03 / 2);
  EXPECT_LE(outcome.upper - outcome.lower, 1e-12);
}

TEST(RunInSpace, what_nothing_holds_is_named) {
  scene::Scene<3> scene = two_blocks(2);
  scene.boundary.at("upper.top") = traction(0.0, 0.1, 0.0);
  try {
    bounds::run(scene);
    FAIL();
  } catch (const scene::Error& error) {
    EXPECT_EQ(error.status(), scene::Status::ill_posed);
    EXPECT_NE(std::string(error.what()).find("'upper'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace bracket
