// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/limits.h"

#include <gtest/gtest.h>

#include "tests/contact/mixed.h"

namespace bracket::contact {
namespace {

using namespace test;

/// \param problem its load becomes what p balances, as in Bodies::solve(); without what is taken for rounding
Pressure step_by_step(Interface& problem) {
  const Balance start = balance(problem.motion, problem.load, 1e-10 * (problem.load.norm() + 1), problem.limits);
  EXPECT_TRUE(start.possible);
  problem.load = problem.motion.transpose() * start.pressure;
  return primal_active_set(problem, start.pressure);
}

TEST(Limits, BothWaysAgreeWithAllStates) {
  std::mt19937 random(60);
  int blocks = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Index m = 1 + static_cast<Index>(random() % 6), k = static_cast<Index>(random() % 3) * (m > 3);
    Interface problem = scaled(mixed_interface(m, m + 4, k, 1, random)).problem;
    const Pressure slow = step_by_step(problem);
    const auto least = least_of_all_states(problem);
    ASSERT_TRUE(least);
    expect_minimum(problem, slow);
    EXPECT_NEAR(work(problem, slow.pressure), *least, 1e-9 * (1 + std::abs(*least)));
    std::vector<char> guess(static_cast<std::size_t>(m));
    for (char& g : guess) g = random() % 2;
    for (const auto& from : {guess, std::vector<char>(static_cast<std::size_t>(m), 1)})
      if (const auto fast = block_active_set(problem, from)) {
        ++blocks;
        expect_minimum(problem, *fast);
        EXPECT_NEAR((fast->pressure - slow.pressure).norm(), 0, 1e-9 * (1 + slow.pressure.norm()));
      }
  }
  EXPECT_GE(blocks, 300);
}

TEST(Limits, ManyRowsWithJumpsOfCompliance) {
  std::mt19937 random(61);
  for (double jump : {1e-6, 1.0, 1e6})
    for (int trial = 0; trial < 8; ++trial) {
      Interface problem = scaled(mixed_interface(60, 200, 3, jump, random)).problem;
      const Pressure slow = step_by_step(problem);
      expect_minimum(problem, slow);
      const auto fast = block_active_set(problem, std::vector<char>(60, 1));
      if (!fast) continue;
      expect_minimum(problem, *fast);
      EXPECT_NEAR((fast->pressure - slow.pressure).norm(), 0, 1e-9 * fast->pressure.norm());
    }
}

// Fewer unknowns than rows, of integers: rows that are the same, opposite, or means of others, exact ties, p not
// unique. What no limit lets open is met by some displacement: then there is a solution, and else there is none.
TEST(Limits, RowsThatDependOnEachOther) {
  std::mt19937 random(62);
  int contradictions = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Index m = 2 + static_cast<Index>(random() % 5), n = 1 + static_cast<Index>(random() % 2);
    const Index k = static_cast<Index>(random() % 2);
    const auto integer = [&] { return static_cast<double>(static_cast<int>(random() % 5) - 2); };
    const MatrixXd rows = MatrixXd::NullaryExpr(m, n, integer);
    MatrixXd motion = MatrixXd::NullaryExpr(m, k, integer);
    if (k > 0 && motion.norm() == 0) motion(0, 0) = 1;
    Limits limits{VectorXd(m), VectorXd(m)};
    VectorXd left(m);
    for (Index i = 0; i < m; ++i) {
      const double kind[][3] = {{0, infinity, 1}, {-infinity, infinity, 0}, {-1, 1, 2}, {-2, 3, -1}, {0, 0, 3},
                                {1, 1, -2}};
      const auto& [lower, upper, slack] = kind[random() % 6];
      limits.lower[i] = lower;
      limits.upper[i] = upper;
      left[i] = slack * static_cast<double>(random() % 2);
    }
    const VectorXd possible = VectorXd::NullaryExpr(n, integer), moved = VectorXd::NullaryExpr(k, integer);
    const VectorXd gap = rows * possible + motion * moved + left;
    const VectorXd overlap = 2 * rows * VectorXd::NullaryExpr(n, integer) - gap;
    const VectorXd within = VectorXd(VectorXd::NullaryExpr(m, integer)).cwiseMax(limits.lower).cwiseMin(limits.upper);
    Interface problem =
        scaled({rows * rows.transpose(), overlap, overlap.cwiseAbs(), motion, motion.transpose() * within, limits})
            .problem;
    const auto least = least_of_all_states(problem);
    ASSERT_TRUE(least);
    const Pressure found = step_by_step(problem);
    expect_minimum(problem, found);
    EXPECT_NEAR(work(problem, found.pressure), *least, 1e-10 * (1 + std::abs(*least)));

    // A row more, the same as one without limits, but with another gap.
    const auto bilateral = [&](Index i) { return std::isinf(limits.lower[i]) && std::isinf(limits.upper[i]); };
    Index twice = 0;
    while (twice < m && !(bilateral(twice) && rows.row(twice).norm() > 0)) ++twice;
    if (twice == m) continue;
    std::vector<Index> all(static_cast<std::size_t>(m) + 1, twice);
    for (Index i = 0; i < m; ++i) all[static_cast<std::size_t>(i)] = i;
    const MatrixXd more = rows(all, Eigen::all);
    VectorXd other = overlap(all);
    other[m] += 0.5;
    problem = scaled({more * more.transpose(),
                      other,
                      other.cwiseAbs(),
                      motion(all, Eigen::all),
                      motion.transpose() * within,
                      {limits.lower(all), limits.upper(all)}})
                  .problem;
    EXPECT_EQ(step_by_step(problem).termination, Termination::contradiction);
    EXPECT_FALSE(block_active_set(problem, std::vector<char>(all.size(), 1)));
    ++contradictions;
  }
  EXPECT_GE(contradictions, 100);
}

