// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/limits.h"

#include <cassert>
#include <cmath>
#include <limits>

namespace bracket::contact {

using Eigen::Index;
using Eigen::VectorXd;

Limits complete(const Limits& limits, Index rows) {
  if (limits.lower.size() == 0 && limits.upper.size() == 0)
    return {VectorXd::Zero(rows), VectorXd::Constant(rows, std::numeric_limits<double>::infinity())};
  assert(limits.lower.size() == rows && limits.upper.size() == rows);
  assert((limits.lower.array() <= limits.upper.array()).all());
  assert(rows == 0 || (limits.lower.maxCoeff() < std::numeric_limits<double>::infinity() &&
                       limits.upper.minCoeff() > -std::numeric_limits<double>::infinity()));
  return limits;
}

VectorXd at_rest(const Limits& limits) { return clamped(VectorXd::Zero(limits.lower.size()), limits); }

VectorXd clamped(const VectorXd& pressure, const Limits& limits) {
  return pressure.cwiseMax(limits.lower).cwiseMin(limits.upper);
}

Limits scaled(const Limits& limits, const VectorXd& factor) {
  return {limits.lower.cwiseProduct(factor), limits.upper.cwiseProduct(factor)};
}

VectorXd scaled(const VectorXd& pressure, const VectorXd& factor, const Limits& from, const Limits& to) {
  VectorXd result = clamped(pressure.cwiseProduct(factor), to);
  for (Index i = 0; i < pressure.size(); ++i)
    if (pressure[i] == from.lower[i])
      result[i] = to.lower[i];
    else if (pressure[i] == from.upper[i])
      result[i] = to.upper[i];
  return result;
}

double violation(const Limits& limits, Index row, double pressure, double slack) {
  const bool rises = pressure<limits.upper[row], falls = pressure> limits.lower[row];  // whether p may
  if (rises && falls) return std::abs(slack);
  return rises ? -slack : falls ? slack : 0;
}

}  // namespace bracket::contact
