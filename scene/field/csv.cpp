// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "scene/field/raw_field.h"
#include "scene/mesh/abaqus_cards.h"
#include "scene/mesh/readers.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

struct Row {
  std::vector<std::string> values;
  int line;
};

/// The rows of a text, without those that are empty.
std::vector<Row> rows_of(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // a byte-order mark
  std::vector<Row> rows;
  for (int line = 1; !text.empty(); ++line) {
    Row row{{}, line};
    for (std::string_view value : fields(text.substr(0, text.find('\n')))) {
      if (value.size() > 1 && value.front() == '"' && value.back() == '"') value = value.substr(1, value.size() - 2);
      row.values.emplace_back(value);
    }
    if (!row.values.empty()) rows.push_back(std::move(row));
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  }
  return rows;
}

[[noreturn]] void refuse(const std::string& file, const Row& row, const std::string& message) {
  fail(Status::input, fmt::format("{}:{}", file, row.line), message);
}

/// The place of each column by its name.
std::map<std::string, std::size_t> columns_of(const std::string& file, const Row& header, int dim) {
  const char* expected = dim == 2 ? "expected a first line with x, y, ux, uy and, if need be, z, uz, body"
                                  : "expected a first line with x, y, z, ux, uy, uz and, if need be, body";
  std::map<std::string, std::size_t> columns;
  for (std::size_t i = 0; i < header.values.size(); ++i) {
    std::string name = header.values[i];
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
    static const std::array known = {"x", "y", "z", "ux", "uy", "uz", "body"};
    if (std::ranges::find(known, name) == known.end())
      refuse(file, header, fmt::format("the column '{}' is not known; {}", header.values[i].substr(0, 40), expected));
    if (!columns.emplace(name, i).second)
      refuse(file, header, fmt::format("the column '{}' is there twice; {}", name, expected));
  }
  std::vector<const char*> all_needed = {"x", "y", "ux", "uy"};
  if (dim == 3) all_needed.insert(all_needed.end(), {"z", "uz"});
  for (const char* needed : all_needed)
    if (!columns.contains(needed)) refuse(file, header, fmt::format("there is no column '{}'; {}", needed, expected));
  return columns;
}

double number(const std::string& file, const Row& row, std::size_t column) {
  const std::optional<double> value = decimal(row.values[column]);
  if (!value) refuse(file, row, fmt::format("'{}' is not a number", row.values[column].substr(0, 40)));
  return *value;
}

}  // namespace

template <int dim> RawField<dim> read_csv_field(const std::filesystem::path& path) {
  RawField<dim> field{.file = path.string(), .word = "line"};
  const std::vector<Row> rows = rows_of(read_text(path));
  if (rows.empty())
    fail(Status::input, field.file,
         fmt::format("is empty; expected a first line with {}", dim == 2 ? "x, y, ux, uy" : "x, y, z, ux, uy, uz"));
  const auto columns = columns_of(field.file, rows[0], dim);
  std::vector<double> out_of_plane;
  for (const Row& row : std::span(rows).subspan(1)) {
    if (row.values.size() != columns.size())
      refuse(field.file, row,
             fmt::format("there are {} values, and {} columns; the file may be truncated", row.values.size(),
                         columns.size()));
    const auto value = [&](const char* name) {
      return columns.contains(name) ? number(field.file, row, columns.at(name)) : 0;
    };
    field.nodes.push_back({row.line, {value("x"), value("y"), value("z")}});
    const std::array<double, 3> u = {value("ux"), value("uy"), value("uz")};
    field.values.emplace_back(Eigen::Map<const Vector<dim>>(u.data()));
    if (dim == 2) out_of_plane.push_back(u[2]);
    if (columns.contains("body")) field.bodies.push_back(row.values[columns.at("body")]);
  }
  field.coordinate_rounding = rounding_of(field.nodes, dim);
  std::vector<RawMesh::Node> values;
  for (const Vector<dim>& u : field.values) values.push_back({0, {u[0], u[1], dim == 3 ? u[dim - 1] : 0}});
  field.value_rounding = rounding_of(values, dim);
  check_values(field, out_of_plane);
  return field;
}

template RawField<2> read_csv_field(const std::filesystem::path&);
template RawField<3> read_csv_field(const std::filesystem::path&);

}  // namespace bracket::scene
