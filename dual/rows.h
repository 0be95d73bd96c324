// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/contact.h"
#include "dual/cells.h"
#include "dual/dual.h"
#include "scene/problem/law.h"

/// Contact as the edge displacements see it (docs/theory.md §4.2, §11).
namespace bracket::dual {

/// ∫ B_i r over a contact facet, or ∫ B_i v_t, for the Bernstein polynomials of its first facet; the multiplier is the
/// coefficient i of p, or of τ. Both sides count displacements along their own outward normal, or tangent: r = u'·n' +
/// u''·n''.
struct RowOf {
  int facet;  ///< index into Problem::contact
  int i;
  bool is_slip;            ///< of v_t
  double of_approach = 1;  ///< how much of r it has,
  double of_slip = 0;      ///< and of v_t
  scene::FacetState state() const { return is_slip ? scene::sticks : scene::touches; }
};
/// degree + 1 rows of each contact facet, then as many of slip for each that has friction. Where shear is bounded by μ
/// p the multipliers are a = μ p + τ and, in place of slip, b = μ p − τ, both ≥ 0: p r + τ v_t = a (r/μ + v_t)/2 + b
/// (r/μ − v_t)/2.
template <int dim> std::vector<RowOf> contact_rows(const scene::Problem<dim>& problem, int degree, Shear shear);

/// Sets contact::System::rows. \param layout lay_out() of the rows' degree
template <int dim>
void set_contact_rows(const scene::Problem<dim>& problem, const Layout& layout, const std::vector<RowOf>& rows,
                      std::vector<contact::System>& bodies);

/// The springs of the contact, if there are any, as one more system: what the pressure shortens them by is ∫ B_i C p
/// (compliance_on()).
template <int dim>
void add_springs(const scene::Problem<dim>& problem, int degree, std::vector<contact::System>& bodies);

/// Between which the multipliers of the rows lie: p ≥ 0, or of either sign where the sides keep together; |τ| not above
/// g_T, coefficient by coefficient.
template <int dim>
contact::Limits limits(const scene::Problem<dim>& problem, int degree, const std::vector<RowOf>& rows);

}  // namespace bracket::dual
