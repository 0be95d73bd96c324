// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/report/pairs.h"
#include "apps/report/shares.h"
#include "apps/report/units.h"
#include "apps/report/words.h"
#include "bounds/certificate/open_contact.h"
#include "bounds/results.h"

namespace bracket::apps {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
/// Of the largest stress or displacement, what in sums and differences of them is rounding: the certificate drops
/// pressures up to that.
constexpr double rounding_share = 1e-11;

template <int dim> bool is_guaranteed(const ReportOf<dim>& report) { return report.outcome.guarantee != "none"; }

/// The bounds of the first quantity asked for that is meant; nothing: there are none.
template <int dim, class IsMeant>
std::optional<Between> asked_for(const ReportOf<dim>& report, const IsMeant& is_meant) {
  const auto& quantities = report.scene.quantities;
  for (std::size_t i = 0; i < quantities.size() && i < report.outcome.quantities.size(); ++i) {
    const bounds::QuantityInterval& found = report.outcome.quantities[i];
    if (!is_guaranteed(report) || found.weighted || !is_meant(quantities[i], found)) continue;
    if (std::isfinite(found.lower) || std::isfinite(found.upper)) return Between{found.lower, found.upper};
  }
  return std::nullopt;
}

template <int dim> std::string name_of(const scene::ContactPair<dim>& pair) {
  const std::string sides = name(pair.first) + " on " + name(pair.second);
  return pair.name.empty() ? sides : fmt::format("{} ({})", pair.name, sides);
}

template <int dim> std::vector<FindingOf<dim>> of_contact(const ReportOf<dim>& report, int pair, const Units& units) {
  const PairSummary<dim> summary = apps::summary(report, pair);
  const scene::ContactPair<dim>& given = report.scene.contact[pair];
  std::vector<FindingOf<dim>> rows;
  const auto add = [&](const std::string& key, double computed, const std::string& unit) -> FindingOf<dim>& {
    return rows.emplace_back(FindingOf<dim>{Subject::contact, pair, name_of(given), key, computed, unit});
  };
  add("force", summary.force, units.force).bounds = asked_for(report, [&](const auto& asked, const auto& found) {
    return is_pressing_force(asked) && found.contact == pair && !asked.stretch && !asked.weight;
  });
  if constexpr (dim == 3) {
    const scene::Vector<dim> resultant =
        bounds::contact_result(report.outcome.problem, report.outcome.stress, pair).resultant.force;
    for (int axis = 0; axis < dim; ++axis)
      add(fmt::format("resultant_{}", axis_names[axis]), resultant[axis], units.force).rounding =
          rounding_share * std::abs(summary.force);
  }
  const std::string& measure = dim == 2 ? units.length : units.area;
  add(Words<dim>::measure, summary.length, measure);
  add(fmt::format("pressed_{}", Words<dim>::measure), summary.pressed_length, measure);
  if (summary.pressed_length > 0) add("mean_pressure", summary.force / summary.pressed_length, units.stress);
  FindingOf<dim>& largest = add("largest_pressure", summary.largest_pressure, units.stress);
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
    FindingOf<dim>& penetration = add("largest_penetration", 0, units.length);
    penetration.bounds = Between{0, 0};
    penetration.note = "by construction";
  }
  FindingOf<dim>& gap = add("largest_gap", summary.largest_gap, units.length);
  gap.rounding = rounding_share *
                 bounds::largest_displacement(report.outcome.problem, report.outcome.displacement).displacement.norm();
  if (summary.largest_gap > gap.rounding) gap.at = summary.gap_at;
  if (is_guaranteed(report) && !report.running) {
    const auto open = bounds::open_contact(report.outcome.problem, report.outcome.displacement,
                                           report.outcome.levels.back().certificate, pair);
    if (open.length > 0 && open.force < summary.force) {  // more says nothing
      FindingOf<dim>& force = add("force_of_the_open_part", nothing, units.force);
      force.bounds = Between{0, open.force};
      force.note = fmt::format("on {:.4g}{}, open by {:.4g}{} or more", open.length, measure, open.gap, units.length);
    }
  }
  for (std::size_t i = 0; i < report.outcome.quantities.size(); ++i) {
    const bounds::QuantityInterval& zone = report.outcome.quantities[i];
    if (zone.contact != pair || zone.zone < 0 || !is_guaranteed(report)) continue;
    FindingOf<dim>& force = add(fmt::format("force_of_zone_{}", zone.zone + 1), nothing, units.force);
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
template <int dim>
double rounding_of_reaction(const scene::Mesh<dim>& mesh, const std::string& part, double largest_stress) {
  double length = 0;
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
    if (const int own = mesh.boundary[f].part; own >= 0 && mesh.parts[own] == part)
      length += scene::length(mesh, static_cast<int>(f));
  return rounding_share * largest_stress * length;
}

template <int dim> std::vector<FindingOf<dim>> of_supports(const ReportOf<dim>& report, const Units& units) {
  const scene::Problem<dim>& problem = report.outcome.problem;
  double largest_stress = 0;
  for (const auto& cell : report.outcome.stress.cell)
    for (const scene::Voigt<dim>& s : cell) largest_stress = std::max(largest_stress, s.norm());
  std::vector<FindingOf<dim>> rows;
  for (const auto& [part, condition] : report.scene.boundary) {
    if (condition.kind != scene::ConditionKind::fixed && condition.kind != scene::ConditionKind::sliding) continue;
    const scene::Vector<dim> force = bounds::resultant(problem, report.outcome.stress, part).force;
    const double rounding = rounding_of_reaction(problem.mesh, part, largest_stress);
    for (int axis = 0; axis < dim; ++axis) {
      FindingOf<dim>& row = rows.emplace_back(FindingOf<dim>{
          Subject::support, -1, part, fmt::format("reaction_{}", axis_names[axis]), force[axis], units.force});
      row.rounding = rounding;
      const scene::Vector<dim> along = scene::Vector<dim>::Unit(axis);
      row.bounds = asked_for(report, [&, part = part](const auto& asked, const auto&) {
        return asked.kind == scene::QuantityKind::reaction && asked.of == part && asked.direction &&
               (*asked.direction)[axis] > 0 && (*asked.direction - (*asked.direction)[axis] * along).isZero(0);
      });
    }
  }
  return rows;
}

template <int dim> std::vector<FindingOf<dim>> of_bodies(const ReportOf<dim>& report, const Units& units) {
  std::vector<FindingOf<dim>> rows;
  const auto largest = bounds::largest_displacement(report.outcome.problem, report.outcome.displacement);
  rows.push_back({Subject::bodies, -1, "", "largest_displacement", largest.displacement.norm(), units.length});
  rows.back().at = largest.at;
  if (const LargestVonMisesOf<dim>& stress = report.von_mises; stress.value >= 0) {
    rows.push_back({Subject::bodies, -1, "", "largest_von_mises_stress", stress.value, units.stress});
    rows.back().at = stress.at;
    if (!stress.of_all) rows.back().note = "of the bodies with E and nu";
  }
  return rows;
}

}  // namespace

template <int dim> std::vector<FindingOf<dim>> findings(const ReportOf<dim>& report) {
  const Units units = units_of(report.scene.units, dim);
  std::vector<FindingOf<dim>> rows;
  const auto append = [&rows](std::vector<FindingOf<dim>> more) { rows.insert(rows.end(), more.begin(), more.end()); };
  for (int pair = 0; pair < static_cast<int>(report.scene.contact.size()); ++pair)
    append(of_contact(report, pair, units));
  append(of_supports(report, units));
  append(of_bodies(report, units));
  return rows;
}

template std::vector<FindingOf<2>> findings(const ReportOf<2>&);
template std::vector<FindingOf<3>> findings(const ReportOf<3>&);

}  // namespace bracket::apps
