// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/active_set.h"

#include <gtest/gtest.h>

#include "contact/growing_cholesky.h"
#include "tests/contact/truss.h"

namespace bracket::contact {
namespace {

using namespace test;

double energy(const Interface& problem, const VectorXd& pressure) {
  return 0.5 * pressure.dot(problem.compliance * pressure) - pressure.dot(problem.overlap);
}

/// The least energy over the minima of all active sets, where p ≥ 0 and Gᵀp = e. Each is a feasible p; the solution is
/// one of them. \return nothing if no set has one
std::optional<double> brute_force(const Interface& problem) {
  const Index m = problem.overlap.size(), k = problem.load.size();
  std::optional<double> least;
  for (int set = 0; set < (1 << m); ++set) {
    std::vector<Index> active;
    for (Index i = 0; i < m; ++i)
      if (set >> i & 1) active.push_back(i);
    const auto n = static_cast<Index>(active.size());
    if (n + k == 0) {
      least = 0;
      continue;
    }
    MatrixXd system = MatrixXd::Zero(n + k, n + k);
    VectorXd right(n + k);
    system.topLeftCorner(n, n) = problem.compliance(active, active);
    system.topRightCorner(n, k) = -problem.motion(active, Eigen::all);
    system.bottomLeftCorner(k, n) = problem.motion(active, Eigen::all).transpose();
    right << problem.overlap(active), problem.load;
    const VectorXd unknowns = system.completeOrthogonalDecomposition().solve(right);
    if ((system * unknowns - right).norm() > 1e-9 * (right.norm() + unknowns.norm())) continue;
    VectorXd pressure = VectorXd::Zero(m);
    pressure(active) = unknowns.head(n);
    if ((pressure.array() < -1e-10 * pressure.norm()).any()) continue;
    if (!least || energy(problem, pressure) < *least) least = energy(problem, pressure);
  }
  return least;
}

/// p ≥ 0, Gᵀp = e, slacks ≥ 0, zero where p > 0: sufficient for the minimum, since it is convex.
void expect_optimal(const Interface& problem, const Pressure& found) {
  ASSERT_EQ(found.termination, Termination::solved);
  ASSERT_EQ(found.pressure.size(), problem.overlap.size());
  const VectorXd& p = found.pressure;
  const VectorXd terms = problem.compliance.cwiseAbs() * p + problem.size + problem.overlap.cwiseAbs() +
                         problem.motion.cwiseAbs() * found.motion.cwiseAbs();
  const VectorXd slack = problem.compliance * p - problem.overlap - problem.motion * found.motion;
  // Equality problems are solved through pivots as small as 1e-12 of the diagonal; those here are above 1e-4.
  const double rounding = 1e4 * 10 * eps * terms.maxCoeff();
  EXPECT_TRUE((p.array() >= 0).all());
  EXPECT_LE((problem.motion.transpose() * p - problem.load).norm(), rounding + 1e4 * 10 * eps * p.norm());
  EXPECT_GE(slack.minCoeff(), -rounding);
  EXPECT_LE(p.cwiseProduct(slack).cwiseAbs().maxCoeff(), rounding * p.maxCoeff());
  VectorXd open = p;
  open(found.active).setZero();
  EXPECT_EQ(open.norm(), 0);
}

/// F = X Xᵀ from `m` rows in `n` unknowns (dependent if n < m), loads that can be balanced.
Interface random_interface(Index m, Index n, Index k, std::mt19937& random) {
  const MatrixXd rows = MatrixXd::NullaryExpr(m, n, [&] { return random_vector(1, random)[0]; });
  const MatrixXd motion = MatrixXd::NullaryExpr(m, k, [&] { return random_vector(1, random)[0]; });
  const VectorXd overlap = rows * random_vector(n, random);
  return {rows * rows.transpose(), overlap, overlap.cwiseAbs(), motion,
          motion.transpose() * random_vector(m, random).cwiseMax(0)};
}

Pressure descend(const Interface& problem) {
  return primal_active_set(problem, balance(problem.motion, problem.load, 1e-10 * problem.load.norm()).pressure);
}

TEST(ActiveSet, BothWaysAgreeWithAllSubsets) {
  std::mt19937 random(10);
  for (int trial = 0; trial < 150; ++trial) {
    const Index m = 1 + static_cast<Index>(random() % 8), k = static_cast<Index>(random() % 4) * (m > 3);
    const Interface problem = scaled(random_interface(m, m + 4, k, random)).problem;
    const auto least = brute_force(problem);
    ASSERT_TRUE(least);
    const Pressure slow = descend(problem);
    expect_optimal(problem, slow);
    EXPECT_NEAR(energy(problem, slow.pressure), *least, 1e-10 * (1 + std::abs(*least)));
    std::vector<char> guess(static_cast<std::size_t>(m));
    for (char& g : guess) g = random() % 2;
    for (const auto& from : {guess, std::vector<char>(static_cast<std::size_t>(m), 1)})
      if (const auto fast = block_active_set(problem, from)) {
        expect_optimal(problem, *fast);
        EXPECT_NEAR((fast->pressure - slow.pressure).norm(), 0, 1e-9 * (1 + slow.pressure.norm()));
      }
  }
}

TEST(ActiveSet, BlocksSettleWhereRowsAreManyAndIndependent) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 10; ++trial) {
    const Interface problem = scaled(random_interface(60, 300, 3, random)).problem;
    const auto fast = block_active_set(problem, std::vector<char>(60, 1));
    ASSERT_TRUE(fast);
    expect_optimal(problem, *fast);
    EXPECT_NEAR((fast->pressure - descend(problem).pressure).norm(), 0, 1e-9 * fast->pressure.norm());
  }
}

