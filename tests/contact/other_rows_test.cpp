// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

#include "tests/contact/truss.h"

namespace bracket::contact {
namespace {

using namespace test;
using Sparse = Eigen::SparseMatrix<double>;

/// A truss above another one, joint against joint, `per_joint` rows of random normals each.
std::vector<Loaded> opposed(int per_joint, bool first_floats, std::mt19937& random) {
  const Truss upper = random_truss(9, random), lower_truss = random_truss(9, random);
  const Index m = 6 * per_joint;
  MatrixXd first = MatrixXd::Zero(m, 18), second = MatrixXd::Zero(m, 18);
  for (Index i = 0; i < m; ++i) {
    const Eigen::Vector2d normal = Eigen::Vector2d(random_vector(2, random)).normalized();
    bind(first, i, i / per_joint, normal);
    bind(second, i, i / per_joint, -normal);
  }
  const VectorXd carried =
      first.transpose() * random_vector(m, random).cwiseAbs() + upper.stiffness * random_vector(18, random);
  return {first_floats ? floating(upper, carried, first) : supported(upper, random_vector(18, random), first),
          supported(lower_truss, random_vector(18, random), second)};
}

std::vector<Sparse> rows_of(const std::vector<Loaded>& bodies) {
  std::vector<Sparse> rows;
  for (const Loaded& body : bodies) rows.push_back(body.rows);
  return rows;
}

void expect_same(const Solution& a, const Solution& b) {
  ASSERT_EQ(a.termination, Termination::solved);
  ASSERT_EQ(b.termination, Termination::solved);
  for (std::size_t k = 0; k < b.displacement.size(); ++k)
    EXPECT_LE((a.displacement[k] - b.displacement[k]).norm(), 1e3 * truss_rounding * (1 + b.displacement[k].norm()));
}

TEST(OtherRows, CombinationsAreAsIfTheBodiesHadBeenFactorisedWithThem) {
  std::mt19937 random(50);
  for (int trial = 0; trial < 20; ++trial) {
    const std::vector<Loaded> bodies = opposed(1, trial % 2 == 0, random);
    MatrixXd weights = random_vector(4 * 6, random).cwiseAbs().reshaped(4, 6);
    weights = (weights.array() > 1).select(0, weights);
    const VectorXd gap = 0.1 * random_vector(4, random);
    std::vector<Loaded> other = bodies;
    for (Loaded& body : other) body.rows = MatrixXd(weights * body.rows).sparseView();
    // A combination need not balance what the rows did.
    if (trial % 2 == 0) other[0].load = other[0].rows.transpose() * random_vector(4, random).cwiseAbs();
    const Solution anew = solve(other, gap);
    const Solution found = Bodies(systems_of(bodies)).with_rows(rows_of(other), {}).solve(loads_of(other), gap);
    expect_same(found, anew);
    EXPECT_LE((found.pressure - anew.pressure).norm(), 1e4 * truss_rounding * anew.pressure.norm());
    EXPECT_GE(found.pressure.minCoeff(), 0);
  }
}

TEST(OtherRows, AddedComplianceIsThatOfSpringsBetween) {
  std::mt19937 random(51);
  for (int trial = 0; trial < 20; ++trial) {
    const std::vector<Loaded> bodies = opposed(1, trial % 2 == 0, random);
    const VectorXd gap = 0.1 * random_vector(6, random), stiffness = random_vector(6, random).cwiseAbs();
    MatrixXd shortened = -MatrixXd::Identity(6, 6);  // r − s ≤ g
    std::vector<Loaded> with_springs = bodies;
    with_springs.push_back(
        {{lower(stiffness.asDiagonal()), {0, 1, 2, 3, 4, 5, 6}, shortened.sparseView(), MatrixXd(6, 0)},
         VectorXd::Zero(6)});
    const Solution anew = solve(with_springs, gap);
    const MatrixXd added = stiffness.cwiseInverse().asDiagonal();
    const Solution found =
        Bodies(systems_of(bodies)).with_rows(rows_of(bodies), added.sparseView()).solve(loads_of(bodies), gap);
    ASSERT_EQ(found.termination, Termination::solved);
    ASSERT_EQ(anew.termination, Termination::solved);
    EXPECT_LE((found.pressure - anew.pressure).norm(), 1e4 * truss_rounding * anew.pressure.norm());
    for (std::size_t b = 0; b < bodies.size(); ++b)
      EXPECT_LE((found.displacement[b] - anew.displacement[b]).norm(),
                1e4 * truss_rounding * (1 + anew.displacement[b].norm()));
  }
}

TEST(OtherRows, UnknownsThatNoRowTouchedAreRefused) {
  std::mt19937 random(52);
  const std::vector<Loaded> bodies = opposed(1, false, random);
  std::vector<Sparse> rows = rows_of(bodies);
  rows[1].coeffRef(0, 17) = 1;  // joints 6 to 8 have no rows
  rows[1].makeCompressed();
  EXPECT_THROW(Bodies(systems_of(bodies)).with_rows(rows, {}), std::invalid_argument);
}

TEST(DependentRows, ManyAtOneJointGiveTheSameDisplacementsAsOneByOne) {
  std::mt19937 random(53);
  int fewer = 0;
  for (int trial = 0; trial < 30; ++trial) {
    const std::vector<Loaded> bodies = opposed(2 + trial % 4, trial % 2 == 0, random);
    const Index m = bodies[0].rows.rows();
    // Zero: all rows of a joint close together; else at most two of them can.
    const VectorXd gap =
        trial % 3 == 0 ? VectorXd(VectorXd::Zero(m)) : VectorXd(0.1 * random_vector(m, random).cwiseAbs());
    const Solution one_by_one = solve(bodies, gap);
    const Solution found = Bodies(systems_of(bodies), true).solve(loads_of(bodies), gap);
    expect_same(found, one_by_one);
    const Kkt conditions = kkt(bodies, gap, found);
    EXPECT_LE(conditions.equilibrium, truss_rounding);
    EXPECT_LE(conditions.penetration, truss_rounding);
    EXPECT_LE(conditions.complementarity, truss_rounding);
    EXPECT_GE(conditions.least_pressure, 0);
    fewer += found.iterations < one_by_one.iterations;
  }
  EXPECT_GE(fewer, 10);
}

TEST(Memory, WhatTheMachineDoesNotHaveIsNotTried) {
  constexpr int n = 2000000;  // the rows' dense matrices would take 6e13 bytes
  System body;
  body.stiffness.resize(n, n);
  body.stiffness.setIdentity();
  body.rows = body.stiffness;
  for (int i = 0; i <= n; ++i) body.nodes.push_back(i);
  body.rigid.resize(n, 0);
  EXPECT_THROW(Bodies({body}), std::bad_alloc);
}

}  // namespace
}  // namespace bracket::contact
