// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>

#include "tests/support/interval_faults.h"
#include "tests/support/random_laws.h"
#include "tests/support/random_quantities.h"
#include "tests/support/sanitized.h"

namespace bracket::tests {
namespace {

/// Parts of the first of the scenes that bracket_random_laws judges, for different processes.
class RandomLaws : public testing::TestWithParam<int> {};

TEST_P(RandomLaws, HaveIntervalsThatMeetOrAreRefused) {
  constexpr int scenes = 40;
  std::map<scene::Status, int> endings;
  for (std::uint64_t seed = scenes * GetParam() + 1; seed <= scenes * (GetParam() + 1u); ++seed) {
    const RandomScene random = random_laws(seed);
    const Verdict verdict = judge(random.scene, random.mesh);
    ++endings[verdict.status];
    for (const std::string& fault : verdict.faults)
      ADD_FAILURE() << "seed " << seed << "\n" << fault << "\n" << random.text;
  }
  EXPECT_GE(endings[scene::Status::done], scenes / 4);
}

TEST_P(RandomLaws, HaveQuantitiesThatMeetOrAreRefused) {
  constexpr int scenes = 8;
  int both_ends = 0;
  for (std::uint64_t seed = scenes * GetParam() + 1; seed <= scenes * (GetParam() + 1u); ++seed) {
    const QuantitiesVerdict verdict = judge_random_quantities(seed, true);
    both_ends += verdict.both_ends;
    for (const std::string& fault : verdict.faults)
      ADD_FAILURE() << "seed " << seed << "\n" << fault << "\n" << verdict.text;
  }
  EXPECT_GE(both_ends, 1);
}

INSTANTIATE_TEST_SUITE_P(RandomScenes, RandomLaws, testing::Range(0, sanitized ? 1 : 4));

}  // namespace
}  // namespace bracket::tests
