// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/report/report.h"

/// What a run has found of contacts, supports and bodies: plain rows, which terminal, JSON, CSV and HTML render.
namespace bracket::apps {

enum class Standing { guaranteed, computed };
/// How numbers are told apart: "● guaranteed" lie in their interval for sure, "○ computed" are those of the fields of
/// the last level, which are near the exact ones in the energy norm and nothing more.
const char* mark(Standing standing);
const char* name(Standing standing);

enum class Subject { contact, support, bodies };

struct Between {
  double lower, upper;
};

template <int dim> struct FindingOf {
  Subject subject = Subject::bodies;
  int contact = -1;     ///< of a contact: index into Scene::contact
  std::string of;       ///< the contact's sides, the support's part; empty: all bodies
  std::string key;      ///< what it is, as files have it: "largest_pressure"
  double computed = 0;  ///< of the fields; not a number: nothing was computed
  std::string unit;     ///< with a blank in front; empty: not known
  /// In which the exact value lies, where that is known; then people are shown it in place of what was computed.
  std::optional<Between> bounds = {};
  std::optional<scene::Vector<dim>> at = {};  ///< where it is so large
  std::string note = {};
  double rounding = 0;  ///< what was computed is 0 but for rounding up to this size: then people are shown 0

  Standing standing() const { return bounds ? Standing::guaranteed : Standing::computed; }
};
using Finding = FindingOf<2>;

/// Of each contact: force (by λ_h; with bounds where the scene asks for it), length, pressed length, mean and largest
/// pressure, as its law has it the largest tension, the shortening of springs, shear force and slip, the largest
/// penetration (0: the displacement of the upper bound has none), largest gap, what its open part
/// carries, the forces of its zones. Of each support the reaction of λ_h. Of all bodies the largest displacement u_h at
/// a node, and the largest von Mises stress of ½ (σ(u_h) + λ_h), left out where the stress across the plane is not
/// known. In space lengths along a contact are areas, and its resultant is told as well: what acts on the body of the
/// first side.
template <int dim> std::vector<FindingOf<dim>> findings(const ReportOf<dim>& report);

/// What a finding is, in words: "largest pressure".
template <int dim> std::string what(const FindingOf<dim>& finding);

/// Of which contact, support or bodies it is.
template <int dim> std::string of_what(const FindingOf<dim>& finding);
/// Its bounds or else what was computed, its place and note. \param length the unit of places, with a blank in front
template <int dim> std::string value_with_place(const FindingOf<dim>& finding, const std::string& length);

/// Lines for a terminal, by contact, support and bodies.
template <int dim> std::string findings_text(const ReportOf<dim>& report);
/// A heading and a table; each cell escaped.
template <int dim> std::string findings_html(const ReportOf<dim>& report);

}  // namespace bracket::apps
