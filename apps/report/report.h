// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "apps/report/drawing.h"
#include "bounds/bounds.h"

namespace bracket::apps {

/// Seconds of wall clock around one level, as the command measured them.
struct LevelSeconds {
  double elapsed = 0;  ///< from the start of the command until the level was estimated
  double write = 0;    ///< to write its fields
};

/// The largest von Mises stress of ½ (σ(u_h) + λ_h), whose error has the least bound, on the bodies whose stress across
/// the plane is known: zero in plane stress, ν (σ_xx + σ_yy) in plane strain, not told by a 3 × 3 stiffness. In space
/// it is known of all.
template <int dim> struct LargestVonMisesOf {
  double value = -1;  ///< less than 0: it is known of no body
  scene::Vector<dim> at = scene::Vector<dim>::Zero();
  bool of_all = true;  ///< it is known of all
};
using LargestVonMises = LargestVonMisesOf<2>;

/// What a run has found so far, in the forms in which it is told. Numbers in them read back to the same double.
template <int dim> struct ReportOf {
  const scene::Scene<dim>& scene;
  const bounds::Outcome<dim>& outcome;        ///< \pre at least one level
  std::vector<bounds::ContactState> contact;  ///< as Problem::contact
  LargestVonMisesOf<dim> von_mises;           ///< searched once, as all cells are looked at
  bool running = false;                       ///< more levels may follow
  double read = 0;                            ///< seconds to read the scene file
  std::vector<LevelSeconds> around;           ///< as Outcome::levels
  double pictures = 0;                        ///< seconds to draw them
  std::vector<std::string> missing;           ///< what could not be drawn, and why, one line each
};
using Report = ReportOf<2>;

/// The report of a run that has ended, told by a program of one's own. What has elapsed is the sum of its levels, and
/// nothing was written.
/// \pre at least one level, with fields; scene and outcome outlive the report, which refers to them
template <int dim> ReportOf<dim> report(const scene::Scene<dim>& scene, const bounds::Outcome<dim>& outcome);

/// What a contact is called: its name, or "first side on second side".
template <int dim> std::string pair_name(const scene::ContactPair<dim>& pair);

/// The width of the run's bracket by the larger of its bounds' sizes.
template <int dim> double relative_width(const bounds::Outcome<dim>& outcome);

/// Whether the indicators are together no more than what doubles tell of the energy: where they lie says nothing.
template <int dim> bool error_is_rounding(const bounds::Outcome<dim>& outcome);

/// report.json: the fields of the report, schema 1, in space with "dim" 3. A number that is not finite is null.
template <int dim> std::string report_json(const ReportOf<dim>& report);

/// The heading of report.json, status, exit status and reason of a command that ended without a report.
std::string error_json(scene::Status status, const std::string& reason);

/// quantities.csv: a line of names, then a line per quantity and level it was computed on.
template <int dim> std::string quantities_csv(const ReportOf<dim>& report);

/// history.csv: a line of names, then a line per level.
template <int dim> std::string history_csv(const ReportOf<dim>& report);

/// contact.csv: a line of names, then a line for each number of contacts, supports and bodies, computed or guaranteed.
template <int dim> std::string findings_csv(const ReportOf<dim>& report);

/// What is solved: title, file, plane and units.
template <int dim> std::string scene_text(const scene::Scene<dim>& scene);
/// The lines that are printed level by level: names, then the interval so far (of the goal, where there is one), the
/// guaranteed error and the seconds until then. \pre the last level is new
template <int dim> std::string level_names(const scene::Scene<dim>& scene);
template <int dim> std::string level_line(const ReportOf<dim>& so_far);

/// The answer, every bound rounded outward: how the problem is not quite the scene's, where it is not, each in a line;
/// the guaranteed error; each quantity; the energy. Or that there is no guarantee, and why.
template <int dim> std::string headline(const ReportOf<dim>& report);

/// All that follows the headline on the terminal: contacts, supports, bodies, checks, data, seconds, what was left out.
template <int dim> std::string report_text(const ReportOf<dim>& report);

/// report.html: the same for people, with the pictures, in one file that refers to no other.
template <int dim> std::string report_html(const ReportOf<dim>& report, const std::vector<Drawing>& drawings);

}  // namespace bracket::apps
