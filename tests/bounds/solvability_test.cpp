// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bounds/bounds.h"
#include "tests/support/scenes.h"

namespace bracket::bounds {
namespace {

/// The message with which a scene is refused as ill-posed; empty if it is not.
std::string refusal(const scene::Scene<2>& scene) {
  try {
    balanced(tests::problem(scene), scene.solve.degree);
  } catch (const scene::Error& error) {
    EXPECT_EQ(error.status(), scene::Status::ill_posed);
    return error.what();
  }
  return "";
}

scene::Scene<2> free_on_a_wall() {
  scene::Scene<2> s;
  s.blocks = {tests::block("block", -1, 1, 0, 1, 4, 2)};
  s.bodies = {{"block", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
  s.contact = {{"block.bottom", "rigid", tests::constant(0), ""}};
  return s;
}

TEST(Solvability, loads_press_or_push_off) {  // [HH81, (1.16)]
  auto s = free_on_a_wall();
  s.boundary["block.top"] = tests::traction(tests::constant(0), tests::constant(-1));
  EXPECT_EQ(refusal(s), "");
  s.boundary["block.top"] = tests::traction(tests::constant(0), tests::constant(1));
  const std::string message = refusal(s);
  EXPECT_NE(message.find("'block'"), std::string::npos) << message;
  EXPECT_NE(message.find("(0, 1)"), std::string::npos) << message;
}

TEST(Solvability, loads_along_an_unresisted_motion_must_balance) {
  auto s = free_on_a_wall();
  s.boundary["block.top"] = tests::traction(tests::constant(0.1), tests::constant(-1));
  EXPECT_NE(refusal(s).find("'block'"), std::string::npos);
  // Opposite shears on top and left balance the force sideways only to rounding.
  s.boundary["block.left"] = tests::traction(tests::constant(-0.2), tests::constant(0));
  EXPECT_EQ(refusal(s), "");
}

TEST(Solvability, resultant_must_pass_through_the_contact) {
  // p = 1 − c x on the top of (−1, 1): its resultant acts at x = −c/3, within the contact for |c| < 3.
  for (const double c : {-2.9, 0.0, 2.9, 3.1, -3.1}) {
    auto s = free_on_a_wall();
    s.boundary["block.top"] = tests::pressure([c](const auto& x) { return 1 - c * x[0]; });
    const std::string message = refusal(s);
    EXPECT_EQ(message.empty(), std::abs(c) < 3) << c << ": " << message;
    if (c > 3) {
      EXPECT_NE(message.find("counter-clockwise about (-1,"), std::string::npos) << message;
    }
  }
}

TEST(Solvability, prescribed_displacements_must_keep_the_contact) {
  auto s = free_on_a_wall();
  s.boundary["block.left"] = tests::fixed(0, -0.01);
  const std::string message = refusal(s);
  EXPECT_NE(message.find("'block.bottom'"), std::string::npos) << message;
  EXPECT_NE(message.find("0.01 more than it has at (-1, 0)"), std::string::npos) << message;
  s.contact[0].gap = tests::constant(0.01);
  EXPECT_EQ(refusal(s), "");
}

TEST(Solvability, a_turn_by_rounding_is_none) {
  // So far from the origin that the moment of the load is rounded to 1e-11 of its size.
  auto s = free_on_a_wall();
  s.blocks = {tests::block("block", 1e5, 1e5 + 0.7, 0, 0.7, 4, 4)};
  s.boundary["block.top"] = tests::traction(tests::constant(0), tests::constant(0.1));
  const std::string message = refusal(s);
  EXPECT_NE(message.find("moving it by (0, 1)"), std::string::npos) << message;
}

TEST(Solvability, bodies_stand_on_each_other) {
  auto s = tests::linear_pressure({.c = 0.3}, 4, 2);
  EXPECT_EQ(refusal(s), "");
  s.boundary["upper.top"] = tests::pressure(tests::constant(-1));
  EXPECT_NE(refusal(s).find("'upper'"), std::string::npos);
}

TEST(Solvability, bodies_held_by_nothing_need_balanced_loads) {
  scene::Scene<2> s;
  s.blocks = {tests::block("free", 0, 1, 0, 1, 2, 2)};
  s.bodies = {{"free", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
  EXPECT_EQ(refusal(s), "");
  s.boundary = {{"free.left", tests::pressure(tests::constant(-1))},
                {"free.right", tests::pressure(tests::constant(-1))}};
  EXPECT_EQ(refusal(s), "");
  const auto outcome = run(s);  // uniaxial tension, exact: L = −½ σ²/E' for a unit square
  EXPECT_NEAR(outcome.levels[0].bracket.lower, -0.5 * (1 - 0.09), 1e-13);
  EXPECT_NEAR(outcome.levels[0].bracket.upper, -0.5 * (1 - 0.09), 1e-13);
  s.boundary.erase("free.left");
  EXPECT_NE(refusal(s).find("'free'"), std::string::npos);
}

}  // namespace
}  // namespace bracket::bounds
