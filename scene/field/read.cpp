// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/field/raw_field.h"
#include "scene/mesh/abaqus_cards.h"
#include "scene/range.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

double largest(const std::vector<Vector<2>>& vectors) {
  double result = 0;
  for (const Vector<2>& v : vectors) result = std::max(result, v.cwiseAbs().maxCoeff());
  return result;
}

}  // namespace

RawField read_raw_field(const std::filesystem::path& file) {
  const std::string ending = capitals(file.extension().string());
  if (ending == ".CSV") return read_csv_field(file);
  if (ending == ".VTU") return read_vtu_field(file);
  if (ending == ".FRD") return read_frd_field(file);
  read_text(file);  // says what is wrong where it cannot be read
  fail(Status::input, file.string(),
       "is of no kind that is read; expected displacements as .csv (x, y, ux, uy), .vtu (VTK) or .frd (CalculiX)");
}

RawField raw_field_of(const NodalDisplacement& given, const std::string& name) {
  const int count = static_cast<int>(given.nodes.size());
  const auto refuse_size = [&](const char* what, std::size_t size) {
    fail(Status::input, name, fmt::format("has {} {} for {} nodes", size, what, count));
  };
  if (given.values.size() != given.nodes.size()) refuse_size("values", given.values.size());
  if (!given.bodies.empty() && given.bodies.size() != given.nodes.size())
    refuse_size("names of bodies", given.bodies.size());
  RawField field{.file = name, .word = "node", .values = given.values, .bodies = given.bodies};
  for (int i = 0; i < count; ++i) field.nodes.push_back({i, {given.nodes[i][0], given.nodes[i][1], 0}});
  for (const std::vector<int>& nodes : given.cells) {
    constexpr std::array<std::size_t, 5> known = {3, 4, 6, 8, 9};
    if (std::ranges::find(known, nodes.size()) == known.end())
      fail(Status::input, name, fmt::format("has a cell of {} nodes; expected 3, 4, 6, 8 or 9", nodes.size()));
    for (const int node : nodes)
      if (node < 0 || node >= count)
        fail(Status::input, name, fmt::format("has a cell with the node {}; expected 0 to {}", node, count - 1));
    field.cells.push_back({nodes.size() % 3 == 0 && nodes.size() < 9 ? 3 : 4, nodes});
  }
  field.coordinate_rounding = rounding_of(field.nodes);
  field.value_rounding = std::numeric_limits<double>::epsilon() / 2;
  check_values(field, {});
  return field;
}

void refuse(const RawField& field, int node, const std::string& message) {
  const RawMesh::Node& at = field.nodes[node];
  const std::string place = point(Vector<2>(at.x[0], at.x[1]));
  if (field.word == "line")
    fail(Status::input, fmt::format("{}:{}", field.file, at.tag), "the point " + place + " " + message);
  fail(Status::input, field.file, fmt::format("the {} {} at {} {}", field.word, at.tag, place, message));
}

double place_tolerance(const RawField& field, const Mesh<2>& mesh) {
  // Corners are off by one rounding in each coordinate, midpoints by two: the length is below √2 · 2 < 3 of them. Who
  // computes the place of a node by basis functions sums up to nine terms, each rounded twice, in doubles.
  constexpr double sums = 2 * (9 + 1) * std::numeric_limits<double>::epsilon() / 2;
  return (3 * (field.coordinate_rounding + mesh.coordinate_rounding) + sums) * largest(mesh.vertices);
}

double value_tolerance(const RawField& field) { return 2 * (9 + 1) * field.value_rounding * largest(field.values); }

void check_values(const RawField& field, const std::vector<double>& out_of_plane) {
  if (field.nodes.empty()) fail(Status::input, field.file, "has no displacements");
  double size = 0;
  for (int i = 0; i < static_cast<int>(field.nodes.size()); ++i) {
    for (const double x : field.nodes[i].x) {
      if (!(std::abs(x) <= largest_size))
        refuse(field, i, fmt::format("has the coordinate {:g}; expected a number", x));
      size = std::max(size, std::abs(x));
    }
    const Vector<2>& u = field.values[i];
    if (!(std::abs(u[0]) <= largest_size && std::abs(u[1]) <= largest_size))
      refuse(field, i, fmt::format("has the displacement {}; expected numbers", point(u)));
  }
  const double tolerance = value_tolerance(field);
  for (int i = 0; i < static_cast<int>(field.nodes.size()); ++i) {
    const double z = field.nodes[i].x[2];
    if (std::abs(z - field.nodes[0].x[2]) > 2 * field.coordinate_rounding * size)
      refuse(
          field, i,
          fmt::format("has z = {:g}, the first one z = {:g}; expected a plane of constant z", z, field.nodes[0].x[2]));
    if (!out_of_plane.empty() && !(std::abs(out_of_plane[i]) <= tolerance))
      refuse(field, i,
             fmt::format("is moved out of the plane by {:g}; expected no third displacement", out_of_plane[i]));
  }
}

GivenDisplacement matched(const RawField& field, const Mesh<2>& mesh) {
  const auto result = [&]() -> GivenDisplacement {
    if (field.cells.empty()) return matched_by_place(field, mesh);
    if (auto matched = matched_by_cells(field, mesh)) return *matched;
    return interpolated(field, mesh);
  };
  GivenDisplacement given = result();
  given.notes = field.notes;
  return given;
}

GivenDisplacement read_field(const std::filesystem::path& file, const Mesh<2>& mesh) {
  return matched(read_raw_field(file), mesh);
}

}  // namespace bracket::scene
