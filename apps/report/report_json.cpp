// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <bracket/version.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "apps/report/columns.h"
#include "apps/report/findings.h"
#include "apps/report/json.h"
#include "apps/report/pairs.h"
#include "apps/report/quantities.h"
#include "apps/report/shares.h"
#include "apps/report/von_mises.h"
#include "apps/report/words.h"
#include "bounds/certificate/open_contact.h"

namespace bracket::apps {
namespace {

using Json = nlohmann::ordered_json;

Json checks_json(const bounds::Checks& checks, const scene::Oscillation& oscillation) {
  Json json = {{"tolerance", bounds::Checks::tolerance}};
  for (const bounds::Check& check : checks.all()) {
    std::string key = check.name;
    std::ranges::replace(key, ' ', '_');
    json[key] = check.value;
  }
  json["data_oscillation"] = oscillation_json(oscillation);
  return json;
}

/// The energies as they were computed, before the certificate.
Json plain_json(const bounds::Level& level) { return {{"lower", level.plain.lower}, {"upper", level.plain.upper}}; }

}  // namespace

std::string name(scene::Status status) {
  switch (status) {
    case scene::Status::done: return "done";
    case scene::Status::internal: return "internal_error";
    case scene::Status::input: return "input_error";
    case scene::Status::mesh: return "mesh_error";
    case scene::Status::ill_posed: return "ill_posed";
    case scene::Status::budget: return "budget_spent";
    case scene::Status::not_guaranteed: return "not_guaranteed";
  }
  return {};
}

Json heading() { return {{"schema", 1}, {"generator", "bracket"}, {"version", BRACKET_VERSION_STRING}}; }

template <int dim> Json heading(const scene::Scene<dim>& scene) {
  Json json = heading();
  if (dim == 3) json["dim"] = dim;
  json["title"] = scene.title;
  json["scene"] = scene.file;
  return json;
}

template <int dim> Json quality_json(const scene::Mesh<dim>& mesh) {
  const scene::Quality quality = scene::quality(mesh);
  Json json = {{"smallest_angle", quality.smallest_angle},
               {"largest_angle", quality.largest_angle},
               {fmt::format("smallest_{}", Words<dim>::size), quality.smallest_area},
               {fmt::format("largest_{}", Words<dim>::size), quality.largest_area}};
  if (dim == 3) json["smallest_shape"] = quality.smallest_shape;
  return json;
}

Json oscillation_json(const scene::Oscillation& oscillation) {
  return {{"traction", oscillation.traction}, {"displacement", oscillation.displacement}, {"gap", oscillation.gap}};
}

std::string dump(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string error_json(scene::Status status, const std::string& reason) {
  Json json = heading();
  json["status"] = name(status);
  json["exit_status"] = static_cast<int>(status);
  json["reason"] = reason;
  return dump(json);
}

Json level_json(const bounds::Level& level, const LevelSeconds& around) {
  Json json;
  for (const Column& column : columns())
    std::visit([&](auto number) { json[Json::json_pointer(column.path)] = number; }, column.value(level, around));
  if (level.friction.steps > 0)
    json["friction"] = {
        {"steps", level.friction.steps}, {"residual", level.friction.residual}, {"settled", level.friction.settled}};
  return json;
}

template <int dim> ReportOf<dim> report(const scene::Scene<dim>& scene, const bounds::Outcome<dim>& outcome) {
  ReportOf<dim> report{.scene = scene,
                       .outcome = outcome,
                       .contact = bounds::contact_state(outcome.problem, outcome.displacement, outcome.stress),
                       .von_mises = largest_von_mises(outcome, scene.plane),
                       .around = {},
                       .missing = {}};
  double elapsed = 0;
  for (const bounds::Level& level : outcome.levels)
    report.around.push_back({.elapsed = elapsed += level.seconds.total});
  return report;
}

template <int dim> double relative_width(const bounds::Outcome<dim>& outcome) {
  const double size = std::max(std::abs(outcome.lower), std::abs(outcome.upper));
  return size > 0 ? (outcome.upper - outcome.lower) / size : 0;
}

template <int dim> Json share_json(const ReportOf<dim>& report, std::size_t quantity) {
  const auto known = share(report, quantity);
  return known ? Json{{"lower", known->lower}, {"upper", known->upper}} : Json();
}

template <int dim> bool error_is_rounding(const bounds::Outcome<dim>& outcome) {
  const double energy = std::max(std::abs(outcome.lower), std::abs(outcome.upper));
  return outcome.guarantee != "none" && outcome.indicator.sum <= std::numeric_limits<double>::epsilon() * energy;
}

template <int dim> Json quantities_json(const ReportOf<dim>& report) {
  Json quantities = Json::array();
  for (std::size_t i = 0; i < report.outcome.quantities.size(); ++i) {
    const bounds::QuantityInterval& one = report.outcome.quantities[i];
    if (one.zone >= 0) continue;
    Json levels = Json::array();
    for (const bounds::QuantityLevel& level : one.levels)
      levels.push_back({{"cells", level.cells},
                        {"lower", level.lower},
                        {"upper", level.upper},
                        {"s", level.s},
                        {"seconds", level.seconds}});
    quantities.push_back({{"name", one.name},
                          {"kind", name(one.kind)},
                          {"weighted", one.weighted},
                          {"lower", one.lower},
                          {"upper", one.upper},
                          {"relative_width", one.relative_width},
                          {"share", share_json(report, i)},
                          {"target_reached", one.target_reached},
                          {"reason", one.reason},
                          {"levels", levels}});
  }
  return quantities;
}

template <int dim> Json friction_json(const ReportOf<dim>& report) {
  Json all = Json::array();
  for (const bounds::FrictionForce& one : report.outcome.friction)
    all.push_back({{"contact", pair_name(report.scene.contact[one.contact])},
                   {"at", {one.at[0], one.at[1]}},
                   {"lower", one.lower},
                   {"upper", one.upper},
                   {"assumed_lower", one.assumed_lower},
                   {"assumed_upper", one.assumed_upper}});
  return all;
}

/// The forces of a contact's zones.
template <int dim> Json zones_json(const ReportOf<dim>& report, int contact) {
  Json zones = Json::array();
  for (std::size_t i = 0; i < report.outcome.quantities.size(); ++i)
    if (const auto& one = report.outcome.quantities[i]; one.contact == contact && one.zone >= 0)
      zones.push_back(
          {{"lower", one.lower}, {"upper", one.upper}, {"share", share_json(report, i)}, {"reason", one.reason}});
  return zones;
}

/// What was computed of one of the rows' subjects by its key, with its bounds where there are some, and where it is.
template <int dim> void put(Json& json, const FindingOf<dim>& row) {
  if (!std::isfinite(row.computed)) return;
  json[row.key] = row.computed;
  if (row.bounds) json[row.key + "_bounds"] = {{"lower", row.bounds->lower}, {"upper", row.bounds->upper}};
  if (row.at) json[row.key + "_at"] = std::vector<double>(row.at->begin(), row.at->end());
}

template <int dim> Json contact_json(const ReportOf<dim>& report, const std::vector<FindingOf<dim>>& rows) {
  Json pairs = Json::array();
  for (int i = 0; i < static_cast<int>(report.scene.contact.size()); ++i) {
    const PairSummary<dim> of = summary(report, i);
    Json& pair = pairs.emplace_back(Json{{"name", report.scene.contact[i].name},
                                         {"first", name(report.scene.contact[i].first)},
                                         {"second", name(report.scene.contact[i].second)},
                                         {"law", name(report.scene.contact[i].law)}});
    for (const FindingOf<dim>& row : rows)
      if (row.contact == i) put(pair, row);
    pair["at"] = std::vector<double>(of.at.begin(), of.at.end());
    pair["grows"] = of.grows;
    if (report.outcome.guarantee != "none" && !report.running) {
      const auto open = bounds::open_contact(report.outcome.problem, report.outcome.displacement,
                                             report.outcome.levels.back().certificate, i);
      pair["open"] = {{Words<dim>::measure, open.length}, {"gap", open.gap}, {"force_at_most", open.force}};
    }
    if (report.scene.contact[i].zones > 0) pair["zones"] = zones_json(report, i);
  }
  return pairs;
}

template <int dim> Json supports_json(const std::vector<FindingOf<dim>>& rows) {
  Json supports = Json::array();
  for (const FindingOf<dim>& row : rows) {
    if (row.subject != Subject::support) continue;
    if (supports.empty() || supports.back()["part"] != row.of) supports.push_back({{"part", row.of}});
    put(supports.back(), row);
  }
  return supports;
}

template <int dim> Json bodies_json(const std::vector<FindingOf<dim>>& rows) {
  Json json;
  for (const FindingOf<dim>& row : rows)
    if (row.subject == Subject::bodies) put(json, row);
  return json;
}

template <int dim> std::string report_json(const ReportOf<dim>& report) {
  const bounds::Outcome<dim>& outcome = report.outcome;
  const bounds::Level& last = outcome.levels.back();
  const std::vector<FindingOf<dim>> rows = findings(report);
  Json levels = Json::array();
  for (std::size_t i = 0; i < outcome.levels.size(); ++i)
    levels.push_back(level_json(outcome.levels[i], report.around[i]));
  Json json = heading(report.scene);
  json["units"] = report.scene.units;
  if (dim == 2) json["plane"] = name(report.scene.plane);
  const Json found = {{"degree", report.scene.solve.degree},
                      {"dual", name(report.scene.solve.dual)},
                      {"guarantee", outcome.guarantee},
                      {"status", report.running ? "running" : name(outcome.status)},
                      {"reason", outcome.reason},
                      {"energy", {{"lower", outcome.lower}, {"upper", outcome.upper}}},
                      {"plain", plain_json(last)},
                      {"relative_width", relative_width(outcome)},
                      {"relative_error_bound", outcome.relative_error_bound},
                      {"error_bound", std::sqrt(2 * std::max(0.0, outcome.upper - outcome.lower))},
                      {"mean_stress_error_bound", last.bracket.mean_stress_error_bound},
                      {"oscillation_energy", last.oscillation_energy},
                      {"oscillation_part", last.oscillation_part},
                      {"levels", levels},
                      {"quantities", quantities_json(report)},
                      {"checks", checks_json(last.checks, outcome.problem.oscillation)},
                      {"contact", contact_json(report, rows)},
                      {"supports", supports_json(rows)},
                      {"bodies", bodies_json(rows)},
                      {"loads_changed", outcome.problem.imbalance},
                      {"quality", quality_json(outcome.problem.mesh)},
                      {"seconds", {{"read", report.read}, {"pictures", report.pictures}}},
                      {"skipped", outcome.skipped},
                      {"missing", report.missing},
                      {"notes", outcome.problem.mesh.notes}};
  json.update(found);
  if (!report.scene.curves.empty()) json["moved"] = outcome.moved;
  if (!outcome.friction.empty()) json["friction"] = friction_json(report);
  return dump(json);
}

template <int dim> std::string history_csv(const ReportOf<dim>& report) {
  std::string text = "level," + csv_names() + "\n";
  for (std::size_t i = 0; i < report.outcome.levels.size(); ++i)
    text += fmt::format("{},{}\n", i, csv_values(report.outcome.levels[i], report.around[i]));
  return text;
}

template Json heading(const scene::Scene<2>&);
template Json quality_json(const scene::Mesh<2>&);
template ReportOf<2> report(const scene::Scene<2>&, const bounds::Outcome<2>&);
template double relative_width(const bounds::Outcome<2>&);
template bool error_is_rounding(const bounds::Outcome<2>&);
template std::string report_json(const ReportOf<2>&);
template std::string history_csv(const ReportOf<2>&);
template Json heading(const scene::Scene<3>&);
template Json quality_json(const scene::Mesh<3>&);
template ReportOf<3> report(const scene::Scene<3>&, const bounds::Outcome<3>&);
template double relative_width(const bounds::Outcome<3>&);
template bool error_is_rounding(const bounds::Outcome<3>&);
template std::string report_json(const ReportOf<3>&);
template std::string history_csv(const ReportOf<3>&);

}  // namespace bracket::apps
