// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/active_set.h"

#include <set>

namespace bracket::contact {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Scaled scaled(const Interface& problem) {
  // A row that touches pinned unknowns only has no compliance of its own.
  const VectorXd diagonal = problem.compliance.diagonal();
  const double typical = diagonal.size() > 0 && diagonal.maxCoeff() > 0 ? diagonal.maxCoeff() : 1;
  const VectorXd row = (diagonal.array() > 0).select(diagonal, typical).cwiseSqrt().cwiseInverse();

  const Index m = problem.motion.rows(), k = problem.motion.cols();
  Scaled result{{}, row, MatrixXd(k, k)};
  Interface& to = result.problem;
  to.compliance = row.asDiagonal() * problem.compliance * row.asDiagonal();
  to.overlap = row.cwiseProduct(problem.overlap);
  to.size = row.cwiseProduct(problem.size);
  to.motion = row.asDiagonal() * problem.motion;
  to.load = problem.load;
  if (k == 0) return result;
  const Eigen::HouseholderQR<MatrixXd> qr(to.motion);
  result.motion = qr.matrixQR().topRows(k).triangularView<Eigen::Upper>();
  to.motion = qr.householderQ() * MatrixXd::Identity(m, k);
  to.load = result.motion.transpose().triangularView<Eigen::Lower>().solve(problem.load);
  return result;
}

VectorXd slack_rounding(const Interface& problem, const VectorXd& pressure, const VectorXd& motion) {
  return 1e-13 * (problem.compliance.cwiseAbs() * pressure.cwiseAbs() + problem.size +
                  problem.motion.cwiseAbs() * motion.cwiseAbs());
}

std::optional<Equality> solve_closed(const Interface& problem, const std::vector<Index>& active,
                                     const VectorXd& overlap, const VectorXd& load) {
  constexpr double singular = 1e-12;  // a pivot by its diagonal entry
  if (active.empty()) return load.size() == 0 ? std::optional(Equality{}) : std::nullopt;
  // G Gᵀ makes F definite and adds nothing but G e where Gᵀp = e.
  const MatrixXd motion = problem.motion(active, Eigen::all);
  MatrixXd definite = problem.compliance(active, active);
  definite += motion * motion.transpose();
  const VectorXd diagonal = definite.diagonal();
  const Eigen::LLT<Eigen::Ref<MatrixXd>> factor(definite);
  if (factor.info() != Eigen::Success) return {};
  if ((definite.diagonal().array().square() <= singular * diagonal.array()).any()) return {};

  const auto lower = definite.triangularView<Eigen::Lower>();
  // Eigen divides by zero on a solve without right-hand sides.
  const MatrixXd left = motion.cols() > 0 ? MatrixXd(lower.solve(motion)) : motion;
  const VectorXd right = lower.solve(VectorXd(overlap(active) + motion * load));
  MatrixXd schur = left.transpose() * left;
  const VectorXd schur_diagonal = schur.diagonal();
  const Eigen::LLT<MatrixXd> schur_factor(schur);
  if (schur_factor.info() != Eigen::Success) return {};
  if ((schur_factor.matrixLLT().diagonal().array().square() <= singular * schur_diagonal.array()).any()) return {};

  Equality result;
  result.motion = schur_factor.solve(load - left.transpose() * right);
  result.pressure = definite.transpose().triangularView<Eigen::Upper>().solve(right + left * result.motion);
  return result;
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
    VectorXd pressure = VectorXd::Zero(m);
    pressure(active) = closed->pressure;
    const VectorXd slack = problem.compliance * pressure - problem.overlap - problem.motion * closed->motion;
    const VectorXd rounding = slack_rounding(problem, pressure, closed->motion);
    std::vector<char> next(m);
    for (Index i = 0; i < m; ++i) next[i] = guess[i] ? pressure[i] > 0 : slack[i] < -rounding[i];
    if (next == guess) return Pressure{Outcome::solved, pressure, closed->motion, active, iteration};
    guess = std::move(next);
  }
  return {};
}

}  // namespace bracket::contact
