// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: bisection of tetrahedra, at the edges that scene/mesh/space/marks.h says.
#pragma once

#include "scene/mesh/mesh.h"
#include "scene/problem/problem.h"

namespace bracket::scene {

/// A part of a boundary facet, seen from the cell it belongs to.
struct BoundaryPart {
  int local;                                    ///< which facet of the cell
  int facet;                                    ///< of the old mesh, index into its boundary
  std::array<std::array<double, 2>, 3> corner;  ///< its vertices, as in Piece<2> of the first mesh's facet
};

/// A mesh of which cells were bisected, and where its pieces come from.
struct BisectedCells {
  Mesh<3> mesh;
  std::vector<int> cell_parent;   ///< of each cell: index into the old Mesh::cells, in their order
  std::vector<Piece<3>> cells;    ///< of each cell, on the first mesh
  std::vector<int> facet_parent;  ///< of each boundary facet: index into the old Mesh::boundary
  std::vector<Piece<2>> facets;   ///< of each boundary facet, on the first mesh
  std::vector<int> glued;         ///< of each vertex, what stands for all that lie on it
};

/// Bisects the marked cells, then cells with an edge that was cut, until there is none: the mesh conforms, across
/// contact as well, along which vertices are glued. Vertices keep their numbers. \throw Error (budget) where rounding
/// of coordinates spoils the shape of cells, or 52 halvings deep
BisectedCells bisect(const Problem<3>& problem, const std::vector<char>& marked);

}  // namespace bracket::scene
