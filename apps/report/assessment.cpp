// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/assessment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/report/findings.h"
#include "apps/report/json.h"
#include "apps/report/lines.h"
#include "apps/report/numbers.h"
#include "apps/report/quantities.h"
#include "apps/report/units.h"
#include "apps/report/words.h"

namespace bracket::apps {
namespace {

using bounds::ErrorInterval;
using Json = nlohmann::ordered_json;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// In percent, outward: the product is rounded.
ErrorInterval in_percent(const ErrorInterval& ratio) {
  const auto percent = [](double x, double towards) { return x == 0 ? 0 : std::nextafter(100 * x, towards); };
  return {percent(ratio.lower, 0), percent(ratio.upper, infinity)};
}

/// The error between its bounds; where the lower one is zero it says nothing.
std::string between(const ErrorInterval& interval, const std::string& unit) {
  const double lower = interval.lower == 0 ? -infinity : interval.lower;
  return std::isfinite(lower) || std::isfinite(interval.upper) ? interval_text(lower, interval.upper, unit) : "unknown";
}

template <int dim> std::string cells_of(const AssessmentReportOf<dim>& report) {
  const scene::FieldOnSceneOf<dim>& field = report.assessment.field;
  const std::string refined =
      field.refinements == 0 ? ""
                             : fmt::format(", refined {} time{}", field.refinements, field.refinements == 1 ? "" : "s");
  return fmt::format("{} {} {} of the scene's mesh{}", field.problem.mesh.cells.size(),
                     field.given.displacement.degree == 2 ? "quadratic" : "linear", Words<dim>::cells, refined);
}

/// What is not admissible: all of it counts as error.
template <int dim> std::string inadmissible(const AssessmentReportOf<dim>& report) {
  const bounds::AssessmentOf<dim>& of = report.assessment;
  const std::string unit = units_of(report.scene.units, dim).length;
  const double rounding = std::numeric_limits<double>::epsilon() * of.largest;
  const auto share = [&](double length, const char* whole) {
    return of.largest > 0 ? fmt::format("{} of {}", rounded_up_exponent(length / of.largest), whole)
                          : rounded_up_exponent(length) + unit;
  };
  constexpr const char* largest = "its largest displacement";
  std::string text;
  if (of.misfit > rounding) text = fmt::format("misses what supports prescribe by up to {}", share(of.misfit, largest));
  if (of.penetration > rounding)
    text += fmt::format("{}penetrates the contact by up to {}", text.empty() ? "" : ", and ",
                        share(of.penetration, text.empty() ? largest : "that"));
  return text.empty() ? "" : "not admissible: it " + text + "; that counts as error\n";
}

/// Of the problem that the bounds hold for, where it is not quite the scene's, a line each.
template <int dim> std::string what_else(const AssessmentReportOf<dim>& report) {
  const bounds::AssessmentOf<dim>& of = report.assessment;
  std::string text;
  if (of.guarantee == "discretisation") text += "! for data that were sampled\n";
  // An energy that differs by this much belongs to solutions that are √2 of it apart.
  if (std::sqrt(2 * of.data_energy) > of.error.upper - of.error.lower)
    text += fmt::format("! for the data as the displacement's mesh has them, which is {} off\n",
                        std::isfinite(of.data_energy) ? "an energy of about " + rounded_up_exponent(of.data_energy) +
                                                            units_of(report.scene.units, dim).energy
                                                      : "no bounded energy");
  return text;
}

template <int dim> std::string level_table(const AssessmentReportOf<dim>& report) {
  const bounds::AssessmentOf<dim>& of = report.assessment;
  const std::string unit = units_of(report.scene.units, dim).energy_norm;
  const auto& [norm_lower, norm_upper] = std::pair(of.levels.back().norm_lower, of.levels.back().norm_upper);
  const bool relative = norm_lower > 0;
  const auto told = [&](const ErrorInterval& interval) -> std::string {
    if (!std::isfinite(interval.upper)) return "-";
    const ErrorInterval shown =
        relative ? in_percent({interval.lower / norm_upper, interval.upper / norm_lower}) : interval;
    return interval_text(shown.lower, shown.upper, "");
  };
  constexpr const char* format = "{:>8}  {}  {}{:>12}{:>8}\n";
  constexpr std::size_t columns = 24;
  std::string text = fmt::format(format, "cells", padded("by stresses", columns),
                                 padded("by energies and contact", columns), "mean stress", "seconds");
  for (const auto& level : of.levels)
    text +=
        fmt::format(format, level.cells, padded(told(level.by_stress), columns), padded(told(level.by_energy), columns),
                    fmt::format("{:.3g}", level.stress_error), fmt::format("{:.2f}", level.seconds));
  return text +
         fmt::format("(errors between bounds{}; the error of Bracket's mean stress is at most the fourth number{})\n",
                     relative ? " in % of the last level's norm" : (unit.empty() ? "" : ", in" + unit),
                     unit.empty() ? "" : ", in" + unit);
}

Json interval_json(const ErrorInterval& interval) {
  return {{"lower", interval.lower}, {"upper", std::isfinite(interval.upper) ? Json(interval.upper) : Json(nullptr)}};
}

}  // namespace

template <int dim> std::string assessment_headline(const AssessmentReportOf<dim>& report) {
  const bounds::AssessmentOf<dim>& of = report.assessment;
  if (of.guarantee == "none") return within_columns(fmt::format("no guaranteed bounds: {}\n", of.reason));
  const bool relative = std::isfinite(of.relative.lower);
  std::string text =
      what_else(report) + fmt::format("{} guaranteed error of the displacement  {}   (energy norm)\n",
                                      mark(Standing::guaranteed),
                                      relative ? between(in_percent(of.relative), " %")
                                               : between(of.error, units_of(report.scene.units, dim).energy_norm) +
                                                     ", where nothing else is strained");
  if (of.field.given.interpolated)
    text += fmt::format("interpolated: {} is of another mesh; what is judged has its values at the nodes of {}\n",
                        report.field, cells_of(report));
  text += inadmissible(report);
  if (of.relative.lower > 1)
    text += fmt::format(
        "note: above 100 %, zero would be no worse: are signs, units and moduli{}, supports and "
        "loads those of the scene?\n",
        dim == 2 ? ", plane stress or strain" : "");
  return within_columns(text);
}

template <int dim> std::string assessment_text(const AssessmentReportOf<dim>& report) {
  const bounds::AssessmentOf<dim>& of = report.assessment;
  std::string text = report.scene.title.empty() ? "\n" : fmt::format("\n{}\n", report.scene.title);
  text +=
      fmt::format("Scene: {}; {}{}\nDisplacement: {}, on {}\n", report.scene.file, setting_of(report.scene),
                  report.scene.units.empty() ? "" : "; units " + report.scene.units, report.field, cells_of(report));
  if (of.guarantee != "none")
    text += fmt::format(
        "The energy norm is the root of twice the strain energy; 100 % is that of\nBracket's own displacement. The "
        "error itself is {}. Guarantee: {}.\n\n{}",
        between(of.error, units_of(report.scene.units, dim).energy_norm), of.guarantee, level_table(report));
  if (of.status == scene::Status::budget) text += fmt::format("Budget: {}\n", of.reason);
  return within_columns(text);
}

template <int dim> std::string assessment_json(const AssessmentReportOf<dim>& report) {
  const bounds::AssessmentOf<dim>& of = report.assessment;
  const scene::GivenDisplacementOf<dim>& given = of.field.given;
  Json json = heading(report.scene);
  json["units"] = report.scene.units;
  json["displacement"] = {{"file", report.field},
                          {"degree", given.displacement.degree},
                          {"cells", of.field.problem.mesh.cells.size()},
                          {"refinements", of.field.refinements},
                          {"interpolated", given.interpolated},
                          {"off", given.off},
                          {"largest", of.largest},
                          {"misfit", of.misfit},
                          {"penetration", of.penetration}};
  json["status"] = name(of.status);
  json["exit_status"] = static_cast<int>(of.status);
  json["reason"] = of.reason;
  json["guarantee"] = of.guarantee;
  json["error"] = interval_json(of.error);
  json["relative_error"] = interval_json(of.relative);
  json["data_energy"] = of.data_energy;
  json["levels"] = Json::array();
  for (const auto& level : of.levels)
    json["levels"].push_back({{"cells", level.cells},
                              {"by_stress", interval_json(level.by_stress)},
                              {"by_energy", interval_json(level.by_energy)},
                              {"mean_stress_error_bound", level.stress_error},
                              {"norm", interval_json({level.norm_lower, level.norm_upper})},
                              {"seconds", level.seconds}});
  return dump(json);
}

#define INSTANTIATE(dim)                                                    \
  template std::string assessment_headline(const AssessmentReportOf<dim>&); \
  template std::string assessment_text(const AssessmentReportOf<dim>&);     \
  template std::string assessment_json(const AssessmentReportOf<dim>&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::apps
