// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/contact.h"

namespace bracket::contact {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The least-squares solution p of Gᵀp = e that is zero off `support`.
VectorXd least_squares(const Eigen::MatrixXd& rows, const VectorXd& load, const std::vector<Index>& support) {
  VectorXd pressure = VectorXd::Zero(rows.rows());
  if (support.empty()) return pressure;
  const Eigen::MatrixXd columns = rows(support, Eigen::all).transpose();
  pressure(support) = columns.colPivHouseholderQr().solve(load);
  return pressure;
}

/// Moves p from `from` towards `to` until a row of `support` reaches zero; takes the rows at zero out of it.
VectorXd step_to_boundary(const VectorXd& from, const VectorXd& to, std::vector<Index>& support) {
  double step = 1;
  Index blocking = -1;
  for (Index i : support)
    if (to[i] <= 0 && from[i] / (from[i] - to[i]) < step) {
      step = from[i] / (from[i] - to[i]);
      blocking = i;
    }
  VectorXd pressure = from + step * (to - from);
  if (blocking >= 0) pressure[blocking] = 0;
  for (Index i : support) pressure[i] = std::max(pressure[i], 0.0);
  std::erase_if(support, [&](Index i) { return pressure[i] == 0; });
  return pressure;
}

}  // namespace

// Lawson & Hanson, Solving Least Squares Problems (1974), ch. 23. Each passage of the outer loop reduces the residual,
// so no support comes twice; a row whose entry would not reduce it (its gradient was rounding) is set aside until the
// residual falls.
Balance balance(const Eigen::MatrixXd& rows, const VectorXd& load, double explained, const Limits& /*limits*/) {
  constexpr double flat = 64 * std::numeric_limits<double>::epsilon();
  const VectorXd size = rows.rowwise().norm();
  VectorXd pressure = VectorXd::Zero(rows.rows());
  VectorXd residual = load;
  std::vector<Index> support;
  std::vector<char> aside(rows.rows(), 0);
  while (residual.norm() > explained / 64) {
    Index entering = -1;
    double steepest = flat * load.norm();
    for (Index i = 0; i < rows.rows(); ++i) {
      if (size[i] == 0 || aside[i] || pressure[i] > 0) continue;
      const double slope = rows.row(i).dot(residual) / size[i];
      if (slope > steepest) {
        steepest = slope;
        entering = i;
      }
    }
    if (entering < 0) break;

    std::vector<Index> trial_support = support;
    trial_support.push_back(entering);
    VectorXd target = least_squares(rows, load, trial_support);
    if (target[entering] <= 0) {
      aside[entering] = 1;
      continue;
    }
    VectorXd trial = pressure;
    while ((target(trial_support).array() <= 0).any()) {
      trial = step_to_boundary(trial, target, trial_support);
      target = least_squares(rows, load, trial_support);
    }
    const VectorXd left = load - rows.transpose() * target;
    if (left.norm() >= residual.norm()) {
      aside[entering] = 1;
      continue;
    }
    pressure = target;
    residual = left;
    support = trial_support;
    std::fill(aside.begin(), aside.end(), 0);
  }

  if (residual.norm() <= explained) return {true, pressure, {}};
  return {false, {}, residual};
}

}  // namespace bracket::contact
