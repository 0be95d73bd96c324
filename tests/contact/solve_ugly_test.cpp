// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/contact/truss.h"

namespace bracket::contact {
namespace {

using namespace test;

void expect_kkt(const std::vector<Loaded>& bodies, const VectorXd& gap, const Solution& solution) {
  ASSERT_EQ(solution.termination, Termination::solved);
  const Kkt found = kkt(bodies, gap, solution);
  EXPECT_LE(found.equilibrium, truss_rounding);
  EXPECT_LE(found.rigid, truss_rounding);
  EXPECT_LE(found.penetration, truss_rounding);
  EXPECT_LE(found.complementarity, truss_rounding);
  EXPECT_GE(found.least_pressure, 0);
}

/// The same rows twice, and the means of neighbours.
MatrixXd with_dependent_rows(const MatrixXd& rows) {
  MatrixXd result(3 * rows.rows() - 1, rows.cols());
  result << rows, rows, 0.5 * (rows.topRows(rows.rows() - 1) + rows.bottomRows(rows.rows() - 1));
  return result;
}

TEST(SolveUgly, DependentRowsChangeNothingButTheSharesOfPressure) {
  std::mt19937 random(30);
  for (int trial = 0; trial < 20; ++trial) {
    const Truss truss = random_truss(9, random);
    MatrixXd rows = MatrixXd::Zero(6, 18);
    for (Index i = 0; i < 6; ++i) bind(rows, i, i, Eigen::Vector2d(random_vector(2, random)).normalized());
    const VectorXd gap = 0.1 * random_vector(6, random);
    const VectorXd load = random_vector(18, random);
    const std::vector<Loaded> plain{supported(truss, load, rows)};
    const std::vector<Loaded> dependent{supported(truss, load, with_dependent_rows(rows))};
    const VectorXd gaps = with_dependent_rows(gap);
    const Solution one = solve(plain, gap), other = solve(dependent, gaps);
    expect_kkt(plain, gap, one);
    expect_kkt(dependent, gaps, other);
    EXPECT_NEAR((one.displacement[0] - other.displacement[0]).norm(), 0,
                10 * truss_rounding * one.displacement[0].norm());
  }
}

TEST(SolveUgly, ContradictingRows) {
  std::mt19937 random(31);
  const Truss truss = random_truss(9, random);
  MatrixXd rows = MatrixXd::Zero(2, 18);
  bind(rows, 0, 4, {0, 1});
  bind(rows, 1, 4, {0, -1});
  const std::vector<Loaded> bodies{supported(truss, random_vector(18, random), rows)};
  EXPECT_EQ(solve(bodies, Eigen::Vector2d(-1, -1)).termination, Termination::contradiction);
  EXPECT_EQ(solve(bodies, Eigen::Vector2d(1, -1.001)).termination, Termination::contradiction);
  const Eigen::Vector2d fitted(1, -1);
  expect_kkt(bodies, fitted, solve(bodies, fitted));
}

// A row that touches nothing is met or not, whatever the bodies do.
TEST(SolveUgly, EmptyRows) {
  std::mt19937 random(32);
  const Truss truss = random_truss(9, random);
  MatrixXd rows = MatrixXd::Zero(2, 18);
  bind(rows, 0, 4, {0, 1});
  const std::vector<Loaded> bodies{supported(truss, random_vector(18, random), rows)};
  const Eigen::Vector2d open(0, 1), closed(0, -1);
  expect_kkt(bodies, open, solve(bodies, open));
  EXPECT_EQ(solve(bodies, closed).termination, Termination::contradiction);
}

// All but three unknowns are in contact, so some that are pinned are, too.
TEST(SolveUgly, ContactEverywhere) {
  std::mt19937 random(33);
  for (int trial = 0; trial < 20; ++trial) {
    const Truss truss = random_truss(6, random);
    const MatrixXd rows = MatrixXd::Identity(12, 12);
    const VectorXd load = truss.stiffness * random_vector(12, random) + random_vector(12, random).cwiseAbs();
    const VectorXd gap = 0.1 * random_vector(12, random);
    const std::vector<Loaded> bodies{floating(truss, load, rows)};
    expect_kkt(bodies, gap, solve(bodies, gap));
  }
}

TEST(SolveUgly, ABodyWithoutUnknowns) {
  std::mt19937 random(34);
  const Truss truss = random_truss(9, random);
  MatrixXd rows = MatrixXd::Zero(1, 18);
  bind(rows, 0, 4, {0, 1});
  const Loaded prescribed{
      {Eigen::SparseMatrix<double>(0, 0), {0, 0, 0}, Eigen::SparseMatrix<double>(1, 0), MatrixXd(0, 0)}, VectorXd(0)};
  const std::vector<Loaded> bodies{prescribed, supported(truss, random_vector(18, random), rows)};
  const VectorXd gap = VectorXd::Constant(1, -1);
  const Solution solution = solve(bodies, gap);
  expect_kkt(bodies, gap, solution);
  EXPECT_EQ(solution.displacement[0].size(), 0);
}

TEST(SolveUgly, StiffnessThatIsNotDefinite) {
  std::mt19937 random(35);
  const Truss truss = random_truss(9, random);
  const VectorXd load = VectorXd::Zero(18);
  const Loaded good = supported(truss, load, MatrixXd(0, 18));
  Loaded forgotten = floating(truss, load, MatrixXd(0, 18));
  forgotten.rigid.resize(18, 0);  // its rigid motions are not told
  Solution solution = solve({good, forgotten}, VectorXd(0));
  EXPECT_EQ(solution.termination, Termination::not_definite);
  EXPECT_EQ(solution.body, 1);
  Loaded half = floating(truss, load, MatrixXd(0, 18));
  half.rigid = half.rigid.leftCols(2).eval();
  solution = solve({half, good}, VectorXd(0));
  EXPECT_EQ(solution.termination, Termination::not_definite);
  EXPECT_EQ(solution.body, 0);
}

// No load, no gap: nothing moves, nothing presses.
TEST(SolveUgly, NothingHappens) {
  std::mt19937 random(36);
  const Truss truss = random_truss(9, random);
  MatrixXd rows = MatrixXd::Zero(4, 18);
  for (Index i = 0; i < 4; ++i) bind(rows, i, i, {0, 1});
  for (const Loaded& body : {supported(truss, VectorXd::Zero(18), rows), floating(truss, VectorXd::Zero(18), rows)}) {
    const Solution solution = solve({body}, VectorXd::Zero(4));
    ASSERT_EQ(solution.termination, Termination::solved);
    EXPECT_EQ(solution.pressure.norm(), 0);
    EXPECT_EQ(solution.displacement[0].norm(), 0);
  }
}

// In other units of force and length, with one body stiffer than the other or softer, the same holds.
TEST(SolveUgly, UnitsAndModuli) {
  std::mt19937 random(37);
  const Truss upper = random_truss(9, random), under = random_truss(9, random);
  MatrixXd first = MatrixXd::Zero(5, 18), second = MatrixXd::Zero(5, 18);
  for (Index i = 0; i < 5; ++i) {
    bind(first, i, i, {0, -1});
    bind(second, i, i, {0, 1});
  }
  const VectorXd carried = first.transpose() * random_vector(5, random).cwiseAbs();
  const VectorXd load = random_vector(18, random), gap = random_vector(5, random).cwiseAbs();
  for (double ratio : {1e-12, 1e-6, 1.0, 1e6, 1e12})
    for (double force : {1e-12, 1.0, 1e12})
      for (double length : {1e-12, 1.0, 1e12}) {
        // Stiffness is force by length; the joints' coordinates are lengths.
        Truss a{upper.joints * length, upper.stiffness * (force / length * ratio)};
        Truss b{under.joints * length, under.stiffness * (force / length)};
        Loaded lying = supported(b, load * force, second);
        lying.stiffness = lower(b.stiffness + MatrixXd::Identity(18, 18) * (force / length));
        const std::vector<Loaded> bodies{floating(a, carried * force, first), lying};
        expect_kkt(bodies, gap * length, solve(bodies, gap * length));
      }
}

// A body far from the origin: its rotation looks like a translation.
TEST(SolveUgly, FarFromTheOrigin) {
  std::mt19937 random(38);
  Truss truss = random_truss(9, random);
  MatrixXd rows = MatrixXd::Zero(6, 18);
  for (Index i = 0; i < 6; ++i) bind(rows, i, i, Eigen::Vector2d(random_vector(2, random)).normalized());
  const VectorXd load = rows.transpose() * random_vector(6, random).cwiseAbs();
  const VectorXd gap = VectorXd::Zero(6);
  const std::vector<Loaded> near{floating(truss, load, rows)};
  truss.joints.array() += 1e4;
  const std::vector<Loaded> far{floating(truss, load, rows)};
  const Solution one = solve(near, gap), other = solve(far, gap);
  expect_kkt(near, gap, one);
  ASSERT_EQ(other.termination, Termination::solved);
  // The coordinates themselves have lost four digits.
  EXPECT_NEAR((one.pressure - other.pressure).norm(), 0, 1e4 * truss_rounding * one.pressure.norm());
}

}  // namespace
}  // namespace bracket::contact
