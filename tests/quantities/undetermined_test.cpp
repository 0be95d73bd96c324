// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/quantities/asked.h"

namespace bracket::tests {
namespace {

/// A block that lies on a wall and is squeezed from both sides: nothing holds it down, nor sideways.
scene::Scene<2> squeezed() {
  scene::Scene<2> s;
  s.blocks = {block("block", 0, 2, 0, 1, 4, 2)};
  s.bodies = {{"block", scene::isotropic<2>(1, 0.25, scene::Plane::strain)}};
  s.boundary = {{"block.left", pressure(constant(0.125))}, {"block.right", pressure(constant(0.125))}};
  s.contact = {{"block.bottom", "rigid", constant(0), ""}};
  return s;
}

// It may be lifted at no cost, not pushed down: the least of its mean displacements is known, the largest is not.
TEST(Undetermined, one_end_where_one_sign_of_a_motion_is_free) {
  const double strain = 0.25 * 1.25 * 0.125;  // ν (1 + ν) p / E across
  const auto outcome = outcome_of(squeezed(),
                                  {along(quantity(QuantityKind::displacement, "block.top"), 0, 1),
                                   along(quantity(QuantityKind::displacement, "block.top"), 0, -1),
                                   quantity(QuantityKind::opening, "block.bottom")},
                                  {.strategy = scene::Strategy::uniform, .max_levels = 2});
  ASSERT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
  const auto &up = outcome.quantities[0], &down = outcome.quantities[1], &opening = outcome.quantities[2];
  EXPECT_EQ(up.upper, INFINITY);
  EXPECT_LE(up.lower, strain);
  EXPECT_GE(up.lower, strain - 1e-6);
  EXPECT_NE(up.reason.find("moving it by (0, 1)"), std::string::npos) << up.reason;
  EXPECT_EQ(down.lower, -INFINITY);
  EXPECT_GE(down.upper, -strain);
  EXPECT_LE(down.upper, -strain + 1e-6);
  EXPECT_EQ(opening.upper, INFINITY);
  EXPECT_EQ(opening.lower, 0);
}

TEST(Undetermined, refused_where_both_signs_are_free) {
  try {
    outcome_of(squeezed(), {along(quantity(QuantityKind::displacement, "block.top"), 1, 0)}, {});
    FAIL() << "sideways nothing holds it";
  } catch (const scene::Error& error) {
    EXPECT_EQ(error.status(), scene::Status::ill_posed);
    EXPECT_NE(std::string(error.what()).find("moving it by"), std::string::npos) << error.what();
  }
}

// Stresses, forces and the energy do not care.
TEST(Undetermined, stresses_are_determined) {
  const auto outcome = outcome_of(squeezed(),
                                  {component(quantity(QuantityKind::stress, "block"), scene::StressComponent::xx),
                                   quantity(QuantityKind::force, "block.bottom"), quantity(QuantityKind::energy, "")},
                                  {.strategy = scene::Strategy::uniform, .max_levels = 2});
  const double energy = 0.5 * 0.125 * 0.125 * (1 - 0.0625) * 2;
  const double exact[] = {-0.125, 0, energy};
  for (int i = 0; i < 3; ++i) {
    EXPECT_LE(outcome.quantities[i].lower, exact[i]) << i;
    EXPECT_GE(outcome.quantities[i].upper, exact[i]) << i;
    EXPECT_LE(outcome.quantities[i].upper - outcome.quantities[i].lower, 1e-9) << i;
  }
}

// A perturbation that pushes the body off is too large, and no reason to give up: here the load holds it down.
TEST(Undetermined, held_down_by_its_load_alone) {
  auto s = squeezed();
  s.boundary["block.top"] = pressure(constant(1e-3));
  const auto outcome = outcome_of(s, {along(quantity(QuantityKind::displacement, "block.top"), 0, 1)},
                                  {.strategy = scene::Strategy::uniform, .max_levels = 2});
  const double exact = 0.25 * 1.25 * 0.125 - 1e-3 * (1 - 0.0625);
  const auto& interval = outcome.quantities[0];
  EXPECT_EQ(interval.reason, "");
  EXPECT_LE(interval.lower, exact);
  EXPECT_GE(interval.upper, exact);
  EXPECT_LE(interval.upper - interval.lower, 1e-8);
}

}  // namespace
}  // namespace bracket::tests
