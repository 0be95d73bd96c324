// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/space/asked.h"

// What is not determined, what is not what its name says, and what is no quantity at all.
namespace bracket {
namespace {

using namespace tests::space;

/// A block that lies on a wall and is squeezed from two sides: nothing holds it down, nor sideways.
scene::Scene<3> squeezed() {
  scene::Scene<3> s;
  s.blocks = {block("block", {0, 2}, {0, 1}, {0, 1}, {2, 1, 1})};
  s.bodies = {{"block", isotropic(1, 0.25)}};
  s.boundary = {{"block.left", {ConditionKind::pressure, {0.125}, ""}},
                {"block.right", {ConditionKind::pressure, {0.125}, ""}}};
  s.contact = {{"block.back", "rigid", 0.0, ""}};
  return s;
}

TEST(UndeterminedInSpace, one_end_where_one_sign_of_a_motion_is_free) {
  const double strain = 0.25 * 0.125;  // across, of a bar
  const auto top = quantity(QuantityKind::displacement, "block.front");
  const auto outcome = outcome_of(
      squeezed(), {along(top, 0, 0, 1), along(top, 0, 0, -1), quantity(QuantityKind::opening, "block.back")}, {});
  ASSERT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
  const auto &up = outcome.quantities[0], &down = outcome.quantities[1], &opening = outcome.quantities[2];
  EXPECT_EQ(up.upper, INFINITY);
  EXPECT_LE(up.lower, strain);
  EXPECT_GE(up.lower, strain - 1e-6);
  EXPECT_NE(up.reason.find("nothing resists a motion of body 'block'"), std::string::npos) << up.reason;
  EXPECT_EQ(down.lower, -INFINITY);
  EXPECT_GE(down.upper, -strain);
  EXPECT_LE(down.upper, -strain + 1e-6);
  EXPECT_EQ(opening.upper, INFINITY);
  EXPECT_EQ(opening.lower, 0);
}

TEST(UndeterminedInSpace, refused_where_both_signs_are_free) {
  try {
    outcome_of(squeezed(), {along(quantity(QuantityKind::displacement, "block.front"), 1, 0, 0)}, {});
    FAIL() << "sideways nothing holds it";
  } catch (const scene::Error& error) {
    EXPECT_EQ(error.status(), scene::Status::ill_posed);
    EXPECT_NE(std::string(error.what()).find("is not determined"), std::string::npos) << error.what();
  }
}

TEST(UndeterminedInSpace, stresses_are_determined) {
  const auto outcome = outcome_of(
      squeezed(), {stress("block", scene::StressComponent::xx), quantity(QuantityKind::force, "block.back")}, {});
  const double exact[] = {-0.125, 0};
  for (int i = 0; i < 2; ++i) {
    EXPECT_LE(outcome.quantities[i].lower, exact[i]) << i;
    EXPECT_GE(outcome.quantities[i].upper, exact[i]) << i;
    EXPECT_LE(outcome.quantities[i].upper - outcome.quantities[i].lower, 1e-8) << i;
  }
}

// At an edge where another support begins the weight falls to zero; where a sliding face meets it at an angle it does
// not.
TEST(WeightedInSpace, reactions_that_end_at_supports_say_so) {
  scene::Scene<3> s;
  s.blocks = {block("block", {0, 1}, {0, 1}, {0, 1}, {2, 2, 2})};
  s.bodies = {{"block", isotropic(1, 0.3)}};
  s.boundary = {{"block.left", fixed()},
                {"block.bottom", sliding()},
                {"block.back", sliding()},
                {"block.front", traction(0.01, 0.0, -0.1)}};
  const auto outcome = outcome_of(s,
                                  {along(quantity(QuantityKind::reaction, "block.left"), 1, 0, 0),
                                   along(quantity(QuantityKind::reaction, "block.left"), 0, 0, 1),
                                   quantity(QuantityKind::reaction, "block.bottom")},
                                  {});
  ASSERT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
  for (int i = 0; i < 3; ++i) EXPECT_EQ(outcome.quantities[i].reason, "") << i;
  EXPECT_FALSE(outcome.quantities[0].weighted);  // along both faces that it meets
  EXPECT_TRUE(outcome.quantities[1].weighted);
  EXPECT_TRUE(outcome.quantities[2].weighted);
  EXPECT_LE(outcome.quantities[0].lower, -0.01);  // statics
  EXPECT_GE(outcome.quantities[0].upper, -0.01);
}

// Four faces meet at the tip of a pyramid: no displacement of it follows one and leaves the other three.
TEST(WeightedInSpace, reactions_of_crowded_corners_have_bounds) {
  scene::Scene<3> s;
  scene::GivenMesh<3> mesh;
  mesh.vertices = {{0, 0, 1}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 0, 0}};
  mesh.cells = {{5, 1, 2, 0}, {5, 2, 3, 0}, {5, 3, 4, 0}, {5, 4, 1, 0}};
  mesh.bodies = {{"tip", {0, 1, 2, 3}}};
  mesh.parts = {{"a", {{0, 1, 2}}}, {"b", {{0, 2, 3}}}, {"c", {{0, 3, 4}}}, {"d", {{0, 4, 1}}}};
  s.given = mesh;
  s.bodies = {{"tip", isotropic(1, 0.3)}};
  s.bodies.at("tip").force = {0.1, 0.2, 0.5};
  for (const char* side : {"a", "b", "c", "d"}) s.boundary[side] = sliding();
  const auto outcome =
      outcome_of(s, {quantity(QuantityKind::reaction, "a")}, {.strategy = scene::Strategy::uniform, .max_levels = 2});
  ASSERT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
  EXPECT_EQ(outcome.quantities[0].reason, "");
  EXPECT_TRUE(outcome.quantities[0].weighted);
  EXPECT_TRUE(std::isfinite(outcome.quantities[0].lower) && std::isfinite(outcome.quantities[0].upper));
}

void expect_refusal(const Quantity& quantity, const std::string& part, scene::Scene<3> scene = two_blocks(2)) {
  std::string line;
  try {
    outcome_of(std::move(scene), {quantity}, {});
  } catch (const scene::Error& error) {
    EXPECT_EQ(error.status(), scene::Status::input) << error.what();
    line = error.what();
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
  EXPECT_NE(line.find(part), std::string::npos) << "'" << line << "' lacks '" << part << "'";
}

TEST(RefusedInSpace, one_clear_line) {
  const auto top = quantity(QuantityKind::displacement, "upper.top"),
             force = quantity(QuantityKind::force, "upper.bottom");
  expect_refusal(along(quantity(QuantityKind::displacement, "upper.tip"), 0, 1, 0), "did you mean 'upper.top'");
  expect_refusal(quantity(QuantityKind::force, "lower.top"), "there is no contact 'lower.top'");
  expect_refusal(along(quantity(QuantityKind::displacement, "lower.bottom"), 0, 1, 0), "the part is fixed");
  expect_refusal(along(quantity(QuantityKind::displacement, "upper.front"), 0, 0, 1), "along its normal is given");
  expect_refusal(along(quantity(QuantityKind::reaction, "upper.top"), 0, 1, 0), "neither fixed nor sliding");
  expect_refusal(quantity(QuantityKind::rotation, "upper.top"), "about an axis of the coordinates");
  expect_refusal(along(quantity(QuantityKind::rotation, "upper.top"), 0, 1, 1), "about an axis of the coordinates");
  expect_refusal(quantity(QuantityKind::slip, "upper.bottom"), "the plane alone");
  auto shear = force;
  shear.of_force = scene::ForceComponent::shear;
  expect_refusal(shear, "the plane alone");
  auto stretch = force;
  stretch.stretch = scene::LineStretch{0, 0.5};
  expect_refusal(stretch, "in space write a weight");
  const auto jump = scene::enclosed<3>([](const auto& x) { return scene::choose(x[0] < 0.5, 1.0, 0.0); });
  expect_refusal(weighted(force, jump), "its weight jumps at (0.5, ");
  expect_refusal(weighted(force, scene::enclosed<3>([](const auto& x) { return x[0] * x[0] * x[2]; })),
                 "not one quadratic on the face");
  expect_refusal(weighted(quantity(QuantityKind::opening, "upper.bottom"),
                          scene::enclosed<3>([](const auto& x) { return x[0] * x[2]; })),
                 "must be linear on each face");
}

}  // namespace
}  // namespace bracket
