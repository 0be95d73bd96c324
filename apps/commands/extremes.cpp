// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studies/extremes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "apps/commands/commands.h"
#include "apps/commands/dimension.h"
#include "apps/commands/folder.h"
#include "apps/commands/watch.h"
#include "contact/clock.h"

namespace bracket::apps {
namespace {

Interval interval(const bounds::Outcome<2>& outcome) {
  if (outcome.guarantee == "none") throw scene::Error(outcome.status, outcome.reason);
  return {outcome.lower, outcome.upper};
}

Interval times(double factor, const Interval& interval) { return {factor * interval.lower, factor * interval.upper}; }

/// The interval on the mesh with all edges halved; none where there is no such mesh or no guarantee on it.
std::optional<Interval> on_finer_mesh(const scene::Scene<2>& settings, const scene::Problem<2>& problem) {
  try {
    const std::vector<char> all(problem.mesh.cells.size(), 1);
    return interval(bounds::run(settings, scene::refine(problem, all).problem));
  } catch (const scene::Error&) {
    return std::nullopt;
  }
}

Extreme solved(const scene::Scene<2>& settings, const Sweep& sweep, double parameter, const Interval& benign) {
  constexpr double rounding = 1e-12;  // of midpoints, by the energy
  Extreme row{sweep.name, parameter};
  const Clock clock;
  try {
    const scene::Problem<2> problem = sweep.make(parameter);
    row.interval = interval(bounds::run(settings, problem));
    row.seconds = clock.seconds();
    if (sweep.energy_factor) {
      row.reference = times(sweep.energy_factor(parameter), benign);
    } else {
      row.reference = on_finer_mesh(settings, problem);
      row.slack = rounding * std::max(std::abs(row.interval->lower), std::abs(row.interval->upper));
    }
  } catch (const scene::Error& error) {
    row.status = error.status();
    row.reason = error.what();
    row.seconds = clock.seconds();
  }
  return row;
}

void write_tables(const std::filesystem::path& folder, const scene::Scene<2>& scene, const Extremes& extremes) {
  write_file(folder, "extremes.csv", extremes_csv(extremes));
  write_file(folder, "extremes.json", extremes_json(scene, extremes));
}

Ending ending(const Extremes& extremes, bool interrupted) {
  for (const Extreme& row : extremes.rows)
    if (contains_reference(row) == false)
      return {scene::Status::not_guaranteed,
              fmt::format("{} = {:g}: interval and reference exclude each other, a fault of this program", row.sweep,
                          row.parameter)};
  if (interrupted) return {scene::Status::budget, "stopped on request"};
  return {};
}

}  // namespace

Ending extremes(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                const std::filesystem::path& given_folder) {
  refuse_space(file, overrides, "extremes");
  const scene::Scene<2> scene = scene::read_scene<2>(file, overrides);
  scene::Scene<2> settings = scene;
  settings.refine = {};  // each interval is that of one mesh
  const std::filesystem::path folder = results_folder(given_folder, file, ".extremes");
  const Descriptor in_use = prepare_folder(folder);

  Extremes extremes;
  bool interrupted = false;
  {
    const Watch watch;
    watch.show("the scene as it is");
    const scene::Problem<2> benign = scene::fix_data(scene, scene::build_mesh(scene));
    extremes.benign = interval(bounds::run(settings, benign));
    for (const Sweep& sweep : extreme_sweeps(scene, benign)) {
      if (!sweep.left_out.empty()) {
        extremes.left_out.push_back(fmt::format("{}: {}", sweep.name, sweep.left_out));
        continue;
      }
      for (const double parameter : sweep.parameters) {
        interrupted = interrupted || watch.interrupted();
        if (interrupted) break;
        watch.show(fmt::format("{} = {:g}", sweep.name, parameter));
        extremes.rows.push_back(solved(settings, sweep, parameter, extremes.benign));
        write_tables(folder, scene, extremes);
      }
    }
  }
  write_tables(folder, scene, extremes);
  std::cout << extremes_text(extremes);
  if (has_picture(extremes)) write_picture(folder, extremes_picture(extremes));
  std::cout << fmt::format("Tables and plot: {}\n", folder.string());
  return ending(extremes, interrupted);
}

}  // namespace bracket::apps
