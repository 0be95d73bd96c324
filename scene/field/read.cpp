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

template <int dim> double largest(const std::vector<Vector<dim>>& vectors) {
  double result = 0;
  for (const Vector<dim>& v : vectors) result = std::max(result, v.cwiseAbs().maxCoeff());
  return result;
}

}  // namespace

template <int dim> RawField<dim> read_raw_field(const std::filesystem::path& file) {
  const std::string ending = capitals(file.extension().string());
  if (ending == ".CSV") return read_csv_field<dim>(file);
  if (ending == ".VTU") return read_vtu_field<dim>(file);
  if (ending == ".FRD") return read_frd_field<dim>(file);
  read_text(file);  // says what is wrong where it cannot be read
  fail(Status::input, file.string(),
       fmt::format("is of no kind that is read; expected displacements as .csv ({}), .vtu (VTK) or .frd (CalculiX)",
                   dim == 2 ? "x, y, ux, uy" : "x, y, z, ux, uy, uz"));
}

template <int dim> RawField<dim> raw_field_of(const NodalDisplacementOf<dim>& given, const std::string& name) {
  const int count = static_cast<int>(given.nodes.size());
  const auto refuse_size = [&](const char* what, std::size_t size) {
    fail(Status::input, name, fmt::format("has {} {} for {} nodes", size, what, count));
  };
  if (given.values.size() != given.nodes.size()) refuse_size("values", given.values.size());
  if (!given.bodies.empty() && given.bodies.size() != given.nodes.size())
    refuse_size("names of bodies", given.bodies.size());
  RawField<dim> field{.file = name, .word = "node", .values = given.values, .bodies = given.bodies};
  for (int i = 0; i < count; ++i)
    field.nodes.push_back({i, {given.nodes[i][0], given.nodes[i][1], dim == 3 ? given.nodes[i][dim - 1] : 0}});
  for (const std::vector<int>& nodes : given.cells) {
    const std::vector<std::size_t> known =
        dim == 2 ? std::vector<std::size_t>{3, 4, 6, 8, 9} : std::vector<std::size_t>{4, 10};
    if (std::ranges::find(known, nodes.size()) == known.end())
      fail(Status::input, name,
           fmt::format("has a cell of {} nodes; expected {}", nodes.size(), dim == 2 ? "3, 4, 6, 8 or 9" : "4 or 10"));
    for (const int node : nodes)
      if (node < 0 || node >= count)
        fail(Status::input, name, fmt::format("has a cell with the node {}; expected 0 to {}", node, count - 1));
    const bool triangle = nodes.size() % 3 == 0 && nodes.size() < 9;
    field.cells.push_back({triangle ? 3 : 4, nodes});
  }
  field.coordinate_rounding = rounding_of(field.nodes, dim);
  field.value_rounding = std::numeric_limits<double>::epsilon() / 2;
  check_values(field, {});
  return field;
}

template <int dim> void refuse(const RawField<dim>& field, int node, const std::string& message) {
  const RawMesh::Node& at = field.nodes[node];
  const std::string place = point(Vector<dim>(Eigen::Map<const Vector<dim>>(at.x.data())));
  if (field.word == "line")
    fail(Status::input, fmt::format("{}:{}", field.file, at.tag), "the point " + place + " " + message);
  fail(Status::input, field.file, fmt::format("the {} {} at {} {}", field.word, at.tag, place, message));
}

template <int dim> double place_tolerance(const RawField<dim>& field, const Mesh<dim>& mesh) {
  // Corners are off by one rounding in each coordinate, midpoints by two: the length is below √2 · 2 < 3 of them, in
  // space √3 · 2 < 4. Who computes the place of a node by basis functions sums up as many terms as a cell has nodes,
  // each rounded twice, in doubles.
  constexpr double sums = 2 * (most_nodes<dim> + 1) * std::numeric_limits<double>::epsilon() / 2;
  return ((dim + 1) * (field.coordinate_rounding + mesh.coordinate_rounding) + sums) * largest(mesh.vertices);
}

template <int dim> double value_tolerance(const RawField<dim>& field) {
  return 2 * (most_nodes<dim> + 1) * field.value_rounding * largest(field.values);
}

template <int dim> void check_values(const RawField<dim>& field, const std::vector<double>& out_of_plane) {
  if (field.nodes.empty()) fail(Status::input, field.file, "has no displacements");
  double size = 0;
  for (int i = 0; i < static_cast<int>(field.nodes.size()); ++i) {
    for (const double x : field.nodes[i].x) {
      if (!(std::abs(x) <= largest_size))
        refuse(field, i, fmt::format("has the coordinate {:g}; expected a number", x));
      size = std::max(size, std::abs(x));
    }
    const Vector<dim>& u = field.values[i];
    if (!std::ranges::all_of(u, [](double component) { return std::abs(component) <= largest_size; }))
      refuse(field, i, fmt::format("has the displacement {}; expected numbers", point(u)));
  }
  if (dim == 3) return;
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

template <int dim> GivenDisplacementOf<dim> matched(const RawField<dim>& field, const Mesh<dim>& mesh) {
  const auto result = [&]() -> GivenDisplacementOf<dim> {
    if (field.cells.empty()) return matched_by_place(field, mesh);
    if (auto matched = matched_by_cells(field, mesh)) return *matched;
    return interpolated(field, mesh);
  };
  GivenDisplacementOf<dim> given = result();
  given.notes = field.notes;
  return given;
}

template <int dim> GivenDisplacementOf<dim> read_field(const std::filesystem::path& file, const Mesh<dim>& mesh) {
  return matched(read_raw_field<dim>(file), mesh);
}

#define INSTANTIATE(dim)                                                                    \
  template RawField<dim> read_raw_field(const std::filesystem::path&);                      \
  template RawField<dim> raw_field_of(const NodalDisplacementOf<dim>&, const std::string&); \
  template void refuse(const RawField<dim>&, int, const std::string&);                      \
  template double place_tolerance(const RawField<dim>&, const Mesh<dim>&);                  \
  template double value_tolerance(const RawField<dim>&);                                    \
  template void check_values(const RawField<dim>&, const std::vector<double>&);             \
  template GivenDisplacementOf<dim> matched(const RawField<dim>&, const Mesh<dim>&);        \
  template GivenDisplacementOf<dim> read_field(const std::filesystem::path&, const Mesh<dim>&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::scene
