// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "contact/active_set.h"
#include "contact/growing_cholesky.h"
#include "contact/limits.h"

namespace bracket::contact {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double largest(const VectorXd& values) { return values.size() > 0 ? values.lpNorm<Eigen::Infinity>() : 0; }

/// The working set W: rows whose p may change. Always G_W has full column rank and H_WW = (F + G Gᵀ)_WW is
/// definite, so the minimum over p_W of ½ pᵀF p − pᵀw with Gᵀp = e, and its α, are unique.
class WorkingSet {
 public:
  explicit WorkingSet(const Interface& problem) : problem_(problem), cholesky_(problem.overlap.size()) {}

  const std::vector<Index>& rows() const { return rows_; }
  bool append(Index row) {
    if (!cholesky_.append(column(row), entry(row, row))) return false;
    rows_.push_back(row);
    return true;
  }
  void remove(Index row) {
    const auto place = std::find(rows_.begin(), rows_.end(), row);
    cholesky_.remove(place - rows_.begin());
    rows_.erase(place);
  }

  /// \param pressure p off W
  Equality minimum(const VectorXd& pressure) const {
    VectorXd given = pressure;
    given(rows_).setZero();
    const MatrixXd motion = problem_.motion(rows_, Eigen::all);
    const MatrixXd left = cholesky_.forward(motion);
    const auto response = [&](const VectorXd& overlap, const VectorXd& load) {
      const auto found = held(left, cholesky_.forward(overlap(rows_) + motion * load), load);
      if (!found) throw HeldByRounding();
      return *found;
    };
    Held found = response(problem_.overlap, problem_.load);
    if (!given.isZero(0))
      found = sum(found, response(-(problem_.compliance * given), -(problem_.motion.transpose() * given)));
    return equality(rows_, given, found, cholesky_.backward(found.parts.rowwise().sum()),
                    cholesky_.backward(found.parts));
  }
  /// Rows of W whose pressure Gᵀp = e and p off W decide alone: without one of them G_W would lose rank.
  std::vector<Index> fixed() const {
    const Index k = problem_.motion.cols();
    std::vector<Index> result;
    if (k == 0) return result;
    const MatrixXd motion = problem_.motion(rows_, Eigen::all).rowwise().normalized();
    const MatrixXd range = motion.householderQr().householderQ() * MatrixXd::Identity(motion.rows(), k);
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (range.row(static_cast<Index>(i)).squaredNorm() > 1 - 1e-12) result.push_back(rows_[i]);
    return result;
  }
  /// d (m) with d_row = 1, zero off W and `row`, and F d = 0, Gᵀd = 0. \pre append(row) returned false
  VectorXd flat_direction(Index row) const {
    VectorXd direction = VectorXd::Zero(problem_.overlap.size());
    const VectorXd left = cholesky_.forward(column(row));
    direction(rows_) = -cholesky_.backward(left);
    direction[row] = 1;
    return direction;
  }

 private:
  double entry(Index i, Index j) const {
    return problem_.compliance(i, j) + problem_.motion.row(i).dot(problem_.motion.row(j));
  }
  VectorXd column(Index row) const {
    VectorXd result(rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) result[static_cast<Index>(i)] = entry(rows_[i], row);
    return result;
  }

  const Interface& problem_;
  std::vector<Index> rows_;
  GrowingCholesky cholesky_;
};

/// The rows where `start` is not given by the limits, extended row by row (the farthest from the span of those before)
/// until G_W has full rank; then the bilateral rows that do not depend on these.
WorkingSet first_working_set(const Interface& problem, const VectorXd& start) {
  const Limits& limits = problem.limits;
  WorkingSet set(problem);
  MatrixXd left = problem.motion;  // less its projection on the rows of the set
  const auto take = [&](Index row) {
    const VectorXd direction = left.row(row).normalized();
    left -= (left * direction) * direction.transpose();
    left.row(row).setZero();
    if (!set.append(row)) throw HeldByRounding();
  };
  const VectorXd rest = at_rest(limits);
  for (Index i = 0; i < start.size(); ++i)
    if (start[i] != rest[i] && is_between(limits, i, start[i])) take(i);
  while (static_cast<Index>(set.rows().size()) < problem.motion.cols()) {
    Index farthest = 0;
    left.rowwise().squaredNorm().maxCoeff(&farthest);
    take(farthest);
  }
  std::vector<char> in_set(start.size(), 0);
  for (Index i : set.rows()) in_set[i] = 1;
  for (Index i = 0; i < start.size(); ++i)
    if (!in_set[i] && std::isinf(limits.lower[i]) && std::isinf(limits.upper[i])) set.append(i);
  return set;
}

/// How far the limits allow to go along a direction: the row that stops it first (−1: none; of several, the least).
struct Stop {
  double step = 0;
  Index row = -1;
};
/// \param candidates the rows that may stop it, direction ≠ 0 there
Stop first_stop(const Limits& limits, const VectorXd& pressure, const VectorXd& direction,
                std::vector<Index> candidates) {
  std::sort(candidates.begin(), candidates.end());
  Stop stop;
  for (Index i : candidates) {
    const double left = room(limits, i, pressure[i], direction[i]), speed = std::abs(direction[i]);
    if (stop.row < 0 || left < speed * stop.step) stop = {left / speed, i};
  }
  return stop;
}

/// The rows of `set` where p is beyond a limit by more than rounding.
std::vector<Index> beyond(const Limits& limits, const VectorXd& pressure, double rounding,
                          const std::vector<Index>& set) {
  std::vector<Index> result;
  for (Index i : set)
    if (pressure[i] < limits.lower[i] - rounding || pressure[i] > limits.upper[i] + rounding) result.push_back(i);
  return result;
}

/// The rows of `set`, and `entering`, that a limit stops along a direction, if they go far enough.
std::vector<Index> stopping(const Limits& limits, const VectorXd& pressure, const VectorXd& direction,
                            const std::vector<Index>& set, Index entering) {
  std::vector<Index> result;
  const double moves = 1e-7 * largest(direction);
  for (Index i : set)
    if (std::abs(direction[i]) > moves && std::isfinite(room(limits, i, pressure[i], direction[i])))
      result.push_back(i);
  if (std::isfinite(room(limits, entering, pressure[entering], direction[entering]))) result.push_back(entering);
  return result;
}

/// The row off `set` whose slack has the wrong sign by most, or with `least_index` the first; −1: none by more than
/// rounding.
Index violated(const Limits& limits, const VectorXd& pressure, const VectorXd& slack, const VectorXd& rounding,
               const std::vector<Index>& set, bool least_index) {
  VectorXd wrong(slack.size());
  for (Index i = 0; i < slack.size(); ++i) wrong[i] = violation(limits, i, pressure[i], slack[i]);
  wrong(set).setZero();
  Index result = -1;
  for (Index i = 0; i < slack.size(); ++i)
    if (wrong[i] > rounding[i] && (result < 0 || (!least_index && wrong[i] > wrong[result]))) result = i;
  return result;
}

}  // namespace

