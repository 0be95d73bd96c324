// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numeric>

#include "bounds/bounds.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

namespace bracket::bounds {
namespace {

using scene::Status;
using scene::Vector;

scene::Scene<2> adaptive(double target) {
  auto scene = tests::two_blocks(2);
  scene.refine = {.strategy = scene::Strategy::adaptive, .target = target, .max_cells = 20000};
  return scene;
}

TEST(Driver, stops_at_the_target) {
  const auto outcome = run(adaptive(0.02));
  EXPECT_EQ(outcome.status, Status::done);
  EXPECT_LE(outcome.relative_error_bound, 0.02);
  ASSERT_GE(outcome.levels.size(), 2u);
  EXPECT_GT(outcome.levels[outcome.levels.size() - 2].bracket.relative_error_bound, 0.02);
}

// Both sides prescribed so that they touch, in any direction: their gap is closed but for rounding, which nothing could
// make good.
TEST(Driver, sides_prescribed_to_touch_have_bounds) {
  const Vector<2> lower(0.1, 0.3), upper(-0.2, 0.07);
  for (const int degree : {1, 2, 3, 4})
    for (int angle = 0; angle < 20; ++angle) {
      auto scene = tests::two_blocks(2);
      scene.solve.degree = degree;
      scene.refine = {.strategy = scene::Strategy::uniform, .max_levels = 2};
      for (const char* side : {".left", ".right"}) {
        scene.boundary[std::string("lower") + side] = tests::fixed(lower[0], lower[1]);
        scene.boundary[std::string("upper") + side] = tests::fixed(upper[0], upper[1]);
      }
      scene.boundary.erase("lower.bottom");
      auto mesh = scene::build_mesh(scene);
      for (Vector<2>& x : mesh.vertices) x = Eigen::Rotation2Dd(0.3 * angle) * x;
      const auto without_gap = scene::fix_data(scene, mesh);
      const Vector<2> d = without_gap.facets[without_gap.contact[0].first].normal;
      scene.contact[0].gap = tests::constant((upper - lower).dot(d));
      const auto outcome = run(scene, scene::fix_data(scene, mesh));
      EXPECT_EQ(outcome.guarantee, "rounding-safe") << angle << ": " << outcome.reason;
      EXPECT_EQ(outcome.levels.size(), 2u) << angle;
    }
}

TEST(Driver, spends_its_budget_and_keeps_the_bounds) {
  auto levels = adaptive(1e-6);
  levels.refine.max_levels = 3;
  const auto three = run(levels);
  EXPECT_EQ(three.status, Status::budget);
  EXPECT_EQ(three.levels.size(), 3u);
  EXPECT_EQ(three.guarantee, "rounding-safe");
  EXPECT_NE(three.reason.find("max_levels"), std::string::npos) << three.reason;

  auto cells = adaptive(1e-6);
  cells.refine.max_cells = 100;
  const auto small = run(cells);
  EXPECT_EQ(small.status, Status::budget);
  EXPECT_LE(small.levels.back().cells, 100);

  auto unasked = adaptive(0);
  unasked.refine.max_levels = 2;
  EXPECT_EQ(run(unasked).status, Status::done);

  auto none = tests::two_blocks(2);
  none.refine.target = 1e-6;
  EXPECT_EQ(run(none).status, Status::budget);
}

TEST(Driver, stops_on_request_after_a_finished_level) {
  std::stop_source stop;
  Observer<2> observer;
  int levels = 0;
  observer.level = [&](const Outcome<2>& so_far) {
    EXPECT_EQ(static_cast<int>(so_far.levels.size()), ++levels);
    if (levels == 2) stop.request_stop();
  };
  observer.stop = stop.get_token();
  const auto outcome = run(adaptive(1e-6), observer);
  EXPECT_EQ(levels, 2);
  EXPECT_EQ(outcome.levels.size(), 2u);
  EXPECT_EQ(outcome.status, Status::budget);
}

TEST(Driver, intersects_its_levels_and_never_raises_the_upper_bound) {
  for (const auto strategy : {scene::Strategy::adaptive, scene::Strategy::uniform})
    for (const int degree : {1, 2, 3, 4}) {
      auto scene = adaptive(0);
      scene.refine.strategy = strategy;
      scene.refine.max_cells = tests::sanitized ? 600 : 3000;
      scene.solve.degree = degree;
      const auto outcome = run(scene);
      ASSERT_GT(outcome.levels.size(), 2u);
      double lower = outcome.levels[0].bracket.lower, upper = outcome.levels[0].bracket.upper;
      for (const auto& level : outcome.levels) {
        EXPECT_LE(level.bracket.upper, upper + 1e-13 * std::abs(upper));
        lower = std::max(lower, level.bracket.lower);
        upper = std::min(upper, level.bracket.upper);
      }
      EXPECT_EQ(outcome.lower, lower);
      EXPECT_EQ(outcome.upper, upper);
      EXPECT_LE(outcome.relative_error_bound, outcome.levels.back().bracket.relative_error_bound);
    }
}

TEST(Driver, uniform_refinement_agrees_with_another_mesh_of_that_size) {
  auto coarse = tests::two_blocks(4);
  coarse.refine = {.strategy = scene::Strategy::uniform, .max_levels = 3};
  const auto refined = run(coarse);
  const auto other = run(tests::two_blocks(16));
  ASSERT_EQ(refined.levels.size(), 3u);
  EXPECT_EQ(refined.levels[2].cells, other.levels[0].cells);
  EXPECT_LE(std::max(refined.lower, other.lower), std::min(refined.upper, other.upper));
  EXPECT_NEAR(std::log2((refined.upper - refined.lower) / (other.upper - other.lower)), 0, 1);
}

TEST(Driver, refines_where_a_coarse_mesh_cannot_balance_the_loads) {
  // The resultant acts within the outer third of the last edge: no linear pressure on one edge balances it, two do.
  scene::Scene<2> s;
  s.blocks = {tests::block("block", -1, 1, 0, 1, 1, 1)};
  s.bodies = {{"block", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
  s.contact = {{"block.bottom", "rigid", tests::constant(0), ""}};
  s.boundary = {{"block.top", tests::pressure([](const auto& x) { return 1 - 1.5 * x[0]; })}};
  const auto coarse = run(s);
  EXPECT_EQ(coarse.status, Status::not_guaranteed);
  EXPECT_TRUE(coarse.levels.empty());
  EXPECT_NE(coarse.reason.find("refine"), std::string::npos) << coarse.reason;
  s.refine = {.strategy = scene::Strategy::adaptive, .max_levels = 4};
  const auto refined = run(s);
  EXPECT_EQ(refined.status, Status::done);
  EXPECT_FALSE(refined.levels.empty());
}

/// Two blocks without loads, the upper one held by nothing but the contact.
scene::Scene<2> unloaded(double gap) {
  auto s = tests::two_blocks(4);
  s.boundary = {{"lower.bottom", tests::fixed(0, 0)}};
  s.contact[0].gap = tests::constant(gap);
  return s;
}

TEST(Driver, scenes_without_energy_have_no_width_but_for_rounding_of_what_moves_them) {
  std::vector<scene::Scene<2>> scenes = {unloaded(0), unloaded(0.1), unloaded(-0.1)};
  scenes.push_back(unloaded(0));  // carried away and turned
  scenes.back().boundary["lower.bottom"] = {
      tests::ConditionKind::fixed,
      {[](const auto& x) { return 0.1 - 0.01 * x[1]; }, [](const auto& x) { return 0.3 + 0.01 * x[0]; }},
      ""};
  scenes.push_back(unloaded(0));  // a box of walls
  scenes.back().contact.clear();
  for (const char* side : {"upper.left", "upper.right", "upper.top", "upper.bottom"})
    scenes.back().contact.push_back({side, "rigid", tests::constant(0.01), ""});
  scenes.push_back(unloaded(0.1));  // the gap just closes
  scenes.back().boundary["lower.bottom"] = tests::fixed(0, 0.1);
  for (std::size_t i = 0; i < scenes.size(); ++i)
    for (const int degree : {1, 2, 3, 4})
      for (const double young : {1.0, 2e11}) {
        scenes[i].solve.degree = degree;
        scenes[i].bodies.at("lower").material = scene::isotropic<2>(young, 0.3, scene::Plane::strain);
        scenes[i].refine = {.strategy = scene::Strategy::adaptive, .target = 1e-6};
        const auto outcome = run(scenes[i]);
        EXPECT_EQ(outcome.status, Status::done) << i << ": " << outcome.reason;
        EXPECT_EQ(outcome.levels.size(), 1u) << i;
        EXPECT_EQ(outcome.lower, 0) << i;
        EXPECT_FALSE(std::signbit(outcome.lower)) << i;
        // Where rest is admissible it has no energy at all; else displacements of up to 0.4 are rounded, on a mesh
        // width of 1/4: strains of some ten times 8 · 0.4 ε, squared, times the stiffness 1.35 E over the area 2.
        const double rounded = 32 * std::numeric_limits<double>::epsilon();
        const bool rest = i == 0 || i == 1 || i == 4;
        EXPECT_LE(outcome.upper, rest ? 0 : 1.35 * std::max(young, 1.0) * rounded * rounded) << i;
      }
}

TEST(Driver, small_strains_are_not_taken_for_none) {
  // Stretched along with a displacement 10⁵ or 10¹¹ times as large: σ = E' ε, L = ½ E' ε².
  for (const double asked : {1e-5, 1e-11}) {
    scene::Scene<2> s;
    s.blocks = {tests::block("b", 0, 1, 0, 1, 4, 4)};
    s.bodies = {{"b", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
    s.boundary = {{"b.left", tests::sliding(-1)}, {"b.right", tests::sliding(1 + asked)}};
    const auto outcome = run(s);
    const double strain = (1 + asked) - 1;  // what rounding leaves of it
    const double exact = strain * strain / 2 / (1 - 0.09), rounding = 4 * std::numeric_limits<double>::epsilon();
    EXPECT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
    EXPECT_LE(outcome.lower, exact * (1 + rounding));
    EXPECT_GE(outcome.upper, exact * (1 - rounding));
    // Displacements of 1 are rounded to ε, on a mesh width of ¼.
    EXPECT_LE(outcome.upper - outcome.lower, exact * (1e-10 + std::pow(100 * rounding / strain, 2)));
  }
}

TEST(Driver, loads_that_rounding_hides_are_not_taken_for_none) {
  // Uniaxial tension below a wall: L = −½ p²/E' < 0, but the gap is 10¹⁵ times as large as the displacements.
  scene::Scene<2> s;
  s.blocks = {tests::block("b", 0, 1, 0, 1, 4, 4)};
  s.bodies = {{"b", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
  s.boundary = {{"b.left", tests::pressure(tests::constant(-1e-15))},
                {"b.right", tests::pressure(tests::constant(-1e-15))}};
  s.contact = {{"b.top", "rigid", tests::constant(1), ""}};
  const auto outcome = run(s);
  const double exact = -0.5 * 1e-30 * (1 - 0.09);
  EXPECT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
  EXPECT_LE(outcome.lower, exact);
  EXPECT_GE(outcome.upper, exact);
}

TEST(Mark, takes_as_few_cells_as_carry_the_bulk) {
  const auto problem = tests::problem(tests::two_blocks(4));
  Indicator indicator;
  indicator.cell.assign(problem.mesh.cells.size(), 0);
  std::iota(indicator.cell.begin(), indicator.cell.end(), 1.0);
  indicator.contact.assign(problem.contact.size(), 0);
  const double sum = std::accumulate(indicator.cell.begin(), indicator.cell.end(), 0.0);
  for (const double bulk : {0.1, 0.5, 1.0}) {
    const auto marked = mark(problem, indicator, bulk);
    double carried = 0, least = sum, most = 0;
    for (std::size_t c = 0; c < marked.size(); ++c) {
      if (marked[c]) {
        carried += indicator.cell[c];
        least = std::min(least, indicator.cell[c]);
      } else {
        most = std::max(most, indicator.cell[c]);
      }
    }
    EXPECT_GE(carried, bulk * sum);
    EXPECT_LT(carried - least, bulk * sum);  // one fewer would not do
    EXPECT_LE(most, least);
  }
}

TEST(Mark, counts_the_contact_at_the_cells_on_both_sides) {
  const auto problem = tests::problem(tests::two_blocks(4));
  Indicator indicator;
  indicator.cell.assign(problem.mesh.cells.size(), 1e-6);
  indicator.contact.assign(problem.contact.size(), 0);
  indicator.contact[1] = 1;
  const auto marked = mark(problem, indicator, 0.9);
  EXPECT_TRUE(marked[problem.mesh.boundary[problem.contact[1].first].cell]);
  EXPECT_TRUE(marked[problem.mesh.boundary[problem.contact[1].second].cell]);
  EXPECT_EQ(std::count(marked.begin(), marked.end(), 1), 2);
}

}  // namespace
}  // namespace bracket::bounds
