// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <bracket/version.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/report/findings.h"
#include "apps/report/html.h"
#include "apps/report/numbers.h"
#include "apps/report/quantities.h"
#include "apps/report/sheet.h"
#include "apps/report/sheet_parts.h"
#include "apps/report/units.h"

namespace bracket::apps {
namespace {

using Rows = std::vector<std::vector<std::string>>;

// What one page holds: lines of each list, and characters of a text that someone else wrote.
constexpr std::size_t most_levels = 4, most_intervals = 8, most_findings = 6, most_costs = 4, most_overrides = 3,
                      most_characters = 160, most_of_title = 100, most_of_name = 48;

/// The text's beginning, whole characters of UTF-8, escaped.
std::string short_text(const std::string& text, std::size_t most = most_characters) {
  if (text.size() <= most) return escaped(text);
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return escaped(text.substr(0, end)) + "…";
}

/// The first rows; the last of them tells how many more there are.
Rows first_rows(Rows rows, std::size_t most, const char* where) {
  if (rows.size() <= most) return rows;
  const std::size_t left = rows.size() - (most - 1);
  const std::size_t columns = rows.front().size();
  rows.resize(most - 1);
  rows.push_back({"…", fmt::format("{} more in {}", left, where)});
  rows.back().resize(columns);
  return rows;
}

Rows rows_of(const std::vector<Line>& lines) {
  Rows rows;
  for (const auto& [what, said] : lines) rows.push_back({escaped(what), short_text(said)});
  return rows;
}

/// A heading and what is said of what.
std::string section(const char* title, const Rows& rows) {
  std::string html = fmt::format("<h2>{}</h2>\n<dl class=\"said\">\n", title);
  for (const auto& row : rows) html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", row[0], row[1]);
  return html + "</dl>\n";
}

template <int dim> std::string problem(const ReportOf<dim>& report, const Given& given) {
  Rows rows = {{"mathematical model", short_text(model(report))}};
  for (const FileRead& one : given.files)
    rows.push_back(
        {"file", short_text(one.file) + (one.sha256.empty() ? "" : "<br><code>SHA-256 " + one.sha256 + "</code>")});
  Rows changes;
  for (const std::string& one : given.overrides)
    changes.push_back({"changed", "<code>" + short_text(one, most_of_name) + "</code>"});
  const Rows shown = first_rows(std::move(changes), most_overrides, "sheet.json");
  rows.insert(rows.end(), shown.begin(), shown.end());
  return section("Problem", rows);
}

template <int dim> std::string order_text(const ReportOf<dim>& report) {
  if (const auto order = order_of(report))
    return fmt::format("{:.2f} by the mean size of a cell, over the last half of the meshes; formal: {}",
                       order->by_size, report.scene.solve.degree);
  return error_is_rounding(report.outcome) ? "none: the error is rounding"
                                           : "none: that takes three meshes or more with an error";
}

/// The first mesh and the last ones.
template <int dim> std::string meshes(const ReportOf<dim>& report) {
  const auto& levels = report.outcome.levels;
  Rows rows;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (levels.size() > most_levels && i > 0 && i + most_levels - 1 < levels.size()) continue;
    const double error = levels[i].bracket.relative_error_bound;
    rows.push_back({fmt::to_string(i), fmt::to_string(levels[i].cells), fmt::to_string(levels[i].primal.unknowns),
                    fmt::to_string(levels[i].dual.unknowns), std::isfinite(error) ? percent(error) : "none"});
  }
  return html_table({"mesh", "cells", "unknowns, displacements", "unknowns, stresses", "guaranteed relative error"},
                    rows, 0,
                    levels.size() > most_levels
                        ? fmt::format("The first and the last of {} meshes; all are in sheet.json", levels.size())
                        : "The meshes");
}

template <int dim> std::string verification(const ReportOf<dim>& report) {
  const auto& outcome = report.outcome;
  Rows rows = {{"method", escaped(method(report))}, {"observed order", order_text(report)}};
  rows.push_back({"guarantee", fmt::format("{}: {}", escaped(outcome.guarantee), escaped(certainty(report)))});
  return section("Verification of the calculation (ASME V&amp;V 10)", rows) + meshes(report);
}

template <int dim> std::string intervals(const ReportOf<dim>& report) {
  if (report.outcome.guarantee == "none") return "";
  Rows rows;
  for (std::size_t i = 0; i < report.outcome.quantities.size(); ++i)
    rows.push_back({short_text(report.outcome.quantities[i].name, most_of_name), short_text(told(report, i))});
  rows = first_rows(std::move(rows), most_intervals, "sheet.json");
  rows.push_back({"energy", escaped(told_energy(report, report.outcome.lower, report.outcome.upper))});
  rows.insert(rows.begin(), {"displacements, stresses",
                             report.outcome.unstrained ? "nothing is strained, but for rounding"
                                                       : fmt::format("≤ {} in the energy norm",
                                                                     percent(report.outcome.relative_error_bound))});
  for (auto& row : rows)
    if (row[0] != "…") row[0] = std::string(mark(Standing::guaranteed)) + " " + row[0];
  return "<h2>Numerical uncertainty (ASME V&amp;V 20)</h2>\n" +
         html_table({"of", "interval   ± numerical uncertainty"}, rows, 2,
                    "± is half of an interval's width: a bound of the numerical error of its middle, not a standard "
                    "deviation. Where a standard uncertainty u<sub>num</sub> is asked for, it is at most that.");
}

template <int dim> bool is_told(const FindingOf<dim>& finding) {
  return finding.subject != Subject::contact || finding.key == "force" || finding.key == "largest_pressure";
}

/// Of all bodies first, then contacts and supports.
template <int dim> std::string found(const ReportOf<dim>& report) {
  std::vector<FindingOf<dim>> all = findings(report);
  std::erase_if(all, [](const FindingOf<dim>& one) { return !is_told(one); });
  std::ranges::stable_partition(all, [](const FindingOf<dim>& one) { return one.subject == Subject::bodies; });
  const std::string length = units_of(report.scene.units, dim).length;
  Rows rows;
  for (const FindingOf<dim>& one : all)
    rows.push_back({fmt::format("{} {}", mark(one.standing()), what(one)), short_text(of_what(one), most_of_name),
                    short_text(value_with_place(one, length))});
  return "<h2>Contacts, supports, bodies</h2>\n" +
         html_table({"what", "of", "value"}, first_rows(std::move(rows), most_findings, "sheet.json"), 3,
                    "● lies in the interval for sure; ○ is a number of the computed fields");
}

constexpr const char* sheet_style = R"(
main { max-width: 52rem; padding: 1.2rem 1.25rem 2rem; }
h1 { font-size: 1.3rem; }
h2 { font-size: .95rem; margin: .8rem 0 .2rem; }
header p { font-size: .85rem; }
table { font-size: .8rem; }
caption { padding: .25rem .5rem .1rem; }
th, td, td.name { padding: .12rem .5rem; min-width: 0; }
tbody th.name { white-space: normal; }
.said { display: grid; grid-template-columns: 11rem 1fr; gap: .1rem .8rem; margin: 0; font-size: .8rem; }
.said dt { color: var(--soft); }
.said dd { margin: 0; overflow-wrap: anywhere; }
code { font-size: .72rem; overflow-wrap: anywhere; }
footer { margin-top: .8rem; font-size: .75rem; }
@media (max-width: 40rem) { .said { grid-template-columns: 1fr; } .said dd { margin-bottom: .3rem; } }
@page { margin: 10mm 14mm; }
@media print {
  body { font-size: 8.5pt; line-height: 1.3; }
  h1 { font-size: 13pt; }
  h2 { font-size: 9pt; margin: 1.6mm 0 .4mm; }
  table, .said, header p { font-size: 7pt; }
  .said { grid-template-columns: 36mm 1fr; gap: .2mm 2mm; }
  th, td, td.name { padding: .1mm 1.5mm; }
  code { font-size: 6.5pt; }
  footer { margin-top: 2mm; font-size: 7pt; }
}
)";

}  // namespace

template <int dim> std::string sheet_html(const ReportOf<dim>& report, const Given& given) {
  const std::string title =
      short_text(report.scene.title.empty() ? report.scene.file : report.scene.title, most_of_title);
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{0} – sheet – Bracket</title>\n"
      "<style>{1}{2}</style>\n</head>\n<body>\n<main>\n<header><h1>{0}</h1><p>Sheet of a calculation by Bracket {3}{4}"
      "</p></header>\n",
      title, html_style, sheet_style, BRACKET_VERSION_STRING, given.ended.empty() ? "" : " · " + escaped(given.ended));
  html += problem(report, given) + verification(report) + intervals(report) + found(report);
  html += section("Cost of data and geometry", first_rows(rows_of(costs(report)), most_costs, "sheet.json"));
  html += section("Outside of the model", rows_of(outside<dim>()));
  return html +
         "<footer>All numbers with all their digits are in sheet.json, the fields in the folder of the run, what this "
         "version was verified by in its documentation (docs/verification.md).</footer>\n</main>\n</body>\n</html>\n";
}

template std::string sheet_html(const ReportOf<2>&, const Given&);
template std::string sheet_html(const ReportOf<3>&, const Given&);

}  // namespace bracket::apps
