// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// States of one stress and one strain, which are in both spaces: the bounds are the energy, whatever the law.
#include <gtest/gtest.h>

#include <cmath>

#include "bounds/bounds.h"
#include "bounds/results.h"
#include "tests/laws/pairs.h"

namespace bracket::tests {
namespace {

using scene::Law;
using scene::Scene;

void expect_energy(Scene<2> s, double energy) {
  s.refine = {.strategy = scene::Strategy::uniform, .max_levels = 2};
  for (const int degree : {1, 2, 3, 4}) {
    s.solve.degree = degree;
    const auto outcome = bounds::run(s);
    SCOPED_TRACE(testing::Message() << "degree " << degree << " " << outcome.reason);
    ASSERT_EQ(outcome.guarantee, "rounding-safe");
    for (const auto& level : outcome.levels) {
      EXPECT_LE(level.certificate.lower, energy);
      EXPECT_GE(level.certificate.upper, energy);
      EXPECT_LE(level.certificate.upper - level.certificate.lower, 1e-12 * std::abs(energy));
    }
  }
}

constexpr double young = 3, poisson = 0.3;

/// A bar 2 wide and 1.5 high between smooth side walls, on a wall at its bottom, with the vertical traction t on top.
Scene<2> bar(double t, const NamedLaw& law) {
  Scene<2> s;
  s.blocks = {block("bar", 0, 2, 0, 1.5, 3, 2)};
  s.bodies = {{"bar", scene::isotropic<2>(young, poisson, scene::Plane::strain)}};
  s.boundary = {{"bar.left", sliding(0)}, {"bar.right", sliding(0)}, {"bar.top", traction(constant(0), constant(t))}};
  s.contact = {{"bar.bottom", "rigid", {}, ""}};
  return with_law(s, law);
}
/// −½ ∫ (t²/M + t²/k), M the modulus of strain without side-strain.
double energy_of_bar(double t, double by_k) {
  const double modulus = young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson));
  return -0.5 * 2 * t * t * (1.5 / modulus + by_k);
}

TEST(Laws, ABarOnSpringsIsExact) {
  for (const double k : {1e-6, 0.25, 1e8})
    for (const bool lifts_off : {true, false})
      expect_energy(bar(-0.5, {"", Law::winkler, constant(k), lifts_off}), energy_of_bar(0.5, 1 / k));
}

TEST(Laws, ABarHangsOnSpringsThatPullAndOnSidesThatDoNotPart) {
  expect_energy(bar(0.5, {"", Law::winkler, constant(0.25), false}), energy_of_bar(0.5, 4));
  expect_energy(bar(0.5, {"", Law::bilateral}), energy_of_bar(0.5, 0));
  expect_energy(bar(0.5, {"", Law::tresca, constant(1), false}), energy_of_bar(0.5, 0));
}

TEST(Laws, ABarThatIsPulledOffIsNamed) {
  for (const NamedLaw& law : {NamedLaw{"", Law::winkler, constant(2)}, NamedLaw{"", Law::tresca, constant(2)}}) {
    try {
      bounds::run(bar(0.5, law));
      FAIL();
    } catch (const scene::Error& error) {
      EXPECT_EQ(error.status(), scene::Status::ill_posed);
      EXPECT_NE(std::string(error.what()).find("body 'bar' is pushed off: moving it by (0, 1)"), std::string::npos)
          << error.what();
    }
  }
}

/// A block without side-strain (ν = 0), its top moved by (along, −down), its bottom on a wall with friction; sides
/// carry the shear t of the state of uniform shear.
Scene<2> sheared(double along, double down, double bound, double t) {
  return block_on_wall(young, along, down, t, {"", Law::tresca, constant(bound)});
}

