// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/mesh/raw_nodes.h"

#include <fmt/format.h>

#include <limits>
#include <numeric>

#include "scene/mesh/topology.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// The corners of a cell, two by two, between which it has a side: a tetrahedron its edges.
template <int dim> std::vector<std::array<int, 2>> sides_of(const RawMesh::Element& cell) {
  std::vector<std::array<int, 2>> sides;
  if constexpr (dim == 3) {
    sides.assign(Simplex<3>::edges.begin(), Simplex<3>::edges.end());
  } else {
    const int n = n_corners(cell);
    for (int k = 0; k < n; ++k) sides.push_back({k, (k + 1) % n});
  }
  return sides;
}

}  // namespace

UsedNodes used_nodes(const RawMesh& raw) {
  UsedNodes used{std::vector<char>(raw.nodes.size(), 0), std::vector<char>(raw.nodes.size(), 0)};
  for (const RawMesh::Element& cell : raw.cells)
    for (const int node : cell.corners)
      if (node != -1) used.by_cells[node] = used.at_all[node] = 1;
  for (const RawMesh::Element& line : raw.lines)
    for (const int node : line.corners)
      if (node != -1) used.at_all[node] = 1;
  return used;
}

template <int dim>
std::vector<int> representatives(const RawMesh& raw, const UsedNodes& used, double merge, const std::string& where,
                                 std::vector<std::string>& notes) {
  std::vector<int> representative(raw.nodes.size());
  std::iota(representative.begin(), representative.end(), 0);
  if (merge <= 0) return representative;
  for (const RawMesh::Element& cell : raw.cells) {
    for (const auto& [i, k] : sides_of<dim>(cell)) {
      const RawMesh::Node &a = raw.nodes[cell.corners[i]], &b = raw.nodes[cell.corners[k]];
      const double side = (point_of<dim>(a) - point_of<dim>(b)).norm();
      if (&a == &b || side > merge) continue;
      fail(Status::mesh, where,
           fmt::format("mesh.merge = {} makes one of the nodes {} and {} of the cell {}, which are {:.3g} apart; write "
                       "a smaller one",
                       merge, a.tag, b.tag, cell.tag, side));
    }
  }
  std::vector<int> nodes;
  std::vector<Vector<dim>> points;
  for (std::size_t i = 0; i < raw.nodes.size(); ++i) {
    if (!used.at_all[i]) continue;
    nodes.push_back(static_cast<int>(i));
    points.push_back(point_of<dim>(raw.nodes[i]));
  }
  const std::vector<int> of = merged(points, merge);
  int count = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    representative[nodes[i]] = nodes[of[i]];
    count += of[i] == static_cast<int>(i) ? 0 : 1;
  }
  notes.push_back(fmt::format("mesh.merge = {}: {} node{} merged with others", merge, count, count == 1 ? "" : "s"));
  return representative;
}

template <int dim>
void number_vertices(Simplices<dim>& result, const RawMesh& raw, const UsedNodes& used,
                     const std::vector<int>& representative) {
  result.vertex.assign(raw.nodes.size(), -1);
  for (std::size_t node = 0; node < raw.nodes.size(); ++node)
    if (used.by_cells[node]) result.vertex[representative[node]] = 0;
  for (std::size_t node = 0; node < raw.nodes.size(); ++node) {
    if (result.vertex[node] == -1) continue;
    result.vertex[node] = static_cast<int>(result.vertices.size());
    result.vertices.push_back(point_of<dim>(raw.nodes[node]));
  }
  for (std::size_t node = 0; node < raw.nodes.size(); ++node) result.vertex[node] = result.vertex[representative[node]];
}

template <int dim> std::optional<std::string> straightened(const RawMesh& raw) {
  std::size_t curved = 0;
  double height = 0;  // of the side of second order that is farthest from its chord
  Vector<dim> at = Vector<dim>::Zero();
  for (const RawMesh::Element& cell : raw.cells) {
    bool second_order = false;
    const auto sides = sides_of<dim>(cell);
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (cell.middles[k] == -1) continue;
      second_order = true;
      const Vector<dim> a = point_of<dim>(raw.nodes[cell.corners[sides[k][0]]]);
      const Vector<dim> from_a = point_of<dim>(raw.nodes[cell.middles[k]]) - a;
      const Vector<dim> along = point_of<dim>(raw.nodes[cell.corners[sides[k][1]]]) - a;
      double above;
      if constexpr (dim == 2) above = std::abs(along[0] * from_a[1] - along[1] * from_a[0]) / along.norm();
      if constexpr (dim == 3) above = along.cross(from_a).norm() / along.norm();
      if (above <= height) continue;
      height = above;
      at = point_of<dim>(raw.nodes[cell.middles[k]]);
    }
    curved += second_order ? 1 : 0;
  }
  if (curved == 0) return {};
  return fmt::format("{} cell{} of second order straightened: {}", curved, curved == 1 ? "" : "s",
                     height == 0 ? "all sides are straight"
                                 : fmt::format("the largest height above a chord is {:.3g}, at {}", height, point(at)));
}

template std::vector<int> representatives<2>(const RawMesh&, const UsedNodes&, double, const std::string&,
                                             std::vector<std::string>&);
template std::vector<int> representatives<3>(const RawMesh&, const UsedNodes&, double, const std::string&,
                                             std::vector<std::string>&);
template void number_vertices(Simplices<2>&, const RawMesh&, const UsedNodes&, const std::vector<int>&);
template void number_vertices(Simplices<3>&, const RawMesh&, const UsedNodes&, const std::vector<int>&);
template std::optional<std::string> straightened<2>(const RawMesh&);
template std::optional<std::string> straightened<3>(const RawMesh&);

}  // namespace bracket::scene
