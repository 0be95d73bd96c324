// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bounds/bounds.h"
#include "tests/bounds/certificate/rational.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

/// All levels of a run are of one problem, that of the first mesh, to the last bit.
namespace bracket::bounds {
namespace {

using scene::Vector;

/// A block of modulus 1 without contraction, carried along x by `common`, whose right side is moved by `strain` more at
/// its upper end than at the lower: σ_xx = strain · y, of which L = strain²/6. All given numbers are doubles, and those
/// of the first mesh's ends and midpoints exact; refinement soon comes to points where they would be rounded.
/// \param gap by a wall that presses, in place of a prescribed displacement
scene::Scene<2> bent(double common, double strain, bool gap) {
  scene::Scene<2> s;
  s.blocks = {tests::block("b", 0, 1, 0, 1, 1, 1)};
  s.bodies = {{"b", scene::isotropic<2>(1, 0, scene::Plane::strain)}};
  s.boundary = {{"b.left", tests::sliding(-common)}};
  if (gap)
    s.contact = {{"b.right", "rigid", scene::enclosed<2>([=](const auto& x) { return common - strain * x[1]; }), ""}};
  else
    s.boundary["b.right"] = {
        scene::ConditionKind::sliding, {scene::enclosed<2>([=](const auto& x) { return common + strain * x[1]; })}, ""};
  return s;
}

void expect_exact_energy_inside(double common, double strain, int levels) {
  // A multiple of eight units in the last place of the common part, and odd, so that halves and quarters are exact.
  const double unit = common == 0 ? strain : std::ldexp(8 * std::numeric_limits<double>::epsilon(), std::ilogb(common));
  const double exact_strain = unit * (2 * std::floor(strain / unit / 2) + 1);
  const Rational energy = Rational(exact_strain) * Rational(exact_strain) / 6;
  for (const bool gap : {false, true})
    for (const int degree : {1, 2, 3, 4}) {
      auto s = bent(common, exact_strain, gap);
      s.solve.degree = degree;
      s.refine = {.strategy = scene::Strategy::uniform, .max_levels = levels};
      const auto outcome = run(s);
      SCOPED_TRACE(testing::Message() << "common " << common << ", strain " << exact_strain << ", gap " << gap
                                      << ", degree " << degree << ": " << outcome.reason);
      EXPECT_EQ(outcome.guarantee, "rounding-safe");
      EXPECT_EQ(outcome.levels.size(), static_cast<std::size_t>(levels));
      for (const Level& level : outcome.levels) {
        EXPECT_LE(Rational(level.bracket.lower), energy) << level.cells;
        EXPECT_GE(Rational(level.bracket.upper), energy) << level.cells;
      }
    }
}

TEST(OneProblem, holds_the_exact_energy_on_every_level) {
  for (const double common : {0.0, 1.0, 1000.0, 1048576.0})
    for (const double strain : {1e-2, 1e-7, 1e3 * std::numeric_limits<double>::epsilon()})
      expect_exact_energy_inside(common, common == 0 ? strain : strain * common, tests::sanitized ? 3 : 5);
}

TEST(OneProblem, holds_the_exact_energy_however_fine) { expect_exact_energy_inside(1, 1e-7, tests::sanitized ? 4 : 7); }

// A thin strip, turned and far away: midpoints of its vertices are rounded by much of its thickness.
TEST(OneProblem, of_a_strip_far_away_has_levels_that_share_a_point) {
  const int levels = tests::sanitized ? 2 : 4;
  for (const double away : {1e6, 1e8})
    for (const int degree : {1, 2, 3, 4}) {
      scene::Scene<2> s;
      s.blocks = {tests::block("b", 0, 1, 0, 0.01, 20, 1)};
      s.bodies = {{"b", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
      s.boundary = {{"b.left", tests::fixed(0, 0)},
                    {"b.right", tests::traction(tests::constant(1), tests::constant(0))}};
      s.solve.degree = degree;
      s.refine = {.strategy = scene::Strategy::uniform, .max_levels = levels};
      auto mesh = scene::build_mesh(s);
      for (Vector<2>& x : mesh.vertices) x = Eigen::Rotation2Dd(0.5) * x + Vector<2>(away, -away);
      const auto outcome = run(s, scene::fix_data(s, mesh));
      EXPECT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
      ASSERT_EQ(outcome.levels.size(), static_cast<std::size_t>(levels)) << outcome.reason;
      double lower = outcome.levels[0].bracket.lower, upper = outcome.levels[0].bracket.upper;
      for (const Level& level : outcome.levels) {
        lower = std::max(lower, level.bracket.lower);
        upper = std::min(upper, level.bracket.upper);
      }
      EXPECT_LE(lower, upper) << away << ", degree " << degree;
    }
}

// By Gauss a uniform pressure on a closed contour is in balance, wherever rounding put its nodes.
TEST(OneProblem, of_pressure_all_round_is_in_balance) {
  for (const double noise : {0.0, 1e-10, 1e-8, 1e-6, 1e-4}) {
    scene::Scene<2> s;
    s.blocks = {tests::block("b", 0, 1, 0, 1, 4, 4)};
    s.bodies = {{"b", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
    for (const char* side : {"b.left", "b.right", "b.bottom", "b.top"})
      s.boundary[side] = tests::pressure(tests::constant(1));
    auto mesh = scene::build_mesh(s);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      mesh.vertices[v] += noise * Vector<2>(std::sin(1.0 * v * v), std::cos(2.0 * v * v));
    const auto problem = scene::fix_data(s, mesh);
    EXPECT_LE(balanced(problem, 2).imbalance, 64 * std::numeric_limits<double>::epsilon()) << noise;
    const auto outcome = run(s, problem);
    EXPECT_EQ(outcome.guarantee, "rounding-safe") << noise << ": " << outcome.reason;
  }
}

// What rounding explains is taken off and told; what it does not is refused with both forces.
TEST(OneProblem, has_loads_changed_by_no_more_than_rounding_explains) {
  scene::Scene<2> s;
  s.blocks = {tests::block("b", 0, 1, 0, 1, 2, 2)};
  s.bodies = {{"b", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
  s.boundary = {{"b.left", tests::pressure(tests::constant(1))}, {"b.right", tests::pressure(tests::constant(1))}};
  auto problem = scene::fix_data(s, scene::build_mesh(s));
  for (auto& facet : problem.facets)
    if (facet.pressure[0] != 0 && facet.normal[0] > 0) facet.pressure = {1 + 1e-15, 1 + 1e-15};
  const auto changed = balanced(problem, 2);
  EXPECT_GT(changed.imbalance, 1e-16);
  EXPECT_LT(changed.imbalance, 1e-14);
  EXPECT_EQ(run(s, problem).guarantee, "rounding-safe");
  for (auto& facet : problem.facets)
    if (facet.pressure[0] != 0 && facet.normal[0] > 0) facet.pressure = {1 + 1e-9, 1 + 1e-9};
  try {
    balanced(problem, 2);
    FAIL() << "an imbalance of 1e-9 is no rounding";
  } catch (const scene::Error& error) {
    EXPECT_EQ(error.status(), scene::Status::ill_posed);
    EXPECT_NE(std::string(error.what()).find("of which rounding explains"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace bracket::bounds
