// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/mesh/curves.h"

namespace bracket::scene {

/// The boundary parts that the two sides of a contact are made of, by their numbers.
struct SideParts {
  std::vector<int> first, second;
  std::string where;  ///< of the contact, for messages
};

/// The facets of a contact, two by two: those that face each other from end to end.
using FacetPairs = std::vector<std::array<int, 2>>;

/// A mesh on which the sides of all contacts are cut alike: where a vertex of one side faces the other, that has a
/// vertex, too. Vertices slide along the straight line or the arc that they lie on; facets are halved, with what
/// conformity asks for, and the midpoint slid; so that neither makes angles below 20 degrees, or 0.7 of the mesh's
/// smallest, that bisection alone would not (of cuts near thirds, 0.85 or, where that
/// would take too many cells, 0.6 of that). Bodies do not change, but for new
/// vertices on arcs. What was done is told in a note.
struct CutAlike {
  Mesh<2> mesh;
  std::vector<FacetPairs> pairs;  ///< of each contact, in the order of its first side
};
/// \throw Error (mesh) where no facet of a contact faces the other side, with the nearest; where the sides cannot be
///        cut alike
CutAlike cut_alike(Mesh<2> mesh, const std::vector<SideParts>& contacts, const Arcs& arcs);

}  // namespace bracket::scene
