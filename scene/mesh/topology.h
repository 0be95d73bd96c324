// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace bracket::scene {

/// An edge that is said to lie on a boundary part.
struct PartEdge {
  std::array<int, 2> vertices;
  int part;
};

/// `mesh`, of which vertices, cells, cell_body, bodies and parts are given, with the rest: clockwise cells turned (with
/// a note), edges and boundary facets (both sorted by their vertices, lower index first), the facets' parts, the
/// components and, as the refinement edge of each cell, its longest.
/// \pre every vertex has a cell
/// \throw Error (mesh), at `where`: degenerate, duplicate or overlapping cells, an edge with more than two, bodies that
///        share vertices, fall into pieces or hang by a point, part edges off the boundary or in two parts
Mesh<2> with_topology(Mesh<2> mesh, const std::vector<PartEdge>& part_edges, const std::string& where);

}  // namespace bracket::scene
