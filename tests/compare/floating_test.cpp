// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bounds/bounds.h"
#include "tests/support/scenes.h"

/// Bodies that nothing but contact holds, and stiff ones held by soft ones.
namespace bracket::bounds {
namespace {

// A bar pressed against a block that slides on a wall; below the block an unloaded body rests on contact and may fall
// as far as it likes. The stress is uniaxial: L(u) = −½ p²/E · area of bar and block, whatever the resting body is.
TEST(Floating, an_unloaded_body_stays_near_what_it_touches) {
  constexpr double p = 1e-3, exact = -0.5 * p * p * 0.5 * 5.1;
  for (const double ratio : {1e-12, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e12})
    for (const int degree : {1, 2, 3, 4}) {
      scene::Scene<2> s;
      s.plane = scene::Plane::stress;
      s.solve.degree = degree;
      s.blocks = {tests::block("resting", 0, 0.1, 0.1, 0.2, 1, 1), tests::block("block", 0, 0.1, 0.2, 0.7, 1, 3),
                  tests::block("bar", 0.1, 5.1, 0.2, 0.7, 3, 3)};
      s.bodies = {{"resting", scene::isotropic<2>(ratio, 0.3, scene::Plane::stress)},
                  {"block", scene::isotropic<2>(1, 0.3, scene::Plane::stress)},
                  {"bar", scene::isotropic<2>(1, 0.3, scene::Plane::stress)}};
      s.boundary = {{"block.left", tests::sliding(0)},
                    {"bar.top", tests::sliding(0)},
                    {"bar.right", tests::pressure(tests::constant(p))}};
      s.contact = {{"block.bottom", "resting.top", tests::constant(0), ""},
                   {"bar.left", "block.right", tests::constant(0), ""}};
      const auto outcome = run(s);
      EXPECT_EQ(outcome.status, scene::Status::done) << outcome.reason << ", ratio " << ratio << ", degree " << degree;
      EXPECT_NEAR(outcome.lower, exact, 1e-12 * -exact) << "ratio " << ratio << ", degree " << degree;
      EXPECT_NEAR(outcome.upper, exact, 1e-12 * -exact) << "ratio " << ratio << ", degree " << degree;
      double largest = 0;
      for (const auto& u : outcome.displacement.vertex) largest = std::max(largest, u.norm());
      EXPECT_LE(largest, 10 * p * 5.1) << "ratio " << ratio << ", degree " << degree;
    }
}

// Four blocks around a corner, each pressed against two others: a closed chain. Without a Poisson effect each stress is
// uniform, −p both ways: L(u) = −p²/E · area.
TEST(Floating, a_ring_of_blocks_is_pressed_together) {
  constexpr double p = 1e-3, exact = -4 * p * p;
  for (const int degree : {1, 2, 3, 4}) {
    scene::Scene<2> s;
    s.solve.degree = degree;
    s.blocks = {tests::block("b00", 0, 1, 0, 1, 2, 3), tests::block("b10", 1, 2, 0, 1, 4, 3),
                tests::block("b11", 1, 2, 1, 2, 4, 5), tests::block("b01", 0, 1, 1, 2, 2, 5)};
    s.plane = scene::Plane::stress;
    for (const auto& block : s.blocks) s.bodies.emplace(block.body, scene::isotropic<2>(1, 0, s.plane));
    for (const char* held : {"b00.left", "b01.left", "b00.bottom", "b10.bottom"}) s.boundary[held] = tests::sliding(0);
    for (const char* pressed : {"b10.right", "b11.right", "b01.top", "b11.top"})
      s.boundary[pressed] = tests::pressure(tests::constant(p));
    s.contact = {{"b10.left", "b00.right", tests::constant(0), ""},
                 {"b11.bottom", "b10.top", tests::constant(0), ""},
                 {"b01.right", "b11.left", tests::constant(0), ""},
                 {"b00.top", "b01.bottom", tests::constant(0), ""}};
    const auto outcome = run(s);
    EXPECT_EQ(outcome.status, scene::Status::done) << outcome.reason << ", degree " << degree;
    EXPECT_NEAR(outcome.lower, exact, 1e-12 * -exact) << "degree " << degree;
    EXPECT_NEAR(outcome.upper, exact, 1e-12 * -exact) << "degree " << degree;
  }
}

// Four blocks around a corner, two of them held by contact alone, one of these much softer than the others.
TEST(Floating, soft_bodies_may_hold_stiff_ones) {
  for (const double ratio : {1e-11, 1e-8, 1e-4, 1.0, 1e4, 1e8, 1e11}) {
    scene::Scene<2> s;
    s.blocks = {tests::block("b00", 0, 0.1, 0, 0.5, 2, 6), tests::block("b01", 0, 0.1, 0.5, 2.5, 2, 2),
                tests::block("b10", 0.1, 2.1, 0, 0.5, 2, 6), tests::block("b11", 0.1, 2.1, 0.5, 2.5, 2, 2)};
    s.plane = scene::Plane::stress;
    for (const auto& block : s.blocks) {
      const double young = block.body == "b01" ? ratio : 1;
      s.bodies.emplace(block.body, scene::isotropic<2>(young, 0.3, s.plane));
    }
    s.boundary = {{"b00.left", tests::fixed(0, 0)},
                  {"b10.bottom", tests::fixed(0, 0)},
                  {"b10.right", tests::pressure(tests::constant(1e-3))}};
    s.contact = {{"b00.right", "b10.left", tests::constant(0), ""},
                 {"b11.left", "b01.right", tests::constant(0), ""},
                 {"b10.top", "b11.bottom", tests::constant(0), ""}};
    s.refine.strategy = scene::Strategy::uniform;
    s.refine.max_levels = 3;
    const auto outcome = run(s);
    EXPECT_EQ(outcome.status, scene::Status::done) << outcome.reason << ", ratio " << ratio;
    ASSERT_EQ(outcome.levels.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)  // brackets of one energy
        EXPECT_LE(outcome.levels[i].bracket.lower, outcome.levels[j].bracket.upper) << "ratio " << ratio;
  }
}

}  // namespace
}  // namespace bracket::bounds
