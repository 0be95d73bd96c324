// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// What the axes, the numbers of vertices and cells, and the mesh have no part in.
#include <gtest/gtest.h>

#include <random>

#include "bounds/bounds.h"
#include "bounds/estimate/on_mesh.h"
#include "tests/scene/space/boxes.h"
#include "tests/space/random_boxes.h"
#include "tests/support/sanitized.h"

namespace bracket {
namespace {

using namespace tests::space;

bounds::Outcome<3> solved_on(scene::Scene<3> scene, scene::Strategy strategy, int levels) {
  scene.refine.strategy = strategy;
  scene.refine.max_levels = levels;
  scene.refine.target = 0;
  return bounds::run(scene);
}

void expect_guaranteed(const bounds::Outcome<3>& outcome, const std::string& name) {
  EXPECT_EQ(outcome.guarantee, "rounding-safe") << name << ": " << outcome.reason;
  for (const bounds::Level& level : outcome.levels) {
    EXPECT_LE(level.bracket.lower, level.bracket.upper) << name;
    EXPECT_TRUE(level.checks.passed()) << name << " " << level.checks.worst().name;  // p ≥ 0 among others
  }
}

/// The same problem has them, on whatever meshes.
void expect_meet(const std::vector<bounds::Outcome<3>>& all, const std::string& name) {
  double lower = -std::numeric_limits<double>::infinity(), upper = -lower;
  for (const auto& outcome : all)
    for (const bounds::Level& level : outcome.levels) {
      lower = std::max(lower, level.bracket.lower);
      upper = std::min(upper, level.bracket.upper);
    }
  EXPECT_LE(lower, upper) << name;
}

TEST(Turned, bounds_do_not_know_the_axes) {
  std::mt19937 random(5);
  for (const double poisson : tests::sanitized ? std::vector{0.3} : std::vector{0.0, 0.3, 0.49}) {
    RandomBoxes boxes = solvable_boxes(random);
    boxes.poisson = {poisson, poisson};
    const scene::Mesh<3> mesh = refined_once(boxes, 2, random);
    const auto straight = solved_on(boxes.on(mesh), scene::Strategy::none, 1);
    for (int round = 0; round < 2; ++round) {
      RandomBoxes turned = boxes;
      turned.rotation = scene::test::random_rotation(random);
      const auto other = solved_on(turned.on(mesh), scene::Strategy::none, 1);
      const double size = 1e-11 * std::abs(straight.upper);
      EXPECT_NEAR(other.lower, straight.lower, size) << poisson;
      EXPECT_NEAR(other.upper, straight.upper, size) << poisson;
      const auto refined_after = solved_on(turned.on(mesh), scene::Strategy::adaptive, 4);
      expect_guaranteed(refined_after, "turned");
      expect_meet({straight, other, refined_after}, "turned");
    }
  }
}

TEST(Turned, numbers_of_vertices_cells_and_parts_do_not_count) {
  std::mt19937 random(6);
  for (int round = 0; round < (tests::sanitized ? 2 : 4); ++round) {
    const RandomBoxes boxes = solvable_boxes(random);
    const scene::Mesh<3> mesh = refined_once(boxes, 2, random);
    const scene::Scene<3> scene = boxes.on(mesh);
    const auto one = solved_on(scene, scene::Strategy::none, 1);
    const auto other = solved_on(renumbered(scene, random), scene::Strategy::none, 1);
    expect_guaranteed(other, "renumbered");
    expect_meet({one, other}, "renumbered");
    // Of the stresses the stars are, in the order of vertices: lower bounds differ.
    EXPECT_NEAR(one.upper, other.upper, 1e-10 * std::abs(one.upper));
  }
}

TEST(Turned, three_meshes_of_one_problem_never_exclude_each_other) {
  std::mt19937 random(7);
  for (int round = 0; round < (tests::sanitized ? 2 : 8); ++round) {
    const RandomBoxes boxes = solvable_boxes(random);
    const std::string name = "round " + std::to_string(round);
    const std::vector<bounds::Outcome<3>> all = {
        solved_on(boxes.on(boxes.mesh(2, random)), scene::Strategy::adaptive, 4),
        solved_on(renumbered(boxes.on(boxes.mesh(2, random)), random), scene::Strategy::uniform, 2),
        solved_on(boxes.on(boxes.mesh(3, random)), scene::Strategy::none, 1)};
    for (const auto& outcome : all) expect_guaranteed(outcome, name);
    expect_meet(all, name);
  }
}

}  // namespace
}  // namespace bracket
