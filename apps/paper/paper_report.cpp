// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "apps/paper/paper.h"
#include "apps/plots/pictures.h"
#include "apps/report/json.h"

namespace bracket::apps {
namespace {

std::string number(const Table::Column& column, double value) {
  return std::isnan(value) ? "-" : fmt::format(fmt::runtime("{:" + column.format + "}"), value);
}

std::size_t column(const Table& table, const std::string& name) {
  return std::ranges::find(table.columns, name, &Table::Column::name) - table.columns.begin();
}

}  // namespace

std::string table_text(const Table& table) {
  std::size_t label = 0;
  for (const Table::Row& row : table.rows) label = std::max(label, row.label.size());
  std::vector<std::size_t> width;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    width.push_back(table.columns[c].name.size());
    for (const Table::Row& row : table.rows)
      width[c] = std::max(width[c], number(table.columns[c], row.values[c]).size());
  }
  std::string text = fmt::format("{}\n\n{:{}}", table.claim, "", label);
  for (std::size_t c = 0; c < width.size(); ++c) text += fmt::format("  {:>{}}", table.columns[c].name, width[c]);
  text += "\n";
  for (const Table::Row& row : table.rows) {
    text += fmt::format("{:{}}", row.label, label);
    for (std::size_t c = 0; c < width.size(); ++c)
      text += fmt::format("  {:>{}}", number(table.columns[c], row.values[c]), width[c]);
    text += "\n";
  }
  return text + "\n";
}

std::string paper_json(const std::vector<Table>& tables) {
  using Json = nlohmann::ordered_json;
  Json json = heading();
  for (const Table& table : tables) {
    Json rows = Json::array(), names = Json::array();
    for (const Table::Column& column : table.columns) names.push_back(column.name);
    for (const Table::Row& row : table.rows) rows.push_back({{"label", row.label}, {"values", row.values}});
    json["tables"][table.key] = {{"claim", table.claim}, {"columns", names}, {"rows", rows}};
  }
  return json.dump(2) + "\n";
}

Picture paper_picture(const Table& interpolation, const Table& stress_error) {
  std::vector<double> sizes, errors;
  std::string items, data, last;
  std::size_t colour = 0;
  constexpr std::array<int, 5> colours = {1, 2, 3, 4, 7};  // gnuplot's; its fifth is pale
  for (const auto& [table, name] : {std::pair(&interpolation, "r_h, "), std::pair(&stress_error, "λ_h, ")}) {
    const std::size_t h = column(*table, "h"), error = column(*table, "error");
    for (const Table::Row& row : table->rows) {
      const std::string title = name + row.label;
      if (title != last) {
        items += fmt::format("{}'-' with linespoints lw 2 ps 0.7 pt 7 lc {} title {} noenhanced",
                             items.empty() ? "" : ", ", colours[colour++ % colours.size()], quoted(title));
        data += data.empty() ? "" : "e\n";
        last = title;
      }
      sizes.push_back(row.values[h]);
      errors.push_back(row.values[error]);
      data += fmt::format("{} {}\n", sizes.back(), errors.back());
    }
  }
  return {"paper",
          "The errors of the interpolation r_h (Theorem 2.2) and of the stresses λ_h (Theorem 2.3), by the norm of the "
          "stress, against h.",
          900, 560,
          plot_style() + log_axis("x", sizes) + log_axis("y", errors) +
              fmt::format("set xlabel 'h'\nset ylabel 'relative error'\nplot {}\n{}e\n", items, data)};
}

}  // namespace bracket::apps
