// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/active_set.h"

#include <cmath>
#include <set>

#include "contact/statics.h"

namespace bracket::contact {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Whether no pivot of a Cholesky factor is lost: its square is no rounding of the diagonal entry it came from.
bool regular(const VectorXd& pivots, const VectorXd& diagonal) {
  return (pivots.array().square() > 1e-12 * diagonal.array()).all();
}

}  // namespace

Scaled scaled(const Interface& problem) {
  // A row that touches pinned unknowns only has no compliance of its own.
  const VectorXd diagonal = problem.compliance.diagonal();
  const double typical = diagonal.size() > 0 && diagonal.maxCoeff() > 0 ? diagonal.maxCoeff() : 1;
  const VectorXd row = (diagonal.array() > 0).select(diagonal, typical).cwiseSqrt().cwiseInverse();

  const Index k = problem.motion.cols();
  Scaled result{{}, row, MatrixXd(k, k)};
  Interface& to = result.problem;
  to.compliance = row.asDiagonal() * problem.compliance * row.asDiagonal();
  to.overlap = row.cwiseProduct(problem.overlap);
  to.size = row.cwiseProduct(problem.size);
  to.motion = row.asDiagonal() * problem.motion;
  to.load = problem.load;
  if (k == 0) return result;
  Orthonormal found = orthonormal(to.motion);
  to.motion = std::move(found.q);
  result.motion = std::move(found.r);
  to.load = result.motion.transpose().triangularView<Eigen::Lower>().solve(problem.load);
  return result;
}

VectorXd slack(const Interface& problem, const VectorXd& pressure, const VectorXd& motion) {
  return problem.compliance * pressure - problem.overlap - problem.motion * motion;
}

VectorXd slack_rounding(const Interface& problem, const Equality& minimum) {
  return 1e-13 * (problem.compliance.cwiseAbs() * minimum.pressure_size + problem.size +
                  problem.motion.cwiseAbs() * minimum.motion_size);
}

std::optional<Held> held(const MatrixXd& left, const VectorXd& right, const VectorXd& load) {
  const Index n = right.size(), k = load.size();
  Held result{MatrixXd::Zero(n, 3), load, load};
  result.parts.col(0) = right;
  if (k == 0) return result;
  if (n < k) return {};
  // G has orthonormal columns and F a diagonal of ones: with all rows closed, R is of the order of one.
  constexpr double resists = 1e-12;
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(left);
  if (!(std::abs(qr.matrixQR()(k - 1, k - 1)) > resists)) return {};
  // qr.householderQ() * I, reflection by reflection: there are few, and Eigen's blocks of them take long to compile.
  MatrixXd q = MatrixXd::Identity(n, k);
  VectorXd workspace(k);
  for (Index j = k - 1; j >= 0; --j)
    q.bottomRows(n - j).applyHouseholderOnTheLeft(qr.matrixQR().col(j).tail(n - j - 1), qr.hCoeffs()[j],
                                                  workspace.data());
  const auto upper = qr.matrixQR().topRows(k).triangularView<Eigen::Upper>();
  const auto& order = qr.colsPermutation();
  const VectorXd by_load = upper.transpose().solve(VectorXd(order.transpose() * load));
  const VectorXd by_overlap = q.transpose() * right;
  result.parts.col(1) = -q * by_overlap;
  result.parts.col(2) = q * by_load;
  result.motion = order * upper.solve(by_load - by_overlap);
  const MatrixXd inverse = order * upper.solve(MatrixXd::Identity(k, k));
  result.motion_size = inverse.cwiseAbs() * (by_load.cwiseAbs() + q.cwiseAbs().transpose() * right.cwiseAbs());
  return result;
}

Equality equality(Index m, const std::vector<Index>& active, const Held& held, const VectorXd& sum,
                  const MatrixXd& parts) {
  Equality result{VectorXd::Zero(m), held.motion, VectorXd::Zero(m), held.motion_size};
  result.pressure(active) = sum;
  result.pressure_size(active) = parts.cwiseAbs().rowwise().sum();
  return result;
}

std::optional<Equality> solve_closed(const Interface& problem, const std::vector<Index>& active,
                                     const VectorXd& overlap, const VectorXd& load) {
  if (active.empty()) {
    const VectorXd none = VectorXd::Zero(overlap.size());
    return load.size() == 0 ? std::optional(Equality{none, load, none, load}) : std::nullopt;
  }
  // G Gᵀ makes F definite and adds nothing but G e where Gᵀp = e.
  const MatrixXd motion = problem.motion(active, Eigen::all);
  MatrixXd definite = problem.compliance(active, active);
  definite += motion * motion.transpose();
  const VectorXd diagonal = definite.diagonal();
  const Eigen::LLT<Eigen::Ref<MatrixXd>> factor(definite);
  if (factor.info() != Eigen::Success || !regular(definite.diagonal(), diagonal)) return {};

  const auto lower = definite.triangularView<Eigen::Lower>();
  const MatrixXd left = motion.size() > 0 ? MatrixXd(lower.solve(motion)) : motion;
  const VectorXd right = lower.solve(VectorXd(overlap(active) + motion * load));
  const auto found = held(left, right, load);
  if (!found) return {};
  const auto upper = definite.transpose().triangularView<Eigen::Upper>();
  return equality(overlap.size(), active, *found, upper.solve(VectorXd(found->parts.rowwise().sum())),
                  upper.solve(found->parts));
}

std::optional<Pressure> block_active_set(const Interface& problem, std::vector<char> guess) {
  constexpr int most = 30;
  const Index m = problem.overlap.size();
  std::set<std::vector<char>> seen;
  for (int iteration = 1; iteration <= most && seen.insert(guess).second; ++iteration) {
    std::vector<Index> active;
    for (Index i = 0; i < m; ++i)
      if (guess[i]) active.push_back(i);
    const auto closed = solve_closed(problem, active, problem.overlap, problem.load);
    if (!closed) return {};
    const VectorXd left = slack(problem, closed->pressure, closed->motion);
    const VectorXd rounding = slack_rounding(problem, *closed);
    std::vector<char> next(static_cast<std::size_t>(m));
    for (Index i = 0; i < m; ++i) next[i] = guess[i] ? closed->pressure[i] > 0 : left[i] < -rounding[i];
    if (next == guess) return Pressure{Termination::solved, closed->pressure, closed->motion, active, iteration};
    guess = std::move(next);
  }
  return {};
}

}  // namespace bracket::contact
