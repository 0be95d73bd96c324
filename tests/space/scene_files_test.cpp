// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "bounds/bounds.h"
#include "bounds/results.h"
#include "tests/support/sanitized.h"

namespace bracket {
namespace {

/// What is known of the energy of a scene that comes with the program.
struct Known {
  const char* scene;
  double least, most;
  int levels = 6;
};
const Known known[] = {{"bolted_joint", 5.40, 5.60, 2},              // as a finer mesh has it
                       {"fichera", -43.5193410997, -43.1368075638},  // the same
                       {"hertz", 1.58824245e-6, 1.58881162e-6, 10},  // the same
                       {"lift_off", -0.00156588569415 / 2, -0.00156588566432 / 2},
                       {"linear_pressure", -3.3125, -3.3125},
                       {"patch", 50, 50},
                       {"trough", -0.00251594041, -0.00251587952}};  // the same

scene::Scene<3> from_file(const std::string& name, int levels) {
  return scene::read_scene<3>(BRACKET_SCENES "/space/" + name + ".toml",
                              {"refine.max_levels=" + std::to_string(levels)});
}

TEST(SceneFilesInSpace, every_level_contains_what_is_known) {
  std::set<std::string> there, tested;
  for (const auto& entry : std::filesystem::directory_iterator(BRACKET_SCENES "/space"))
    if (entry.path().extension() == ".toml") there.insert(entry.path().stem());
  for (const auto& [name, least, most, levels] : known) {
    tested.insert(name);
    const auto outcome = bounds::run(from_file(name, tests::sanitized ? std::min(levels, 2) : levels));
    EXPECT_EQ(outcome.guarantee, "rounding-safe") << name << ": " << outcome.reason;
    for (const bounds::Level& level : outcome.levels) {
      EXPECT_LE(level.bracket.lower, most) << name;
      EXPECT_GE(level.bracket.upper, least) << name;
      EXPECT_LE(level.checks.gap_identity, 1e-10) << name;
    }
  }
  EXPECT_EQ(there, tested);
}

double force(const bounds::Outcome<3>& outcome, int pair) {
  return bounds::contact_result(outcome.problem, outcome.stress, pair).resultant.force.norm();
}

// Forces of stresses in equilibrium are what statics says, on any mesh.
TEST(SceneFilesInSpace, contacts_carry_what_balance_demands) {
  for (const int levels : {1, 4}) {
    const auto trough = bounds::run(from_file("trough", levels));
    EXPECT_NEAR(force(trough, 0), 0.05 * 1.5, 1e-12);
    EXPECT_NEAR(force(trough, 1), 0.1 * std::sqrt(0.75) * 1.5 - 0.1 * (1.5 * 1.5 / 2 - 0.5 * 1.5), 1e-12);
  }
  const auto bolted = bounds::run(from_file("bolted_joint", 1));
  const double joint = force(bolted, 0), head = force(bolted, 1), nut = force(bolted, 2);
  EXPECT_NEAR(head, nut, 1e-9 * head);
  EXPECT_NEAR(head, joint + 3.0 * 2 * 12 * 6, 1e-9 * head);
}

// A displacement of the octant is one of the half-space.
TEST(SceneFilesInSpace, an_octant_takes_no_less_energy_than_hertz_half_space) {
  if (tests::sanitized) GTEST_SKIP();
  const double modulus = 1 / (1 - 0.3 * 0.3), depth = 0.01;
  const double hertz = 2 / 15.0 * modulus * std::pow(depth, 2.5);
  const auto outcome = bounds::run(from_file("hertz", 14));
  EXPECT_GE(outcome.lower, hertz);
  EXPECT_LE(outcome.lower, 1.084 * hertz);
}

// What closure makes besides what is marked, and what becomes of shapes, where errors say what is marked.
TEST(SceneFilesInSpace, refinement_makes_few_cells_and_keeps_shapes) {
  const std::size_t cells = tests::sanitized ? 150 : 1000;
  std::vector<const char*> names = {"lift_off"};
  if (!tests::sanitized) names.insert(names.end(), {"bolted_joint", "fichera", "hertz", "trough"});
  for (const char* name : names) {
    const scene::Scene<3> scene = from_file(name, 1);
    scene::Problem<3> problem = scene::fix_data(scene, scene::build_mesh(scene));
    const double first = scene::quality(problem.mesh).smallest_shape;
    double made = 0, marks = 0;
    while (problem.mesh.cells.size() < cells || marks == 0) {
      const auto outcome = bounds::run(scene, problem);
      const auto marked = bounds::mark(outcome.problem, outcome.indicator, scene.refine.bulk);
      marks += static_cast<double>(std::ranges::count(marked, 1));
      made -= static_cast<double>(problem.mesh.cells.size());
      problem = scene::refine(outcome.problem, marked).problem;
      made += static_cast<double>(problem.mesh.cells.size());
    }
    EXPECT_LE(made, 6 * marks) << name;
    EXPECT_GE(scene::quality(problem.mesh).smallest_shape, 0.5 * first) << name;
  }
}

}  // namespace
}  // namespace bracket
