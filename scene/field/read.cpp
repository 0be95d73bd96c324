// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

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

RawField read_raw_field(const std::filesystem::path& file) {
  const std::string ending = capitals(file.extension().string());
  if (ending == ".CSV") return read_csv_field(file);
  if (ending == ".VTU") return read_vtu_field(file);
  if (ending == ".FRD") return read_frd_field(file);
  read_text(file);  // says what is wrong where it cannot be read
  fail(Status::input, file.string(),
       "is of no kind that is read; expected displacements as .csv (x, y, ux, uy), .vtu (VTK) or .frd (CalculiX)");
}

}  // namespace

void refuse(const RawField& field, int node, const std::string& message) {
  const RawMesh::Node& at = field.nodes[node];
  const std::string place = point({at.x[0], at.x[1]});
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

GivenDisplacement read_field(const std::filesystem::path& file, const Mesh<2>& mesh) {
  const RawField field = read_raw_field(file);
  const auto result = [&]() -> GivenDisplacement {
    if (field.cells.empty()) return matched_by_place(field, mesh);
    if (auto matched = matched_by_cells(field, mesh)) return *matched;
    return interpolated(field, mesh);
  };
  GivenDisplacement given = result();
  given.notes = field.notes;
  return given;
}

std::size_t count_of_nodes(const std::filesystem::path& file) { return read_raw_field(file).nodes.size(); }

}  // namespace bracket::scene
