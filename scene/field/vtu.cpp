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

/// The corners of VTK's type of cell with so many points; 0: what lies beside cells, none: not known. Types are those
/// of first order, of second order, and Lagrange's, whose first nodes are in the same order.
std::optional<int> corners_of(int type, int points, int dim) {
  const auto is = [&](std::initializer_list<int> types) { return std::ranges::find(types, type) != types.end(); };
  const bool tetrahedron = is({10, 24, 71}), triangle = is({5, 22, 69}), quadrilateral = is({9, 23, 28, 70});
  if (is({1, 2, 3, 4, 21, 68}) || (dim == 3 && (triangle || quadrilateral))) return 0;
  if (dim == 3 && tetrahedron && (points == 4 || points == 10)) return 4;
  if (dim == 2 && triangle && (points == 3 || points == 6)) return 3;
  if (dim == 2 && quadrilateral && (points == 4 || points == 8 || points == 9)) return 4;
  return {};
}

/// The cells that carry a displacement; lines and points beside them, in space also faces, do not.
template <int dim> void read_cells(Words& in, RawField<dim>& field) {
  for (int left = in.integer(); left > 0; --left) {
    const int type = in.integer(), n = in.integer();
    std::vector<int> nodes;
    for (int i = 0; i < n; ++i) nodes.push_back(in.integer());
    const std::optional<int> corners = corners_of(type, n, dim);
    if (!corners)
      fail(Status::input, field.file,
           fmt::format("has cells of VTK's type {} with {} points; expected {}, linear or quadratic", type, n,
                       dim == 2 ? "triangles or quadrilaterals" : "tetrahedra"));
    if (*corners > 0) field.cells.push_back({*corners, std::move(nodes)});
  }
}

/// The array of displacements: of a usual name, or the only one that can be.
template <int dim> const Array& displacement_of(const std::vector<Array>& arrays, const std::string& file) {
  std::vector<std::string> names;
  std::vector<const Array*> vectors;
  for (const Array& array : arrays) {
    names.push_back(fmt::format("'{}' ({})", array.name, array.components));
    if (array.components == dim || array.components == 3) vectors.push_back(&array);
  }
  for (const char* usual : {"displacement", "displacements", "disp", "u", "f"})
    for (const Array* array : vectors) {
      std::string name = array->name;
      std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
      if (name == usual) return *array;
    }
  if (vectors.size() == 1) return *vectors[0];
  fail(Status::input, file,
       fmt::format("has {}; expected point data named 'displacement', 'u' or 'f', or only one array with {} "
                   "components; there are: {}",
                   vectors.empty() ? "no displacement" : "several arrays that may be the displacement",
                   dim == 2 ? "2 or 3" : "3", names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
}

}  // namespace

template <int dim> RawField<dim> read_vtu_field(const std::filesystem::path& path) {
  RawField<dim> field{.file = path.string(), .word = "point"};
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
  field.coordinate_rounding = single ? rounding_of_float : rounding_of(field.nodes, dim);
  in.next();  // "cells"
  read_cells(in, field);
  std::vector<Array> arrays;
  while (in.next() == "array") arrays.push_back(read_array(in, points));
  const Array& displacement = displacement_of<dim>(arrays, field.file);
  field.value_rounding = displacement.single ? rounding_of_float : std::numeric_limits<double>::epsilon() / 2;
  std::vector<double> out_of_plane;
  for (int i = 0; i < points; ++i) {
    const double* u = &displacement.values[static_cast<std::size_t>(displacement.components) * i];
    field.values.emplace_back(Eigen::Map<const Vector<dim>>(u));
    if (displacement.components > dim) out_of_plane.push_back(u[dim]);
  }
  check_values(field, out_of_plane);
  return field;
}

template RawField<2> read_vtu_field(const std::filesystem::path&);
template RawField<3> read_vtu_field(const std::filesystem::path&);

}  // namespace bracket::scene
