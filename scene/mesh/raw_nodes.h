// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "scene/mesh/raw_mesh.h"

/// How nodes of mesh files become vertices.
namespace bracket::scene {

inline int n_corners(const RawMesh::Element& cell) { return cell.corners[3] == -1 ? 3 : 4; }

template <int dim> Vector<dim> point_of(const RawMesh::Node& node) {
  return Eigen::Map<const Eigen::Vector3d>(node.x.data()).head<dim>();
}

/// Nodes that cells have, and those that lines have, too.
struct UsedNodes {
  std::vector<char> by_cells, at_all;
};
UsedNodes used_nodes(const RawMesh& raw);

/// The node that stands for each, by the scene's wish that close ones become one. \throw Error (mesh), at `where`, if
/// they are of one cell
template <int dim>
std::vector<int> representatives(const RawMesh& raw, const UsedNodes& used, double merge, const std::string& where,
                                 std::vector<std::string>& notes);

/// Fills in the vertices, those nodes that cells have.
template <int dim>
void number_vertices(Simplices<dim>& result, const RawMesh& raw, const UsedNodes& used,
                     const std::vector<int>& representative);

/// A note on cells of second order, whose sides become straight, if there are any.
template <int dim> std::optional<std::string> straightened(const RawMesh& raw);

}  // namespace bracket::scene
