// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "apps/report/columns.h"
#include "apps/report/findings.h"
#include "apps/report/lines.h"
#include "apps/report/numbers.h"
#include "apps/report/quantities.h"
#include "apps/report/report.h"
#include "apps/report/units.h"
#include "apps/report/words.h"

namespace bracket::apps {
namespace {

template <int dim> std::string explanation(const ReportOf<dim>& report) {
  if (report.outcome.guarantee == "none")
    return "No bound is printed; the plain values of this run are in report.json.\n";
  std::string text = fmt::format(
      "The exact values lie in these intervals, for sure ({}).\n{}"
      "What the energy is good for: the error follows from it. At least minus the\n"
      "complementary energy of stresses in equilibrium, at most the potential energy\n"
      "of displacements that respect the contact: the root of twice the width bounds\n"
      "the error of either field in the energy norm.\n",
      report.outcome.guarantee,
      report.outcome.guarantee == "tresca-step" ? "Exact are those of friction up to the last step's bound; Coulomb's "
                                                  "own law has\nno energy, and no bounds.\n"
                                                : "");
  if (report.outcome.problem.sampled)
    text += "Some functions are known at points only; what they do between is not in it.\n";
  if (report.outcome.levels.size() > 1)
    text += report.outcome.guarantee == "tresca-step" ? "The interval is that of the last level's friction bound.\n"
            : report.scene.curves.empty()             ? "The interval is the intersection of those of the levels.\n"
                                          : "The interval is that of the last level's polygon, which its arcs are.\n";
  return text;
}

/// What the formulations cost, a row each.
template <int dim> std::string seconds_table(const ReportOf<dim>& report) {
  std::string text = fmt::format("\n{:<15}{:>10}", "Seconds", "unknowns");
  for (const char* name : phase_names) text += fmt::format("{:>10}", name);
  text += "\n";
  const bounds::Level& last = report.outcome.levels.back();
  for (const auto& [name, formulation, unknowns] : {std::tuple("displacements", "primal", last.primal.unknowns),
                                                    std::tuple("stresses", "dual", last.dual.unknowns)}) {
    text += fmt::format("  {:<13}{:>10}", name, unknowns);
    for (const char* phase : phase_names)
      text += fmt::format("{:>10.2f}", sum(fmt::format("{}_{}", formulation, phase), report));
    text += "\n";
  }
  return text + fmt::format(
                    "  ({}); mesh {:.2f}, estimate {:.2f}, certify {:.2f}, quantities {:.2f},\n  write {:.2f}, "
                    "pictures {:.2f}\n",
                    report.scene.solve.dual == scene::Dual::local ? "one after the other" : "side by side",
                    sum("seconds_mesh", report), sum("seconds_estimate", report), sum("seconds_certify", report),
                    sum("seconds_quantities", report), sum("seconds_write", report), report.pictures);
}

/// How the contact was found, and whether that was hard.
template <int dim> std::string iterations_text(const ReportOf<dim>& report) {
  if (report.scene.contact.empty()) return "";
  constexpr int many = 30;
  const bounds::Level& last = report.outcome.levels.back();
  int most = 0;
  for (const bounds::Level& level : report.outcome.levels)
    most = std::max({most, level.primal.iterations, level.dual.iterations});
  std::string text = "\n";
  for (const auto& [name, of] : {std::pair("displacements", &last.primal), std::pair("stresses", &last.dual)})
    text += fmt::format("Contact of the {}: {} of {} rows closed{}\n", name, of->active_rows, of->rows,
                        of->iterations == 0   ? ""  // star by star
                        : of->iterations == 1 ? ", found in one step"
                                              : fmt::format(", found in {} steps", of->iterations));
  // Uzawa's iteration is another one, which takes thousands.
  if (most > many && report.scene.solve.dual == scene::Dual::hybrid)
    text += fmt::format("To find which rows are closed took {} steps on one level, which is many.\n", most);
  return text;
}

/// How far the last of Coulomb's steps is from the law.
template <int dim> std::string friction_text(const ReportOf<dim>& report) {
  if (report.outcome.friction.empty()) return "";
  const std::string unit = units_of(report.scene.units, dim).force;
  std::string text =
      "\nCoulomb's law: the force that the last step presses with near a place of the\ncontact, between bounds, and "
      "the "
      "one that its friction bound assumed\n";
  for (const bounds::FrictionForce& one : report.outcome.friction)
    text += fmt::format("  {} near ({:.5g}, {:.5g})  {}; assumed {:.5g}\n",
                        pair_name(report.scene.contact[one.contact]), one.at[0], one.at[1],
                        interval_text(one.lower, one.upper, unit), (one.assumed_lower + one.assumed_upper) / 2);
  return text;
}

std::string checks_text(const bounds::Checks& checks) {
  std::string text =
      "\nChecks of the fields as computed, before the certificate (by the largest stress\nor displacement)\n";
  for (const bounds::Check& check : checks.all())
    text += fmt::format("{:>5} {:<17}{:>8.1e} {}\n", check.value <= bounds::Checks::tolerance ? "ok" : "LARGE",
                        check.name, check.value, check.meaning);
  return text;
}

template <int dim> std::string data_text(const ReportOf<dim>& report) {
  const scene::Oscillation& data = report.outcome.problem.oscillation;
  const bounds::Level& last = report.outcome.levels.back();
  constexpr double rounding = 1e-13;
  std::string changed;
  if (const double part = report.outcome.problem.imbalance; part > 0)
    changed = fmt::format("Loads: changed by {} of the largest, so that a body that nothing holds is in balance.\n",
                          rounded_up_exponent(part));
  if (std::max({data.traction, data.displacement, data.gap}) < rounding)
    return "\nData: the given functions are carried exactly.\n" + changed;
  return fmt::format(
             "\nData: fixed {0} by {0}, which moved tractions by {1:.1e}, displacements by {2:.1e} and gaps by "
             "{3:.1e} of their\n"
             "      largest values, and the energy by about {4:.1e}. The bounds hold for the fixed data.\n",
             Words<dim>::facet, data.traction, data.displacement, data.gap, last.oscillation_energy) +
         changed;
}

template <int dim> std::string error_text(const bounds::Outcome<dim>& outcome) {
  if (outcome.unstrained && outcome.lower < outcome.upper)
    return "nothing is strained, but for the rounding of the data";
  return fmt::format("≤ {}   of displacements and stresses (energy norm)", percent(outcome.relative_error_bound));
}

/// Of the problem that the bounds hold for, where it is not quite the scene's, a line each.
template <int dim> std::string what_else(const ReportOf<dim>& report) {
  const bounds::Outcome<dim>& outcome = report.outcome;
  const std::string energy_unit = units_of(report.scene.units, dim).energy;
  std::string text;
  if (!report.scene.curves.empty())
    text += "! of the last mesh's polygon" +
            (std::isfinite(outcome.moved) ? ", whose energy moved by " + rounded_up_exponent(outcome.moved) +
                                                energy_unit + " from the one before"
                                          : std::string()) +
            "\n";
  if (outcome.guarantee == "tresca-step") {
    const bounds::FrictionSteps& friction = outcome.levels.back().friction;
    text += fmt::format("! for the friction bound of the last step; Coulomb's residual is {}{}\n",
                        rounded_up_exponent(friction.residual), energy_unit);
  }
  const double changed = outcome.problem.imbalance;
  // To first order the energy moves by twice the part by which the loads do.
  if (2 * changed > relative_width(outcome))
    text += fmt::format("! loads changed by {} to balance\n", rounded_up_exponent(changed));
  if (outcome.guarantee != "none" && outcome.problem.sampled) text += "! for data that were sampled\n";
  const bounds::Level& last = outcome.levels.back();
  if (last.oscillation_energy > outcome.upper - outcome.lower)
    text += fmt::format("! for the data of '{}' as the first mesh has them, which is {} off\n", last.oscillation_part,
                        std::isfinite(last.oscillation_energy)
                            ? "an energy of about " + rounded_up_exponent(last.oscillation_energy) + energy_unit
                            : "no bounded energy");
  return text;
}

/// What is narrowed level by level: a goal's interval or the energy's.
template <int dim> const bounds::QuantityInterval* goal(const ReportOf<dim>& report) {
  const auto found =
      std::ranges::find(report.outcome.quantities, report.scene.refine.goal, &bounds::QuantityInterval::name);
  return report.scene.refine.goal.empty() || found == report.outcome.quantities.end() ? nullptr : &*found;
}

constexpr const char* level_format = "{:>5}{:>9}{:>11}  {}{:>8}\n";
constexpr std::size_t interval_columns = 45;

}  // namespace

template <int dim> std::string scene_text(const scene::Scene<dim>& scene) {
  return within_columns((scene.title.empty() ? "" : scene.title + "\n") +
                        fmt::format("Scene: {}; {}{}\n", scene.file, setting_of(scene),
                                    scene.units.empty() ? "" : "; units " + scene.units));
}

template <int dim> std::string level_names(const scene::Scene<dim>& scene) {
  const std::string narrowed = scene.refine.goal.empty() ? "energy" : scene.refine.goal;
  return fmt::format(level_format, "level", "cells", "error", padded(narrowed + " so far", interval_columns),
                     "seconds");
}

template <int dim> std::string level_line(const ReportOf<dim>& so_far) {
  const bounds::Outcome<dim>& outcome = so_far.outcome;
  const bounds::QuantityInterval* const asked = goal(so_far);
  const double lower = asked ? asked->lower : outcome.lower, upper = asked ? asked->upper : outcome.upper;
  const bool known = std::isfinite(lower) || std::isfinite(upper);
  return fmt::format(level_format, outcome.levels.size() - 1, outcome.levels.back().cells,
                     percent(outcome.relative_error_bound),
                     padded(known ? interval_text(lower, upper, "") : "-", interval_columns),
                     fmt::format("{:.2f}", so_far.around.back().elapsed));
}

template <int dim> std::string headline(const ReportOf<dim>& report) {
  const bounds::Outcome<dim>& outcome = report.outcome;
  if (outcome.guarantee == "none") return within_columns(fmt::format("no guaranteed bounds: {}\n", outcome.reason));
  const std::string error = "guaranteed error";
  std::size_t columns = error.size();
  for (const auto& interval : outcome.quantities)
    if (interval.zone < 0) columns = std::max(columns, columns_of(interval.name));
  const char* const sure = mark(Standing::guaranteed);
  return within_columns(
      what_else(report) + fmt::format("{} {}  {}\n", sure, padded(error, columns), error_text(outcome)) +
      quantity_lines(report, columns) +
      fmt::format("{} {}  {}\n", sure, padded("energy", columns), told_energy(report, outcome.lower, outcome.upper)));
}

template <int dim> std::string report_text(const ReportOf<dim>& report) {
  const bounds::Outcome<dim>& outcome = report.outcome;
  std::string text = "\n" + explanation(report) + findings_text(report) + friction_text(report) +
                     iterations_text(report) + checks_text(outcome.levels.back().checks) + data_text(report) +
                     seconds_table(report);
  if (error_is_rounding(outcome)) text += "The error is rounding: there is no picture of where it is.\n";
  if (outcome.status == scene::Status::budget) text += fmt::format("Budget: {}\n", outcome.reason);
  if (!outcome.skipped.empty()) text += fmt::format("Not needed: {}.\n", fmt::join(outcome.skipped, "; "));
  return within_columns(text);
}

template std::string scene_text(const scene::Scene<2>&);
template std::string level_names(const scene::Scene<2>&);
template std::string level_line(const ReportOf<2>&);
template std::string headline(const ReportOf<2>&);
template std::string report_text(const ReportOf<2>&);
template std::string scene_text(const scene::Scene<3>&);
template std::string level_names(const scene::Scene<3>&);
template std::string level_line(const ReportOf<3>&);
template std::string headline(const ReportOf<3>&);
template std::string report_text(const ReportOf<3>&);

}  // namespace bracket::apps
