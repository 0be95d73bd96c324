// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/report.h"

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

Json phases(double assemble, const contact::Seconds& seconds) {
  return {{"assemble", assemble},
          {"order", seconds.order},
          {"factorise", seconds.factorise},
          {"contact", seconds.contact},
          {"recover", seconds.recover}};
}

Json interface_problem(int rows, int active, int iterations) {
  return {{"rows", rows}, {"active", active}, {"iterations", iterations}};
}

Json level_json(const bounds::Level& level) {
  const bounds::Seconds& seconds = level.seconds;
  Json contact = interface_problem(level.contact_rows, level.contact_active, level.contact_iterations);
  contact["dual"] =
      interface_problem(level.dual_contact_rows, level.dual_contact_active, level.dual_contact_iterations);
  return {{"cells", level.cells},
          {"primal_dofs", level.primal_dofs},
          {"dual_dofs", level.dual_dofs},
          {"lower", level.bracket.lower},
          {"upper", level.bracket.upper},
          {"relative_width", level.bracket.relative_width},
          {"error_bound", level.bracket.error_bound},
          {"mean_stress_error_bound", level.bracket.mean_stress_error_bound},
          {"relative_error_bound", level.bracket.relative_error_bound},
          {"oscillation_energy", level.oscillation_energy},
          {"imbalance", {{"primal", level.primal_imbalance}, {"dual", level.dual_imbalance}}},
          {"seconds",
           {{"mesh", seconds.mesh},
            {"primal", seconds.primal},
            {"dual", seconds.dual},
            {"estimate", seconds.estimate},
            {"total", seconds.total},
            {"primal_phases", phases(level.primal_assemble, level.primal_phases)},
            {"dual_phases", phases(level.dual_assemble, level.dual_phases)}}},
          {"contact", std::move(contact)}};
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

}  // namespace

std::string report_json(const Report& report) {
  const bounds::Outcome<2>& outcome = report.outcome;
  const bounds::Level& last = outcome.levels.back();
  const scene::Quality quality = scene::quality(outcome.problem.mesh);
  Json levels = Json::array();
  for (const bounds::Level& level : outcome.levels) levels.push_back(level_json(level));
  const Json json = {{"schema", 1},
                     {"generator", "bracket"},
                     {"version", BRACKET_VERSION},
                     {"title", report.scene.title},
                     {"scene", report.scene.file},
                     {"units", report.scene.units},
                     {"plane", report.scene.plane},
                     {"degree", report.scene.solve.degree},
                     {"dual", report.scene.solve.dual},
                     {"guarantee", outcome.guarantee},
                     {"status", name(outcome.status)},
                     {"reason", outcome.reason},
                     {"energy", {{"lower", last.bracket.lower}, {"upper", last.bracket.upper}}},
                     {"relative_width", last.bracket.relative_width},
                     {"relative_error_bound", last.bracket.relative_error_bound},
                     {"error_bound", last.bracket.error_bound},
                     {"mean_stress_error_bound", last.bracket.mean_stress_error_bound},
                     {"oscillation_energy", last.oscillation_energy},
                     {"levels", levels},
                     {"checks", checks_json(last.checks, outcome.problem.oscillation)},
                     {"quality",
                      {{"smallest_angle", quality.smallest_angle},
                       {"largest_angle", quality.largest_angle},
                       {"smallest_area", quality.smallest_area},
                       {"largest_area", quality.largest_area}}},
                     {"skipped", outcome.skipped},
                     {"notes", outcome.problem.mesh.notes}};
  // Names come from files that may hold any bytes; what is not UTF-8 is replaced, rather than the report refused.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string history_csv(const Report& report) {
  std::string text =
      "level,cells,primal_dofs,dual_dofs,lower,upper,relative_width,relative_error_bound,contact_rows,contact_active,"
      "contact_iterations,seconds_mesh,seconds_primal,seconds_dual,seconds_estimate,seconds_total\n";
  int number = 0;
  for (const bounds::Level& level : report.outcome.levels)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", number++, level.cells, level.primal_dofs,
                        level.dual_dofs, level.bracket.lower, level.bracket.upper, level.bracket.relative_width,
                        level.bracket.relative_error_bound, level.contact_rows, level.contact_active,
                        level.contact_iterations, level.seconds.mesh, level.seconds.primal, level.seconds.dual,
                        level.seconds.estimate, level.seconds.total);
  return text;
}

}  // namespace bracket::apps
