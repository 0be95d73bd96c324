// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/mesh/space/marks.h"

#include "scene/mesh/space/tetrahedron.h"

namespace bracket::scene {

namespace {

using Table = Simplex<3>;

}  // namespace

int refinement_edge(const FacetMarks& marks) {
  for (int edge = 0; edge < 6; ++edge) {
    int times = 0;
    for (int k = 0; k < 4; ++k) times += marks[k] == edge && !has_end(edge, k);
    if (times == 2) return edge;
  }
  return -1;
}

Mesh<3>::Marks marks_of_child(const Mesh<3>::Marks& parent, int kept, int moved) {
  std::array<int, 2> others;
  for (int k = 0, n = 0; k < 4; ++k)
    if (k != kept && k != moved) others[n++] = k;
  // Facets by the vertex opposite: the old one to `moved`, the new one to `kept`.
  Mesh<3>::Marks child = parent;
  const int old = parent.facet[moved], across = parent.facet[kept];
  int shared = -1;  // the end that both old marks have besides those of the refinement edge: they lie in one plane
  for (const int k : others)
    if (has_end(old, k) && has_end(old, kept) && has_end(across, k) && has_end(across, moved)) shared = k;
  for (int n = 0; n < 2; ++n) child.facet[others[n]] = static_cast<char>(Table::edge_between(kept, others[1 - n]));
  const bool flagged = shared >= 0 && parent.flagged;
  child.facet[kept] =
      static_cast<char>(flagged ? Table::edge_between(moved, shared) : Table::edge_between(others[0], others[1]));
  child.flagged = shared >= 0 && !parent.flagged;
  return child;
}

}  // namespace bracket::scene
