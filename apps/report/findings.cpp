// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/report/pairs.h"
#include "apps/report/shares.h"
#include "apps/report/units.h"
#include "bounds/certificate/open_contact.h"
#include "bounds/results.h"

namespace bracket::apps {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
/// Of the largest stress or displacement, what in sums and differences of them is rounding: the certificate drops
/// pressures up to that.
constexpr double rounding_share = 1e-11;

bool is_guaranteed(const Report& report) { return report.outcome.guarantee != "none"; }

/// The bounds of the first quantity asked for that is meant; nothing: there are none.
template <class IsMeant> std::optional<Between> asked_for(const Report& report, const IsMeant& is_meant) {
  const auto& quantities = report.scene.quantities;
  for (std::size_t i = 0; i < quantities.size() && i < report.outcome.quantities.size(); ++i) {
    const bounds::QuantityInterval& found = report.outcome.quantities[i];
    if (!is_guaranteed(report) || found.weighted || !is_meant(quantities[i], found)) continue;
    if (std::isfinite(found.lower) || std::isfinite(found.upper)) return Between{found.lower, found.upper};
  }
  return std::nullopt;
}

std::string name_of(const scene::ContactPair<2>& pair) {
  const std::string sides = name(pair.first) + " on " + name(pair.second);
  return pair.name.empty() ? sides : fmt::format("{} ({})", pair.name, sides);
}

std::vector<Finding> of_contact(const Report& report, int pair, const Units& units) {
  const PairSummary summary = apps::summary(report, pair);
  const scene::ContactPair<2>& given = report.scene.contact[pair];
  std::vector<Finding> rows;
  const auto add = [&](const std::string& key, double computed, const std::string& unit) -> Finding& {
    return rows.emplace_back(Finding{Subject::contact, pair, name_of(given), key, computed, unit});
  };
  add("force", summary.force, units.force).bounds = asked_for(report, [&](const auto& asked, const auto& found) {
    return is_pressing_force(asked) && found.contact == pair && !asked.stretch && !asked.weight;
  });
  add("length", summary.length, units.length);
  add("pressed_length", summary.pressed_length, units.length);
  if (summary.pressed_length > 0) add("mean_pressure", summary.force / summary.pressed_length, units.stress);
  Finding& largest = add("largest_pressure", summary.largest_pressure, units.stress);
  if (summary.largest_pressure > 0) largest.at = summary.at;
  if (!summary.grows.empty()) largest.note = "grows with refinement: " + summary.grows;
  if (scene::is_two_sided(given)) add("largest_tension", summary.largest_tension, units.stress);
  if (given.law == scene::Law::winkler) add("largest_shortening", summary.largest_shortening, units.length);
  if (given.law == scene::Law::tresca || given.law == scene::Law::coulomb) {
    add("shear_force", summary.shear, units.force).bounds =
        asked_for(report, [&](const auto& asked, const auto& found) {
          return asked.of_force == scene::ForceComponent::shear && found.contact == pair;
        });
    add("largest_slip", summary.largest_slip, units.length);
  }
  if (is_guaranteed(report) && given.law != scene::Law::winkler) {
    Finding& penetration = add("largest_penetration", 0, units.length);
    penetration.bounds = Between{0, 0};
    penetration.note = "by construction";
  }
  Finding& gap = add("largest_gap", summary.largest_gap, units.length);
  gap.rounding = rounding_share *
                 bounds::largest_displacement(report.outcome.problem, report.outcome.displacement).displacement.norm();
  if (summary.largest_gap > gap.rounding) gap.at = summary.gap_at;
  if (is_guaranteed(report) && !report.running) {
    const auto open = bounds::open_contact(report.outcome.problem, report.outcome.displacement,
                                           report.outcome.levels.back().certificate, pair);
    if (open.length > 0 && open.force < summary.force) {  // more says nothing
      Finding& force = add("force_of_the_open_part", nothing, units.force);
      force.bounds = Between{0, open.force};
      force.note =
          fmt::format("on {:.4g}{}, open by {:.4g}{} or more", open.length, units.length, open.gap, units.length);
    }
  }
  for (std::size_t i = 0; i < report.outcome.quantities.size(); ++i) {
    const bounds::QuantityInterval& zone = report.outcome.quantities[i];
    if (zone.contact != pair || zone.zone < 0 || !is_guaranteed(report)) continue;
    Finding& force = add(fmt::format("force_of_zone_{}", zone.zone + 1), nothing, units.force);
    force.bounds = Between{zone.lower, zone.upper};
    if (zone.lower > 0) force.note = "in contact somewhere";
    if (const auto part = share(report, i)) {
      const auto [low, high] = in_percent(*part);
      add(fmt::format("share_of_zone_{}", zone.zone + 1), nothing, " %").bounds = Between{low, high};
    }
  }
  return rows;
}

/// Up to which a part's reaction is rounding.
double rounding_of_reaction(const scene::Mesh<2>& mesh, const std::string& part, double largest_stress) {
  double length = 0;
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
    if (const int own = mesh.boundary[f].part; own >= 0 && mesh.parts[own] == part)
      length += scene::length(mesh, static_cast<int>(f));
  return rounding_share * largest_stress * length;
}

std::vector<Finding> of_supports(const Report& report, const Units& units) {
  const scene::Problem<2>& problem = report.outcome.problem;
  double largest_stress = 0;
  for (const auto& cell : report.outcome.stress.cell)
    for (const scene::Voigt<2>& s : cell) largest_stress = std::max(largest_stress, s.norm());
  std::vector<Finding> rows;
  for (const auto& [part, condition] : report.scene.boundary) {
    if (condition.kind != scene::ConditionKind::fixed && condition.kind != scene::ConditionKind::sliding) continue;
    const scene::Vector<2> force = bounds::resultant(problem, report.outcome.stress, part).force;
    const double rounding = rounding_of_reaction(problem.mesh, part, largest_stress);
    for (int axis = 0; axis < 2; ++axis) {
      Finding& row = rows.emplace_back(
          Finding{Subject::support, -1, part, axis == 0 ? "reaction_x" : "reaction_y", force[axis], units.force});
      row.rounding = rounding;
      row.bounds = asked_for(report, [&, part = part](const auto& asked, const auto&) {
        return asked.kind == scene::QuantityKind::reaction && asked.of == part && asked.direction &&
               (*asked.direction)[axis] > 0 && (*asked.direction)[1 - axis] == 0;
      });
    }
  }
  return rows;
}

std::vector<Finding> of_bodies(const Report& report, const Units& units) {
  std::vector<Finding> rows;
  const auto largest = bounds::largest_displacement(report.outcome.problem, report.outcome.displacement);
  rows.push_back({Subject::bodies, -1, "", "largest_displacement", largest.displacement.norm(), units.length});
  rows.back().at = largest.at;
  if (const LargestVonMises& stress = report.von_mises; stress.value >= 0) {
    rows.push_back({Subject::bodies, -1, "", "largest_von_mises_stress", stress.value, units.stress});
    rows.back().at = stress.at;
    if (!stress.of_all) rows.back().note = "of the bodies with E and nu";
  }
  return rows;
}

}  // namespace

std::vector<Finding> findings(const Report& report) {
  const Units units = units_of(report.scene.units);
  std::vector<Finding> rows;
  const auto append = [&rows](std::vector<Finding> more) { rows.insert(rows.end(), more.begin(), more.end()); };
  for (int pair = 0; pair < static_cast<int>(report.scene.contact.size()); ++pair)
    append(of_contact(report, pair, units));
  append(of_supports(report, units));
  append(of_bodies(report, units));
  return rows;
}

}  // namespace bracket::apps
