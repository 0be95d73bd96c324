// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/mesh/curves.h"
#include "scene/problem/tolerance.h"

namespace bracket::scene {

/// Where a vertex of one side of a contact faces the other side.
struct Landing {
  int vertex;
  int facet;        ///< of the other side
  double t;         ///< there: 0 at the facet's vertex 0, 1 at its vertex 1
  int onto;         ///< the vertex of that facet which is there, within `tolerance`; −1: none
  double distance;  ///< from the vertex, positive where there is room between the sides
};

/// The direction along which two sides with these unit outward normals approach each other: (n' − n'')/|n' − n''|, n'
/// itself where n'' is its opposite.
Vector<2> direction(const Vector<2>& first, const Vector<2>& second);

/// For the vertices of the facets `from`, where the nearest of the facets `onto` lies along the direction of both: the
/// normals at vertices where a side bends by less than 20 degrees are means, and at its ends go on as they did; linear
/// between; those of arcs are radial. Facets face each other
/// where their direction is within 25 degrees of both normals. Vertices that face nothing are left out.
/// \param normals of all boundary facets
std::vector<Landing> landings(const Mesh<2>& mesh, const std::vector<Vector<2>>& normals, const std::vector<int>& from,
                              const std::vector<int>& onto, const Arcs& arcs);

}  // namespace bracket::scene
