// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "apps/report/numbers.h"

namespace bracket::apps {
namespace {

using bounds::Bracket;
using bounds::Level;
using bounds::PlainEnergies;
using bounds::Seconds;
using contact::Phases;
using contact::Statistics;

/// The member of a level that the members lead to, each in the one before.
template <class... Members> auto of(Members... members) {
  return [=](const Level& level, const LevelSeconds&) -> Number { return (level.*....*members); };
}

auto of(double LevelSeconds::*member) {
  return [=](const Level&, const LevelSeconds& around) -> Number { return around.*member; };
}

std::vector<Column> made() {
  std::vector<Column> all = {
      {"cells", "/cells", of(&Level::cells)},
      {"primal_dofs", "/primal_dofs", of(&Level::primal, &Statistics::unknowns)},
      {"dual_dofs", "/dual_dofs", of(&Level::dual, &Statistics::unknowns)},
      {"lower", "/lower", of(&Level::bracket, &Bracket::lower)},
      {"upper", "/upper", of(&Level::bracket, &Bracket::upper)},
      {"relative_width", "/relative_width", of(&Level::bracket, &Bracket::relative_width), Shape::percent},
      {"relative_error_bound", "/relative_error_bound", of(&Level::bracket, &Bracket::relative_error_bound),
       Shape::percent},
      {"contact_rows", "/contact/rows", of(&Level::primal, &Statistics::rows)},
      {"contact_active", "/contact/active", of(&Level::primal, &Statistics::active_rows)},
      {"contact_iterations", "/contact/iterations", of(&Level::primal, &Statistics::iterations)},
      {"seconds_mesh", "/seconds/mesh", of(&Level::seconds, &Seconds::mesh), Shape::seconds},
      {"seconds_primal", "/seconds/primal", of(&Level::seconds, &Seconds::primal), Shape::seconds},
      {"seconds_dual", "/seconds/dual", of(&Level::seconds, &Seconds::dual), Shape::seconds},
      {"seconds_estimate", "/seconds/estimate", of(&Level::seconds, &Seconds::estimate), Shape::seconds},
      {"seconds_certify", "/seconds/certify", of(&Level::seconds, &Seconds::certify), Shape::seconds},
      {"seconds_quantities", "/seconds/quantities", of(&Level::seconds, &Seconds::quantities), Shape::seconds},
      {"seconds_total", "/seconds/total", of(&Level::seconds, &Seconds::total), Shape::seconds},
      {"seconds_write", "/seconds/write", of(&LevelSeconds::write), Shape::seconds},
      {"seconds_elapsed", "/seconds/elapsed", of(&LevelSeconds::elapsed), Shape::seconds}};
  constexpr std::array<double Phases::*, 5> phase = {&Phases::assemble, &Phases::order, &Phases::factorise,
                                                     &Phases::contact, &Phases::recover};
  for (const auto& [formulation, statistics] : {std::pair("primal", &Level::primal), std::pair("dual", &Level::dual)})
    for (std::size_t i = 0; i < phase.size(); ++i)
      all.push_back({fmt::format("{}_{}", formulation, phase_names[i]),
                     fmt::format("/seconds/{}_phases/{}", formulation, phase_names[i]),
                     of(statistics, &Statistics::seconds, phase[i]), Shape::seconds});
  all.insert(
      all.end(),
      {{"contact_dual_rows", "/contact/dual/rows", of(&Level::dual, &Statistics::rows)},
       {"contact_dual_active", "/contact/dual/active", of(&Level::dual, &Statistics::active_rows)},
       {"contact_dual_iterations", "/contact/dual/iterations", of(&Level::dual, &Statistics::iterations)},
       {"error_bound", "/error_bound", of(&Level::bracket, &Bracket::error_bound)},
       {"mean_stress_error_bound", "/mean_stress_error_bound", of(&Level::bracket, &Bracket::mean_stress_error_bound)},
       {"plain_lower", "/plain/lower", of(&Level::plain, &PlainEnergies::lower)},
       {"plain_upper", "/plain/upper", of(&Level::plain, &PlainEnergies::upper)},
       {"oscillation_energy", "/oscillation_energy", of(&Level::oscillation_energy)},
       {"imbalance_primal", "/imbalance/primal", of(&Level::primal, &Statistics::imbalance)},
       {"imbalance_dual", "/imbalance/dual", of(&Level::dual, &Statistics::imbalance)}});
  return all;
}

std::string digits(const Number& number) {
  return std::visit([](auto value) { return fmt::to_string(value); }, number);
}

double real(const Number& number) {
  return std::visit([](auto value) { return static_cast<double>(value); }, number);
}

std::string shown_as(Shape shape, const Number& number) {
  switch (shape) {
    case Shape::number: return digits(number);
    case Shape::percent: return percent(real(number));
    case Shape::seconds: return fmt::format("{:.2f}", real(number));
  }
  return {};
}

const Column& column(const std::string& name) {
  const auto found = std::ranges::find(columns(), name, &Column::name);
  assert(found != columns().end());
  return *found;
}

}  // namespace

const std::vector<Column>& columns() {
  static const std::vector<Column> all = made();
  return all;
}

std::string csv_names() {
  std::string line;
  for (const Column& column : columns()) line += (line.empty() ? "" : ",") + column.name;
  return line;
}

std::string csv_values(const Level& level, const LevelSeconds& around) {
  std::string line;
  for (const Column& column : columns()) line += (line.empty() ? "" : ",") + digits(column.value(level, around));
  return line;
}

double value(const std::string& name, const Level& level, const LevelSeconds& around) {
  return real(column(name).value(level, around));
}

template <int dim> double sum(const std::string& name, const ReportOf<dim>& report) {
  double total = 0;
  for (std::size_t i = 0; i < report.outcome.levels.size(); ++i)
    total += value(name, report.outcome.levels[i], report.around[i]);
  return total;
}

template <int dim>
std::vector<std::vector<std::string>> level_rows(const ReportOf<dim>& report, const std::vector<Shown>& shown) {
  std::vector<std::vector<std::string>> rows(1, {"level"});
  for (const Shown& each : shown) rows[0].push_back(each.heading);
  for (std::size_t i = 0; i < report.outcome.levels.size(); ++i) {
    std::vector<std::string>& row = rows.emplace_back(1, fmt::to_string(i));
    for (const Shown& each : shown) {
      std::string cell;
      for (const std::string& name : each.names) {
        const Column& own = column(name);
        cell +=
            (cell.empty() ? "" : " / ") + shown_as(own.shape, own.value(report.outcome.levels[i], report.around[i]));
      }
      row.push_back(cell);
    }
  }
  return rows;
}

template double sum(const std::string&, const ReportOf<2>&);
template std::vector<std::vector<std::string>> level_rows(const ReportOf<2>&, const std::vector<Shown>&);
template double sum(const std::string&, const ReportOf<3>&);
template std::vector<std::vector<std::string>> level_rows(const ReportOf<3>&, const std::vector<Shown>&);

}  // namespace bracket::apps
