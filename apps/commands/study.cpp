// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studies/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <utility>

#include "apps/commands/commands.h"
#include "apps/commands/dimension.h"
#include "apps/commands/folder.h"
#include "apps/commands/watch.h"
#include "contact/clock.h"

namespace bracket::apps {
namespace {

void write_tables(const std::filesystem::path& folder, const scene::Scene<2>& scene, const std::vector<Series>& all) {
  write_file(folder, "study.csv", study_csv(all));
  write_file(folder, "study.json", study_json(scene, all));
}

bool any_reaches(double target, const std::vector<Series>& all) {
  return std::ranges::any_of(all, [&](const Series& series) {
    return std::ranges::any_of(
        series.levels, [&](const bounds::Level& level) { return level.bracket.relative_error_bound <= target; });
  });
}

}  // namespace

Ending study(const std::filesystem::path& file, const std::vector<std::string>& overrides,
             const std::filesystem::path& given_folder) {
  refuse_space(file, overrides, "study");
  scene::Scene<2> scene = scene::read_scene<2>(file, overrides);
  const double target = std::exchange(scene.refine.target, 0);
  const std::filesystem::path folder = results_folder(given_folder, file, ".study");
  const Descriptor in_use = prepare_folder(folder);

  std::vector<Series> all;
  const auto solve = [&](Watch& watch) {
    Series& series = all.emplace_back(name(scene.refine.strategy), scene.solve.degree);
    const Clock clock;
    const std::string label = fmt::format("{}, degree {}: ", series.strategy, series.degree);
    const auto level = [&](const bounds::Outcome<2>& so_far) {
      series.levels.push_back(so_far.levels.back());
      series.around.push_back({.elapsed = clock.seconds()});
      write_tables(folder, scene, all);
    };
    const bounds::Outcome<2> outcome = bounds::run(scene, watch.observer(label, level));
    series.end = outcome.reason;
    if (series.end.empty()) series.end = outcome.relative_error_bound == 0 ? "exact" : "budget spent";
    return Ending{outcome.status, label + series.end};
  };

  Ending ending;
  {
    Watch watch;
    for (const auto strategy : {scene::Strategy::uniform, scene::Strategy::adaptive})
      for (int degree = 1; degree <= scene::largest_degree; ++degree) {
        if (watch.interrupted()) continue;
        scene.refine.strategy = strategy;
        scene.solve.degree = degree;
        const Ending ended = solve(watch);
        if (ending.status != scene::Status::not_guaranteed && ended.status != scene::Status::done) ending = ended;
      }
  }
  write_tables(folder, scene, all);
  std::cout << study_text(all);
  if (has_picture(all)) write_picture(folder, study_picture(all));
  std::cout << fmt::format("Tables and plot: {}\n", folder.string());
  if (ending.status == scene::Status::done && target > 0 && !any_reaches(target, all))
    return {scene::Status::budget, fmt::format("no way of refining reaches the target {:g} within the budget", target)};
  return ending;
}

}  // namespace bracket::apps
