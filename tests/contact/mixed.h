// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <optional>

#include "contact/active_set.h"
#include "tests/contact/truss.h"

/// Random interface problems with limits of every kind, and how to tell their minima.
namespace bracket::contact::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
/// As in active_set_test.cpp: equality problems are solved through pivots above 1e-4 of the diagonal.
inline constexpr double pivots = 1e4 * 10 * eps;

/// Limits of every kind, those of friction around `size`.
inline Limits mixed_limits(Index m, double size, std::mt19937& random) {
  Limits limits{VectorXd(m), VectorXd(m)};
  const auto set = [&](Index i, double lower, double upper) {
    limits.lower[i] = lower;
    limits.upper[i] = upper;
  };
  for (Index i = 0; i < m; ++i) {
    const double b = size * std::abs(random_vector(1, random)[0]);
    switch (random() % 8) {
      case 0: set(i, -infinity, infinity); break;
      case 1:
      case 2: set(i, -b, b); break;
      case 3: set(i, 0, 0); break;
      case 4: set(i, -infinity, -b); break;
      case 5: set(i, -0.5 * b, 2 * b); break;
      case 6: set(i, b, random() % 2 ? b : 2 * b); break;
      default: set(i, 0, infinity);
    }
  }
  return limits;
}

/// Some p within limits, of the size of one where they leave it open.
inline VectorXd some_within(const Limits& limits, std::mt19937& random) {
  return random_vector(limits.lower.size(), random).cwiseMax(limits.lower).cwiseMin(limits.upper);
}

inline double work(const Interface& problem, const VectorXd& p) {
  return 0.5 * p.dot(problem.compliance * p) - p.dot(problem.overlap);
}

/// The least energy over the minima of all states (each row at a limit or free), where p is within the limits: each is
/// feasible, the solution is one of them. \return nothing if no state has one
inline std::optional<double> least_of_all_states(const Interface& problem) {
  const Index m = problem.overlap.size(), k = problem.load.size();
  std::optional<double> least;
  int states = 1;
  for (Index i = 0; i < m; ++i) states *= 3;
  for (int state = 0; state < states; ++state) {
    std::vector<Index> active;
    VectorXd p = VectorXd::Zero(m);
    int rest = state;
    for (Index i = 0; i < m; ++i, rest /= 3)
      if (rest % 3 == 0)
        active.push_back(i);
      else
        p[i] = rest % 3 == 1 ? problem.limits.lower[i] : problem.limits.upper[i];
    if (!p.allFinite()) continue;
    const auto n = static_cast<Index>(active.size());
    if (n + k > 0) {
      MatrixXd system = MatrixXd::Zero(n + k, n + k);
      VectorXd right(n + k);
      system.topLeftCorner(n, n) = problem.compliance(active, active);
      system.topRightCorner(n, k) = -problem.motion(active, Eigen::all);
      system.bottomLeftCorner(k, n) = problem.motion(active, Eigen::all).transpose();
      right << VectorXd(problem.overlap - problem.compliance * p)(active),
          problem.load - problem.motion.transpose() * p;
      const VectorXd unknowns = system.completeOrthogonalDecomposition().solve(right);
      if ((system * unknowns - right).norm() > 1e-9 * (right.norm() + unknowns.norm())) continue;
      p(active) = unknowns.head(n);
    }
    const double rounding = 1e-10 * (1 + p.norm());
    if ((p.array() < problem.limits.lower.array() - rounding).any() ||
        (p.array() > problem.limits.upper.array() + rounding).any())
      continue;
    if (!least || work(problem, p) < *least) least = work(problem, p);
  }
  return least;
}

/// Sufficient for the minimum, since it is convex.
inline void expect_minimum(const Interface& problem, const Pressure& found) {
  ASSERT_EQ(found.termination, Termination::solved);
  const VectorXd &p = found.pressure, &lower = problem.limits.lower, &upper = problem.limits.upper;
  ASSERT_EQ(p.size(), problem.overlap.size());
  const VectorXd terms = problem.compliance.cwiseAbs() * p.cwiseAbs() + problem.size + problem.overlap.cwiseAbs() +
                         problem.motion.cwiseAbs() * found.motion.cwiseAbs();
  const VectorXd y = problem.compliance * p - problem.overlap - problem.motion * found.motion;
  const double rounding = pivots * terms.maxCoeff();
  EXPECT_LE((problem.motion.transpose() * p - problem.load).norm(), rounding + pivots * p.norm());
  std::vector<char> active(static_cast<std::size_t>(p.size()), 0);
  for (Index i : found.active) active[static_cast<std::size_t>(i)] = 1;
  for (Index i = 0; i < p.size(); ++i) {
    EXPECT_GE(p[i], lower[i]);
    EXPECT_LE(p[i], upper[i]);
    if (p[i] > lower[i]) {
      EXPECT_LE(y[i], rounding) << i;
    }
    if (p[i] < upper[i]) {
      EXPECT_GE(y[i], -rounding) << i;
    }
    if (active[static_cast<std::size_t>(i)]) {
      EXPECT_LE(std::abs(y[i]), rounding) << i;
    }
    if (!active[static_cast<std::size_t>(i)]) {
      EXPECT_TRUE(p[i] == lower[i] || p[i] == upper[i] || p[i] == 0) << i;
    }
  }
}

/// F = X Xᵀ, X of m × n, its columns in parts whose compliances are 1 and `jump`; loads that p within limits balances.
inline Interface mixed_interface(Index m, Index n, Index k, double jump, std::mt19937& random) {
  const auto matrix = [&](Index rows, Index columns) {
    return MatrixXd(MatrixXd::NullaryExpr(rows, columns, [&] { return random_vector(1, random)[0]; }));
  };
  MatrixXd rows = matrix(m, n);
  for (Index i = 0; i < m / 2; ++i) rows.row(i) *= std::sqrt(jump);
  const MatrixXd motion = matrix(m, k);
  const VectorXd overlap = rows * random_vector(n, random);
  const Limits limits = mixed_limits(m, 1, random);
  return {rows * rows.transpose(),
          overlap,
          overlap.cwiseAbs(),
          motion,
          motion.transpose() * some_within(limits, random),
          limits};
}

}  // namespace bracket::contact::test
