// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/contact.h"

#include <optional>

namespace bracket::contact {

/// The problem in the multipliers:  min ½ pᵀF p − pᵀw  over  p ≥ 0, Gᵀp = e.
/// With α the multipliers of Gᵀp = e, the slacks g − r are F p − w − G α.
struct Interface {
  Eigen::MatrixXd compliance;  ///< F, m × m, symmetric, positive semi-definite; definite where Gᵀp = 0 and no rows depend
  Eigen::VectorXd overlap;     ///< w, m: the approach that the loads would cause without contact, less the gap
  Eigen::VectorXd size;        ///< m: what w is a difference of, absolute; so its rounding is known
  Eigen::MatrixXd motion;      ///< G, m × k, full column rank
  Eigen::VectorXd load;        ///< e, k
};

struct Pressure {
  Outcome outcome = Outcome::solved;  ///< or contradiction; then nothing else is set
  Eigen::VectorXd pressure;           ///< p ≥ 0, m, zero off the active rows
  Eigen::VectorXd motion;             ///< α, k
  std::vector<Eigen::Index> active;   ///< independent rows that are closed
  int iterations = 0;
};

/// Makes the problem independent of units and moduli: F has a diagonal of ones, G orthonormal columns.
struct Scaled {
  Interface problem;
  Eigen::VectorXd row;     ///< p = row ∘ (p of `problem`)
  Eigen::MatrixXd motion;  ///< upper triangular T: (α of `problem`) = T α;  e = Tᵀ (e of `problem`)
};
Scaled scaled(const Interface& problem);

/// Minimum over p with p = 0 off `active`, Gᵀp = e, of whatever sign: closed rows  (F p − G α)_A = w_A.
/// \return p on `active` and α; nothing where rows of `active` depend on each other or do not resist all motions
struct Equality {
  Eigen::VectorXd pressure, motion;
};
std::optional<Equality> solve_closed(const Interface& problem, const std::vector<Eigen::Index>& active,
                                     const Eigen::VectorXd& overlap, const Eigen::VectorXd& load);

/// Changes the active set in blocks until it repeats: few steps, but it may fail.
/// \param problem scaled   \param guess rows to start from
std::optional<Pressure> block_active_set(const Interface& problem, std::vector<char> guess);

/// Descends from a feasible p, one row at a time; always ends.
/// \param problem scaled   \param start p ≥ 0, Gᵀp = e, with linearly independent rows of G where p > 0
Pressure primal_active_set(const Interface& problem, const Eigen::VectorXd& start);

/// How far below zero a slack has to be to count as violated, for each row: what rounding may do to it.
Eigen::VectorXd slack_rounding(const Interface& problem, const Eigen::VectorXd& pressure,
                               const Eigen::VectorXd& motion);

}  // namespace bracket::contact
