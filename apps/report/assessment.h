// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "bounds/assess.h"

/// The error of a displacement from another program, in the forms in which it is told.
namespace bracket::apps {

/// What was assessed, and what came of it.
template <int dim> struct AssessmentReportOf {
  const scene::Scene<dim>& scene;
  std::string field;                            ///< the file
  const bounds::AssessmentOf<dim>& assessment;  ///< \pre at least one level
};

/// The interval in percent of ‖u_h‖_A, rounded outward, or that there is none, and why. Then, each on a line where
/// there is something to say: that u_x was interpolated, what of it is not admissible, a note on an error above 100 %.
template <int dim> std::string assessment_headline(const AssessmentReportOf<dim>& report);

/// All that follows it on the terminal: what was assessed, the levels, what the interval rests on.
template <int dim> std::string assessment_text(const AssessmentReportOf<dim>& report);

/// assess.json (docs/report.md). A number that is not finite is null.
template <int dim> std::string assessment_json(const AssessmentReportOf<dim>& report);

/// The displacement on the cells that it lives on, each with points of its own, and where it is wrong. Point data:
/// displacement, in the plane (x, y, 0). Cell data: body (index), error_squared (‖σ(u_x) − m‖² of the cell, not below)
/// and error_density (that by its area or volume).
template <int dim> std::string assessment_vtu(const bounds::AssessmentOf<dim>& assessment);

}  // namespace bracket::apps
