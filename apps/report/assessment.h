// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "bounds/assess.h"

/// The error of a displacement from another program, in the forms in which it is told.
namespace bracket::apps {

/// What was assessed, and what came of it.
struct AssessmentReport {
  const scene::Scene<2>& scene;
  std::string field;                     ///< the file
  const bounds::Assessment& assessment;  ///< \pre at least one level
};

/// The interval in percent of ‖u_h‖_A, rounded outward, or that there is none, and why. Then, each on a line where
/// there is something to say: that u_x was interpolated, what of it is not admissible, a note on an error above 100 %.
std::string assessment_headline(const AssessmentReport& report);

/// All that follows it on the terminal: what was assessed, the levels, what the interval rests on.
std::string assessment_text(const AssessmentReport& report);

/// assess.json (docs/report.md). A number that is not finite is null.
std::string assessment_json(const AssessmentReport& report);

/// The displacement on the cells that it lives on, each with points of its own, and where it is wrong. Point data:
/// displacement (x, y, 0). Cell data: body (index), error_squared (‖σ(u_x) − m‖² of the cell, not below) and
/// error_density (that by its area).
std::string assessment_vtu(const bounds::Assessment& assessment);

}  // namespace bracket::apps
