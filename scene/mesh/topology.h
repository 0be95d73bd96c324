// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace bracket::scene {

/// An edge that is said to lie on a boundary part.
struct PartEdge {
  std::array<int, 2> vertices;
  int part;
};

/// `mesh`, of which vertices, cells, cell_body, bodies and parts are given, with edges and boundary facets (both sorted
/// by their vertices, lower index first). Clockwise cells are turned, with a note.
/// \pre every vertex has a cell
/// \throw Error (mesh), at `where`: degenerate, duplicate or overlapping cells, an edge with more than two
Mesh<2> with_edges(Mesh<2> mesh, const std::string& where);

/// `mesh` as with_edges() makes it, with the facets' parts, the components and, as the refinement edge of each cell,
/// its longest. \pre the part edges lie on the boundary \throw Error (mesh), at `where`: a body that falls into pieces
/// or hangs by a point
Mesh<2> completed(Mesh<2> mesh, const std::vector<PartEdge>& part_edges, const std::string& where);

/// How close nodes are that are meant to be one: a millionth of the shortest edge, rounded down to a power of ten.
double coincidence(const Mesh<2>& mesh);
/// Why a body may fall into pieces: how many of its nodes lie on others, and how to mend it; empty: none.
std::string coinciding_nodes(const Mesh<2>& mesh, int body);

/// completed() after with_edges().
Mesh<2> with_topology(Mesh<2> mesh, const std::vector<PartEdge>& part_edges, const std::string& where);

}  // namespace bracket::scene
