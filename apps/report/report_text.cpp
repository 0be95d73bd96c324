// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "apps/report/columns.h"
#include "apps/report/numbers.h"
#include "apps/report/pairs.h"
#include "apps/report/quantities.h"
#include "apps/report/report.h"
#include "apps/report/shares.h"
#include "bounds/certificate/open_contact.h"

namespace bracket::apps {
namespace {

std::string explanation(const Report& report) {
  if (report.outcome.guarantee == "none")
    return "No bound is printed; the plain values of this run are in report.json.\n";
  return fmt::format(
      "The exact potential energy lies in this interval: not below minus the complementary energy of stresses in\n"
      "equilibrium, not above the potential energy of displacements that respect the contact. The error of either\n"
      "field, in the energy norm, is at most the square root of twice the width: {}.\n"
      "Guarantee: {}. The fields were moved into balance and out of contact exactly, and every rounding error of\n"
      "their energies is within the interval.\n{}",
      rounded_up(std::sqrt(2 * std::max(0.0, report.outcome.upper - report.outcome.lower))), report.outcome.guarantee,
      report.outcome.guarantee == "discretisation"
          ? "Some functions are known at points only; what they do between those is not in it.\n"
          : "");
}

std::string level_table(const Report& report) {
  const auto rows = level_rows(report, {{"cells", {"cells"}},
                                        {"displacements", {"primal_dofs"}},
                                        {"stresses", {"dual_dofs"}},
                                        {"lower bound", {"lower"}},
                                        {"upper bound", {"upper"}},
                                        {"error", {"relative_error_bound"}},
                                        {"seconds", {"seconds_total"}}});
  std::vector<std::size_t> width(rows[0].size(), 0);
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].size());
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) text += fmt::format("{}{:>{}}", c > 0 ? "  " : "", row[c], width[c]);
    text += "\n";
  }
  return text +
         (report.scene.curves.empty()
              ? "       (unknowns of either formulation; each level's own bounds, of which the interval is the "
                "intersection)\n"
              : "       (unknowns of either formulation; each level's own bounds, of the polygon that its arcs are)\n");
}

std::string seconds_table(const Report& report) {
  std::string text = "\nSeconds         ";
  for (const char* name : phase_names) text += fmt::format("{:>10}", name);
  text += fmt::format("{:>10}\n", "all");
  for (const auto& [name, formulation] : {std::pair("displacements", "primal"), std::pair("stresses", "dual")}) {
    text += fmt::format("  {:<14}", name);
    for (const char* phase : phase_names)
      text += fmt::format("{:>10.2f}", sum(fmt::format("{}_{}", formulation, phase), report));
    text += fmt::format("{:>10.2f}\n", sum(fmt::format("seconds_{}", formulation), report));
  }
  return text + fmt::format(
                    "  (side by side), read {:.2f}, mesh {:.2f}, estimate {:.2f}, certify {:.2f}, quantities {:.2f}, "
                    "write {:.2f}, pictures "
                    "{:.2f}\n",
                    report.read, sum("seconds_mesh", report), sum("seconds_estimate", report),
                    sum("seconds_certify", report), sum("seconds_quantities", report), sum("seconds_write", report),
                    report.pictures);
}

// What one pair transmits, and whether its largest pressure says something.
std::string pair_line(const Report& report, int pair) {
  const PairSummary of = summary(report, pair);
  const auto& contact = report.scene.contact[pair];
  return fmt::format("  {} on {}: force {:.4g}, largest pressure {:.4g}{}, pressed on {:.4g} of a length of {:.4g}\n",
                     name(contact.first), name(contact.second), of.force, of.largest_pressure,
                     of.grows.empty() ? "" : " (grows with refinement: at " + of.grows + ")", of.pressed_length,
                     of.length);
}

/// What the open part of a contact can carry.
std::string open_line(const Report& report, int pair) {
  if (report.outcome.guarantee == "none") return "";
  const auto open = bounds::open_contact(report.outcome.problem, report.outcome.displacement,
                                         report.outcome.levels.back().certificate, pair);
  if (open.length == 0) return "";
  return fmt::format(
      "    guaranteed: where it is open by {:.4g} or more, on {:.4g} of its length, it carries at most {}\n", open.gap,
      open.length, rounded_up(open.force));
}

/// The forces of a contact's zones, and where it presses for sure.
std::string zone_lines(const Report& report, int pair) {
  std::string text;
  if (report.outcome.guarantee == "none") return text;
  for (std::size_t i = 0; i < report.outcome.quantities.size(); ++i)
    if (const auto& one = report.outcome.quantities[i]; one.contact == pair && one.zone >= 0)
      text += fmt::format("    {}: force {}{}{}\n", one.name, told(one, ""), share_text(report, i),
                          one.lower > 0 ? "   in contact somewhere" : "");
  return text;
}

