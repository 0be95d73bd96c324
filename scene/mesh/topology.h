// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tuple>

#include "scene/scene.h"

namespace bracket::scene {

/// A facet that is said to lie on a boundary part.
template <int dim> struct PartFacet {
  std::array<int, dim> vertices;
  int part;
};
using PartEdge = PartFacet<2>;

/// `mesh`, of which vertices, cells, cell_body, bodies and parts are given, with edges and boundary facets (both sorted
/// by their vertices, lower index first), in space with facet numbers in the same order. Clockwise cells, in space
/// those inside out, are turned, with a note. \pre every vertex has a cell \throw Error (mesh), at `where`: degenerate,
/// duplicate or overlapping cells, a facet with more than two
Mesh<2> with_edges(Mesh<2> mesh, const std::string& where);
Mesh<3> with_edges(Mesh<3> mesh, const std::string& where);

/// `mesh` as with_edges() makes it, with the facets' parts, the components and, as the refinement edge of each cell,
/// its longest. \pre the part facets lie on the boundary \throw Error (mesh), at `where`: a body that falls into pieces
/// or hangs by a point or, in space, an edge
Mesh<2> completed(Mesh<2> mesh, const std::vector<PartFacet<2>>& part_facets, const std::string& where);
Mesh<3> completed(Mesh<3> mesh, const std::vector<PartFacet<3>>& part_facets, const std::string& where);

/// completed() after with_edges().
template <int dim>
Mesh<dim> with_topology(Mesh<dim> mesh, const std::vector<PartFacet<dim>>& part_facets, const std::string& where) {
  return completed(with_edges(std::move(mesh), where), part_facets, where);
}

// ---- what is the same in the plane and in space ---------------------------------------------------------------------

template <int dim> Vector<dim> centre(const Mesh<dim>& mesh, int cell);

/// Bisection cuts the longest edge of each coarse cell first: the shapes of its descendants are then the best. Among
/// equals, in the plane the one with the lowest number, in space the one with the first end, then the first other end,
/// in the order of coordinates: so neighbours agree, in space across contacts, too.
std::vector<char> longest_edges(const Mesh<2>& mesh);
std::vector<char> longest_edges(const Mesh<3>& mesh);
/// By which edges are compared in space: squared length, one end, the other end.
using EdgeRank = std::tuple<double, std::array<double, 3>, std::array<double, 3>>;
EdgeRank edge_rank(const Mesh<3>& mesh, int edge);

/// With the components and their names, in the order of their first bodies.
template <int dim> Mesh<dim> with_components(Mesh<dim> mesh);
/// \throw Error (mesh), at `where`, for a body of several components
template <int dim> void check_whole(const Mesh<dim>& mesh, const std::string& where);

/// How close nodes are that are meant to be one: a millionth of the shortest edge, rounded down to a power of ten.
template <int dim> double coincidence(const Mesh<dim>& mesh);
/// Why a body may fall into pieces: how many of its nodes lie on others, and how to mend it; empty: none.
template <int dim> std::string coinciding_nodes(const Mesh<dim>& mesh, int body);

/// Of each point, the first of those that it can be reached from by steps of at most `distance`.
template <int dim> std::vector<int> merged(const std::vector<Vector<dim>>& points, double distance);

}  // namespace bracket::scene
