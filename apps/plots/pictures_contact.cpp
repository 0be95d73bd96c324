// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include "apps/plots/pictures.h"
#include "apps/report/pairs.h"
#include "apps/report/samples.h"

namespace bracket::apps {
namespace {

/// A contact line unrolled: what is drawn over its arc length, as lines of data. It begins where the stretches of
/// quantities do.
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
  for (Chain chain : chains(problem, pair)) {
    std::ranges::reverse(
        chain);  // the body is to the left of its facets: they begin at the right end, seen from inside
    for (const int i : chain) {
      const int facet = problem.contact[i].first;
      const double from = line.length, to = from + scene::length(problem.mesh, facet);
      const bounds::ContactState& state = report.contact[i];
      const auto draw = [&](std::string& data, const std::vector<double>& coefficients) {
        std::vector<double> values = samples(coefficients);
        std::ranges::reverse(values);
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

/// What is certain of the zones of a pair: of each from where to where, and between what its mean pressure lies.
std::string certain_zones(const Report& report, int pair, double length) {
  const int zones = report.scene.contact[pair].zones;
  std::string boxes;
  for (const bounds::QuantityInterval& zone : report.outcome.quantities) {
    if (zone.zone < 0 || zone.contact != pair || !std::isfinite(zone.lower) || !std::isfinite(zone.upper)) continue;
    const double from = zone.zone * length / zones, to = (zone.zone + 1) * length / zones;
    fmt::format_to(std::back_inserter(boxes), "{:.9g} 0 {:.9g} {:.9g} {:.9g} {:.9g}\n", from, from, to,
                   zone.lower / (to - from), zone.upper / (to - from));
  }
  return boxes;
}

std::string panel(const Report& report, int pair) {
  const Unrolled line = unroll(report, pair);
  const double top = drawn_pressure(report, pair), widest = drawn_gap(report, pair);
  const double bottom = -std::max(0.08 * top, 1.15 * summary(report, pair).largest_tension);
  const bool none = line.pressed.find_first_not_of('\n') == std::string::npos;
  const std::string zones = certain_zones(report, pair, line.length);
  const std::string certain =
      zones.empty() ? "" : "'-' with boxxyerror fs solid 0.35 border lc rgb '#e0a030' title 'zones', ";
  return fmt::format(
      "set title {} noenhanced font ',16'\nset xrange [0:{}]\nset yrange [{}:{}]\nset y2range [{}:{}]\nplot {}"
      "'-' using 1:(-{}*$2) with filledcurves y1={} fc rgb '#ff2f5f' title 'pressed', "
      "'-' with lines lw 2.4 lc rgb '{}' title 'stresses', "
      "'-' with lines lw 1.2 lc rgb '{}' title 'displacements', "
      "'-' axes x1y2 with lines lw 1.8 dt (6,3) lc rgb '#3f8f3f' title 'gap left'\n"
      "{}{}e\n{}e\n{}e\n{}e\n",
      quoted(pair_name(report.scene.contact[pair])), line.length, bottom, top, bottom / top * widest, widest, certain,
      0.03 * top, bottom, stress_colour, displacement_colour, zones.empty() ? "" : zones + "e\n",
      none ? "0 0\n" : line.pressed, line.equilibrated, line.of_displacement, line.gap);
}

}  // namespace

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

Picture contact_picture(const Report& report, int pair) {
  const std::string& units = report.scene.units;
  const scene::ContactPair<2>& names = report.scene.contact[pair];
  std::string caption =
      pair_name(names) +
      ": pressure of both formulations, by stresses and by displacements, and the gap that the displacements leave, "
      "from "
      "the left end of the first side as seen from inside: computed, not guaranteed. The bar at the bottom marks where "
      "the stresses press. Pressures of the displacements jump from edge to edge; singular ones are cut at the frame.";
  if (names.zones > 0) caption += " Boxes: between what the mean pressure of each zone lies, guaranteed.";
  return {report.scene.contact.size() == 1 ? "contact" : fmt::format("contact_{}", pair + 1), std::move(caption), 600,
          400,
          plot_style() +
              fmt::format("set key font ',14'\nset ytics nomirror\nset y2tics\nset xlabel {} noenhanced\n"
                          "set ylabel {} noenhanced\nset y2label {} noenhanced\n",
                          with_unit("arc length", length_unit(units)), with_unit("pressure", stress_unit(units)),
                          with_unit("gap", length_unit(units))) +
              panel(report, pair)};
}

}  // namespace bracket::apps
