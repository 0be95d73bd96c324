// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/mesh/mesh.h"

/// Newest-vertex bisection of meshes, which knows no data: a cell is cut from the midpoint of its refinement edge to
/// the vertex opposite; a child's refinement edge is opposite to that midpoint.
namespace bracket::scene {

/// A mesh of which edges were halved, and where its pieces come from.
struct Bisected {
  Mesh<2> mesh;
  std::vector<int> cell_parent;   ///< of each cell: index into the old Mesh::cells, in their order
  std::vector<int> facet_parent;  ///< of each boundary facet: index into the old Mesh::boundary; halves run as it did
  std::vector<int> midpoint;      ///< of each old edge: the vertex that halves it, −1: none
};

/// The edges that must be halved so that `edges` are: a cell of which any edge is halved has its refinement edge
/// halved, and so has an edge whose partner is. Each edge and each cell at it are looked at once: linear time, and
/// however the refinement edges were chosen on the coarsest mesh, all the rounds together add no more than a multiple
/// of the cells marked [Karkulik, Pavlicek & Praetorius, Constr. Approx. 38 (2013)].
/// \param partner of each edge, −1: none; empty: of all none   \return for each edge whether it is to be halved
std::vector<char> conforming(const Mesh<2>& mesh, const std::vector<int>& edges, const std::vector<int>& partner = {});

/// \param edges to be halved, as conforming() has them
/// \throw Error (budget) where cells have become so small that rounding of coordinates spoils their shape
Bisected bisect(const Mesh<2>& old, const std::vector<char>& edges);

}  // namespace bracket::scene