// Why it ends. Let p be the minimum over W, p off W being kept. If the slack of a row j off W has the wrong sign, j
// enters W, and p_j will leave its limit inwards; on the way to the new minimum each row (also j itself, at its other
// limit) that would pass a limit stops the move there and leaves W. A row without limits never leaves.
// - G_W keeps its rank: if it fell with row i, Gᵀp = e would fix p_i; but it changes.
// - If j makes H_WW singular, its null vector d has Gᵀd = 0, F d = 0, and the energy ½ pᵀF p − pᵀw changes by s_j per
//   unit of p_j along it, slacks not at all: without a stop it falls without end, so no approach satisfies all rows
//   (contradiction). Where j itself stops it, at its other limit, W stays. Else the row that stops it leaves; since d
//   is the only null vector and d_i ≠ 0, H is definite again and G_W keeps its rank.
// - A row off W that is between its limits was so from the start, for rows leave W at limits only; there are finitely
//   many such values, so finitely many W with p off W. A row with equal limits does not enter.
// - Every move of positive length lowers the energy; so no W with p off W whose minimum was reached comes twice, unless
//   the moves between have length zero. As long as they do, the least row enters and, of those at a limit, the least
//   row leaves (Bland). Suppose they went in a circle: p, and with it c = F p − w, is fixed. Rows that enter and leave
//   do so at the limit where they are; turn the signs of those at their upper one, so that all such are at a lower
//   limit. Let t be the largest of them; s the slacks when it enters (s_t < 0, s_i ≥ 0 for such rows i < t, 0 for the
//   others in the sets), and d the direction along which it leaves (d_t < 0, d_i ≥ 0 for such i < t), cᵀd < 0. As Gᵀd =
//   0, cᵀd = sᵀd > 0. So no.
Pressure primal_active_set(const Interface& problem, const VectorXd& start) {
  const Limits& limits = problem.limits;
  const Index m = problem.overlap.size();
  const Index most = 100 * (m + 10);
  WorkingSet set = first_working_set(problem, start);
  VectorXd pressure = start;
  bool moved = true;  // since the last row entered
  const auto move = [&](const VectorXd& change, double rounding) {
    moved = moved || largest(change) > rounding;
    pressure += change;
  };
  const auto to_limit = [&](Index row, double direction) {
    pressure[row] = direction < 0 ? limits.lower[row] : limits.upper[row];
  };

  for (int iteration = 1; iteration <= most; ++iteration) {
    const Equality minimum = set.minimum(pressure);
    const double rounding = 1e-13 * largest(minimum.pressure_size);
    const VectorXd direction = minimum.pressure - pressure;
    auto passing = beyond(limits, minimum.pressure, rounding, set.rows());
    if (!passing.empty())  // a pressure that the statics fix passes a limit by rounding only
      for (Index i : set.fixed()) std::erase(passing, i);
    if (!passing.empty()) {
      const Stop stop = first_stop(limits, pressure, direction, passing);
      move(stop.step * direction, rounding);
      to_limit(stop.row, direction[stop.row]);
      set.remove(stop.row);
      continue;
    }
    move(direction, rounding);
    pressure = clamped(minimum.pressure, limits);

    const VectorXd left = slack(problem, pressure, minimum.motion);
    const Index entering = violated(limits, pressure, left, slack_rounding(problem, minimum), set.rows(), !moved);
    moved = false;
    if (entering < 0) return {Termination::solved, pressure, minimum.motion, set.rows(), iteration};
    if (set.append(entering)) continue;

    VectorXd flat = set.flat_direction(entering);
    if (left[entering] > 0) flat = -flat;  // p falls
    const Stop stop = first_stop(limits, pressure, flat, stopping(limits, pressure, flat, set.rows(), entering));
    if (stop.row < 0) return {Termination::contradiction, {}, {}, {}, iteration};
    move(stop.step * flat, rounding);
    to_limit(stop.row, flat[stop.row]);
    if (stop.row == entering) continue;
    set.remove(stop.row);
    if (!set.append(entering)) throw HeldByRounding();
  }
  throw HeldByRounding();
}

}  // namespace bracket::contact
