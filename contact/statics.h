// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/contact.h"

namespace bracket::contact {

/// The rigid motions of one body in a basis that does not depend on its units or its distance from the origin:
/// R = basis · change, basisᵀ basis = n: the entries are of the order of one.
struct Motions {
  Eigen::MatrixXd basis;   ///< n × k
  Eigen::MatrixXd change;  ///< k × k
};
Motions motions(const Eigen::MatrixXd& rigid);

/// A = Q R with orthonormal Q and upper triangular R, by Gram–Schmidt done twice: where columns have no row in
/// common, the zeros of A are zeros of Q. \pre linearly independent columns
struct Orthonormal {
  Eigen::MatrixXd q, r;
};
Orthonormal orthonormal(Eigen::MatrixXd columns);

/// As many unknowns as there are rigid motions, such that no motion leaves them all at rest; well apart, and not
/// contact unknowns where others are about as good.
/// \param basis as in Motions   \param contact the unknowns that contact rows touch
std::vector<int> pins(const Eigen::MatrixXd& basis, const std::vector<int>& contact);

/// The bodies' equilibrium as wholes: Gᵀp = e, in a basis of those motions that contact resists at all.
struct Statics {
  /// Motions that contact resists and that, with the free ones, are all: which of the bodies' bases, stacked (k of
  /// k_all).
  std::vector<Eigen::Index> resisted;
  Eigen::MatrixXd free;  ///< the motions that it does not resist: orthonormal coefficients of the bases (k_all × …)
  Eigen::MatrixXd rows;  ///< G (m × k): the approach by these motions
  Eigen::VectorXd row_size;  ///< m: the largest entry of each row of B; 1 for a row without entries
};
/// \param motions of each body   \param fixed rows whose p is given (m, or empty: none): they resist nothing
/// \param bodies the rows B of each
Statics statics(const std::vector<Eigen::SparseMatrix<double>>& bodies, const std::vector<Motions>& motions,
                const std::vector<char>& fixed = {});

/// Rows whose limits leave their p no choice (m; empty: there is none).
std::vector<char> fixed_rows(const Limits& limits);

/// \return the loads less Bᵀ p of these rows   \param bodies their B   \param fixed as fixed_rows() gives it
std::vector<Eigen::VectorXd> left_by_fixed(std::vector<Eigen::VectorXd> loads,
                                           const std::vector<Eigen::SparseMatrix<double>>& bodies, const Limits& limits,
                                           const std::vector<char>& fixed);

/// Loads that pressures hold, or not.
struct BalancedLoad {
  bool possible = true;
  Eigen::VectorXd load;      ///< e (k), without what is taken for rounding
  Eigen::VectorXd pressure;  ///< one p that balances it, as Balance has it
  double imbalance = 0;      ///< as in Solution
  Eigen::VectorXd motion;    ///< not possible: coefficients of the bodies' bases, stacked (k_all)
};
/// \param loads f of each body, as left_by_fixed()   \param limits complete
BalancedLoad balanced_load(const Statics& statics, const std::vector<Motions>& motions,
                           const std::vector<Eigen::VectorXd>& loads, const Limits& limits);

}  // namespace bracket::contact
