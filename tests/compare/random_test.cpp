// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>

#include "tests/support/interval_faults.h"
#include "tests/support/random_scenes.h"

namespace bracket::tests {
namespace {

// The first of the scenes that bracket_random_scenes judges.
TEST(RandomScenes, have_intervals_that_meet_or_are_refused) {
  std::map<scene::Status, int> endings;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const RandomScene random = random_scene(seed);
    const Verdict verdict = judge(random.scene, random.mesh);
    ++endings[verdict.status];
    for (const std::string& fault : verdict.faults) ADD_FAILURE() << fault << "\n" << random.text;
  }
  // Both kinds are among them, or nothing would have been tested.
  EXPECT_GE(endings[scene::Status::done], 60);
  EXPECT_GE(endings[scene::Status::ill_posed], 40);
}

// Contacts that carry but the rounding of bodies at rest, which nothing else holds in some direction.
TEST(RandomScenes, have_certificates_where_pressures_are_rounding) {
  for (const std::uint64_t seed : {37, 97, 205}) {
    const RandomScene random = random_scene(seed);
    EXPECT_EQ(judge(random.scene, random.mesh).status, scene::Status::done) << random.text;
  }
}

TEST(RandomScenes, are_the_same_for_the_same_seed) {
  EXPECT_EQ(random_scene(7).text, random_scene(7).text);
  EXPECT_NE(random_scene(7).text, random_scene(8).text);
}

}  // namespace
}  // namespace bracket::tests
