// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/statics.h"

#include <gtest/gtest.h>

#include "contact/limits.h"
#include "tests/contact/truss.h"

namespace bracket::contact {
namespace {

using namespace test;

TEST(Motions, SpanTheRigidOnesFarFromTheOriginAndInAnyUnits) {
  std::mt19937 random(7);
  Truss truss = random_truss(10, random);
  for (double unit : {1e-6, 1.0, 1e6}) {
    const MatrixXd shifted = (truss.joints.array() + 1e3).matrix() * unit;
    const MatrixXd rigid = rigid_motions(shifted);
    const Motions found = motions(rigid);
    const double eps = std::numeric_limits<double>::epsilon();
    EXPECT_LE((found.basis.transpose() * found.basis / 20 - MatrixXd::Identity(3, 3)).norm(), 20 * 3 * eps);
    for (Index j = 0; j < 3; ++j)
      EXPECT_LE((found.basis * found.change - rigid).col(j).norm(), 20 * 3 * eps * rigid.col(j).norm());
  }
}

TEST(Pins, HoldEveryMotionAndSpareContactUnknowns) {
  std::mt19937 random(8);
  for (int trial = 0; trial < 50; ++trial) {
    const Truss truss = random_truss(10, random);
    const Motions found = motions(rigid_motions(truss.joints));
    std::vector<int> contact{1, 3, 5, 7};
    const std::vector<int> pinned = pins(found.basis, contact);
    ASSERT_EQ(pinned.size(), 3u);
    const MatrixXd held = found.basis(pinned, Eigen::all);
    // A greedy choice of rows loses at most a factor of 2^(k−1) √(n) to the best, which is of the order of one; the
    // weights of the contact unknowns cost another 2.
    EXPECT_GT(held.jacobiSvd().singularValues().minCoeff(), 1 / (4 * std::sqrt(20.0) * 2));
  }
  // All unknowns alike: then none of the contact unknowns is taken.
  EXPECT_EQ(pins(MatrixXd::Ones(5, 1), {0, 1, 3, 4}), std::vector<int>{2});
}

TEST(Pins, TakeContactUnknownsWhereThereAreNoOthers) {
  const MatrixXd basis = MatrixXd::Identity(3, 3);
  EXPECT_EQ(pins(basis, {0, 1, 2}).size(), 3u);
}

// A row that stops one motion of a body, in a random frame: the two others stay free.
TEST(Statics, SeparatesTheMotionsThatContactResists) {
  std::mt19937 random(9);
  const Truss truss = random_truss(8, random);
  MatrixXd rows = MatrixXd::Zero(1, 16);
  bind(rows, 0, 3, Eigen::Vector2d(0.6, 0.8));
  const Truss no_truss{truss.joints, truss.stiffness};
  const VectorXd load = rows.transpose() * VectorXd::Constant(1, 2.0);  // straight onto the row
  const Loaded body = floating(no_truss, load, rows);
  const std::vector<Motions> bases{motions(body.rigid)};
  const Statics all = statics({body.rows}, bases);
  EXPECT_EQ(all.resisted.size(), 1u);
  const BalancedLoad found = balanced_load(all, bases, {load}, complete({}, 1));
  ASSERT_TRUE(found.possible);
  EXPECT_NEAR(found.pressure[0], 2.0, 1e-13);
  EXPECT_LE(found.imbalance, 1e-15);

  VectorXd aside = load;
  aside[0] += 1e-6;  // out of balance along a motion that nothing resists
  const BalancedLoad lost = balanced_load(all, bases, {aside}, complete({}, 1));
  ASSERT_FALSE(lost.possible);
  EXPECT_GT((body.rigid.transpose() * aside).dot(bases[0].change.inverse() * lost.motion), 0);
}

// A body that slides along a line and turns about the origin, and a row straight through it: what is zero in all but
// rounding is made zero.
TEST(Statics, RowsThatResistNothingAreExactlyZero) {
  std::mt19937 random(40);
  for (int trial = 0; trial < 20; ++trial) {
    Truss truss = random_truss(7, random);
    const Eigen::Vector2d normal = Eigen::Vector2d(random_vector(2, random)).normalized();
    truss.joints.row(3) = 3 * normal.transpose();
    MatrixXd rows = MatrixXd::Zero(2, 14);
    bind(rows, 0, 3, normal);
    bind(rows, 1, 5, normal);
    Loaded body = floating(truss, VectorXd::Zero(14), rows);
    const MatrixXd all = body.rigid;
    body.rigid.resize(14, 2);
    body.rigid << all.col(0) * normal.y() - all.col(1) * normal.x(), all.col(2);
    const Statics found = statics({body.rows}, {motions(body.rigid)});
    EXPECT_EQ(found.rows.row(0).norm(), 0);
    EXPECT_GT(found.rows.row(1).norm(), 0);
  }
}

}  // namespace
}  // namespace bracket::contact
