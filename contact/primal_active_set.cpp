// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "contact/active_set.h"
#include "contact/growing_cholesky.h"

namespace bracket::contact {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double largest(const VectorXd& values) { return values.size() > 0 ? values.lpNorm<Eigen::Infinity>() : 0; }

/// The working set W: rows where p may be positive. Always G_W has full column rank and H_WW = (F + G Gᵀ)_WW is
/// definite, so the minimum over W of ½ pᵀF p − pᵀw with Gᵀp = e, and its α, are unique.
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

  Equality minimum() const {
    const MatrixXd motion = problem_.motion(rows_, Eigen::all);
    const MatrixXd left = cholesky_.forward(motion);
    const VectorXd right = cholesky_.forward(problem_.overlap(rows_) + motion * problem_.load);
    const auto found = held(left, right, problem_.load);
    if (!found) throw HeldByRounding();
    return equality(problem_.overlap.size(), rows_, *found, cholesky_.backward(found->parts.rowwise().sum()),
                    cholesky_.backward(found->parts));
  }
  /// Rows of W whose pressure Gᵀp = e alone decides: without one of them G_W would lose rank.
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

/// The support of `start`, extended row by row (the farthest from the span of those before) until G_W has full rank.
WorkingSet first_working_set(const Interface& problem, const VectorXd& start) {
  WorkingSet set(problem);
  MatrixXd left = problem.motion;  // less its projection on the rows of the set
  const auto take = [&](Index row) {
    const VectorXd direction = left.row(row).normalized();
    left -= (left * direction) * direction.transpose();
    left.row(row).setZero();
    if (!set.append(row)) throw HeldByRounding();
  };
  for (Index i = 0; i < start.size(); ++i)
    if (start[i] > 0) take(i);
  while (static_cast<Index>(set.rows().size()) < problem.motion.cols()) {
    Index farthest = 0;
    left.rowwise().squaredNorm().maxCoeff(&farthest);
    take(farthest);
  }
  return set;
}

/// How far p ≥ 0 allows to go along a direction: the row that stops it first (−1: none; of several, the least).
struct Stop {
  double step = 0;
  Index row = -1;
};
/// \param candidates the rows that may stop it, direction < 0 there
Stop first_stop(const VectorXd& pressure, const VectorXd& direction, std::vector<Index> candidates) {
  std::sort(candidates.begin(), candidates.end());
  Stop stop;
  for (Index i : candidates)
    if (stop.row < 0 || pressure[i] < -direction[i] * stop.step) stop = {pressure[i] / -direction[i], i};
  return stop;
}

/// The rows of `set` where `values` are below a bound.
std::vector<Index> below(const VectorXd& values, double bound, const std::vector<Index>& set) {
  std::vector<Index> result;
  for (Index i : set)
    if (values[i] < bound) result.push_back(i);
  return result;
}

/// The row off `set` with the most negative slack, or with `least_index` the first; −1: no slack is negative by more
/// than rounding.
Index violated(const VectorXd& slack, const VectorXd& rounding, const std::vector<Index>& set, bool least_index) {
  VectorXd excess = -(slack + rounding);
  excess(set).setConstant(-1);
  Index result = -1;
  for (Index i = 0; i < slack.size(); ++i)
    if (excess[i] > 0 && (result < 0 || (!least_index && slack[i] < slack[result]))) result = i;
  return result;
}

}  // namespace

// Why it ends. Let p be the minimum over W. If a slack s_j < 0 is left, j enters W; on the way to the new minimum each
// row that would become negative stops the move at zero and leaves W.
// - G_W keeps its rank: if it fell with row i, Gᵀp = e would fix p_i; but it changes from ≥ 0 to < 0.
// - If j makes H_WW singular, its null vector d has Gᵀd = 0, F d = 0, and the energy ½ pᵀF p − pᵀw changes by s_j per
//   unit along it: without a stop it falls without end, so no approach satisfies all rows (contradiction). Else the row
//   that stops it leaves; since d is the only null vector and d_i ≠ 0, H is definite again and G_W keeps its rank.
// - Every move of positive length lowers the energy; so no W whose minimum was reached comes twice, unless the moves
//   between have length zero. As long as they do, the least row enters and, of those at zero, the least row leaves
//   (Bland). Suppose they went in a circle: p, and with it c = F p − w, is fixed. Let t be the largest row that enters
//   and leaves; s the slacks when it enters (s_t < 0, s_i ≥ 0 for such rows i < t, 0 for the others in the sets), and d
//   the direction along which it leaves (d_t < 0, d_i ≥ 0 for such i < t), cᵀd < 0. As Gᵀd = 0, cᵀd = sᵀd > 0. So no.
Pressure primal_active_set(const Interface& problem, const VectorXd& start) {
  const Index m = problem.overlap.size();
  const Index most = 100 * (m + 10);
  WorkingSet set = first_working_set(problem, start);
  VectorXd pressure = start;
  bool moved = true;  // since the last row entered
  const auto move = [&](const VectorXd& change, double rounding) {
    moved = moved || largest(change) > rounding;
    pressure += change;
  };
  const auto leave = [&](Index row) {
    pressure[row] = 0;
    set.remove(row);
  };

  for (int iteration = 1; iteration <= most; ++iteration) {
    const Equality minimum = set.minimum();
    const double rounding = 1e-13 * largest(minimum.pressure_size);
    const VectorXd direction = minimum.pressure - pressure;
    auto negative = below(minimum.pressure, -rounding, set.rows());
    if (!negative.empty())  // a pressure that the statics fix is negative by rounding only
      for (Index i : set.fixed()) std::erase(negative, i);
    if (!negative.empty()) {
      const Stop stop = first_stop(pressure, direction, negative);
      move(stop.step * direction, rounding);
      leave(stop.row);
      continue;
    }
    move(direction, rounding);
    pressure = minimum.pressure.cwiseMax(0);

    const Index entering =
        violated(slack(problem, pressure, minimum.motion), slack_rounding(problem, minimum), set.rows(), !moved);
    moved = false;
    if (entering < 0) return {Termination::solved, pressure, minimum.motion, set.rows(), iteration};
    if (set.append(entering)) continue;

    const VectorXd flat = set.flat_direction(entering);
    const auto falling = below(flat, -1e-7 * largest(flat), set.rows());
    if (falling.empty()) return {Termination::contradiction, {}, {}, {}, iteration};
    const Stop stop = first_stop(pressure, flat, falling);
    move(stop.step * flat, rounding);
    leave(stop.row);
    if (!set.append(entering)) throw HeldByRounding();
  }
  throw HeldByRounding();
}

}  // namespace bracket::contact
