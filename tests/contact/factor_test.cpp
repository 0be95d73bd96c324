// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/factor.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/contact/truss.h"

namespace bracket::contact {
namespace {

using namespace test;
using Sparse = Eigen::SparseMatrix<double>;

/// A random symmetric matrix over nodes of two unknowns; diagonally dominant, so its condition is below 4.
Sparse random_matrix(int n_nodes, int n_edges, std::mt19937& random) {
  MatrixXd dense = MatrixXd::Identity(2 * n_nodes, 2 * n_nodes);
  const double size = 0.3 / n_edges * n_nodes;
  for (int e = 0; e < n_edges; ++e) {
    const Index a = static_cast<Index>(random() % n_nodes), b = static_cast<Index>(random() % n_nodes);
    if (a == b) continue;
    const VectorXd entries = random_vector(4, random).cwiseMax(-1).cwiseMin(1) * std::min(size, 0.02);
    dense.block<2, 2>(2 * a, 2 * b) += Eigen::Map<const Eigen::Matrix2d>(entries.data());
    dense.block<2, 2>(2 * b, 2 * a) = dense.block<2, 2>(2 * a, 2 * b).transpose().eval();
  }
  return lower(dense);
}

// Few edges leave the graph in pieces: then CHOLMOD mixes the last unknowns of one piece with others of the next.
TEST(Factor, TrailingBlockIsTheFactorOfTheSchurComplement) {
  std::mt19937 random(5);
  for (int n_edges : {20, 40, 400}) {
    const int n_nodes = 40;
    const Sparse matrix = random_matrix(n_nodes, n_edges, random);
    const MatrixXd dense = symmetric(matrix);
    std::vector<int> last;
    for (int i = 0; i < 2 * n_nodes; ++i)
      if (random() % 6 == 0) last.push_back(i);
    std::vector<int> sequence(n_nodes);
    std::iota(sequence.begin(), sequence.end(), 0);
    std::shuffle(sequence.begin(), sequence.end(), random);
    Factor factor(matrix, pairs(2 * n_nodes), sequence, last);
    ASSERT_TRUE(factor.factorise(matrix));
    const Trailing trailing = factor.trailing();
    EXPECT_TRUE(std::is_permutation(last.begin(), last.end(), trailing.unknowns.begin(), trailing.unknowns.end()));
    const MatrixXd schur_inverse = dense.inverse()(trailing.unknowns, trailing.unknowns);
    const MatrixXd product = schur_inverse * trailing.lower * trailing.lower.transpose();
    const auto n = static_cast<Index>(last.size());
    EXPECT_LE((product - MatrixXd::Identity(n, n)).norm(), 80 * 16 * std::numeric_limits<double>::epsilon());

    const VectorXd right = random_vector(2 * n_nodes, random);
    EXPECT_LE((dense * factor.solve(right) - right).norm(),
              80 * 16 * std::numeric_limits<double>::epsilon() * right.norm());

    // What only touches the last unknowns, by their columns alone.
    VectorXd at_last = VectorXd::Zero(2 * n_nodes);
    for (const int i : last) at_last[i] = right[i];
    const double rounding = 80 * 16 * std::numeric_limits<double>::epsilon() * dense.inverse().norm() * right.norm();
    const VectorXd half = factor.plus_last(factor.forward(right), at_last), whole = factor.solve(right + at_last);
    EXPECT_LE((factor.backward(half) - whole).norm(), rounding);
    const VectorXd seen = factor.backward_to_last(half);
    EXPECT_LE((seen(last) - whole(last)).norm(), rounding);
    EXPECT_EQ(static_cast<std::size_t>((seen.array() != 0).count()), last.size());
  }
}

TEST(Factor, RefusesWhatIsNotDefinite) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> spring(0.5, 1.5);
  const auto definite = [](const MatrixXd& matrix) {
    Factor factor(lower(matrix), pairs(matrix.rows()), {}, {});
    return factor.factorise(lower(matrix));
  };
  // 20 points on a line, springs between them: the last pivot is zero up to about 20 roundings, of either sign.
  for (int trial = 0; trial < 60; ++trial) {
    const double unit = std::pow(1e12, trial % 3 - 1);
    MatrixXd stiffness = MatrixXd::Zero(20, 20);
    for (Index i = 0; i < 20; ++i)
      for (Index j = 0; j < i; ++j) {
        const double k = unit * spring(random);
        stiffness(i, i) += k;
        stiffness(j, j) += k;
        stiffness(i, j) = stiffness(j, i) = -k;
      }
    EXPECT_FALSE(definite(stiffness));
    MatrixXd held = stiffness;
    held(trial % 20, trial % 20) += 1e-9 * unit;  // weakly
    EXPECT_TRUE(definite(held));
    held(trial % 20, trial % 20) -= 2e-9 * unit;
    EXPECT_FALSE(definite(held));
  }
  EXPECT_FALSE(definite(-MatrixXd::Identity(4, 4)));
  EXPECT_FALSE(definite(MatrixXd::Zero(4, 4)));
  MatrixXd poisoned = MatrixXd::Identity(4, 4);
  poisoned(2, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(definite(poisoned));
}

TEST(Factor, OfNothing) {
  Factor factor(Sparse(0, 0), {0}, {}, {});
  EXPECT_TRUE(factor.factorise(Sparse(0, 0)));
  EXPECT_EQ(factor.solve(VectorXd(0)).size(), 0);
  EXPECT_EQ(factor.trailing().lower.size(), 0);
}

}  // namespace
}  // namespace bracket::contact
