// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

namespace bracket::contact {

/// A Cholesky factor L (its diagonal of either sign) of a matrix to which rows and columns are added at the end and
/// taken out anywhere.
class GrowingCholesky {
 public:
  /// \param most the largest order there will be
  explicit GrowingCholesky(Eigen::Index most) : storage_(Eigen::MatrixXd::Zero(most, most)) {}

  Eigen::Index size() const { return size_; }
  /// L⁻¹ b
  Eigen::MatrixXd forward(const Eigen::MatrixXd& b) const;
  /// L⁻ᵀ b
  Eigen::MatrixXd backward(const Eigen::MatrixXd& b) const;

  /// Adds a last row. \param row the new row left of the diagonal   \param diagonal its diagonal entry
  /// \return false, and nothing is added, where the matrix would be singular: pivot ≤ 1e-12 · diagonal
  bool append(const Eigen::VectorXd& row, double diagonal);
  /// Takes out a row and its column.
  void remove(Eigen::Index place);

 private:
  Eigen::MatrixXd storage_;
  Eigen::Index size_ = 0;
};

}  // namespace bracket::contact
