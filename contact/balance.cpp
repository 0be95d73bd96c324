// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "contact/limits.h"

namespace bracket::contact {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The least-squares solution p of Gᵀp = e that keeps p off `support`.
/// \return nothing where rows of `support` depend on each other
std::optional<VectorXd> least_squares(const Eigen::MatrixXd& rows, const VectorXd& load, VectorXd pressure,
                                      const std::vector<Index>& support) {
  if (support.empty()) return pressure;
  const Eigen::MatrixXd columns = rows(support, Eigen::all).transpose();
  pressure(support).setZero();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  if (qr.rank() < columns.cols()) return {};
  pressure(support) = qr.solve(load - rows.transpose() * pressure);
  return pressure;
}

/// Whether a row of `support` is at a limit or beyond.
bool any_at_limit(const Limits& limits, const VectorXd& pressure, const std::vector<Index>& support) {
  return !std::all_of(support.begin(), support.end(), [&](Index i) { return is_between(limits, i, pressure[i]); });
}

/// Moves p from `from` towards `to` until a row of `support` reaches a limit; takes the rows at limits out of it.
VectorXd step_to_boundary(const Limits& limits, const VectorXd& from, const VectorXd& to, std::vector<Index>& support) {
  double step = 1;
  Index blocking = -1;
  for (Index i : support) {
    if (is_between(limits, i, to[i]) || to[i] == from[i]) continue;
    const double way = to[i] - from[i], part = room(limits, i, from[i], way) / std::abs(way);
    if (part < step) {
      step = part;
      blocking = i;
    }
  }
  VectorXd pressure = blocking >= 0 ? VectorXd(from + step * (to - from)) : to;
  if (blocking >= 0)
    pressure[blocking] = to[blocking] < from[blocking] ? limits.lower[blocking] : limits.upper[blocking];
  for (Index i : support) pressure[i] = std::min(std::max(pressure[i], limits.lower[i]), limits.upper[i]);
  std::erase_if(support, [&](Index i) { return !is_between(limits, i, pressure[i]); });
  return pressure;
}

}  // namespace

// Bounded-variable least squares: P. B. Stark, R. L. Parker, Comput. Statist. 10 (1995) 129–141; with p ≥ 0 that of
// Lawson & Hanson, Solving Least Squares Problems (1974), ch. 23. Begins with the p nearest to zero; what is between
// its limits there is not in the support before it has entered. A row that enters is not orthogonal to the residual,
// which those of the support are: it does not depend on them. Each passage of the outer loop reduces the residual, so
// no support comes twice with the same p off it; a row whose entry would not reduce it (its gradient was rounding) is
// set aside until the residual falls.
Balance balance(const Eigen::MatrixXd& rows, const VectorXd& load, double explained, const Limits& given) {
  constexpr double flat = 64 * std::numeric_limits<double>::epsilon();
  const Limits limits = complete(given, rows.rows());
  const VectorXd size = rows.rowwise().norm();
  VectorXd pressure = at_rest(limits);
  VectorXd residual = load - rows.transpose() * pressure;
  const double least_slope = flat * (load.norm() + (rows.cwiseAbs().transpose() * pressure.cwiseAbs()).norm());
  std::vector<Index> support;
  std::vector<char> aside(rows.rows(), 0);  // these, and those of the support, do not enter
  while (residual.norm() > explained / 64) {
    Index entering = -1;
    double steepest = least_slope;
    for (Index i = 0; i < rows.rows(); ++i) {
      if (size[i] == 0 || aside[i]) continue;
      const double slope = rows.row(i).dot(residual) / size[i];
      if (std::abs(slope) > steepest && room(limits, i, pressure[i], slope) > 0) {
        steepest = std::abs(slope);
        entering = i;
      }
    }
    if (entering < 0) break;
    aside[entering] = 1;

    std::vector<Index> trial_support = support;
    trial_support.push_back(entering);
    std::optional<VectorXd> target = least_squares(rows, load, pressure, trial_support);
    const bool rises = rows.row(entering).dot(residual) > 0;
    if (!target || !(rises ? (*target)[entering] > pressure[entering] : (*target)[entering] < pressure[entering]))
      continue;
    VectorXd trial = pressure;
    while (any_at_limit(limits, *target, trial_support)) {
      trial = step_to_boundary(limits, trial, *target, trial_support);
      target = least_squares(rows, load, trial, trial_support);
      if (!target) break;
    }
    if (!target) continue;
    const VectorXd left = load - rows.transpose() * *target;
    if (left.norm() >= residual.norm()) continue;
    pressure = *target;
    residual = left;
    support = trial_support;
    std::fill(aside.begin(), aside.end(), 0);
    for (Index i : support) aside[i] = 1;
  }

  if (residual.norm() <= explained) return {true, pressure, {}};
  // Once more, so that it is orthogonal to the rows of the support but for its own rounding, not that of the load.
  if (const auto of_support = least_squares(rows, residual, VectorXd::Zero(rows.rows()), support))
    residual -= rows.transpose() * *of_support;
  return {false, {}, residual};
}

}  // namespace bracket::contact
