// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Where laws become each other: intervals meet.
#include <gtest/gtest.h>

#include <algorithm>

#include "bounds/bounds.h"
#include "tests/laws/pairs.h"

namespace bracket::tests {
namespace {

using scene::Law;
using scene::Scene;

/// Two blocks of which the upper one is held at its top, so that it needs no contact.
Scene<2> held_blocks(double pull) {
  Scene<2> s = two_blocks(4, pull);
  s.boundary = {{"lower.bottom", fixed(0, 0)},
                {"lower.right", traction(constant(0.01), constant(0.02))},
                {"upper.top", fixed(0.02, -0.05)},
                {"upper.right",
                 traction(constant(0.03), scene::enclosed<2>([pull](const auto& x) { return pull * (x[1] - 1.5); }))}};
  s.refine = {.strategy = scene::Strategy::uniform, .max_levels = 2};
  return s;
}

bounds::Outcome<2> solved(const Scene<2>& s) {
  auto outcome = bounds::run(s);
  EXPECT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
  return outcome;
}

/// ½ ∫ p² on the last mesh.
double half_square_of_pressure(const bounds::Outcome<2>& outcome) {
  double sum = 0;
  const auto states = bounds::contact_state(outcome.problem, outcome.displacement, outcome.stress);
  for (std::size_t j = 0; j < states.size(); ++j)
    sum += 0.5 * scene::length(outcome.problem.mesh, outcome.problem.contact[j].first) *
           scene::bernstein_product(states[j].pressure, states[j].pressure);
  return sum;
}

void expect_meeting(const bounds::Outcome<2>& one, const bounds::Outcome<2>& other, double apart) {
  EXPECT_LE(one.lower, other.upper + apart);
  EXPECT_LE(other.lower, one.upper + apart);
}

// L_∞ − ½ ∫ p²/k ≤ L_k ≤ L_∞ with the pressure of the rigid contact: φ*(p) is larger by p²/2k.
TEST(Laws, StiffSpringsAreRigidContact) {
  for (const double pull : {0.3, 0.02})
    for (const bool lifts_off : {true, false}) {
      const auto rigid = solved(with_law(held_blocks(pull), {"", lifts_off ? Law::frictionless : Law::bilateral}));
      const double soft = half_square_of_pressure(rigid);
      for (const double k : {1e2, 1e5, 1e8, 1e12}) {
        const auto springs = solved(with_law(held_blocks(pull), {"", Law::winkler, constant(k), lifts_off}));
        SCOPED_TRACE(testing::Message() << "k " << k << ", lift-off " << lifts_off);
        expect_meeting(springs, rigid, 1.5 * soft / k);
        EXPECT_LE(springs.lower, rigid.upper);
      }
    }
}

TEST(Laws, SoftSpringsAreNone) {
  Scene<2> open = held_blocks(0.1);
  open.contact.clear();
  const auto free = solved(open);
  for (const bool lifts_off : {true, false})
    for (const double k : {1e-12, 1e-8, 1e-5}) {
      const auto springs = solved(with_law(held_blocks(0.1), {"", Law::winkler, constant(k), lifts_off}));
      SCOPED_TRACE(testing::Message() << "k " << k << ", lift-off " << lifts_off);
      expect_meeting(springs, free, k);  // displacements are below one: ½ ∫ k r² is less
      EXPECT_GE(springs.upper, free.lower);
    }
}

TEST(Laws, NoFrictionIsFrictionless) {
  for (const bool lifts_off : {true, false}) {
    const auto smooth = solved(with_law(held_blocks(0.3), {"", lifts_off ? Law::frictionless : Law::bilateral}));
    const auto rubbing = solved(with_law(held_blocks(0.3), {"", Law::tresca, constant(0), lifts_off}));
    EXPECT_EQ(smooth.lower, rubbing.lower);
    EXPECT_EQ(smooth.upper, rubbing.upper);
    const auto hardly = solved(with_law(held_blocks(0.3), {"", Law::tresca, constant(1e-10), lifts_off}));
    expect_meeting(smooth, hardly, 1e-10);
  }
}

TEST(Laws, StrongFrictionWithoutLiftOffIsABond) {
  Scene<2> bonded = held_blocks(0.3);
  bonded.contact.clear();
  bonded.bonds = {{"upper.bottom", "lower.top"}};
  const auto one_piece = solved(bonded);
  const auto rubbing = solved(with_law(held_blocks(0.3), {"", Law::tresca, constant(3), false}));
  expect_meeting(one_piece, rubbing, 0);
  EXPECT_NEAR(one_piece.lower, rubbing.lower, 1e-10 * std::abs(one_piece.lower));
  EXPECT_NEAR(one_piece.upper, rubbing.upper, 1e-10 * std::abs(one_piece.upper));
}

}  // namespace
}  // namespace bracket::tests
