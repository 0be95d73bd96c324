// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <bracket/version.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/report/json.h"
#include "apps/report/numbers.h"

namespace bracket::apps {
namespace {

using Json = nlohmann::ordered_json;

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

Json phases(const Phases& seconds) {
  Json json;
  for (std::size_t i = 0; i < seconds.size(); ++i) json[phase_names[i]] = seconds[i];
  return json;
}

Json interface_problem(int rows, int active, int iterations) {
  return {{"rows", rows}, {"active", active}, {"iterations", iterations}};
}

Json checks_json(const bounds::Checks& checks, const scene::Oscillation& oscillation) {
  return {{"tolerance", bounds::Checks::tolerance},
          {"penetration", checks.penetration},
          {"equilibrium", checks.equilibrium},
          {"interface_jump", checks.interface_jump},
          {"boundary_traction", checks.boundary_traction},
          {"tension", checks.tension},
          {"gap_identity", checks.gap_identity},
          {"data_oscillation",
           {{"traction", oscillation.traction}, {"displacement", oscillation.displacement}, {"gap", oscillation.gap}}}};
}

Json quality_json(const scene::Mesh<2>& mesh) {
  const scene::Quality quality = scene::quality(mesh);
  return {{"smallest_angle", quality.smallest_angle},
          {"largest_angle", quality.largest_angle},
          {"smallest_area", quality.smallest_area},
          {"largest_area", quality.largest_area}};
}

/// The energies as they were computed, before the certificate.
Json plain_json(const bounds::Level& level) { return {{"lower", level.plain.lower}, {"upper", level.plain.upper}}; }

}  // namespace

Json heading() { return {{"schema", 1}, {"generator", "bracket"}, {"version", BRACKET_VERSION_STRING}}; }

Json heading(const scene::Scene<2>& scene) {
  Json json = heading();
  json["title"] = scene.title;
  json["scene"] = scene.file;
  return json;
}

Json level_json(const bounds::Level& level, const LevelSeconds& around) {
  const bounds::Seconds& seconds = level.seconds;
  Json contact = interface_problem(level.primal.rows, level.primal.active_rows, level.primal.iterations);
  contact["dual"] = interface_problem(level.dual.rows, level.dual.active_rows, level.dual.iterations);
  return {{"cells", level.cells},
          {"primal_dofs", level.primal.unknowns},
          {"dual_dofs", level.dual.unknowns},
          {"lower", level.bracket.lower},
          {"upper", level.bracket.upper},
          {"relative_width", level.bracket.relative_width},
          {"error_bound", level.bracket.error_bound},
          {"mean_stress_error_bound", level.bracket.mean_stress_error_bound},
          {"relative_error_bound", level.bracket.relative_error_bound},
          {"plain", plain_json(level)},
          {"oscillation_energy", level.oscillation_energy},
          {"imbalance", {{"primal", level.primal.imbalance}, {"dual", level.dual.imbalance}}},
          {"seconds",
           {{"mesh", seconds.mesh},
            {"primal", seconds.primal},
            {"dual", seconds.dual},
            {"estimate", seconds.estimate},
            {"certify", seconds.certify},
            {"total", seconds.total},
            {"write", around.write},
            {"elapsed", around.elapsed},
            {"primal_phases", phases(primal_phases(level))},
            {"dual_phases", phases(dual_phases(level))}}},
          {"contact", std::move(contact)}};
}

double relative_width(const bounds::Outcome<2>& outcome) {
  const double size = std::max(std::abs(outcome.lower), std::abs(outcome.upper));
  return size > 0 ? (outcome.upper - outcome.lower) / size : 0;
}

std::string report_json(const Report& report) {
  const bounds::Outcome<2>& outcome = report.outcome;
  const bounds::Level& last = outcome.levels.back();
  Json levels = Json::array();
  for (std::size_t i = 0; i < outcome.levels.size(); ++i)
    levels.push_back(level_json(outcome.levels[i], report.around[i]));
  Json json = heading(report.scene);
  const Json found = {{"units", report.scene.units},
                      {"plane", name(report.scene.plane)},
                      {"degree", report.scene.solve.degree},
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
                      {"levels", levels},
                      {"checks", checks_json(last.checks, outcome.problem.oscillation)},
                      {"loads_changed", outcome.problem.imbalance},
                      {"quality", quality_json(outcome.problem.mesh)},
                      {"seconds", {{"read", report.read}, {"pictures", report.pictures}}},
                      {"skipped", outcome.skipped},
                      {"missing", report.missing},
                      {"notes", outcome.problem.mesh.notes}};
  json.update(found);
  // Names come from files that may hold any bytes; what is not UTF-8 is replaced, rather than the report refused.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string history_csv(const Report& report) {
  std::string text =
      "level,cells,primal_dofs,dual_dofs,lower,upper,relative_width,relative_error_bound,contact_rows,contact_active,"
      "contact_iterations,seconds_mesh,seconds_primal,seconds_dual,seconds_estimate,seconds_certify,seconds_total,"
      "seconds_write,"
      "seconds_elapsed";
  for (const char* formulation : {"primal", "dual"})
    for (const char* phase : phase_names) text += fmt::format(",{}_{}", formulation, phase);
  text += "\n";
  for (std::size_t i = 0; i < report.outcome.levels.size(); ++i) {
    const bounds::Level& level = report.outcome.levels[i];
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", i, level.cells,
                        level.primal.unknowns, level.dual.unknowns, level.bracket.lower, level.bracket.upper,
                        level.bracket.relative_width, level.bracket.relative_error_bound, level.primal.rows,
                        level.primal.active_rows, level.primal.iterations, level.seconds.mesh, level.seconds.primal,
                        level.seconds.dual, level.seconds.estimate, level.seconds.certify, level.seconds.total,
                        report.around[i].write, report.around[i].elapsed, fmt::join(primal_phases(level), ","),
                        fmt::join(dual_phases(level), ","));
  }
  return text;
}

}  // namespace bracket::apps
