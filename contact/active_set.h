// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "contact/contact.h"

namespace bracket::contact {

/// The problem in the multipliers:  min ½ pᵀF p − pᵀw  over  lower ≤ p ≤ upper, Gᵀp = e.
/// With α the multipliers of Gᵀp = e, the slacks g − r are F p − w − G α: ≥ 0 where p is at its lower limit, ≤ 0 at its
/// upper one, 0 between.
struct Interface {
  Eigen::MatrixXd compliance;  ///< F, m × m, symmetric; positive where Gᵀp = 0 and no rows depend on each other
  Eigen::VectorXd overlap;     ///< w, m: the approach that the loads would cause without contact, less the gap
  Eigen::VectorXd size;        ///< m: what w is a difference of, absolute; so its rounding is known
  Eigen::MatrixXd motion;      ///< G, m × k, full column rank
  Eigen::VectorXd load;        ///< e, k
  Limits limits = {};          ///< m
  bool may_depend = false;     ///< rows that depend on each other may be active together: p is of least norm then
};

struct Pressure {
  Termination termination = Termination::solved;  ///< or contradiction; then nothing else is set
  Eigen::VectorXd pressure;                       ///< p, m, within the limits
  Eigen::VectorXd motion;                         ///< α, k
  std::vector<Eigen::Index> active;  ///< rows without slack, independent unless they may depend; others keep their p
  int iterations = 0;
};

/// Makes the problem independent of units and moduli: F has a diagonal of ones, G orthonormal columns. Limits that are
/// left empty are completed.
struct Scaled {
  Interface problem;
  Eigen::VectorXd row;     ///< p = row ∘ (p of `problem`)
  Eigen::MatrixXd motion;  ///< upper triangular T: (α of `problem`) = T α;  e = Tᵀ (e of `problem`)
};
Scaled scaled(const Interface& problem);

/// The minimum over p with given p off `active` and Gᵀp = e, beyond limits or not: there (F p − G α)_A = w_A.
struct Equality {
  Eigen::VectorXd pressure;       ///< p, m
  Eigen::VectorXd motion;         ///< α, k
  Eigen::VectorXd pressure_size;  ///< what these two are sums of, absolute; so their rounding is known: it shows where
  Eigen::VectorXd motion_size;    ///< bodies are stiff and gaps wide, or where a pressure is zero
};

/// That minimum from a Cholesky factor L of (F + G Gᵀ)_AA. With L⁻¹ G_A = Q R and c = L⁻¹ (w_A + G_A e),
///     Lᵀ p_A = c − Q Qᵀ c + Q R⁻ᵀ e,    α = R⁻¹ (R⁻ᵀ e − Qᵀ c):
/// α, which is large where a soft body holds a stiff one, does not enter the pressure. Given p_N leave w − F p_N and
/// e − Gᵀp_N to the rows of A; the two solutions are added, so that what is a sum is known.
struct Held {
  Eigen::MatrixXd parts;                ///< columns: the three terms of Lᵀ p_A, those of each solution
  Eigen::VectorXd motion, motion_size;  ///< α and what it is a sum of, absolute
};
/// \param left L⁻¹ G_A   \param right c   \return nothing where the rows do not resist all motions
std::optional<Held> held(const Eigen::MatrixXd& left, const Eigen::VectorXd& right, const Eigen::VectorXd& load);
Held sum(const Held& a, const Held& b);

/// \param given p, m, zero on the active rows   \param sum, parts L⁻ᵀ times the sum and times each of the parts
Equality equality(const std::vector<Eigen::Index>& active, const Eigen::VectorXd& given, const Held& held,
                  const Eigen::VectorXd& sum, const Eigen::MatrixXd& parts);

/// \param overlap, load taken for w, e   \param given p off `active`, m, zero on it
/// \return nothing where rows of `active` do not resist all motions, or depend on each other and must not
std::optional<Equality> solve_closed(const Interface& problem, const std::vector<Eigen::Index>& active,
                                     const Eigen::VectorXd& overlap, const Eigen::VectorXd& load,
                                     const Eigen::VectorXd& given);

/// F p − w − G α
Eigen::VectorXd slack(const Interface& problem, const Eigen::VectorXd& pressure, const Eigen::VectorXd& motion);
/// How far on the wrong side of zero each slack has to be to count as violated: what rounding may do to it.
Eigen::VectorXd slack_rounding(const Interface& problem, const Equality& minimum);

/// Changes the active set in blocks until it repeats, the semismooth Newton method (Hüeber & Wohlmuth, Comput. Methods
/// Appl. Mech. Engrg. 194 (2005) 3147–3166): an active row goes to the limit that p reaches, a row at a limit becomes
/// active where the slack has the wrong sign. Few steps, but it may fail.
/// \param problem scaled   \param guess rows to start from; the others start with the p nearest to zero, and where this
///     is between the limits the slack of the first step tells to which of them they go
std::optional<Pressure> block_active_set(const Interface& problem, const std::vector<char>& guess);

/// What the rows do hangs on rounding: none holds a rigid motion by more, they depend on each other within it, or the
/// working set does not settle. Bodies too unlike for the precision of a double.
struct HeldByRounding {};

/// Descends from a feasible p, one row at a time; always ends.
/// \param problem scaled   \param start lower ≤ p ≤ upper, Gᵀp = e, with linearly independent rows of G where p is
///     between its limits and not at rest
/// \throw HeldByRounding
Pressure primal_active_set(const Interface& problem, const Eigen::VectorXd& start);

}  // namespace bracket::contact
