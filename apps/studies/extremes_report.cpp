// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/plots/pictures.h"
#include "apps/report/json.h"
#include "apps/report/lines.h"
#include "apps/report/numbers.h"
#include "apps/report/quantities.h"
#include "apps/studies/extremes.h"

namespace bracket::apps {

double Interval::relative_width() const {
  const double size = std::max(std::abs(lower), std::abs(upper));
  return size > 0 ? (upper - lower) / size : 0;
}

std::optional<bool> contains_reference(const Extreme& extreme) {
  if (!extreme.interval || !extreme.reference) return std::nullopt;
  return extreme.interval->lower <= extreme.reference->upper + extreme.slack &&
         extreme.reference->lower <= extreme.interval->upper + extreme.slack;
}

namespace {

std::string verdict(const Extreme& row) {
  const auto contains = contains_reference(row);
  return !contains ? "-" : *contains ? "yes" : "NO";
}

/// Relative width by the benign one; none where there is no interval or the benign one has no width.
std::optional<double> widening(const Extremes& extremes, const Extreme& row) {
  const double benign = extremes.benign.relative_width();
  if (!row.interval || benign == 0) return std::nullopt;
  return row.interval->relative_width() / benign;
}

bool has_width(const Extreme& row) { return row.interval && row.interval->relative_width() > 0; }

constexpr const char* format = "{:>8}  {}{:>9}{:>6}{:>8}";
constexpr std::size_t interval_columns = 42;

/// \param reasons those of the lines before and of this one
std::string line(const Extremes& extremes, const Extreme& row, const std::vector<std::string>& reasons) {
  const auto ratio = widening(extremes, row);
  const auto reason = std::ranges::find(reasons, row.reason);
  const std::string refused = fmt::format("status {}{}", static_cast<int>(row.status),
                                          row.reason.empty() ? "" : fmt::format(" [{}]", reason - reasons.begin() + 1));
  return fmt::format(format, fmt::format("{:.2g}", row.parameter),
                     padded(row.interval ? interval_text(row.interval->lower, row.interval->upper, "") : refused,
                            interval_columns),
                     row.interval ? rounded_up_exponent(row.interval->relative_width()) : "-", verdict(row),
                     ratio ? fmt::format("{:.2g}", *ratio) : "-") +
         "\n";
}

}  // namespace

std::string extremes_text(const Extremes& extremes) {
  std::string text =
      fmt::format(format, "", padded("energy between", interval_columns), "width", "meets", "wider") + "\n";
  const Interval& benign = extremes.benign;
  text += "the scene as it is\n" +
          fmt::format(format, "", padded(interval_text(benign.lower, benign.upper, ""), interval_columns),
                      rounded_up_exponent(benign.relative_width()), "", "") +
          "\n";
  std::vector<std::string> reasons;
  std::string sweep;
  for (const Extreme& row : extremes.rows) {
    if (!row.reason.empty() && std::ranges::find(reasons, row.reason) == reasons.end()) reasons.push_back(row.reason);
    if (row.sweep != sweep) text += (sweep = row.sweep) + "\n";
    text += line(extremes, row, reasons);
  }
  text +=
      "(each interval is that of one mesh, the scene's first, for the resultants\n"
      "refined at the ends of the contact; width: relative, rounded up; wider: by that\n"
      "of the scene as it is; meets: whether the interval meets another of the same\n"
      "energy: that of the scene as it is, times the factor of the change, or where the\n"
      "problem is another one its own on the mesh with all edges halved)\n";
  for (std::size_t i = 0; i < reasons.size(); ++i) text += fmt::format("[{}] {}\n", i + 1, reasons[i]);
  for (const std::string& reason : extremes.left_out) text += "left out: " + reason + "\n";
  return within_columns(text);
}

std::string extremes_csv(const Extremes& extremes) {
  const auto number = [](const std::optional<double>& value) { return value ? fmt::format("{}", *value) : ""; };
  std::string text =
      "sweep,parameter,lower,upper,relative_width,reference_lower,reference_upper,contains_reference,widening,seconds,"
      "status\n";
  for (const Extreme& row : extremes.rows) {
    const auto of = [&](const std::optional<Interval>& interval, double Interval::*end) {
      return interval ? number((*interval).*end) : "";
    };
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", row.sweep, row.parameter,
                        of(row.interval, &Interval::lower), of(row.interval, &Interval::upper),
                        row.interval ? number(row.interval->relative_width()) : "", of(row.reference, &Interval::lower),
                        of(row.reference, &Interval::upper), row.reference ? verdict(row) : "",
                        number(widening(extremes, row)), row.seconds, static_cast<int>(row.status));
  }
  return text;
}

