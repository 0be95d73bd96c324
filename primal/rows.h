// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

#include "primal/nodes.h"

namespace bracket::primal {

/// A contact row Σ coefficient · q ≤ bound, one Bernstein coefficient of r and g; or of the slip v_t and of what
/// friction does not see of it (ContactFacet::slip). Limits of its multiplier say what it does: p ≥ 0, of either sign
/// where the sides keep together, |τ| ≤ ∫ g_T B_i where they rub.
struct Row {
  struct Entry {
    int body, unknown;
    double coefficient;
    bool operator==(const Entry&) const = default;
  };
  std::vector<Entry> entries;
  double bound;
  double size;  ///< of what `bound` is a difference of, absolute
  int facet;    ///< a contact facet that it belongs to, index into Problem::contact
  double lower = 0, upper = std::numeric_limits<double>::infinity();  ///< limits of the multiplier
  int spring = -1;       ///< which unknown of the springs, their shortening s, is taken off it; −1: none
  bool is_slip = false;  ///< of v_t
};

/// Rows that make r ≤ g on all of Γ_K, or r = g: the Bernstein coefficients of r on each facet are bounded by those of
/// g, at vertices and, in space, edges once for each distinct normal that meets there. Rows without unknowns are
/// checked and dropped. On facets with springs the coefficients of r − s are, of each facet by itself; and v_t has rows
/// where there is friction. \param any_gap the rows that some gap needs, whatever that of the problem is: linear
/// displacements meet the middle
///     coefficients of most gaps by themselves
/// \throw scene::Error (ill_posed) if such a row is violated
template <int dim>
std::vector<Row> contact_rows(const scene::Problem<dim>& problem, const Nodes<dim>& nodes, bool any_gap = false);
template <> std::vector<Row> contact_rows(const scene::Problem<2>& problem, const Nodes<2>& nodes, bool any_gap);
template <> std::vector<Row> contact_rows(const scene::Problem<3>& problem, const Nodes<3>& nodes, bool any_gap);

/// The degree of the springs' shortening: that of r − g.
inline int spring_degree(int degree) { return std::max(2, degree); }

}  // namespace bracket::primal