// The load is all that p at its limits can balance: nothing is left to choose, or but for degenerate rows.
TEST(Limits, LoadsAtTheLimit) {
  std::mt19937 random(63);
  for (int trial = 0; trial < 300; ++trial) {
    const Index m = 6 + static_cast<Index>(random() % 8), k = 1 + static_cast<Index>(random() % 3);
    Interface problem = mixed_interface(m, m + 8, k, 1, random);
    for (Index i = 0; i < m; ++i)
      if (random() % 4) {
        problem.limits.upper[i] = std::abs(random_vector(1, random)[0]);
        problem.limits.lower[i] = -1;
      }
    VectorXd motion = random_vector(k, random), p = VectorXd::Zero(m);
    for (Index i = 0; i < m; ++i) {
      const double limit = problem.motion.row(i).dot(motion) > 0 ? problem.limits.upper[i] : problem.limits.lower[i];
      p[i] = std::isfinite(limit) ? limit : at_rest(problem.limits)[i];
      if (std::isfinite(limit)) continue;
      problem.motion.row(i) -= problem.motion.row(i).dot(motion) * motion.transpose() / motion.squaredNorm();
      if (k == 1) problem.motion.row(i).setZero();  // no rounding: it would be a row that resists
    }
    problem.load = problem.motion.transpose() * p;
    Scaled to = scaled(problem);
    const Pressure found = step_by_step(to.problem);
    expect_minimum(to.problem, found);
  }
}

TEST(Limits, WideOnesAreNoneNarrowOnesTakeTheRowOut) {
  std::mt19937 random(64);
  for (int trial = 0; trial < 40; ++trial) {
    const Index m = 12, k = 2;
    Interface problem = mixed_interface(m, m + 6, k, 1, random);
    problem.limits = complete({}, m);
    problem.load = problem.motion.topRows(m - 4).transpose() * random_vector(m - 4, random).cwiseAbs();
    const std::vector<char> all(static_cast<std::size_t>(m), 1);
    const auto solved = [&](double b) {
      for (Index i = m - 4; i < m; ++i) {
        problem.limits.upper[i] = b;
        problem.limits.lower[i] = -b;
      }
      Scaled to = scaled(problem);
      return VectorXd(to.row.cwiseProduct(step_by_step(to.problem).pressure));
    };
    const VectorXd without = solved(infinity);
    EXPECT_NEAR((solved(1e6 * without.norm()) - without).norm(), 0, 1e-9 * without.norm());
    const VectorXd narrow = solved(0);
    EXPECT_EQ(narrow.tail(4).norm(), 0);
    std::vector<Index> kept(static_cast<std::size_t>(m) - 4);
    for (Index i = 0; i < m - 4; ++i) kept[static_cast<std::size_t>(i)] = i;
    Scaled fewer = scaled({problem.compliance(kept, kept), problem.overlap(kept), problem.size(kept),
                           problem.motion(kept, Eigen::all), problem.load});
    const VectorXd p = fewer.row.cwiseProduct(step_by_step(fewer.problem).pressure);
    EXPECT_NEAR((narrow.head(m - 4) - p).norm(), 0, 1e-9 * p.norm());
  }
}