std::string contact_text(const Report& report) {
  if (report.scene.contact.empty()) return "";
  const contact::Statistics &primal = report.outcome.levels.back().primal, &dual = report.outcome.levels.back().dual;
  std::string text =
      fmt::format("\nContact: displacements {} of {} rows closed in {} iterations, stresses {} of {} in {}\n",
                  primal.active_rows, primal.rows, primal.iterations, dual.active_rows, dual.rows, dual.iterations);
  for (int pair = 0; pair < static_cast<int>(report.scene.contact.size()); ++pair)
    text += pair_line(report, pair) + open_line(report, pair) + zone_lines(report, pair);
  return text;
}

std::string checks_text(const bounds::Checks& checks) {
  std::string text =
      "\nChecks of the fields as computed, before the certificate (by the size of the scene's stresses or "
      "displacements)\n";
  for (const bounds::Check& check : checks.all())
    text += fmt::format("  {:<18} {:>8.1e}  {:<6} {}\n", check.name, check.value,
                        check.value <= bounds::Checks::tolerance ? "ok" : "LARGE", check.meaning);
  return text;
}

std::string data_text(const Report& report) {
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
             "\nData: fixed edge by edge, which moved tractions by {:.1e}, displacements by {:.1e} and gaps by {:.1e} "
             "of their\n"
             "      largest values, and the energy by about {:.1e}. The bounds hold for the fixed data.\n",
             data.traction, data.displacement, data.gap, last.oscillation_energy) +
         changed;
}

std::string accuracy(const bounds::Outcome<2>& outcome) {
  if (outcome.unstrained && outcome.lower < outcome.upper)
    return "nothing is strained, but for the rounding of the data";
  return fmt::format("relative width {}   guaranteed relative error {}", rounded_up_exponent(relative_width(outcome)),
                     percent(outcome.relative_error_bound));
}

/// Of the problem that the bounds hold for, where it is not quite the scene's.
std::string what_else(const Report& report) {
  const bounds::Outcome<2>& outcome = report.outcome;
  std::string text;
  if (!report.scene.curves.empty())
    text += "   of the last mesh's polygon" +
            (std::isfinite(outcome.moved) ? ", moved by " + rounded_up_exponent(outcome.moved) + " from the one before"
                                          : std::string());
  const double changed = outcome.problem.imbalance;
  // To first order the energy moves by twice the part by which the loads do.
  if (2 * changed > relative_width(outcome))
    text += fmt::format("   loads changed by {} to balance", rounded_up_exponent(changed));
  if (outcome.guarantee == "discretisation") text += "   for data that were sampled";
  const bounds::Level& last = outcome.levels.back();
  if (last.oscillation_energy > outcome.upper - outcome.lower)
    text += fmt::format("   for the data of '{}' as the first mesh has them, which is {} off", last.oscillation_part,
                        std::isfinite(last.oscillation_energy)
                            ? "an energy of about " + rounded_up_exponent(last.oscillation_energy)
                            : "no bounded energy");
  return text;
}

}  // namespace

std::string headline(const Report& report) {
  if (report.outcome.guarantee == "none") return fmt::format("no guaranteed bounds: {}\n", report.outcome.reason);
  return quantity_lines(report) + fmt::format("energy in [{}, {}]   {}{}\n", report.outcome.lower, report.outcome.upper,
                                              accuracy(report.outcome), what_else(report));
}

std::string report_text(const Report& report) {
  const bounds::Outcome<2>& outcome = report.outcome;
  std::string text = report.scene.title.empty() ? "\n" : fmt::format("\n{}\n", report.scene.title);
  text += fmt::format("Scene: {}; plane {}{}\n", report.scene.file, name(report.scene.plane),
                      report.scene.units.empty() ? "" : "; units " + report.scene.units);
  text += explanation(report) + "\n";
  if (outcome.guarantee != "none") text += level_table(report);
  text += contact_text(report) + checks_text(outcome.levels.back().checks) + data_text(report) + seconds_table(report);
  if (outcome.status == scene::Status::budget) text += fmt::format("Budget: {}\n", outcome.reason);
  if (!outcome.skipped.empty()) text += fmt::format("Not needed: {}.\n", fmt::join(outcome.skipped, ";\n            "));
  return text;
}

}  // namespace bracket::apps
