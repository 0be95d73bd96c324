// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>

#include "bounds/bounds.h"
#include "dual/dual.h"
#include "tests/support/interval_faults.h"
#include "tests/support/random_scenes.h"

namespace bracket::tests {
namespace {

/// Parts of the first of the scenes that bracket_random_scenes judges, for different processes.
class RandomPart : public testing::TestWithParam<int> {};

TEST_P(RandomPart, has_intervals_that_meet_or_are_refused) {
  constexpr int scenes = 50;
  std::map<scene::Status, int> endings;
  for (std::uint64_t seed = scenes * GetParam() + 1; seed <= scenes * (GetParam() + 1u); ++seed) {
    const RandomScene random = random_scene(seed);
    const Verdict verdict = judge(random.scene, random.mesh);
    ++endings[verdict.status];
    for (const std::string& fault : verdict.faults) ADD_FAILURE() << fault << "\n" << random.text;
  }
  // Both kinds are among them, or nothing would have been tested.
  EXPECT_GE(endings[scene::Status::done], scenes / 5);
  EXPECT_GE(endings[scene::Status::ill_posed], scenes / 10);
}

INSTANTIATE_TEST_SUITE_P(RandomScenes, RandomPart, testing::Range(0, 4));

// Contacts that carry but the rounding of bodies at rest, which nothing else holds in some direction.
TEST(RandomScenes, have_certificates_where_pressures_are_rounding) {
  for (const std::uint64_t seed : {37, 97, 205}) {
    const RandomScene random = random_scene(seed);
    EXPECT_EQ(judge(random.scene, random.mesh).status, scene::Status::done) << random.text;
  }
}

// Among them are slivers and moduli that differ by 1e8, whose stresses are rounded by up to 3000 ε of the largest.
TEST(RandomScenes, press_nowhere_but_on_closed_rows) {
  for (const std::uint64_t seed : {6, 15, 16, 37, 58, 150, 169, 226, 294, 400}) {
    const RandomScene random = random_scene(seed);
    const auto problem = bounds::balanced(scene::fix_data(random.scene, random.mesh), 2);
    const auto solved = dual::solve(problem, 1);
    const auto pressure = bounds::contact_pressure(problem, solved.stress);
    for (std::size_t j = 0; j < pressure.size(); ++j)
      if (!solved.closed[j]) {
        EXPECT_EQ(pressure[j], (std::vector<double>{0, 0})) << random.text;
      }
  }
}

TEST(RandomScenes, are_the_same_for_the_same_seed) {
  EXPECT_EQ(random_scene(7).text, random_scene(7).text);
  EXPECT_NE(random_scene(7).text, random_scene(8).text);
}

}  // namespace
}  // namespace bracket::tests
