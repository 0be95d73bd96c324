// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <set>

#include "bounds/bounds.h"

namespace bracket {
namespace {

/// What is known of the energy of a scene that comes with the program.
struct Known {
  const char* scene;
  double least, most;
};
const Known known[] = {{"fichera", -43.5193410997, -43.1368075638},  // as a finer mesh has it
                       {"lift_off", -0.00156588569415 / 2, -0.00156588566432 / 2},
                       {"linear_pressure", -3.3125, -3.3125},
                       {"patch", 50, 50}};

TEST(SceneFilesInSpace, every_level_contains_what_is_known) {
  std::set<std::string> there, tested;
  for (const auto& entry : std::filesystem::directory_iterator(BRACKET_SCENES "/space"))
    if (entry.path().extension() == ".toml") there.insert(entry.path().stem());
  for (const auto& [name, least, most] : known) {
    tested.insert(name);
    const auto scene =
        scene::read_scene<3>(std::string(BRACKET_SCENES "/space/") + name + ".toml", {"refine.max_levels=6"});
    const auto outcome = bounds::run(scene);
    EXPECT_EQ(outcome.guarantee, "rounding-safe") << name << ": " << outcome.reason;
    for (const bounds::Level& level : outcome.levels) {
      EXPECT_LE(level.bracket.lower, most) << name;
      EXPECT_GE(level.bracket.upper, least) << name;
      EXPECT_LE(level.checks.gap_identity, 1e-10) << name;
    }
  }
  EXPECT_EQ(there, tested);
}

}  // namespace
}  // namespace bracket
