// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Coulomb's friction, as the last of steps whose shear has a given bound.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bounds/bounds.h"
#include "bounds/results.h"
#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/laws/pairs.h"

namespace bracket::tests {
namespace {

using scene::Law;
using scene::Scene;

constexpr double modulus = 3, mu = 0.5;

/// A block without side-strain (ν = 0), its top moved by (along, −down), on a wall; sides carry the shear t.
Scene<2> sheared(double along, double down, double t) {
  Scene<2> s;
  s.blocks = {block("b", 0, 2, 0, 1, 3, 2)};
  s.bodies = {{"b", scene::isotropic<2>(modulus, 0, scene::Plane::strain)}};
  s.boundary = {{"b.top", fixed(along, -down)},
                {"b.right", traction(constant(0), constant(t))},
                {"b.left", traction(constant(0), constant(-t))}};
  s.contact = {{"b.bottom", "rigid", {}, ""}};
  s.refine = {.strategy = scene::Strategy::uniform, .max_levels = 3};
  return with_law(s, {"", Law::coulomb, constant(mu)});
}

// With p = E down and G = E/2: sticks while G along < μ p, slips by along − μ p/G beyond.
TEST(Coulomb, UniformShearSticksOrSlips) {
  constexpr double shear = modulus / 2, down = 0.25, area = 2, bound = mu * modulus * down;
  for (const int degree : {1, 2})
    for (const double sign : {1.0, -1.0})
      for (const double along : {0.125 * sign, 0.75 * sign}) {
        const double t = std::copysign(std::min(shear * std::abs(along), bound), along);
        const double slip = std::abs(along) - std::abs(t) / shear;
        const double energy = 0.5 * (modulus * down * down + t * t / shear) * area + bound * slip * 2;
        Scene<2> s = sheared(along, down, t);
        s.solve.degree = degree;
        const auto outcome = bounds::run(s);
        SCOPED_TRACE(testing::Message() << "degree " << degree << ", moved by " << along);
        ASSERT_EQ(outcome.guarantee, "tresca-step");
        EXPECT_EQ(outcome.status, scene::Status::done);
        double off = 0;
        for (const auto& level : outcome.levels) {
          EXPECT_TRUE(level.friction.settled);
          if (slip == 0) {  // the first step is it
            EXPECT_LE(level.friction.residual, 1e-11 * energy);
            EXPECT_NEAR(level.certificate.lower, energy, 1e-11 * energy);
            EXPECT_NEAR(level.certificate.upper, energy, 1e-11 * energy);
          }
          // Steps end before the bound is that of the law, within twice the width.
          off = std::abs((level.certificate.lower + level.certificate.upper) / 2 - energy);
        }
        EXPECT_LE(off, 1e-3 * energy);
      }
}

/// A heavy block on a slope, which nothing but friction holds.
Scene<2> on_slope(double degrees) {
  Scene<2> s;
  s.blocks = {block("b", 0, 2, 0, 1, 4, 2)};
  s.bodies = {{"b", scene::isotropic<2>(modulus, 0.3, scene::Plane::strain)}};
  const double angle = degrees * std::numbers::pi / 180;
  s.bodies.at("b").force = {-std::sin(angle), -std::cos(angle)};
  s.contact = {{"b.bottom", "rigid", {}, ""}};
  s.refine = {.strategy = scene::Strategy::uniform, .max_levels = 3};
  return with_law(s, {"", Law::coulomb, constant(mu)});
}

// The slope's angle of repose is atan μ = 26.57°.
TEST(Coulomb, ABlockRestsOnASlopeThatIsNotTooSteep) {
  const auto outcome = bounds::run(on_slope(26));
  ASSERT_EQ(outcome.guarantee, "tresca-step") << outcome.reason;
  for (std::size_t i = 0; i < outcome.levels.size(); ++i) {
    const auto& level = outcome.levels[i];
    EXPECT_LE(level.certificate.lower, level.certificate.upper);
    EXPECT_TRUE(level.friction.settled) << level.friction.residual;
    if (i > 0) {
      EXPECT_LT(level.friction.residual, outcome.levels[i - 1].friction.residual);
    }
  }
  try {
    bounds::run(on_slope(27));
    FAIL();
  } catch (const scene::Error& error) {
    EXPECT_EQ(error.status(), scene::Status::ill_posed);
    EXPECT_NE(std::string(error.what()).find("body 'b' is pushed off: moving it by"), std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("shear of at most mu times the pressure"), std::string::npos)
        << error.what();
  }
}

/// A block pressed on another and pushed.
Scene<2> pushed(double friction) {
  Scene<2> s = two_blocks(4);
  s.boundary = {
      {"lower.bottom", fixed(0, 0)}, {"upper.top", pressure(constant(0.1))}, {"upper.left", pressure(constant(0.03))}};
  s.refine = {.strategy = scene::Strategy::uniform, .max_levels = 3};
  return with_law(s, {"", Law::coulomb, constant(friction)});
}

// η ≥ 0, and every step's interval is one: the widths fall with the mesh, and the residual with them.
TEST(Coulomb, ResidualsFallWithTheMesh) {
  for (const int degree : {1, 2}) {
    Scene<2> s = pushed(0.4);
    s.solve.degree = degree;
    const auto outcome = bounds::run(s);
    ASSERT_EQ(outcome.guarantee, "tresca-step") << outcome.reason;
    for (std::size_t i = 0; i < outcome.levels.size(); ++i) {
      const auto& [steps, residual, settled] = outcome.levels[i].friction;
      EXPECT_TRUE(settled);
      EXPECT_GE(residual, 0);
      EXPECT_LE(residual, 2 * (outcome.levels[i].bracket.upper - outcome.levels[i].bracket.lower) * 1.001);
      if (i > 0) {
        EXPECT_LT(residual, 0.7 * outcome.levels[i - 1].friction.residual);
      }
    }
  }
}

// What the last step presses with near five places of the contact, against what its bound assumed: they add up to the
// force, by statics 0.1, and come near to each other as the residual falls.
TEST(Coulomb, ForcesOfTheLastStepAreThoseThatItsBoundAssumed) {
  double before = 1;
  for (const int levels : {1, 2, 3}) {
    Scene<2> s = pushed(0.4);
    s.refine.max_levels = levels;
    const auto outcome = bounds::run(s);
    ASSERT_EQ(outcome.friction.size(), 5u);
    double lower = 0, upper = 0, assumed = 0, off = 0;
    for (const auto& [contact, at, least, most, assumed_least, assumed_most] : outcome.friction) {
      EXPECT_EQ(contact, 0);
      EXPECT_NEAR(at[1], 1, 1e-12);
      EXPECT_GE(least, 0);
      EXPECT_LE(least, most);
      EXPECT_LE(assumed_least, assumed_most);
      EXPECT_LE(assumed_most - assumed_least, 1e-12);
      lower += least, upper += most, assumed += assumed_most;
      off += std::max(most - assumed_least, assumed_most - least);
    }
    EXPECT_LE(lower, 0.1);
    EXPECT_GE(upper, 0.1);
    EXPECT_NEAR(assumed, 0.1, 1e-9);  // of stresses in equilibrium
    EXPECT_LT(off, before);
    before = off;
  }
  EXPECT_LT(before, 0.02);
}

// The last step's fields are the level's: they are not solved for again.
TEST(Coulomb, TheLastStepIsSolvedOnce) {
  int steps = 0, solved = 0, told = 0;
  bounds::Observer<2> observer;
  observer.stage = [&](const std::string& stage) {
    steps += stage.starts_with("friction, step");
    solved += stage.starts_with("displacements and stresses");
  };
  const auto outcome = bounds::run(pushed(0.4), observer);
  for (const auto& level : outcome.levels) told += level.friction.steps;
  EXPECT_EQ(steps, told);
  EXPECT_EQ(solved, 0);
  const auto& problem = outcome.problem;
  const auto u = primal::solve(problem, 2);
  const double energy = bounds::potential_energy(problem, u.displacement).total;
  const double rounding = 1e-13 * std::abs(energy);  // of a solve that starts elsewhere
  EXPECT_NEAR(bounds::potential_energy(problem, outcome.displacement).total, energy, rounding);
}

// Without friction the law is none: the same to the last bit.
TEST(Coulomb, OfNoneIsFrictionless) {
  Scene<2> s = pushed(0);
  s.boundary["upper.left"] = sliding(0);
  const auto none = bounds::run(s);
  const auto smooth = bounds::run(with_law(s, {"", Law::frictionless}));
  EXPECT_EQ(none.guarantee, "rounding-safe");
  EXPECT_EQ(none.lower, smooth.lower);
  EXPECT_EQ(none.upper, smooth.upper);
}

TEST(Coulomb, IsRefusedWhereItHasNoMeaning) {
  EXPECT_THROW(dual::uzawa(problem(pushed(0.4)), {}), std::invalid_argument);
  Scene<2> s = pushed(0.4);
  s.solve.degree = 3;
  EXPECT_THROW(bounds::run(s), scene::Error);
  s.solve.degree = 2;
  EXPECT_THROW(bounds::run(s, problem(s)), scene::Error);  // refined, it needs its scene
  s.refine.strategy = scene::Strategy::none;
  EXPECT_EQ(bounds::run(s, problem(s)).guarantee, "tresca-step");
  s.contact[0].value = scene::enclosed<2>([](const auto& x) { return 0.1 + x[0]; });
  EXPECT_THROW(problem(s), scene::Error);
}

}  // namespace
}  // namespace bracket::tests