// With G = E/2: sticks while G along < g, slips by along − g/G beyond. What the sides carry does no work.
TEST(Laws, UniformShearSticksOrSlipsAtTheBound) {
  constexpr double shear = young / 2, down = 0.25, area = 2;
  const double pressed = 0.5 * young * down * down * area;
  for (const double sign : {1.0, -1.0}) {
    const double stuck = 0.125 * sign, t = shear * stuck;
    expect_energy(sheared(stuck, down, 0.5, t), pressed + 0.5 * t * t / shear * area);
    const double bound = 0.375, along = 0.75 * sign;
    const double slip = std::abs(along) - bound / shear;
    expect_energy(sheared(along, down, bound, bound * sign),
                  pressed + 0.5 * bound * bound / shear * area + bound * slip * 2);
  }
}

// A jump (x, y) between block and wall prescribes the displacement of the bottom, but for what slips.
TEST(Laws, AJumpIsWhatFrictionDoesNotSee) {
  constexpr double shear = young / 2, down = 0.25, area = 2, x = 0.5, y = 0.125;
  const double pressed = 0.5 * young * (down + y) * (down + y) * area;
  const auto with_jump = [](Scene<2> s) {
    s.contact[0].lifts_off = false;
    s.contact[0].jump = {constant(x), constant(y)};
    return s;
  };
  for (const double sign : {1.0, -1.0}) {
    const double stuck = 0.125 * sign, t = shear * stuck;
    expect_energy(with_jump(sheared(x + stuck, down, 0.5, t)), pressed + 0.5 * t * t / shear * area);
    const double bound = 0.375, along = 0.75 * sign, slip = std::abs(along) - bound / shear;
    expect_energy(with_jump(sheared(x + along, down, bound, bound * sign)),
                  pressed + 0.5 * bound * bound / shear * area + bound * slip * 2);
  }
}

// A body that friction alone holds follows a jump that is rigid, and nothing is strained.
TEST(Laws, ARigidJumpIsARigidMotion) {
  Scene<2> s = two_bodies(0, 1, 1, 1, 4, 2);
  s.bodies = {{"lower", scene::isotropic<2>(3, 0.3, scene::Plane::strain)},
              {"upper", scene::isotropic<2>(2, 0.3, scene::Plane::strain)}};
  s.boundary = {{"lower.bottom", fixed(0, 0)}};
  s = with_law(s, {"", Law::tresca, constant(1), false});
  s.contact[0].gap.reset();
  s.contact[0].jump = {scene::enclosed<2>([](const auto& x) { return 0.25 - 0.125 * x[1]; }),
                       scene::enclosed<2>([](const auto& x) { return 0.125 * x[0] - 0.5; })};
  const auto outcome = bounds::run(s);
  ASSERT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
  EXPECT_LE(outcome.lower, 0);
  EXPECT_GE(outcome.upper, 0);
  EXPECT_LE(outcome.upper - outcome.lower, 1e-14);
  const auto top = bounds::largest_displacement(outcome.problem, outcome.displacement);
  EXPECT_NEAR(top.displacement.norm(), scene::Vector<2>(0.25, -0.5).norm(), 1e-12);
}

TEST(Laws, ABlockThatFrictionAloneHoldsIsSheared) {
  Scene<2> s = sheared(0, 0, 0.5, 0.25);
  s.boundary.at("b.top") = traction(constant(0.25), constant(-0.5));
  expect_energy(s, -0.5 * 2 * (0.25 * 0.25 / (young / 2) + 0.5 * 0.5 / young));
  s.boundary.at("b.top") = traction(constant(0.625), constant(-0.5));
  for (const char* side : {"b.left", "b.right"})
    s.boundary.at(side) = traction(constant(0), constant(side == std::string("b.left") ? -0.625 : 0.625));
  try {
    bounds::run(s);
    FAIL();
  } catch (const scene::Error& error) {
    EXPECT_EQ(error.status(), scene::Status::ill_posed);
    EXPECT_NE(std::string(error.what()).find("which friction does not hold"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace bracket::tests
