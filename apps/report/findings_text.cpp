// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/report/findings.h"
#include "apps/report/html.h"
#include "apps/report/lines.h"
#include "apps/report/quantities.h"
#include "apps/report/units.h"
#include "apps/report/words.h"
#include "scene/text.h"

namespace bracket::apps {
namespace {

std::string number(double value) { return std::isfinite(value) ? fmt::to_string(value) : ""; }

}  // namespace

const char* mark(Standing standing) { return standing == Standing::guaranteed ? "●" : "○"; }
const char* name(Standing standing) { return standing == Standing::guaranteed ? "guaranteed" : "computed"; }

template <int dim> std::string what(const FindingOf<dim>& finding) {
  if (finding.key == "largest_von_mises_stress") return "largest von Mises stress";
  std::string words = finding.key;
  std::ranges::replace(words, '_', ' ');
  return words;
}

template <int dim> std::string of_what(const FindingOf<dim>& finding) {
  switch (finding.subject) {
    case Subject::contact: return "contact " + finding.of;
    case Subject::support: return "support " + finding.of;
    case Subject::bodies: return "all bodies";
  }
  return {};
}

template <int dim> std::string value_with_place(const FindingOf<dim>& finding, const std::string& length) {
  const std::string value =
      finding.bounds ? interval_text(finding.bounds->lower, finding.bounds->upper, finding.unit)
                     : fmt::format("{:.4g}{}", std::abs(finding.computed) <= finding.rounding ? 0 : finding.computed,
                                   finding.unit);
  const std::string place = finding.at ? " at " + scene::point(*finding.at) + length : "";
  return value + place + (finding.note.empty() ? "" : ", " + finding.note);
}

template <int dim> std::string findings_text(const ReportOf<dim>& report) {
  const std::string length = units_of(report.scene.units, dim).length;
  const std::vector<FindingOf<dim>> rows = findings(report);
  std::size_t longest = 0;
  for (const FindingOf<dim>& row : rows) longest = std::max(longest, row.key.size());
  std::string text, of;
  for (const FindingOf<dim>& row : rows) {
    if (of_what(row) != of) text += "\n" + (of = of_what(row)) + "\n";
    text += fmt::format("  {} {:<10}  {:<{}}  {}\n", mark(row.standing()), name(row.standing()), what(row), longest,
                        value_with_place(row, length));
  }
  return text;
}

template <int dim> std::string findings_csv(const ReportOf<dim>& report) {
  std::string text = "of,what,standing,computed,lower,upper,unit,";
  for (int axis = 0; axis < dim; ++axis) text += fmt::format("{},", axis_names[axis]);
  text += "note\n";
  for (const FindingOf<dim>& row : findings(report)) {
    const auto unit = row.unit.substr(std::min<std::size_t>(1, row.unit.size()));
    text += fmt::format("{},{},{},{},{},{},{},", csv_text(of_what(row)), row.key, name(row.standing()),
                        number(row.computed), row.bounds ? number(row.bounds->lower) : "",
                        row.bounds ? number(row.bounds->upper) : "", csv_text(unit));
    for (int axis = 0; axis < dim; ++axis) text += fmt::format("{},", row.at ? number((*row.at)[axis]) : "");
    text += csv_text(row.note) + "\n";
  }
  return text;
}

template <int dim> std::string findings_html(const ReportOf<dim>& report) {
  const std::string length = units_of(report.scene.units, dim).length;
  std::vector<std::vector<std::string>> rows;
  std::string of;
  for (const FindingOf<dim>& row : findings(report)) {
    const bool begins = of_what(row) != of;
    of = of_what(row);
    rows.push_back({begins ? escaped(of) : "", escaped(what(row)), escaped(value_with_place(row, length)),
                    fmt::format("{} {}", mark(row.standing()), name(row.standing()))});
  }
  return "<h2>Contacts, supports, bodies</h2>\n" +
         html_table({"of", "what", "value", "standing"}, rows, 4,
                    "● lies in the interval for sure; ○ is a number of the computed fields", "findings");
}

template std::string what(const FindingOf<2>&);
template std::string of_what(const FindingOf<2>&);
template std::string value_with_place(const FindingOf<2>&, const std::string&);
template std::string findings_text(const ReportOf<2>&);
template std::string findings_csv(const ReportOf<2>&);
template std::string findings_html(const ReportOf<2>&);
template std::string what(const FindingOf<3>&);
template std::string of_what(const FindingOf<3>&);
template std::string value_with_place(const FindingOf<3>&, const std::string&);
template std::string findings_text(const ReportOf<3>&);
template std::string findings_csv(const ReportOf<3>&);
template std::string findings_html(const ReportOf<3>&);

}  // namespace bracket::apps
