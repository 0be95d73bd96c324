// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/field/frd_solid.h"

#include <fmt/format.h>

#include <cmath>

#include "scene/text.h"

namespace bracket::scene {

namespace {

/// What is known of cgx's types of elements.
struct Type {
  int corners;  ///< of the plane cell; 0: a line
  bool solid, second_order;
};

std::optional<Type> type_of(int number) {
  switch (number) {
    case 1: return Type{4, true, false};
    case 2: return Type{3, true, false};
    case 4: return Type{4, true, true};
    case 5: return Type{3, true, true};
    case 7: return Type{3, false, false};
    case 8: return Type{3, false, true};
    case 9: return Type{4, false, false};
    case 10: return Type{4, false, true};
    case 11:
    case 12: return Type{0, false, false};
    default: return {};
  }
}

/// The nodes of the lower and upper face of a solid: first come all corners, then the middles of the lower sides, of
/// those across, of the upper sides.
std::array<std::vector<int>, 2> faces(const FrdElement& element, const Type& type) {
  std::array<std::vector<int>, 2> result;
  const auto take = [&](int face, int from) {
    const auto begin = element.nodes.begin() + from * type.corners;
    result[face].insert(result[face].end(), begin, begin + type.corners);
  };
  take(0, 0);
  take(1, 1);
  if (!type.second_order) return result;
  take(0, 2);
  take(1, 4);
  return result;
}

Eigen::Vector3d place(const RawField<2>& field, int node) { return Eigen::Vector3d(field.nodes[node].x.data()); }

/// That a solid is a plane element made thick: each node lies on its partner and is moved as it is, or apart from it.
/// \param size the largest coordinate   \param tolerance of values
void check_pair(const RawField<2>& field, const std::vector<double>& out_of_plane, int lower, int upper, double size,
                double tolerance) {
  const Eigen::Vector3d across = place(field, upper) - place(field, lower);
  if (across.head<2>().norm() > 3 * field.coordinate_rounding * size)
    refuse(field, lower, "belongs to a solid element; expected results of plane elements (CPE3, CPS6, …)");
  if ((field.values[upper] - field.values[lower]).norm() > tolerance ||
      std::abs(out_of_plane[lower] + out_of_plane[upper]) > tolerance)
    refuse(field, lower,
           fmt::format("and the node {} above it are moved differently; expected a plane displacement",
                       field.nodes[upper].tag));
}

/// The nodes that cells have, alone. \param out_of_plane of each node; of space empty
template <int dim> RawField<dim> without_others(RawField<dim> field, std::vector<double>& out_of_plane) {
  std::vector<int> number(field.nodes.size(), -1);
  for (const auto& cell : field.cells)
    for (const int node : cell.nodes) number[node] = 0;
  int count = 0;
  for (std::size_t node = 0; node < number.size(); ++node) {
    if (number[node] == -1) continue;
    field.nodes[count] = field.nodes[node];
    field.values[count] = field.values[node];
    if (dim == 2) out_of_plane[count] = out_of_plane[node];
    number[node] = count++;
  }
  field.nodes.resize(count);
  field.values.resize(count);
  if (dim == 2) out_of_plane.resize(count);
  for (auto& cell : field.cells)
    for (int& node : cell.nodes) node = number[node];
  return field;
}

}  // namespace

RawField<2> plane_field(RawField<2> field, std::vector<double> out_of_plane, const std::vector<FrdElement>& elements) {
  double size = 0;
  for (const RawMesh::Node& node : field.nodes)
    for (const double x : node.x) size = std::max(size, std::abs(x));
  const double tolerance = value_tolerance(field);
  std::vector<int> of_solids;
  for (const FrdElement& element : elements) {
    const std::optional<Type> type = type_of(element.type);
    if (!type) fail(Status::input, field.file, "has tetrahedra; expected results of plane elements (CPE3, CPS6, …)");
    if (type->corners == 0) continue;
    if (!type->solid) {
      field.cells.push_back({type->corners, element.nodes});
      continue;
    }
    const auto [lower, upper] = faces(element, *type);
    for (std::size_t i = 0; i < lower.size(); ++i) check_pair(field, out_of_plane, lower[i], upper[i], size, tolerance);
    of_solids.insert(of_solids.end(), lower.begin(), lower.end());
    field.cells.push_back({type->corners, lower});
  }
  for (const int node : of_solids) out_of_plane[node] = 0;
  if (!field.cells.empty()) field = without_others(std::move(field), out_of_plane);
  check_values(field, out_of_plane);
  return field;
}

RawField<3> field_of_tetrahedra(RawField<3> field, const std::vector<FrdElement>& elements) {
  for (const FrdElement& element : elements) {
    if (element.type == 3 || element.type == 6) field.cells.push_back({4, element.nodes});
    if (const auto type = type_of(element.type); type && type->solid)
      fail(Status::input, field.file, "has hexahedra or wedges; expected tetrahedra (C3D4, C3D10)");
  }
  std::vector<double> none;
  if (!field.cells.empty()) field = without_others(std::move(field), none);
  check_values(field, {});
  return field;
}

}  // namespace bracket::scene
