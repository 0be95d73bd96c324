// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "apps/plots/pictures.h"
#include "apps/report/samples.h"

namespace bracket::apps {
namespace {

/// A contact line unrolled: what is drawn over its arc length, as lines of data.
struct Unrolled {
  std::string equilibrated, of_displacement, gap, pressed;
  double length = 0;
};

Unrolled unroll(const Report& report, int pair) {
  const scene::Problem<2>& problem = report.outcome.problem;
  const double rounding = rounding_of_pressure(problem, report.outcome.stress, report.contact, pair);
  Unrolled line;
  const auto add = [](std::string& data, double s, double value) {
    fmt::format_to(std::back_inserter(data), "{:.9g} {:.9g}\n", s, value);
  };
  for (const Chain& chain : chains(problem, pair)) {
    for (const int i : chain) {
      const int facet = problem.contact[i].first;
      const double from = line.length, to = from + scene::length(problem.mesh, facet);
      const bounds::ContactState& state = report.contact[i];
      const auto draw = [&](std::string& data, const std::vector<double>& coefficients) {
        const std::vector<double> values = samples(coefficients);
        for (std::size_t k = 0; k < values.size(); ++k)
          add(data, from + (to - from) * static_cast<double>(k) / static_cast<double>(values.size() - 1), values[k]);
      };
      draw(line.equilibrated, state.pressure);
      draw(line.of_displacement, displacement_pressure(problem, report.outcome.displacement, facet));
      line.of_displacement += "\n";  // it jumps from edge to edge
      draw(line.gap, state.gap_left);
      if (presses(state, rounding)) {
        add(line.pressed, from, 1);
        add(line.pressed, to, 1);
      } else {
        line.pressed += "\n";
      }
      line.length = to;
    }
    for (std::string* data : {&line.equilibrated, &line.gap, &line.pressed}) *data += "\n";  // the next piece
  }
  return line;
}

/// The pressure up to which a pair is drawn: near the largest, but where it is singular less, or nothing else would be
/// seen. Three hundredths of the pressed length may reach beyond.
double drawn_pressure(const Report& report, int pair) {
  const scene::Problem<2>& problem = report.outcome.problem;
  const double rounding = rounding_of_pressure(problem, report.outcome.stress, report.contact, pair);
  std::vector<std::pair<double, double>> pressed;  // largest pressure on a facet, and its length
  double length = 0;
  for (std::size_t i = 0; i < problem.contact.size(); ++i) {
    if (problem.contact[i].pair != pair || !presses(report.contact[i], rounding)) continue;
    pressed.emplace_back(std::ranges::max(report.contact[i].pressure),
                         scene::length(problem.mesh, problem.contact[i].first));
    length += pressed.back().second;
  }
  if (pressed.empty()) return 1;
  std::ranges::sort(pressed, std::greater<>());
  double beyond = 0;
  const auto usual =
      std::ranges::find_if(pressed, [&](const auto& facet) { return (beyond += facet.second) > 0.03 * length; });
  return std::min(1.15 * pressed.front().first, 1.5 * usual->first);
}

/// The gap up to which a pair is drawn. One that is closed but for rounding errors is drawn so, by the displacements.
double drawn_gap(const Report& report, int pair) {
  double open = 0, moved = 0;
  for (std::size_t i = 0; i < report.contact.size(); ++i)
    if (report.outcome.problem.contact[i].pair == pair)
      open = std::max(open, std::ranges::max(report.contact[i].gap_left));
  for (const scene::Vector<2>& u : report.outcome.displacement.vertex) moved = std::max(moved, u.norm());
  if (open <= bounds::Checks::tolerance * moved) open = moved;
  return open > 0 ? 1.15 * open : 1;
}

std::string panel(const Report& report, int pair) {
  const scene::ContactPair<2>& names = report.scene.contact[pair];
  const Unrolled line = unroll(report, pair);
  const double top = drawn_pressure(report, pair), widest = drawn_gap(report, pair);
  const bool none = line.pressed.find_first_not_of('\n') == std::string::npos;
  return fmt::format(
      "set title {} noenhanced\nset xrange [0:{}]\nset yrange [{}:{}]\nset y2range [{}:{}]\n"
      "plot '-' using 1:(-{}*$2) with filledcurves y1={} fc rgb '#8fb4d6' title 'pressed', "
      "'-' with lines lw 2.4 lc rgb '{}' title 'pressure, stresses', "
      "'-' with lines lw 1.2 lc rgb '{}' title 'pressure, displacements', "
      "'-' axes x1y2 with lines lw 1.8 dt (6,3) lc rgb '#3f8f3f' title 'gap left'\n"
      "{}e\n{}e\n{}e\n{}e\n",
      quoted(name(names.first) + " on " + name(names.second)), line.length, -0.08 * top, top, -0.08 * widest, widest,
      0.03 * top, -0.08 * top, stress_colour, displacement_colour, none ? "0 0\n" : line.pressed, line.equilibrated,
      line.of_displacement, line.gap);
}

}  // namespace

Picture contact_picture(const Report& report) {
  const int pairs = static_cast<int>(report.scene.contact.size());
  std::string script =
      plot_style() +
      "set ytics nomirror\nset y2tics\nset xlabel 'arc length'\nset ylabel 'pressure'\nset y2label 'gap'\n" +
      units_label(report.scene.units) + fmt::format("set multiplot layout {},1\n", pairs);
  for (int pair = 0; pair < pairs; ++pair) script += panel(report, pair);
  return {
      "contact",
      "Pressure of both formulations and the gap that the displacements leave along each contact line, from the left "
      "end of its first side as seen from inside. The bar at the bottom marks where the stresses press. Pressures of "
      "the displacements jump from edge to edge; singular ones are cut at the frame.",
      900,
      330 * pairs,
      script + "unset multiplot\n",
      true};
}

}  // namespace bracket::apps
