// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <memory>
#include <vector>

namespace bracket::contact {

/// The Cholesky factor of the unknowns that come last: S = lower · lowerᵀ, S the Schur complement on them.
struct Trailing {
  std::vector<int> unknowns;  ///< in the order of the rows of `lower`
  Eigen::MatrixXd lower;      ///< its strict upper triangle is zero
};

/// A sparse Cholesky factor P K Pᵀ = L Lᵀ.
class Factor {
 public:
  /// Orders the unknowns, `last` behind all others, and lays out the factor.
  /// \param stiffness K, lower triangle, rows sorted   \param nodes, sequence as in System
  /// \param last without repetition
  Factor(const Eigen::SparseMatrix<double>& stiffness, const std::vector<int>& nodes, const std::vector<int>& sequence,
         const std::vector<int>& last);
  Factor(Factor&&) noexcept;
  Factor& operator=(Factor&&) noexcept;
  ~Factor();

  /// How many numbers L and the space to compute it in take.
  double entries() const;
  /// Computes L. \param stiffness the matrix that was laid out, or one with the same pattern
  /// \param pinned unknowns that are cut off from the others (a diagonal entry is left to them)
  /// \return whether it is definite: no pivot is lost in rounding
  bool factorise(const Eigen::SparseMatrix<double>& stiffness, const std::vector<int>& pinned = {});
  /// K⁻¹ b = Pᵀ L⁻ᵀ (L⁻¹ P b) by halves, each of which reads all of L; from several threads at once, too.
  /// \pre factorise() returned true; so below
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return backward(forward(b)); }
  Eigen::VectorXd forward(const Eigen::VectorXd& b) const;   ///< y = L⁻¹ P b
  Eigen::VectorXd backward(const Eigen::VectorXd& y) const;  ///< Pᵀ L⁻ᵀ y
  /// y + L⁻¹ P b of a b that is zero but for the last unknowns. It changes the last of y alone, and reads but their
  /// columns of L; so does
  Eigen::VectorXd plus_last(Eigen::VectorXd y, const Eigen::VectorXd& b) const;
  /// what backward(y) has at the last unknowns, and zero at the others.
  Eigen::VectorXd backward_to_last(const Eigen::VectorXd& y) const;
  Trailing trailing() const;

 private:
  struct Handle;
  std::unique_ptr<Handle> handle_;
};

}  // namespace bracket::contact