// Friction on the boundary of a half-plane, in part at its bound: the blocks settle as quickly as without.
TEST(Limits, BlocksSettleInFewStepsOnASmoothProblem) {
  const Index m = 200;
  MatrixXd laplacian = MatrixXd::Zero(m, m);  // along the boundary; that of the half-plane leaves √(λ + λ²/4) on it
  for (Index i = 0; i < m; ++i) {
    laplacian(i, i) = 2;
    if (i > 0) laplacian(i, i - 1) = laplacian(i - 1, i) = -1;
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> waves_of(laplacian);
  const Eigen::ArrayXd values = waves_of.eigenvalues();
  const MatrixXd compliance = waves_of.eigenvectors() *
                              (values + 0.25 * values.square()).rsqrt().matrix().asDiagonal() *
                              waves_of.eigenvectors().transpose();
  for (double waves : {1.0, 3.0, 10.0})
    for (double bound : {0.0, 0.1, 0.5, 0.9, 2.0}) {
      const VectorXd place = VectorXd::LinSpaced(m, 0, waves * 2 * 3.14159265358979324);
      const VectorXd overlap = compliance * place.array().sin().matrix();
      Limits limits{VectorXd::Constant(m, -bound), VectorXd::Constant(m, bound)};
      limits.lower.tail(m / 4).setZero();  // and a part that lifts off
      limits.upper.tail(m / 4).setConstant(infinity);
      const Interface problem =
          scaled({compliance, overlap, overlap.cwiseAbs(), MatrixXd(m, 0), VectorXd(0), limits}).problem;
      for (char sticks : {0, 1}) {
        const auto found = block_active_set(problem, std::vector<char>(static_cast<std::size_t>(m), sticks));
        ASSERT_TRUE(found) << waves << ' ' << bound;
        EXPECT_LE(found->iterations, 10) << waves << ' ' << bound;
        expect_minimum(problem, *found);
      }
    }
}

// Two rows that are the same, each between its limits: one of them holds nothing.
TEST(Limits, DependentRowsAtTheStartAreRefused) {
  const MatrixXd ones = MatrixXd::Ones(2, 2);
  const VectorXd none = VectorXd::Zero(2);
  const Limits limits{VectorXd::Constant(2, -1), VectorXd::Constant(2, 1)};
  const Interface problem = scaled({ones, none, none, VectorXd::Ones(2), VectorXd::Ones(1), limits}).problem;
  EXPECT_THROW(primal_active_set(problem, VectorXd::Constant(2, 0.5)), HeldByRounding);
  EXPECT_EQ(primal_active_set(problem, Eigen::Vector2d(1, 0.41421356237309505)).termination, Termination::solved);
}

TEST(Limits, TheirFactorsKeepThemExactly) {
  std::mt19937 random(65);
  for (int trial = 0; trial < 100; ++trial) {
    const Index m = 10;
    const Limits limits = mixed_limits(m, 1, random);
    const VectorXd factor = random_vector(m, random).cwiseAbs();
    const Limits to = scaled(limits, factor);
    VectorXd p = some_within(limits, random);
    for (Index i = 0; i < m; ++i)
      for (double limit : {limits.lower[i], limits.upper[i]})
        if (std::isfinite(limit) && random() % 2) p[i] = limit;
    const VectorXd back = scaled(scaled(p, factor, limits, to), factor.cwiseInverse(), to, limits);
    for (Index i = 0; i < m; ++i) {
      if (is_between(limits, i, p[i]))
        EXPECT_NEAR(back[i], p[i], 2 * eps * std::abs(p[i]));
      else
        EXPECT_EQ(back[i], p[i]);
      EXPECT_TRUE(back[i] >= limits.lower[i] && back[i] <= limits.upper[i]);
    }
  }
}

}  // namespace
}  // namespace bracket::contact
