// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/contact.h"

/// What the limits of the multipliers say of single rows. Everywhere below limits are of m rows, none is left empty.
namespace bracket::contact {

/// With those that were left empty. \param rows m
Limits complete(const Limits& limits, Eigen::Index rows);

/// The multipliers nearest to zero.
Eigen::VectorXd at_rest(const Limits& limits);

Eigen::VectorXd clamped(const Eigen::VectorXd& pressure, const Limits& limits);

/// Each limit times the factor of its row. \param factor > 0
Limits scaled(const Limits& limits, const Eigen::VectorXd& factor);

/// Each p times the factor of its row, within `to`; exactly at a limit where it was at that of `from`.
/// \param from, to limits of p and of the result: `to` is `from` times `factor`, or this divided by it, in rounding
Eigen::VectorXd scaled(const Eigen::VectorXd& pressure, const Eigen::VectorXd& factor, const Limits& from,
                       const Limits& to);

/// Whether the limits leave a row one value only.
inline bool is_fixed(const Limits& limits, Eigen::Index row) { return limits.lower[row] == limits.upper[row]; }
inline bool is_between(const Limits& limits, Eigen::Index row, double pressure) {
  return pressure > limits.lower[row] && pressure < limits.upper[row];
}

/// By how much a slack has the wrong sign (≤ 0: it has not): it must be ≥ 0 where p is at its lower limit, ≤ 0 at its
/// upper one, 0 between, and is whatever it is where both are the same.
double violation(const Limits& limits, Eigen::Index row, double pressure, double slack);

/// How far p may go along a direction. \param direction ≠ 0, of the row
inline double room(const Limits& limits, Eigen::Index row, double pressure, double direction) {
  return direction < 0 ? pressure - limits.lower[row] : limits.upper[row] - pressure;
}

}  // namespace bracket::contact
