// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "scene/child.h"
#include "scene/field/raw_field.h"
#include "scene/mesh/readers.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

constexpr double rounding_of_float = std::numeric_limits<float>::epsilon() / 2;

/// Words and numbers of what bracket-field-converter wrote.
class Words {
 public:
  explicit Words(std::string text) : text_(std::move(text)) {}
  std::string_view next() { return until(" \n"); }
  std::string_view rest_of_line() { return until("\n"); }
  int integer() {
    const std::string_view word = next();
    int value = -1;
    std::from_chars(word.data(), word.data() + word.size(), value);
    return value;
  }
  double number() { return decimal(next()).value_or(std::numeric_limits<double>::quiet_NaN()); }

 private:
  std::string_view until(std::string_view ends) {
    const std::size_t start = position_;
    const std::size_t end = std::min(text_.find_first_of(ends, start), text_.size());
    position_ = std::min(end + 1, text_.size());
    return std::string_view(text_).substr(start, end - start);
  }
  std::string text_;
  std::size_t position_ = 0;
};

struct Array {
  std::string name;
  int components = 0;
  bool single = false;  ///< of single precision
  std::vector<double> values;
};

Array read_array(Words& in, int points) {
  Array array;
  array.components = in.integer();
  array.single = in.next() == "float";
  array.name = in.rest_of_line();
  for (std::size_t left = std::size_t(points) * array.components; left > 0; --left) array.values.push_back(in.number());
  return array;
}

/// The cells that carry a displacement; lines and points beside them do not.
void read_cells(Words& in, RawField& field) {
  for (int left = in.integer(); left > 0; --left) {
    const int type = in.integer(), n = in.integer();
    RawField::Cell cell{0, {}};
    for (int i = 0; i < n; ++i) cell.nodes.push_back(in.integer());
    // Triangles, quadrilaterals, those of second order, and Lagrange's, whose first nodes are in the same order.
    const bool triangle = type == 5 || type == 22 || type == 69,
               quadrilateral = type == 9 || type == 23 || type == 28 || type == 70;
    const bool line_or_point = type == 1 || type == 2 || type == 3 || type == 4 || type == 21 || type == 68;
    if (line_or_point) continue;
    if (triangle && (n == 3 || n == 6)) cell.corners = 3;
    if (quadrilateral && (n == 4 || n == 8 || n == 9)) cell.corners = 4;
    if (cell.corners == 0)
      fail(Status::input, field.file,
           fmt::format("has cells of VTK's type {} with {} points; expected triangles or quadrilaterals, linear or "
                       "quadratic",
                       type, n));
    field.cells.push_back(std::move(cell));
  }
}

/// The array of displacements: of a usual name, or the only one that can be.
const Array& displacement_of(const std::vector<Array>& arrays, const std::string& file) {
  std::vector<std::string> names;
  std::vector<const Array*> vectors;
  for (const Array& array : arrays) {
    names.push_back(fmt::format("'{}' ({})", array.name, array.components));
    if (array.components == 2 || array.components == 3) vectors.push_back(&array);
  }
  for (const char* usual : {"displacement", "displacements", "disp", "u", "f"})
    for (const Array* array : vectors) {
      std::string name = array->name;
      std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
      if (name == usual) return *array;
    }
  if (vectors.size() == 1) return *vectors[0];
  fail(Status::input, file,
       fmt::format("has {}; expected point data named 'displacement', 'u' or 'f', or only one array with 2 or 3 "
                   "components; there are: {}",
                   vectors.empty() ? "no displacement" : "several arrays that may be the displacement",
                   names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
}

}  // namespace

RawField read_vtu_field(const std::filesystem::path& path) {
  RawField field{.file = path.string(), .word = "point"};
  const TemporaryFolder folder(field.file);
  const Converter converter{"bracket-field-converter", "VTK", "field.txt", Status::input};
  Words in(read_text(converted(path, folder, converter, std::chrono::seconds(300))));
  in.next();  // "points"
  const int points = in.integer();
  const bool single = in.next() == "float";
  for (int i = 0; i < points; ++i) {
    const double x = in.number(), y = in.number(), z = in.number();
    field.nodes.push_back({i, {x, y, z}});
  }
  field.coordinate_rounding = single ? rounding_of_float : rounding_of(field.nodes);
  in.next();  // "cells"
  read_cells(in, field);
  std::vector<Array> arrays;
  while (in.next() == "array") arrays.push_back(read_array(in, points));
  const Array& displacement = displacement_of(arrays, field.file);
  field.value_rounding = displacement.single ? rounding_of_float : std::numeric_limits<double>::epsilon() / 2;
  std::vector<double> out_of_plane;
  for (int i = 0; i < points; ++i) {
    const double* u = &displacement.values[static_cast<std::size_t>(displacement.components) * i];
    field.values.emplace_back(u[0], u[1]);
    if (displacement.components == 3) out_of_plane.push_back(u[2]);
  }
  check_values(field, out_of_plane);
  return field;
}

}  // namespace bracket::scene
