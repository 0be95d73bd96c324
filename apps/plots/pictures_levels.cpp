// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/plots/pictures.h"
#include "apps/report/order.h"
#include "apps/report/stresses.h"
#include "apps/report/units.h"

namespace bracket::apps {
namespace {

/// A distance as a height: decades above `floor`, upwards for positive ones. Linear below, so that zero has a place.
double height(double distance, double floor) {
  const double ratio = std::abs(distance) / floor;
  return std::copysign(ratio < 1 ? ratio : 1 + std::log10(ratio), distance);
}

// A tick at each decade, or at each second one where they are many; above and below zero alike.
std::string decade_tics(int lowest, int highest) {
  const int step = 1 + (highest - lowest) / 6;
  std::string tics = "\"0\" 0";
  for (int decade = lowest; decade <= highest; decade += step)
    tics += fmt::format(", \"+10^{{{0}}}\" {1}, \"−10^{{{0}}}\" -{1}", decade, decade - lowest + 1);
  return fmt::format("set ytics ({})\n", tics);
}

std::string error_panel(const char* label, const std::vector<double>& x, const std::vector<double>& error) {
  std::string script = log_axis("x", x) + log_axis("y", error) +
                       fmt::format("set xlabel '{}'\nplot '-' with linespoints lw 2 pt 7 ps 0.6 lc rgb '{}' notitle\n",
                                   label, stress_colour);
  for (std::size_t i = 0; i < x.size(); ++i) script += fmt::format("{} {}\n", x[i], error[i]);
  return script + "e\n";
}

}  // namespace

std::string plot_style() {
  return "set border lw 0.8 lc rgb '#666666'\nset grid lw 0.6 lt 1 lc rgb '#dddddd'\nset tics textcolor rgb '#222222'\n"
         "set key outside top left horizontal Left reverse samplen 2 spacing 1.15\n";
}

namespace {

std::string without_blank(const std::string& unit) { return unit.empty() ? unit : unit.substr(1); }

}  // namespace

std::string length_unit(const std::string& units) { return without_blank(units_of(units).length); }
std::string stress_unit(const std::string& units) { return without_blank(units_of(units).stress); }

std::string with_unit(const std::string& what, const std::string& unit) {
  return quoted(unit.empty() ? what : fmt::format("{} [{}]", what, unit));
}

std::string log_axis(const std::string& axis, const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double from = *low / 1.6, to = *high * 1.6;
  std::string text = fmt::format("set logscale {0}\nset {0}range [{1}:{2}]\n", axis, from, to);
  if (to > 30 * from) return text + fmt::format("set format {0} '10^{{%L}}'\nset {0}tics autofreq\n", axis);
  std::string tics;  // decades alone would be few
  const std::vector<int> digits = to > 8 * from   ? std::vector<int>{1, 2, 5}
                                  : to > 4 * from ? std::vector<int>{1, 2, 3, 5}
                                                  : std::vector<int>{1, 2, 3, 4, 6, 8};
  for (double decade = std::pow(10, std::floor(std::log10(from))); decade <= to; decade *= 10)
    for (const int digit : digits) tics += fmt::format("{}{:g}", tics.empty() ? "" : ", ", digit * decade);
  return text + fmt::format("set format {0} '%g'\nset {0}tics ({1})\n", axis, tics);
}

namespace {

/// An interval that one mesh gave.
struct Enclosed {
  int cells;
  double lower, upper;
};

/// The ends of the meshes' intervals about the middle of the final one [lower, upper].
/// \param one_problem of all meshes: the value is in all of their intervals; else each has its own value
Picture closing(std::string name, std::string caption, const std::string& what, const std::vector<Enclosed>& meshes,
                double final_lower, double final_upper, bool one_problem) {
  const double middle = final_lower + (final_upper - final_lower) / 2;
  const double size = std::max(std::abs(final_lower), std::abs(final_upper));
  double smallest = (final_upper - final_lower) / 2 / size, largest = 0;
  smallest = std::max(smallest, 1e-16);  // of an exact solution only rounding is left
  for (const Enclosed& mesh : meshes)
    largest = std::max({largest, (mesh.upper - middle) / size, (middle - mesh.lower) / size});
  largest = std::max(largest, smallest);
  const int lowest = static_cast<int>(std::floor(std::log10(smallest)));
  const int highest = static_cast<int>(std::ceil(std::log10(largest)));
  const double floor = std::pow(10, lowest);

  std::vector<double> cells;
  std::string band, lower, upper;
  double best_lower = -INFINITY, best_upper = INFINITY;
  for (const Enclosed& mesh : meshes) {
    best_lower = one_problem ? std::max(best_lower, mesh.lower) : mesh.lower;
    best_upper = one_problem ? std::min(best_upper, mesh.upper) : mesh.upper;
    const auto at = [&](double value) { return height((value - middle) / size, floor); };
    band += fmt::format("{} {} {}\n", mesh.cells, at(best_lower), at(best_upper));
    lower += fmt::format("{} {}\n", mesh.cells, at(mesh.lower));
    upper += fmt::format("{} {}\n", mesh.cells, at(mesh.upper));
    cells.push_back(mesh.cells);
  }
  const double top = highest - lowest + 1.5;
  return {std::move(name), std::move(caption), 600, 400,
          plot_style() + "set key font ',14'\n" + decade_tics(lowest, highest) + log_axis("x", cells) +
              fmt::format("set yrange [-{}:{}]\n"
                          "set xlabel 'cells'\nset ylabel 'distance by size of the {}'\n"
                          "plot '-' with filledcurves fc rgb '#cfe0ee' title '{}', "
                          "0 with lines lw 0.8 lc rgb '#999999' notitle, "
                          "'-' with linespoints lw 2 pt 7 ps 0.6 lc rgb '{}' title 'upper bound', "
                          "'-' with linespoints lw 2 pt 7 ps 0.6 lc rgb '{}' title 'lower bound'\n"
                          "{}e\n{}e\n{}e\n",
                          top, top, what, what == "energy" ? what : "value", displacement_colour, stress_colour, band,
                          upper, lower)};
}

constexpr const char* of_polygons = "each level's own: with arcs, each is the problem of its own polygon.";

}  // namespace

template <int dim> Picture closing_picture(const ReportOf<dim>& report) {
  std::vector<Enclosed> meshes;
  for (const bounds::Level& level : report.outcome.levels)
    meshes.push_back({level.cells, level.bracket.lower, level.bracket.upper});
  const bool one_problem = report.scene.curves.empty();
  const std::string caption =
      "The bracket closes: lower bound (stresses) and upper bound (displacements) of each level as distances "
      "from the middle of the final interval, by the size of the energy. The exact energy lies in the shaded "
      "band, ";
  return closing("closing", caption + (one_problem ? "the intersection of the levels' intervals." : of_polygons),
                 "energy", meshes, report.outcome.lower, report.outcome.upper, one_problem);
}

template <int dim> std::vector<Picture> quantity_pictures(const ReportOf<dim>& report) {
  const bool one_problem = report.scene.curves.empty();
  std::vector<Picture> result;
  int number = 0;
  for (const bounds::QuantityInterval& one : report.outcome.quantities) {
    if (one.zone >= 0) continue;
    ++number;
    std::vector<Enclosed> meshes;
    for (const bounds::QuantityLevel& level : one.levels)
      if (std::isfinite(level.lower) && std::isfinite(level.upper))
        meshes.push_back({level.cells, level.lower, level.upper});
    if (meshes.size() < 2 || std::max(std::abs(one.lower), std::abs(one.upper)) == 0) continue;
    result.push_back(
        closing(fmt::format("quantity_{}", number),
                fmt::format("{}: the bounds of each mesh that it was computed on, as distances from the "
                            "middle of the final interval, by its size. The exact value lies in the shaded "
                            "band{}",
                            one.name, one_problem ? "." : std::string(", ") + of_polygons),
                "quantity", meshes, one.lower, one.upper, one_problem));
  }
  return result;
}

template <int dim> Picture error_picture(const ReportOf<dim>& report) {
  std::vector<double> cells, seconds, errors;
  for (std::size_t i = 0; i < report.outcome.levels.size(); ++i) {
    const bounds::Level& level = report.outcome.levels[i];
    const double error = level.bracket.relative_error_bound;
    if (!std::isfinite(error) || error <= 0) continue;
    cells.push_back(level.cells);
    seconds.push_back(report.around[i].elapsed);
    errors.push_back(error);
  }
  const double order = observed_order(samples_of(report.outcome.levels));
  std::string caption =
      "The guaranteed relative error of both fields in the energy norm, against cells and against the seconds since "
      "the start.";
  if (std::isfinite(order))
    caption += fmt::format(" Over the last half of the levels it goes like cells to the power {:.2f}.", order);
  return {"error", std::move(caption), 600, 400,
          plot_style() + "set multiplot layout 1,2\nset ylabel 'guaranteed relative error'\n" +
              error_panel("cells", cells, errors) + "unset ylabel\n" + error_panel("seconds", seconds, errors) +
              "unset multiplot\n"};
}

namespace {

/// Whether there is a curve of the error to draw.
template <int dim> bool has_error_curve(const bounds::Outcome<dim>& outcome) {
  const auto known = [](const bounds::Level& level) {
    return std::isfinite(level.bracket.relative_error_bound) && level.bracket.relative_error_bound > 0;
  };
  return std::ranges::count_if(outcome.levels, known) > 1;
}

}  // namespace

template <int dim> std::vector<Picture> level_pictures(const ReportOf<dim>& report) {
  std::vector<Picture> result;
  if (report.outcome.levels.size() > 1) result.push_back(closing_picture(report));
  for (Picture& picture : quantity_pictures(report)) result.push_back(std::move(picture));
  if (has_error_curve(report.outcome)) result.push_back(error_picture(report));
  return result;
}

std::vector<Picture> pictures(const Report& report) {
  std::vector<Picture> result = {bodies_picture(report)};
  for (int pair = 0; pair < static_cast<int>(report.scene.contact.size()); ++pair)
    result.push_back(contact_picture(report, pair));
  for (Picture& picture : level_pictures(report)) result.push_back(std::move(picture));
  if (knows_stress_across(report.outcome.problem, report.scene.plane)) result.push_back(shear_picture(report));
  if (!error_is_rounding(report.outcome)) result.push_back(mesh_picture(report));
  return result;
}

Drawings drawn(const Report& report, bool png) { return draw(pictures(report), png); }

template Picture closing_picture(const ReportOf<2>&);
template Picture closing_picture(const ReportOf<3>&);
template Picture error_picture(const ReportOf<2>&);
template Picture error_picture(const ReportOf<3>&);
template std::vector<Picture> level_pictures(const ReportOf<2>&);
template std::vector<Picture> level_pictures(const ReportOf<3>&);

}  // namespace bracket::apps