// Fewer unknowns than rows: rows depend on each other, p is not unique. The overlap comes from displacements, less gaps
// that some displacement meets; so there is a solution.
TEST(ActiveSet, RowsThatDependOnEachOther) {
  std::mt19937 random(12);
  for (int trial = 0; trial < 200; ++trial) {
    const Index m = 2 + static_cast<Index>(random() % 7), n = 1 + static_cast<Index>(random() % 3);
    const Index k = static_cast<Index>(random() % 2);
    // Integers: many exact ties and rows that are the same, opposite, or means of two others.
    const auto integer = [&] { return static_cast<double>(static_cast<int>(random() % 5) - 2); };
    const MatrixXd rows = MatrixXd::NullaryExpr(m, n, integer);
    MatrixXd motion = MatrixXd::NullaryExpr(m, k, integer);
    if (k > 0 && motion.norm() == 0) motion(0, 0) = 1;
    const VectorXd possible = VectorXd::NullaryExpr(n, integer), moved = VectorXd::NullaryExpr(k, integer);
    const VectorXd left = VectorXd::NullaryExpr(m, [&] { return static_cast<double>(random() % 2); });
    const VectorXd gap = rows * possible + motion * moved + left;
    const VectorXd unhindered = VectorXd::NullaryExpr(n, integer), pressure = VectorXd::NullaryExpr(m, integer);
    const VectorXd overlap = 2 * rows * unhindered - gap;
    const VectorXd load = motion.transpose() * pressure.cwiseAbs();
    const Interface problem = scaled({rows * rows.transpose(), overlap, overlap.cwiseAbs(), motion, load}).problem;
    const auto least = brute_force(problem);
    ASSERT_TRUE(least);
    const Pressure found = descend(problem);
    expect_optimal(problem, found);
    EXPECT_NEAR(energy(problem, found.pressure), *least, 1e-10 * (1 + std::abs(*least)));
  }
}

// Degenerate statics: the load acts exactly above one row, so p of that row alone balances it, the second row that it
// takes to hold the rotation has none, and which one it is only the slacks tell.
TEST(ActiveSet, LoadExactlyAboveOneRow) {
  const Index m = 7;
  MatrixXd motion(m, 2);
  for (Index i = 0; i < m; ++i) motion.row(i) << 1, static_cast<double>(i) - 3;
  std::mt19937 random(13);
  for (Index above = 0; above < m; ++above)
    for (int trial = 0; trial < 20; ++trial) {
      const VectorXd overlap = -random_vector(m, random).cwiseAbs2();
      const Interface problem =
          scaled({1e-9 * MatrixXd::Identity(m, m), overlap, overlap.cwiseAbs(), motion, motion.row(above).transpose()})
              .problem;
      expect_optimal(problem, descend(problem));
    }
}

// The same with compliances of any kind: rounding must not take out a row that the statics need.
TEST(ActiveSet, DegenerateStatics) {
  std::mt19937 random(17);
  for (int trial = 0; trial < 600; ++trial) {
    const Index m = 8 + static_cast<Index>(random() % 8), k = 2 + static_cast<Index>(random() % 2);
    Interface problem = random_interface(m, m + 8, k, random);
    problem.load = problem.motion.row(static_cast<Index>(random() % m)).transpose();
    const Scaled to = scaled(problem);
    expect_optimal(to.problem, descend(to.problem));
  }
}

TEST(ActiveSet, ContradictionIsFoundAndOnlyThat) {
  // One unknown between two walls: u ≤ g1, −u ≤ g2.
  MatrixXd rows(2, 1);
  rows << 1, -1;
  for (double clearance : {-1.0, -1e-9, 0.0, 1e-9, 1.0}) {
    const VectorXd overlap = Eigen::Vector2d(5 - 1, -5 - (clearance - 1));
    const Interface problem{rows * rows.transpose(), overlap, Eigen::Vector2d(6, 6), MatrixXd(2, 0), VectorXd(0)};
    const Pressure found = primal_active_set(scaled(problem).problem, VectorXd::Zero(2));
    EXPECT_EQ(found.termination, clearance < 0 ? Termination::contradiction : Termination::solved) << clearance;
  }
}

