// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/growing_cholesky.h"

#include <cmath>

namespace bracket::contact {

Eigen::MatrixXd GrowingCholesky::forward(const Eigen::MatrixXd& b) const {
  if (b.size() == 0) return b;
  return storage_.topLeftCorner(size_, size_).triangularView<Eigen::Lower>().solve(b);
}

Eigen::MatrixXd GrowingCholesky::backward(const Eigen::MatrixXd& b) const {
  if (b.size() == 0) return b;
  return storage_.topLeftCorner(size_, size_).transpose().triangularView<Eigen::Upper>().solve(b);
}

bool GrowingCholesky::append(const Eigen::VectorXd& row, double diagonal) {
  const Eigen::VectorXd left = forward(row);
  const double pivot = diagonal - left.squaredNorm();
  if (!(pivot > 1e-12 * diagonal)) return false;
  storage_.row(size_).head(size_) = left.transpose();
  storage_(size_, size_) = std::sqrt(pivot);
  ++size_;
  return true;
}

void GrowingCholesky::remove(Eigen::Index place) {
  // Without its row, L has one entry above the diagonal in each row from `place` on; rotations of columns remove them.
  --size_;
  for (Eigen::Index i = place; i < size_; ++i) storage_.row(i).head(i + 2) = storage_.row(i + 1).head(i + 2);
  for (Eigen::Index j = place; j < size_; ++j) {
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(storage_(j, j), storage_(j, j + 1));
    storage_.middleRows(j, size_ - j).applyOnTheRight(j, j + 1, rotation);
  }
}

}  // namespace bracket::contact
