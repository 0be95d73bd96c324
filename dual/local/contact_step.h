// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

namespace bracket::dual {

/// A small quadratic problem: min ½ xᵀF x + cᵀx  over  Gᵀx = 0, x ≥ least, least ≤ 0 (−∞ where there is no limit).
struct SmallProblem {
  Eigen::MatrixXd form;    ///< F, n × n, symmetric, positive semidefinite where Gᵀx = 0
  Eigen::VectorXd slope;   ///< c
  Eigen::MatrixXd motion;  ///< G, n × k, of any rank
  Eigen::VectorXd least;
};
/// Descends from x = 0 by active sets, each step to the minimum over what is free or to the first limit on the way;
/// whatever rounding does, the result is within the limits and where it is not 0 it is lower than that. Ends after
/// finitely many steps, at the minimum but for rounding or when `most_steps` are done.
Eigen::VectorXd descend(const SmallProblem& problem, int most_steps);

}  // namespace bracket::dual
