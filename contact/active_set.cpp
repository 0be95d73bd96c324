// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/active_set.h"

#include <cmath>
#include <set>

#include "contact/limits.h"
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

/// Where block_active_set() has a row.
enum class Place : char { active, rest, lower, upper };

Place off(const Limits& limits, Index row, double pressure) {
  return pressure == limits.lower[row] ? Place::lower : pressure == limits.upper[row] ? Place::upper : Place::rest;
}

/// Where a row goes. \param pressure p of this step   \param slack its slack, zero within rounding counts as zero
Place next(const Limits& limits, Index row, Place place, double pressure, double slack) {
  if (place == Place::active)
    return !(pressure > limits.lower[row]) ? Place::lower : pressure < limits.upper[row] ? place : Place::upper;
  if (!(violation(limits, row, pressure, slack) > 0)) return place;
  if (place != Place::rest) return Place::active;
  const Place towards = slack < 0 ? Place::upper : Place::lower;
  const double limit = slack < 0 ? limits.upper[row] : limits.lower[row];
  return std::isfinite(limit) ? towards : Place::active;
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
  to.limits = scaled(complete(problem.limits, row.size()), row.cwiseInverse());
  to.may_depend = problem.may_depend;
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

Held sum(const Held& a, const Held& b) {
  Held result{MatrixXd(a.parts.rows(), a.parts.cols() + b.parts.cols()), a.motion + b.motion,
              a.motion_size + b.motion_size};
  result.parts << a.parts, b.parts;
  return result;
}

Equality equality(const std::vector<Index>& active, const VectorXd& given, const Held& held, const VectorXd& sum,
                  const MatrixXd& parts) {
  Equality result{given, held.motion, given.cwiseAbs(), held.motion_size};
  result.pressure(active) = sum;
  result.pressure_size(active) = parts.cwiseAbs().rowwise().sum();
  return result;
}

std::optional<Equality> solve_closed(const Interface& problem, const std::vector<Index>& active,
                                     const VectorXd& overlap, const VectorXd& load, const VectorXd& given) {
  if (active.empty()) {
    const VectorXd none = VectorXd::Zero(0);
    return load.size() == 0 ? std::optional(Equality{given, none, given.cwiseAbs(), none}) : std::nullopt;
  }
  // G Gᵀ makes F definite and adds nothing but G e where Gᵀp = e.
  const MatrixXd motion = problem.motion(active, Eigen::all);
  MatrixXd definite = problem.compliance(active, active);
  definite += motion * motion.transpose();
  const VectorXd diagonal = definite.diagonal();
  const auto factorised = [&] {
    const Eigen::LLT<Eigen::Ref<MatrixXd>> factor(definite);
    return factor.info() == Eigen::Success && regular(definite.diagonal(), diagonal);
  };
  // Rows that depend on each other: with a little on the diagonal, and what that spoils taken out again, p comes near
  // to the one of least norm.
  constexpr double little = 1e-10;
  constexpr int refinements = 2;
  bool depend = false;
  if (!factorised()) {
    if (!problem.may_depend) return {};
    depend = true;
    definite = problem.compliance(active, active);
    definite += motion * motion.transpose();
    definite.diagonal().array() += little;
    if (!factorised()) return {};
  }

  const auto lower = definite.triangularView<Eigen::Lower>();
  const MatrixXd left = motion.size() > 0 ? MatrixXd(lower.solve(motion)) : motion;
  const auto response = [&](const VectorXd& of_overlap, const VectorXd& of_load) {
    return held(left, lower.solve(VectorXd(of_overlap(active) + motion * of_load)), of_load);
  };
  auto found = response(overlap, load);
  if (!found) return {};
  if (!given.isZero(0))
    found = sum(*found, *response(-(problem.compliance * given), -(problem.motion.transpose() * given)));
  const auto upper = definite.transpose().triangularView<Eigen::Upper>();
  for (int step = 0; step < refinements && depend; ++step) {
    VectorXd pressure = given;
    pressure(active) = VectorXd(upper.solve(VectorXd(found->parts.rowwise().sum())));
    const auto further = response(overlap - problem.compliance * pressure + problem.motion * found->motion,
                                  load - problem.motion.transpose() * pressure);
    if (!further) return {};
    found = sum(*found, *further);
  }
  return equality(active, given, *found, upper.solve(VectorXd(found->parts.rowwise().sum())),
                  upper.solve(found->parts));
}

std::optional<Pressure> block_active_set(const Interface& problem, const std::vector<char>& guess) {
  constexpr int most = 30;
  const Limits& limits = problem.limits;
  const Index m = problem.overlap.size();
  VectorXd pressure = at_rest(limits);
  std::vector<Place> places(static_cast<std::size_t>(m));
  for (Index i = 0; i < m; ++i) {
    const bool bilateral = std::isinf(limits.lower[i]) && std::isinf(limits.upper[i]);
    const bool moves = problem.compliance(i, i) > 0 || !problem.motion.row(i).isZero(0);  // else it depends on all
    places[i] =
        moves && ((guess[i] && !is_fixed(limits, i)) || bilateral) ? Place::active : off(limits, i, pressure[i]);
  }
  std::set<std::vector<Place>> seen;
  for (int iteration = 1; iteration <= most && seen.insert(places).second; ++iteration) {
    std::vector<Index> active;
    for (Index i = 0; i < m; ++i) switch (places[i]) {
        case Place::active: active.push_back(i); [[fallthrough]];
        case Place::rest: pressure[i] = 0; break;
        case Place::lower: pressure[i] = limits.lower[i]; break;
        case Place::upper: pressure[i] = limits.upper[i]; break;
      }
    const auto closed = solve_closed(problem, active, problem.overlap, problem.load, pressure);
    if (!closed) return {};
    const VectorXd left = slack(problem, closed->pressure, closed->motion);
    const VectorXd rounding = slack_rounding(problem, *closed);
    const auto changed_places = [&](bool at_rest_only) {
      std::vector<Place> result = places;
      for (Index i = 0; i < m; ++i)
        if (!at_rest_only || places[i] == Place::rest)
          result[i] = next(limits, i, places[i], closed->pressure[i], std::abs(left[i]) > rounding[i] ? left[i] : 0.0);
      return result;
    };
    // The first step tells at which limit the rows are; what else is wrong may be so because they are not there yet.
    std::vector<Place> changed = changed_places(iteration == 1);
    if (changed == places) changed = changed_places(false);
    if (changed == places) return Pressure{Termination::solved, closed->pressure, closed->motion, active, iteration};
    places = std::move(changed);
  }
  return {};
}

}  // namespace bracket::contact
