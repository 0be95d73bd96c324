// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <numeric>

#include "bounds/certificate/geometry.h"
#include "bounds/certificate/problem_faults.h"

namespace bracket::bounds {

using scene::Problem;

std::string topology_fault(const Problem<2>& problem) {
  const auto& mesh = problem.mesh;
  struct Walks {
    int up = 0, down = 0, cell = -1;
  };
  std::vector<Walks> walks(mesh.edges.size());
  std::vector<int> ranks(mesh.cells.size()), parents(mesh.cells.size());
  std::iota(parents.begin(), parents.end(), 0);
  boost::disjoint_sets<int*, int*> connected(ranks.data(), parents.data());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const Enclosure area = doubled_area(corners<Enclosure>(problem, static_cast<int>(c)));
    if (!(area.middle > area.radius)) return fmt::format("the area of cell {} is not positive with certainty", c);
    const int cell = static_cast<int>(c);
    for (int k = 0; k < 3; ++k) {
      const std::array<int, 2> walked = scene::facet_vertices(mesh, static_cast<int>(c), k);
      const std::array<int, 2>& edge = mesh.edges[mesh.cell_edges[c][k]];
      Walks& so_far = walks[mesh.cell_edges[c][k]];
      if (walked == edge)
        ++so_far.up;
      else if (walked[0] == edge[1] && walked[1] == edge[0])
        ++so_far.down;
      else
        return fmt::format("edge {} of cell {} does not join its corners", k, c);
      if (so_far.up > 1 || so_far.down > 1)
        return fmt::format("more than one cell lies on one side of the edge of cell {}", c);
      if (so_far.cell < 0) so_far.cell = cell;
      if (mesh.cell_component[so_far.cell] != mesh.cell_component[c]) return "two components share an edge";
      connected.union_set(so_far.cell, cell);
    }
  }
  // As many connected sets as components, and a cell in each: each component is one of the sets.
  std::vector<char> has_cells(mesh.components.size(), 0);
  for (const int component : mesh.cell_component) has_cells[component] = 1;
  std::size_t sets = 0;
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell)
    if (connected.find_set(cell) == cell) ++sets;
  if (sets != mesh.components.size() || std::ranges::count(has_cells, 0) > 0)
    return "a component of the mesh does not hang together through edges";
  std::size_t open = 0;
  for (const Walks& edge : walks) open += edge.up + edge.down == 1;
  std::vector<char> seen(mesh.edges.size(), 0);
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    const auto& [vertices, cell, local, edge, part] = mesh.boundary[f];
    const bool walked = scene::facet_vertices(mesh, cell, local) == vertices && mesh.cell_edges[cell][local] == edge;
    if (!walked || seen[edge] || walks[edge].up + walks[edge].down != 1)
      return fmt::format("boundary facet {} is not an edge with one cell, walked as its cell walks it", f);
    seen[edge] = 1;
  }
  return open == mesh.boundary.size() ? "" : "an edge with one cell is not on the boundary";
}

}  // namespace bracket::bounds
