// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "apps/plots/pictures.h"
#include "apps/report/columns.h"
#include "apps/report/json.h"
#include "apps/report/lines.h"
#include "apps/report/numbers.h"
#include "apps/report/order.h"
#include "apps/report/quantities.h"
#include "apps/studies/study.h"

namespace bracket::apps {
namespace {

bool drawable(const bounds::Level& level) {
  return std::isfinite(level.bracket.relative_error_bound) && level.bracket.relative_error_bound > 0;
}

double order(const Series& series) { return observed_order(samples_of(series.levels)); }

std::string label(const Series& series) { return fmt::format("{}, degree {}", series.strategy, series.degree); }

std::string power(const Series& series) {
  const double slope = order(series);
  return std::isfinite(slope) ? fmt::format("like cells to the power {:.2f}", slope) : "on too few levels to say";
}

}  // namespace

std::string study_text(const std::vector<Series>& all) {
  constexpr const char* format = "{:>8}{:>11}  {}{:>8}\n";
  constexpr std::size_t columns = 45;
  std::string text = fmt::format(format, "cells", "error", padded("energy of the level between", columns), "seconds");
  for (const Series& series : all) {
    text += label(series) + "\n";
    for (std::size_t i = 0; i < series.levels.size(); ++i) {
      const bounds::Level& level = series.levels[i];
      text += fmt::format(format, level.cells, percent(level.bracket.relative_error_bound),
                          padded(interval_text(level.bracket.lower, level.bracket.upper, ""), columns),
                          fmt::format("{:.2f}", series.around[i].elapsed));
    }
  }
  text +=
      "(seconds since the series began; study.csv has unknowns and where the time went)\n\n"
      "Guaranteed relative error, observed over the last half of the levels\n";
  for (const Series& series : all)
    text += fmt::format("  {:<20} {}   ({})\n", label(series), power(series), series.end);
  return within_columns(text);
}

std::string study_csv(const std::vector<Series>& all) {
  std::string text = "strategy,degree,level," + csv_names() + "\n";
  for (const Series& series : all)
    for (std::size_t i = 0; i < series.levels.size(); ++i)
      text += fmt::format("{},{},{},{}\n", series.strategy, series.degree, i,
                          csv_values(series.levels[i], series.around[i]));
  return text;
}

std::string study_json(const scene::Scene<2>& scene, const std::vector<Series>& all) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const Series& series : all) {
    Json levels = Json::array();
    for (std::size_t i = 0; i < series.levels.size(); ++i)
      levels.push_back(level_json(series.levels[i], series.around[i]));
    list.push_back({{"strategy", series.strategy},
                    {"degree", series.degree},
                    {"end", series.end},
                    {"order", order(series)},
                    {"levels", std::move(levels)}});
  }
  Json json = heading(scene);
  json["series"] = std::move(list);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

bool has_picture(const std::vector<Series>& all) {
  return std::ranges::any_of(all, [](const Series& series) { return std::ranges::any_of(series.levels, drawable); });
}

Picture study_picture(const std::vector<Series>& all) {
  const auto look = [](const Series& series) {
    const char* colour = series.strategy == "adaptive" ? stress_colour : displacement_colour;
    constexpr std::array points = {6, 7, 9, 5};  // of each degree: open and full circles, triangles, squares
    constexpr std::array dashes = {"(6,4)", "1", "(2,3)", "(10,3,2,3)"};
    return fmt::format("lw 2 ps 0.7 pt {} dt {} lc rgb '{}'", points.at(series.degree - 1),
                       dashes.at(series.degree - 1), colour);
  };
  std::vector<double> times, errors;
  std::string items, data;
  for (const Series& series : all) {
    std::string points, last;
    for (std::size_t i = 0; i < series.levels.size(); ++i) {
      if (!drawable(series.levels[i])) continue;
      times.push_back(series.around[i].elapsed);
      errors.push_back(series.levels[i].bracket.relative_error_bound);
      last = fmt::format("{} {}", times.back(), errors.back());
      points += last + "\n";
    }
    if (points.empty()) continue;
    items +=
        fmt::format("{}'-' with linespoints {} title '{}'", items.empty() ? "" : ", ", look(series), label(series));
    data += points + "e\n";
    if (!std::isfinite(order(series))) continue;
    items += ", '-' using 1:2:3 with labels left offset 1,0 notitle";
    data += fmt::format("{} \"cells^{{{:.2f}}}\"\ne\n", last, order(series));
  }
  times.push_back(2 * std::ranges::max(times));  // room for the labels
  return {
      "study",
      "The guaranteed relative error of both fields in the energy norm against the run time, with the order observed "
      "over the last half of the levels.",
      900, 560,
      plot_style() + log_axis("x", times) + log_axis("y", errors) +
          fmt::format("set xlabel 'seconds'\nset ylabel 'guaranteed relative error'\n"
                      "plot {}\n{}",
                      items, data)};
}

}  // namespace bracket::apps
