// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/condensed.h"

namespace bracket::contact {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

VectorXd Condensed::forward(VectorXd force) const {
  force(pinned).setZero();
  return factor.forward(force);
}

VectorXd Condensed::apply_with(VectorXd half, VectorXd further) const {
  further(pinned).setZero();
  return factor.backward(factor.plus_last(std::move(half), further));
}

std::vector<int> contact_unknowns(const Sparse& rows) {
  std::vector<int> result;
  for (int j = 0; j < rows.outerSize(); ++j)
    if (Sparse::InnerIterator(rows, j)) result.push_back(j);
  return result;
}

void add_compliance(const Sparse& rows, const Condensed& body, MatrixXd& compliance) {
  constexpr Index few = 16;  // entries of L, of which no more than one in so many is not zero
  const Trailing trailing = body.factor.trailing();
  const Sparse by_row = rows.transpose();  // column i: row i of B
  std::vector<int> place(rows.cols(), -1);
  for (std::size_t k = 0; k < trailing.unknowns.size(); ++k) place[trailing.unknowns[k]] = static_cast<int>(k);
  for (int i : body.pinned) place[i] = -1;

  std::vector<Index> touching;
  for (int i = 0; i < by_row.outerSize(); ++i)
    if (Sparse::InnerIterator(by_row, i)) touching.push_back(i);
  MatrixXd right = MatrixXd::Zero(static_cast<Index>(trailing.unknowns.size()), static_cast<Index>(touching.size()));
  for (std::size_t i = 0; i < touching.size(); ++i)
    for (Sparse::InnerIterator entry(by_row, touching[i]); entry; ++entry)
      if (place[entry.row()] >= 0) right(place[entry.row()], static_cast<Index>(i)) = entry.value();
  const Index n = trailing.lower.rows();
  if (few * (trailing.lower.array() != 0).count() > n * n) {
    trailing.lower.triangularView<Eigen::Lower>().solveInPlace(right);
    compliance(touching, touching) += right.transpose() * right;
    return;
  }
  // Springs, each with few others: K⁻¹ Bᵀ by a sparse L, then B times that.
  const Sparse lower = trailing.lower.sparseView();
  lower.triangularView<Eigen::Lower>().solveInPlace(right);
  lower.transpose().triangularView<Eigen::Upper>().solveInPlace(right);
  MatrixXd own = MatrixXd::Zero(right.cols(), right.cols());
  for (std::size_t i = 0; i < touching.size(); ++i)
    for (Sparse::InnerIterator entry(by_row, touching[i]); entry; ++entry)
      if (place[entry.row()] >= 0) own.col(static_cast<Index>(i)) += entry.value() * right.row(place[entry.row()]);
  compliance(touching, touching) += 0.5 * (own + own.transpose());
}

}  // namespace bracket::contact
