// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "contact/contact.h"

namespace bracket::contact {
namespace {

// Random cells over nodes with 0 … 3 unknowns; some unknowns of a cell are left out. Integers, so that sums are exact.
TEST(Assembly, EqualsTheDenseSum) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<int> nodes{0};
    for (int v = 0; v < 12; ++v) nodes.push_back(nodes.back() + static_cast<int>(random() % 4));
    std::vector<int> cells;
    for (int c = 0; c < 8; ++c)
      for (int k = 0; k < 3; ++k) cells.push_back(static_cast<int>(random() % 4) + 4 * k);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(nodes.back(), nodes.back());
    Assembly assembly(nodes, cells, 3);
    for (std::size_t c = 0; c < cells.size(); c += 3) {
      std::vector<int> unknowns;
      for (std::size_t k = 3; k-- > 0;)  // not in increasing order
        for (int i = nodes[cells[c + k]]; i < nodes[cells[c + k] + 1]; ++i) unknowns.push_back(random() % 5 ? i : -1);
      const auto n = static_cast<Eigen::Index>(unknowns.size());
      Eigen::MatrixXd cell = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return static_cast<double>(random() % 100); });
      cell = (cell + cell.transpose()).eval();
      assembly.add(unknowns, cell);
      for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
          if (unknowns[i] >= 0 && unknowns[j] >= 0) dense(unknowns[i], unknowns[j]) += cell(i, j);
    }
    const Eigen::SparseMatrix<double> sum = assembly.take();
    EXPECT_TRUE(sum.isCompressed());
    EXPECT_EQ(Eigen::MatrixXd(sum), Eigen::MatrixXd(dense.triangularView<Eigen::Lower>()));
    for (int j = 0; j < sum.outerSize(); ++j)
      for (int k = sum.outerIndexPtr()[j] + 1; k < sum.outerIndexPtr()[j + 1]; ++k)
        EXPECT_LT(sum.innerIndexPtr()[k - 1], sum.innerIndexPtr()[k]);
    EXPECT_EQ(assembly.take().rows(), 0);
  }
}

TEST(Assembly, OfNothing) {
  Assembly assembly({0}, {}, 3);
  EXPECT_EQ(assembly.take().rows(), 0);
}

TEST(Assembly, KeepsANodeWithoutCell) {
  Assembly assembly({0, 2, 4}, std::vector<int>{1, 1, 1}, 3);
  const Eigen::SparseMatrix<double> sum = assembly.take();
  EXPECT_EQ(sum.rows(), 4);
  EXPECT_EQ(Eigen::MatrixXd(sum).norm(), 0);
}

}  // namespace
}  // namespace bracket::contact
