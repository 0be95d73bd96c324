// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "apps/report/findings.h"
#include "apps/report/json.h"
#include "apps/report/sheet.h"
#include "apps/report/sheet_parts.h"
#include "apps/report/units.h"

namespace bracket::apps {
namespace {

using Json = nlohmann::ordered_json;

Json lines_json(const std::vector<Line>& lines) {
  Json json = Json::array();
  for (const auto& [what, said] : lines) json.push_back({{"what", what}, {"said", said}});
  return json;
}

Json or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

/// \param unit with a blank in front
Json interval_record(double lower, double upper, const std::string& unit) {
  const auto middle = uncertain(lower, upper);
  return {{"unit", or_null(unit.empty() ? unit : unit.substr(1))},
          {"lower", lower},
          {"upper", upper},
          {"value", middle ? Json(middle->value) : Json()},
          {"numerical_uncertainty", middle ? Json(middle->uncertainty) : Json()}};
}

template <int dim> Json problem_record(const ReportOf<dim>& report, const Given& given) {
  Json files = Json::array();
  for (const FileRead& one : given.files) files.push_back({{"file", one.file}, {"sha256", or_null(one.sha256)}});
  Json pairs = Json::array();
  for (const auto& pair : report.scene.contact) pairs.push_back(pair_name(pair));
  Json json = {{"files", files}, {"overrides", given.overrides}, {"mathematical_model", model(report)}};
  if (dim == 2) json["plane"] = name(report.scene.plane);
  json["units"] = report.scene.units;
  json["bodies"] = report.outcome.problem.mesh.bodies;
  json["contacts"] = pairs;
  return json;
}

template <int dim> Json verification_record(const ReportOf<dim>& report) {
  const bounds::Outcome<dim>& outcome = report.outcome;
  Json levels = Json::array();
  for (const bounds::Level& level : outcome.levels)
    levels.push_back({{"cells", level.cells},
                      {"primal_dofs", level.primal.unknowns},
                      {"dual_dofs", level.dual.unknowns},
                      {"lower", level.bracket.lower},
                      {"upper", level.bracket.upper},
                      {"relative_error_bound", level.bracket.relative_error_bound}});
  const auto order = order_of(report);
  return {{"status", name(outcome.status)},
          {"reason", outcome.reason},
          {"guarantee", outcome.guarantee},
          {"certainty", certainty(report)},
          {"method", method(report)},
          {"degree", report.scene.solve.degree},
          {"strategy", name(report.scene.refine.strategy)},
          {"target", report.scene.refine.target},
          {"levels", levels},
          {"observed_order", order ? Json{{"by_cells", order->by_cells}, {"by_size", order->by_size}} : Json()},
          {"formal_order", report.scene.solve.degree},
          {"relative_error_bound", outcome.relative_error_bound}};
}

template <int dim> Json interval_records(const ReportOf<dim>& report) {
  const Units units = units_of(report.scene.units, dim);
  Json all = Json::array();
  for (std::size_t i = 0; i < report.outcome.quantities.size(); ++i) {
    const bounds::QuantityInterval& one = report.outcome.quantities[i];
    Json& json = all.emplace_back(Json{{"name", one.name}, {"kind", name(one.kind)}});
    json.update(interval_record(one.lower, one.upper,
                                one.zone >= 0 ? units.force : unit_of(report.scene.quantities[i], units)));
  }
  all.push_back({{"name", "energy"}, {"kind", "potential energy"}});
  all.back().update(interval_record(report.outcome.lower, report.outcome.upper, units.energy));
  return all;
}

template <int dim> Json all_findings(const ReportOf<dim>& report) {
  Json all = Json::array();
  for (const FindingOf<dim>& one : findings(report)) {
    Json& json = all.emplace_back(Json{{"of", one.of}, {"what", one.key}, {"standing", name(one.standing())}});
    json["computed"] = one.computed;
    json["lower"] = one.bounds ? Json(one.bounds->lower) : Json();
    json["upper"] = one.bounds ? Json(one.bounds->upper) : Json();
    json["unit"] = or_null(one.unit.empty() ? one.unit : one.unit.substr(1));
    json["at"] = one.at ? Json(std::vector<double>(one.at->begin(), one.at->end())) : Json();
    json["note"] = one.note;
  }
  return all;
}

}  // namespace

template <int dim> std::string sheet_json(const ReportOf<dim>& report, const Given& given) {
  Json json = heading(report.scene);
  json["ended"] = or_null(given.ended);
  json["problem"] = problem_record(report, given);
  json["verification_of_the_calculation"] = verification_record(report);
  json["intervals"] = report.outcome.guarantee == "none" ? Json::array() : interval_records(report);
  json["findings"] = all_findings(report);
  json["data_and_geometry"] = {{"data_oscillation", oscillation_json(report.outcome.problem.oscillation)},
                               {"oscillation_energy", report.outcome.levels.back().oscillation_energy},
                               {"loads_changed", report.outcome.problem.imbalance},
                               {"moved", report.scene.curves.empty() ? Json() : Json(report.outcome.moved)},
                               {"said", lines_json(costs(report))}};
  json["outside_of_the_model"] = lines_json(outside<dim>());
  return dump(json);
}

template std::string sheet_json(const ReportOf<2>&, const Given&);
template std::string sheet_json(const ReportOf<3>&, const Given&);

}  // namespace bracket::apps