std::string extremes_json(const scene::Scene<2>& scene, const Extremes& extremes) {
  using Json = nlohmann::ordered_json;
  const auto interval = [](const std::optional<Interval>& value) -> Json {
    if (!value) return nullptr;
    return {{"lower", value->lower}, {"upper", value->upper}, {"relative_width", value->relative_width()}};
  };
  Json rows = Json::array();
  for (const Extreme& row : extremes.rows) {
    const auto contains = contains_reference(row);
    const auto ratio = widening(extremes, row);
    rows.push_back({{"sweep", row.sweep},
                    {"parameter", row.parameter},
                    {"status", static_cast<int>(row.status)},
                    {"reason", row.reason},
                    {"energy", interval(row.interval)},
                    {"reference", interval(row.reference)},
                    {"contains_reference", contains ? Json(*contains) : Json(nullptr)},
                    {"widening", ratio ? Json(*ratio) : Json(nullptr)},
                    {"seconds", row.seconds}});
  }
  Json json = heading(scene);
  json["benign"] = interval(extremes.benign);
  json["rows"] = std::move(rows);
  json["left_out"] = extremes.left_out;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

bool has_picture(const Extremes& extremes) { return std::ranges::any_of(extremes.rows, has_width); }

Picture extremes_picture(const Extremes& extremes) {
  struct Panel {
    std::string sweep, data;
    std::vector<double> parameters;
  };
  std::vector<Panel> panels;
  std::vector<double> widths;
  for (const Extreme& row : extremes.rows) {
    if (!has_width(row)) continue;
    if (panels.empty() || panels.back().sweep != row.sweep) panels.push_back({row.sweep, "", {}});
    widths.push_back(row.interval->relative_width());
    panels.back().parameters.push_back(row.parameter);
    panels.back().data += fmt::format("{} {}\n", row.parameter, widths.back());
  }
  constexpr int columns = 3;
  const int lines = (static_cast<int>(panels.size()) + columns - 1) / columns;
  const double benign = extremes.benign.relative_width();
  if (benign > 0) widths.push_back(benign);
  const int height = 20 + 200 * lines;
  std::string script = plot_style() + "unset key\n" + log_axis("y", widths) +
                       fmt::format(
                           "set xtics font ',12'\nset ytics font ',12'\nunset mxtics\nunset mytics\n"
                           "set multiplot layout {},{} margins 0.12,0.98,{:.4f},{:.4f} spacing 0.09,{:.4f}\n",
                           lines, columns, 35.0 / height, 1 - 35.0 / height, 65.0 / height);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Panel& panel = panels[i];
    script += std::string(i % columns == 0 ? "set ylabel 'relative width' font ',13'\n" : "unset ylabel\n");
    script += fmt::format("set title {} noenhanced font ',14' offset 0,-0.4\n", quoted(panel.sweep)) +
              log_axis("x", panel.parameters) + "plot ";
    if (benign > 0) script += fmt::format("{} with lines lw 1.2 dt (4,4) lc rgb '#888888', ", benign);
    script += fmt::format("'-' with linespoints lw 2 ps 0.6 pt 7 lc rgb '{}'\n{}e\n", stress_colour, panel.data);
  }
  return {"extremes",
          "The relative width of the guaranteed interval against the parameter that goes to its limit, a panel per "
          "sweep, all in one measure. Dashed: the scene as it is.",
          900,
          height,
          script + "unset multiplot\n",
          true};
}

}  // namespace bracket::apps