TEST(ActiveSet, RowsThatTouchWithoutPressureStayAsTheyAre) {
  std::mt19937 random(14);
  const Index m = 20;
  const MatrixXd rows = MatrixXd::NullaryExpr(m, 3 * m, [&] { return random_vector(1, random)[0]; });
  const MatrixXd compliance = rows * rows.transpose();
  VectorXd pressure = random_vector(m, random).cwiseMax(0);
  const VectorXd overlap = compliance * pressure;  // all slacks are zero, a half of the pressures too
  const Interface problem = scaled({compliance, overlap, overlap.cwiseAbs(), MatrixXd(m, 0), VectorXd(0)}).problem;
  const auto fast = block_active_set(problem, std::vector<char>(m, 1));
  ASSERT_TRUE(fast);
  EXPECT_LE(fast->iterations, 4);
  expect_optimal(problem, *fast);
  expect_optimal(problem, descend(problem));
}

TEST(ActiveSet, ScalingMakesUnitsAndModuliVanish) {
  std::mt19937 random(15);
  const Interface problem = random_interface(6, 12, 2, random);
  const Scaled plain = scaled(problem);
  EXPECT_NEAR((plain.problem.compliance.diagonal() - VectorXd::Ones(6)).norm(), 0, 6 * eps);
  EXPECT_NEAR((plain.problem.motion.transpose() * plain.problem.motion - MatrixXd::Identity(2, 2)).norm(), 0, 50 * eps);
  const VectorXd p = plain.row.cwiseProduct(descend(plain.problem).pressure);
  for (double unit : {1e-24, 1e24}) {
    const Scaled other =
        scaled({problem.compliance * unit, problem.overlap * unit, problem.size * unit, problem.motion, problem.load});
    EXPECT_NEAR((other.row.cwiseProduct(descend(other.problem).pressure) - p).norm(), 0, 1e4 * 10 * eps * p.norm());
  }
}

// Rows that no motion meets stay so: by rounding they would balance any load, with a pressure without bound.
TEST(ActiveSet, ScalingKeepsZeroRows) {
  MatrixXd motion(7, 2);
  motion << 0, 0, 0, 1, 0, 2, -2, -2, -2, -2, 1, 0, 2, 2;
  const VectorXd none = VectorXd::Zero(7);
  const Scaled found = scaled({MatrixXd::Identity(7, 7), none, none, motion, Eigen::Vector2d(-4, -2)});
  EXPECT_EQ(found.problem.motion.row(0).norm(), 0);
}

// Closed rows that meet a motion by the rounding of zero only do not hold it, those that meet it by 1e-6 do.
TEST(Held, RoundingHoldsNothing) {
  std::mt19937 random(18);
  const VectorXd right = random_vector(5, random), load = random_vector(2, random);
  for (double size : {1.0, 1e-6, 1e-16, 0.0}) {
    MatrixXd left = MatrixXd::NullaryExpr(5, 2, [&] { return random_vector(1, random)[0]; });
    left.col(1) *= size;
    const auto found = held(left, right, load);
    ASSERT_EQ(found.has_value(), size > 1e-12) << size;
    if (!found) continue;
    // Lᵀp balances the load, and Lᵀp − c is in the range of the motions.
    const VectorXd sum = found->parts.rowwise().sum();
    const double rounding = 100 * eps * (found->parts.norm() + left.norm() * found->motion.norm());
    EXPECT_LE((left.transpose() * sum - load).norm(), rounding) << size;
    EXPECT_LE((sum - right - left * found->motion).norm(), rounding) << size;
  }
}

TEST(GrowingCholesky, FollowsRowsInAndOut) {
  std::mt19937 random(16);
  const Index n = 12;
  const MatrixXd x = MatrixXd::NullaryExpr(n, n + 3, [&] { return random_vector(1, random)[0]; });
  const MatrixXd matrix = x * x.transpose();
  GrowingCholesky factor(n);
  std::vector<Index> rows;
  for (int step = 0; step < 200; ++step) {
    const Index row = static_cast<Index>(random() % n);
    const auto place = std::find(rows.begin(), rows.end(), row);
    if (place != rows.end()) {
      factor.remove(place - rows.begin());
      rows.erase(place);
    } else {
      ASSERT_TRUE(factor.append(matrix(rows, row), matrix(row, row)));
      rows.push_back(row);
    }
    const VectorXd right = random_vector(static_cast<Index>(rows.size()), random);
    const VectorXd solution = factor.backward(factor.forward(right));
    const MatrixXd expected = matrix(rows, rows);
    EXPECT_LE((expected * solution - right).norm(), 1e3 * n * eps * (expected.norm() * solution.norm() + 1));
  }
  ASSERT_FALSE(rows.empty());
  EXPECT_FALSE(factor.append(2 * matrix(rows, rows[0]), 4 * matrix(rows[0], rows[0])));  // twice a row that is there
}

}  // namespace
}  // namespace bracket::contact
