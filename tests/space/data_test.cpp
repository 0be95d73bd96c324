// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Loads and displacements that are not linear on the faces of the first mesh.
#include <gtest/gtest.h>

#include <numbers>

#include "bounds/bounds.h"
#include "tests/space/scenes.h"
#include "tests/support/sanitized.h"

namespace bracket {
namespace {

using namespace tests::space;

scene::Scene<3> under(int cells, const Function& down) {
  scene::Scene<3> s;
  s.blocks = {block("b", {0, 1}, {0, 1}, {0, 1}, {cells, cells, cells})};
  s.bodies = {{"b", isotropic(1, 0.3)}};
  for (const char* side : {"b.bottom", "b.left", "b.right", "b.back", "b.front"}) s.boundary[side] = sliding();
  s.boundary["b.top"] = {ConditionKind::pressure, {down}, ""};
  return s;
}

// The energies of two first meshes, whose loads are two projections of one, lie no further apart than by what the two
// are estimated to do; as the meshes become finer that falls like the square of the loads' second differences times
// their length.
TEST(DataInSpace, what_is_left_out_of_a_load_is_estimated) {
  const auto wave = scene::enclosed<3>([](const auto& x) {
    using std::sin;
    return 1 + sin(2 * std::numbers::pi * x[0]) * x[2] * x[2];
  });
  std::vector<bounds::Outcome<3>> of;
  for (const int cells : {2, 4, 8}) {
    auto s = under(cells, wave);
    s.refine.strategy = scene::Strategy::none;
    of.push_back(bounds::run(s));
    EXPECT_EQ(of.back().levels[0].oscillation_part, "b.top");
  }
  const auto effect = [&](int i) { return of[i].levels[0].oscillation_energy; };
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < i; ++k) {
      EXPECT_LE(of[i].lower, of[k].upper + effect(i) + effect(k));
      EXPECT_GE(of[i].upper, of[k].lower - effect(i) - effect(k));
    }
  EXPECT_LE(effect(1), effect(0) / 8);
  EXPECT_LE(effect(2), effect(1) / 8);
}

TEST(DataInSpace, what_is_left_out_of_a_displacement_refines_the_first_mesh) {
  const auto sine = [](int cells, scene::Strategy strategy) {
    scene::Scene<3> s;
    s.blocks = {block("b", {0, 1}, {0, 1}, {0, 0.5}, {cells, cells, cells / 2})};
    s.bodies = {{"b", isotropic(10, 0.3)}};
    s.boundary = {{"b.bottom", fixed()},
                  {"b.back", sliding()},
                  {"b.front", sliding()},
                  {"b.top",
                   {ConditionKind::fixed,
                    {0.0, scene::enclosed<3>([](const auto& x) {
                       using std::sin;
                       return 0.01 * sin(2 * std::numbers::pi * x[0]);
                     }),
                     0.0},
                    ""}}};
    s.refine = {.strategy = strategy, .target = 0.6, .max_levels = 1};
    return s;
  };
  const auto left = bounds::run(sine(2, scene::Strategy::none)),
             coarse = bounds::run(sine(2, scene::Strategy::adaptive)),
             fine = bounds::run(sine(tests::sanitized ? 4 : 8, scene::Strategy::none));
  EXPECT_GT(left.levels[0].oscillation_energy, 0.5 * fine.lower);  // nothing is left of the sine at the vertices
  EXPECT_TRUE(left.problem.mesh.notes.empty());
  ASSERT_FALSE(coarse.problem.mesh.notes.empty());
  EXPECT_NE(coarse.problem.mesh.notes.back().find("for the data of 'b.top'"), std::string::npos);
  EXPECT_GT(coarse.levels[0].cells, left.levels[0].cells);
  EXPECT_LT(coarse.levels[0].oscillation_energy, 0.1 * left.levels[0].oscillation_energy);
  for (const auto* other : {&left, &coarse}) {
    const double moved = other->levels[0].oscillation_energy + fine.levels[0].oscillation_energy;
    EXPECT_LE(other->lower, fine.upper + moved);
    EXPECT_GE(other->upper, fine.lower - moved);
  }
}

// A load of 100 on a square of a hundredth, between all points where loads are looked at.
TEST(DataInSpace, a_spike_between_samples_is_named_or_resolved) {
  const auto spike = scene::enclosed<3>([](const auto& x) {
    return 1 + scene::choose(scene::both(scene::both(x[0] > 0.26, x[0] < 0.27), scene::both(x[2] > 0.51, x[2] < 0.52)),
                             1e6, 0);
  });
  auto s = under(2, spike);
  s.refine = {.strategy = scene::Strategy::adaptive, .target = 0.1, .max_levels = 2, .max_cells = 400};
  const auto named = bounds::run(s);  // within a quarter of max_cells
  EXPECT_GT(named.levels[0].oscillation_energy, named.upper - named.lower);
  EXPECT_EQ(named.levels[0].oscillation_part, "b.top");
  EXPECT_LE(named.levels[0].cells, 100);
  EXPECT_GT(named.problem.oscillation.traction, 0.9);
}

TEST(DataInSpace, linear_data_leave_the_first_mesh_alone) {
  auto s = under(2, scene::enclosed<3>([](const auto& x) { return scene::choose(x[0] < 0.5, 1 + x[0], 3 - x[2]); }));
  s.refine = {.strategy = scene::Strategy::adaptive, .target = 0.3, .max_levels = 1};
  const auto outcome = bounds::run(s);
  EXPECT_EQ(outcome.levels[0].cells, 48);
  EXPECT_LE(outcome.levels[0].oscillation_energy, 1e-13 * std::abs(outcome.upper));
  EXPECT_TRUE(outcome.problem.mesh.notes.empty());
}

// A kept gap that is a quadratic is one to rounding; displacements of degree 1 cannot have it.
TEST(DataInSpace, a_kept_gap_that_is_quadratic_leaves_the_first_mesh_alone) {
  scene::Scene<3> s = everything(1);
  s.contact[1].law = scene::Law::bilateral;
  for (const int degree : {2, 1}) {
    s.solve.degree = degree;
    s.refine = {.strategy = scene::Strategy::adaptive, .max_levels = 1, .max_cells = 40};
    const auto outcome = bounds::run(s);
    ASSERT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
    EXPECT_EQ(outcome.levels[0].cells, 12);
    if (degree == 2) {
      EXPECT_LE(outcome.levels[0].oscillation_energy, 1e-14 * std::abs(outcome.upper));
    }
    if (degree == 1) {
      EXPECT_GT(outcome.levels[0].oscillation_energy, 1e-4 * std::abs(outcome.upper));
    }
  }
}

// Sides that touch stay matched, and the first mesh's marks carry on.
TEST(DataInSpace, contact_stays_matched_on_a_first_mesh_refined_for_its_data) {
  scene::Scene<3> s = two_blocks(2);
  s.boundary["upper.top"] = traction(0.0, scene::enclosed<3>([](const auto& x) {
                                       using std::cos;
                                       return -0.1 - 0.09 * cos(2 * std::numbers::pi * x[0]) * x[2];
                                     }),
                                     0.0);
  s.refine = {.strategy = scene::Strategy::adaptive, .target = 0.1, .max_levels = 3};
  const auto outcome = bounds::run(s);
  ASSERT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
  ASSERT_FALSE(outcome.problem.mesh.notes.empty());
  EXPECT_GT(outcome.levels[0].cells, 96);
  for (const auto& level : outcome.levels) {
    EXPECT_TRUE(level.certificate.valid);
    EXPECT_LE(level.checks.gap_identity, 1e-10);
  }
}

}  // namespace
}  // namespace bracket
