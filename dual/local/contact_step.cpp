// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/local/contact_step.h"

#include <limits>
#include <vector>

namespace bracket::dual {

namespace {

/// What is free of a vector.
Eigen::VectorXd part(const Eigen::VectorXd& x, const std::vector<Eigen::Index>& free) { return x(free); }

/// The motions' rows of what is free, decomposed.
struct FreeMotions {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
  Eigen::MatrixXd unmoved;  ///< an orthonormal basis of the x with Gᵀx = 0

  FreeMotions(const Eigen::MatrixXd& motion, const std::vector<Eigen::Index>& free) {
    const Eigen::Index n = static_cast<Eigen::Index>(free.size());
    if (motion.cols() == 0 || n == 0) {
      unmoved = Eigen::MatrixXd::Identity(n, n);
      return;
    }
    const Eigen::MatrixXd rows = motion(free, Eigen::all);
    qr.setThreshold(1e-10);  // beside rounding, motions are as large as facets by stars
    qr.compute(rows);
    const Eigen::MatrixXd q = qr.householderQ() * Eigen::MatrixXd::Identity(n, n);
    unmoved = q.rightCols(n - qr.rank());
  }
};

}  // namespace

Eigen::VectorXd descend(const SmallProblem& problem, int most_steps) {
  const auto& [form, slope, motion, least] = problem;
  const Eigen::Index n = slope.size();
  std::vector<char> held(n);
  for (Eigen::Index i = 0; i < n; ++i) held[i] = least[i] >= 0;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
  const double size = slope.cwiseAbs().maxCoeff();
  constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
  for (int step = 0; step < most_steps; ++step) {
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < n; ++i)
      if (!held[i]) free.push_back(i);
    const FreeMotions motions(motion, free);
    const Eigen::VectorXd gradient = form * x + slope;
    const Eigen::MatrixXd& basis = motions.unmoved;
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(n);
    if (basis.cols() > 0) {
      const Eigen::VectorXd along = basis.transpose() * part(gradient, free);
      if (along.cwiseAbs().maxCoeff() > rounding * size) {
        const Eigen::MatrixXd reduced = basis.transpose() * form(free, free) * basis;
        direction(free) = -(basis * reduced.completeOrthogonalDecomposition().solve(along));
      }
    }
    if (!(gradient.dot(direction) < 0)) {  // at the minimum over what is free: what has the wrong sign is let go
      Eigen::VectorXd multiplier = gradient;
      if (motion.cols() > 0 && !free.empty()) multiplier -= motion * motions.qr.solve(part(gradient, free));
      Eigen::Index worst = -1;
      for (Eigen::Index i = 0; i < n; ++i)
        if (held[i] && multiplier[i] < -rounding * size && (worst < 0 || multiplier[i] < multiplier[worst])) worst = i;
      if (worst < 0) break;
      held[worst] = 0;
      continue;
    }
    double length = 1;
    Eigen::Index first = -1;
    for (const Eigen::Index i : free)
      if (direction[i] < 0 && least[i] - x[i] > length * direction[i]) {
        length = std::max(0.0, (least[i] - x[i]) / direction[i]);
        first = i;
      }
    x += length * direction;
    if (first >= 0) {
      x[first] = least[first];
      held[first] = 1;
    }
  }
  x = x.cwiseMax(least);
  return x.allFinite() && 0.5 * x.dot(form * x) + slope.dot(x) < 0 ? x : Eigen::VectorXd::Zero(n);
}

}  // namespace bracket::dual
