// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "apps/report/report.h"

namespace bracket::apps {

/// What its law is, in words: "without friction".
template <int dim> std::string law_text(const scene::ContactPair<dim>& pair);

/// What a contact pair transmits by λ_h, and what u_h leaves of its gap: computed, not guaranteed.
template <int dim> struct PairSummary {
  double force = 0;  ///< ∫ p
  double largest_pressure = 0;
  scene::Vector<dim> at = scene::Vector<dim>::Zero();  ///< a vertex with that pressure
  /// Why that pressure grows with refinement rather than tends to something: the vertex is an end of the contact line,
  /// or the line turns there and is not declared as an arc; empty: neither.
  std::string grows;
  double length = 0;          ///< of the first side's edges in contact; in space areas of faces, this and the next
  double pressed_length = 0;  ///< of those on which p > 0 somewhere
  double largest_gap = 0;     ///< that u_h leaves
  scene::Vector<dim> gap_at = scene::Vector<dim>::Zero();
  double largest_tension = 0;     ///< −p, of sides that cannot part
  double largest_shortening = 0;  ///< r(u_h) − g, of springs
  double shear = 0;               ///< ∫ τ, with friction; and the largest |v_t(u_h)|
  double largest_slip = 0;
};
template <int dim> PairSummary<dim> summary(const ReportOf<dim>& report, int pair);
/// In space there is neither friction nor are there springs.
template <> PairSummary<2> summary(const Report& report, int pair);
template <> PairSummary<3> summary(const ReportOf<3>& report, int pair);

}  // namespace bracket::apps
