// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "apps/report/report.h"

/// The numbers that are told of a level: one table for all files and pages.
namespace bracket::apps {

using Number = std::variant<int, double>;

/// How people see a number: with all its digits, as a bound of a ratio, or with two decimals. Files have all digits.
enum class Shape { number, percent, seconds };

struct Column {
  std::string name;  ///< in history.csv and study.csv
  std::string path;  ///< in a level of report.json and study.json, a JSON pointer
  std::function<Number(const bounds::Level& level, const LevelSeconds& around)> value;
  Shape shape = Shape::number;
};

/// All of them, as they follow one another in files.
const std::vector<Column>& columns();

/// The names, and the values of one level, separated by commas.
std::string csv_names();
std::string csv_values(const bounds::Level& level, const LevelSeconds& around);

/// A number by its column's name, and its sum over the levels of a report. \pre there is such a column
double value(const std::string& name, const bounds::Level& level, const LevelSeconds& around);
template <int dim> double sum(const std::string& name, const ReportOf<dim>& report);

/// What a formulation spends its time on: the seconds are in the columns primal_assemble, dual_assemble and so on.
inline constexpr std::array<const char*, 5> phase_names = {"assemble", "order", "factorise", "contact", "recover"};

/// A column that people see: a number of each level, or several as "a / b".
struct Shown {
  std::string heading;
  std::vector<std::string> names;  ///< of columns
};
/// A row of headings, then one for each level: its index, and what is shown of it. \pre there are such columns
template <int dim>
std::vector<std::vector<std::string>> level_rows(const ReportOf<dim>& report, const std::vector<Shown>& shown);

}  // namespace bracket::apps
