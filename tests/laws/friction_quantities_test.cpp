// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of contacts with friction: shear force, slip, and the mean stress of bodies that rub (docs/theory.md
// §10.4, §11).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/laws/pairs.h"
#include "tests/quantities/asked.h"

namespace bracket::tests {
namespace {

using scene::Law;
using scene::Scene;

Quantity<2> shear_force(const std::string& of) {
  auto result = quantity(QuantityKind::force, of);
  result.of_force = scene::ForceComponent::shear;
  return result;
}

constexpr double shear_modulus = 1.5, down = 0.25, young = 2 * shear_modulus;

/// A block without side-strain (ν = 0), its top moved by (along, −down), its bottom on a wall or on a plate that is
/// clamped below; sides carry the shear t.
Scene<2> sheared(double along, double bound, double t, bool lifts_off, bool on_plate) {
  Scene<2> s;
  s.blocks = {block("b", 0, 2, 0, 1, 4, 2)};
  s.bodies = {{"b", scene::isotropic<2>(young, 0, scene::Plane::strain)}};
  s.boundary = {{"b.top", fixed(along, -down)},
                {"b.right", traction(constant(0), constant(t))},
                {"b.left", traction(constant(0), constant(-t))}};
  s.contact = {{"b.bottom", "rigid", {}, ""}};
  if (on_plate) {
    s.blocks.push_back(block("plate", 0, 2, -1, 0, 4, 2));
    s.bodies.insert({"plate", scene::isotropic<2>(young, 0, scene::Plane::strain)});
    s.boundary.insert({"plate.bottom", fixed(0, 0)});
    for (const auto& [side, sign] : {std::pair("plate.right", 1), {"plate.left", -1}})
      s.boundary.insert({side, traction(constant(0), constant(sign * t))});
    s.contact[0].second = std::vector<std::string>{"plate.top"};
  }
  return with_law(s, {"", Law::tresca, constant(bound), lifts_off});
}

void expect_interval(const bounds::QuantityInterval& found, double exact, double width) {
  SCOPED_TRACE(found.name);
  EXPECT_EQ(found.reason, "");
  EXPECT_LE(found.lower, exact);
  EXPECT_GE(found.upper, exact);
  EXPECT_LE(found.upper - found.lower, width);
}

// Stuck: G along / height, no slip. Slipping at the bound g: along − height g/G, whatever a small load does. The state
// is in both spaces, and nothing of the intervals is left but what rounding does to the small factors.
TEST(FrictionQuantities, OfUniformShearAreExact) {
  for (const bool lifts_off : {true, false})
    for (const bool on_plate : {false, true})
      for (const double along : {0.125, -0.125, 1.5, -1.5}) {
        const double height = on_plate ? 2 : 1, bound = 0.375;
        const double t = std::copysign(std::min(shear_modulus * std::abs(along) / height, bound), along);
        const double slip = along - height * t / shear_modulus;
        SCOPED_TRACE(testing::Message() << along << (lifts_off ? "" : ", no lift-off") << (on_plate ? ", plate" : ""));
        const auto outcome = outcome_of(sheared(along, bound, t, lifts_off, on_plate),
                                        {shear_force("b.bottom"), quantity(QuantityKind::slip, "b.bottom"),
                                         component(quantity(QuantityKind::stress, "b"), scene::StressComponent::xy),
                                         component(quantity(QuantityKind::stress, "b"), scene::StressComponent::yy)},
                                        {.strategy = scene::Strategy::uniform, .max_levels = 2});
        ASSERT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
        expect_interval(outcome.quantities.at(0), 2 * t, 1e-6);
        expect_interval(outcome.quantities.at(1), slip, 1e-6);
        expect_interval(outcome.quantities.at(2), t, 1e-6);
        expect_interval(outcome.quantities.at(3), -young * down / height, 1e-6);
      }
}

// By statics the interface bears all of the thrust, whatever slips: what is left of the interval is the width of the
// energy by the largest s, at which the perturbation is a thousand times what it perturbs.
TEST(FrictionQuantities, AreWhatStaticsSays) {
  for (const double bound : {0.3, 0.05}) {
    Scene<2> s = two_bodies(0, 1, 1, 1, 4, 4);
    s.bodies = {{"lower", scene::isotropic<2>(1, 0.3, scene::Plane::strain)},
                {"upper", scene::isotropic<2>(2, 0.2, scene::Plane::strain)}};
    s.boundary = {{"lower.bottom", fixed(0, 0)},
                  {"upper.top", pressure(constant(0.2))},
                  {"upper.left", traction(constant(bound / 2), constant(0))}};
    const auto outcome = outcome_of(with_law(s, {"", Law::tresca, constant(bound)}),
                                    {shear_force("upper.bottom"), quantity(QuantityKind::slip, "upper.bottom")},
                                    {.strategy = scene::Strategy::adaptive, .max_cells = 500});
    ASSERT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
    expect_interval(outcome.quantities.at(0), bound / 2, 1e-6 * bound);
    const auto& slip = outcome.quantities.at(1);
    EXPECT_LT(slip.upper - slip.lower, 0.15 * std::abs(slip.upper) + 1.5e-3);
    for (const auto& level : slip.levels) {
      EXPECT_LE(level.lower, slip.upper);
      EXPECT_GE(level.upper, slip.lower);
    }
  }
}

// No rigid body needs the pressure of the two walls: that it can be held by their friction alone is no reason to take
// its loads for rounding. By symmetry each wall bears half.
TEST(FrictionQuantities, OfABlockThatWallsClampAreHalfOfItsLoad) {
  Scene<2> s;
  s.blocks = {block("b", 0, 2, 0, 1, 4, 2)};
  s.bodies = {{"b", scene::isotropic<2>(young, 0.3, scene::Plane::strain)}};
  s.bodies.at("b").force = {0.25, 0};
  s.contact = {{"b.bottom", "rigid", constant(-0.125), ""}, {"b.top", "rigid", constant(-0.125), ""}};
  const auto outcome =
      outcome_of(with_law(s, {"", Law::tresca, constant(0.5)}), {shear_force("b.bottom"), shear_force("b.top")},
                 {.strategy = scene::Strategy::uniform, .max_levels = 2});
  ASSERT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
  EXPECT_LE(outcome.problem.imbalance, 1e-12);
  for (const int wall : {0, 1}) {  // the tangents are (1, 0) and (−1, 0)
    EXPECT_LE(outcome.quantities.at(wall).lower, wall == 0 ? 0.25 : -0.25);
    EXPECT_GE(outcome.quantities.at(wall).upper, wall == 0 ? 0.25 : -0.25);
    EXPECT_LT(outcome.quantities.at(wall).upper - outcome.quantities.at(wall).lower, 0.1);
  }
}

// The order in the energy's width, of a contact of which a part sticks and a part slips.
TEST(FrictionQuantities, HaveTheOrderOfAContactThatMoves) {
  Scene<2> s = two_bodies(0, 4, 1, 2, 8, 2);
  s.bodies = {{"lower", scene::isotropic<2>(3, 0.3, scene::Plane::strain)},
              {"upper", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
  s.boundary = {{"lower.bottom", fixed(0, 0)},
                {"upper.top", pressure(constant(0.01))},
                {"upper.left", pressure(constant(0.008))},
                {"upper.right", fixed(0, 0)}};
  const auto outcome = outcome_of(with_law(s, {"", Law::tresca, constant(0.0015)}),
                                  {shear_force("upper.bottom"), quantity(QuantityKind::slip, "upper.bottom"),
                                   component(quantity(QuantityKind::stress, "upper"), scene::StressComponent::xx)},
                                  {.strategy = scene::Strategy::adaptive, .max_cells = 3000});
  ASSERT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
  for (const auto& found : outcome.quantities) {
    SCOPED_TRACE(found.name);
    ASSERT_EQ(found.levels.size(), outcome.levels.size());
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < found.levels.size(); ++i) {
      if (found.levels[i].cells < 150) continue;
      const double a = std::log(outcome.levels[i].bracket.upper - outcome.levels[i].bracket.lower);
      const double b = std::log(found.levels[i].upper - found.levels[i].lower);
      n += 1, x += a, y += b, xx += a * a, xy += a * b;
    }
    ASSERT_GE(n, 4);
    EXPECT_GE((n * xy - x * y) / (n * xx - x * x), 0.6);
  }
}

std::string refusal(const Scene<2>& scene, const Quantity<2>& quantity) {
  try {
    outcome_of(scene, {quantity}, {});
  } catch (const scene::Error& error) {
    EXPECT_EQ(error.status(), scene::Status::input) << error.what();
    return error.what();
  }
  return "";
}

TEST(FrictionQuantities, AreRefusedInOneLineWhereThereIsNoBound) {
  const auto slip = quantity(QuantityKind::slip, "upper.bottom"), shear = shear_force("upper.bottom");
  for (const NamedLaw& law : {NamedLaw{"", Law::frictionless}, NamedLaw{"", Law::bilateral}})
    for (const auto& asked : {slip, shear})
      EXPECT_NE(refusal(with_law(two_blocks(2), law), asked).find("has bounds where there is friction"),
                std::string::npos);
  const auto rubbing = with_law(two_blocks(2), {"", Law::tresca, constant(0.004)});
  for (auto asked : {slip, shear}) {
    asked.stretch = scene::LineStretch{0, 0.5};
    EXPECT_NE(refusal(rubbing, asked).find("no stretch or weight"), std::string::npos);
  }
  const auto in_part = with_law(
      two_blocks(2),
      {"", Law::tresca, scene::enclosed<2>([](const auto& x) { return scene::choose(x[0] < 0.5, 0.0, x[0] - 0.5); })});
  EXPECT_NE(refusal(in_part, slip).find("there is none on the edge"), std::string::npos);
  EXPECT_EQ(refusal(in_part, shear), "");
}

}  // namespace
}  // namespace bracket::tests
