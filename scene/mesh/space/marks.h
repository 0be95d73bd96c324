// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: at which edges bisection cuts [Arnold, Mukherjee & Pouly, SIAM J. Sci. Comput. 22 (2000)]. Every facet has
// a mark, one of its edges; the two facets at a cell's refinement edge are marked there. A cell is cut from the middle
// m of that edge. Its children's facets: an old one keeps its mark, at which the child is cut; the halves of those that
// were cut are marked opposite to m; so is the new one, but where the parent's marks lie in one plane and it is
// flagged: there from m to the end of the child's refinement edge. Children are flagged where the parent's marks lie in
// one plane and it is not.
#pragma once

#include "scene/mesh/mesh.h"

namespace bracket::scene {

using FacetMarks = std::array<char, 4>;  ///< of each facet of a cell one of the cell's edges, as in Mesh<3>::Marks

/// The edge at which a cell is cut: the first where both of its facets are marked; −1: there is none.
int refinement_edge(const FacetMarks& marks);

/// The marks of the child that keeps one end of the refinement edge; the middle takes the place of the other.
Mesh<3>::Marks marks_of_child(const Mesh<3>::Marks& parent, int kept, int moved);

/// The least shape() of a cell and all that bisection ever makes of it, which has 72 shapes at most.
/// \pre it is not flagged and has a refinement edge
double least_shape_below(const FacetMarks& marks, const std::array<Vector<3>, 4>& corners);

/// The marks of a first mesh, alike on facets whose vertices have the same `glued`: of each facet the edge that comes
/// first, those before all others of which no two have a cell in common, so that they are cut without others, then the
/// longer before the shorter. Where bisection would so come to half the least shape of the mesh, facets are marked
/// anew, one cell after the other, while that raises the least shape below the cells that it concerns.
std::vector<Mesh<3>::Marks> first_marks(const Mesh<3>& mesh, const std::vector<int>& glued);

}  // namespace bracket::scene
