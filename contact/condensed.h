// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Sparse>
#include <vector>

#include "contact/factor.h"

/// A body as its contact sees it.
namespace bracket::contact {

/// A factorised body. K⁺ is the inverse of K without the pinned unknowns, zero on those.
struct Condensed {
  std::vector<int> pinned;
  Factor factor;

  Eigen::VectorXd apply(Eigen::VectorXd force) const { return factor.backward(forward(std::move(force))); }  ///< K⁺ f
  /// Its first half, y: factor.backward(y) is K⁺ f, factor.backward_to_last(y) what contact sees of it.
  Eigen::VectorXd forward(Eigen::VectorXd force) const;
  /// K⁺ (f + h) from that of f, by one half. \param further h, zero where no contact row touches
  Eigen::VectorXd apply_with(Eigen::VectorXd half, Eigen::VectorXd further) const;
};

/// The unknowns that contact rows touch, in increasing order.
std::vector<int> contact_unknowns(const Eigen::SparseMatrix<double>& rows);

/// Adds B K⁺ Bᵀ to F: with S = L Lᵀ the Schur complement on the contact unknowns, B S⁻¹ Bᵀ = Xᵀ X, X = L⁻¹ Bᵀ.
void add_compliance(const Eigen::SparseMatrix<double>& rows, const Condensed& body, Eigen::MatrixXd& compliance);

}  // namespace bracket::contact
