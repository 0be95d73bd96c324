// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <numeric>

#include "bounds/certificate/space/geometry.h"
#include "bounds/certificate/space/problem_faults.h"

namespace bracket::bounds::space {

using scene::Problem;

namespace {

using Triple = std::array<int, 3>;

/// The same vertices the other way round.
bool are_opposite(const Triple& one, const Triple& other) {
  for (int shift = 0; shift < 3; ++shift)
    if (one[0] == other[shift] && one[1] == other[(shift + 2) % 3] && one[2] == other[(shift + 1) % 3]) return true;
  return false;
}

/// The edges of a cell's facet, sorted.
Triple edges_of(const scene::Mesh<3>& mesh, int cell, int local) {
  Triple edges;
  for (int e = 0; e < 3; ++e) {
    const auto& [a, b] = scene::Simplex<2>::edges[e];
    const auto& corners = scene::Simplex<3>::facets[local];
    edges[e] = mesh.cell_edges[cell][scene::Simplex<3>::edge_between(corners[a], corners[b])];
  }
  std::ranges::sort(edges);
  return edges;
}

/// What is wrong with a cell by itself.
std::string cell_fault(const Problem<3>& problem, int cell) {
  const auto& mesh = problem.mesh;
  const Enclosure volume = volume6(corners<Enclosure>(problem, cell));
  if (!(volume.middle > volume.radius))
    return fmt::format("the volume of cell {} is not positive with certainty", cell);
  for (int e = 0; e < 6; ++e) {
    const auto& [a, b] = scene::Simplex<3>::edges[e];
    const auto [least, most] = std::minmax(mesh.cells[cell][a], mesh.cells[cell][b]);
    if (mesh.edges[mesh.cell_edges[cell][e]] != std::array<int, 2>{least, most})
      return fmt::format("edge {} of cell {} does not join its corners", e, cell);
  }
  return "";
}

}  // namespace

std::string topology_fault(const Problem<3>& problem) {
  const auto& mesh = problem.mesh;
  struct CellsAtFacet {
    int count = 0, cell = -1, local = -1;
  };
  std::vector<CellsAtFacet> sides(scene::n_facets(mesh));
  std::vector<int> ranks(mesh.cells.size()), parents(mesh.cells.size());
  std::iota(parents.begin(), parents.end(), 0);
  boost::disjoint_sets<int*, int*> connected(ranks.data(), parents.data());
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    if (std::string fault = cell_fault(problem, cell); !fault.empty()) return fault;
    for (int k = 0; k < 4; ++k) {
      CellsAtFacet& known = sides[mesh.facet_numbers[cell][k]];
      if (++known.count == 1) {
        known.cell = cell;
        known.local = k;
        continue;
      }
      if (known.count > 2) return fmt::format("more than two cells have a facet of cell {}", cell);
      if (!are_opposite(scene::facet_vertices(mesh, known.cell, known.local), scene::facet_vertices(mesh, cell, k)))
        return fmt::format("cells {} and {} do not lie on the two sides of their facet", known.cell, cell);
      if (edges_of(mesh, known.cell, known.local) != edges_of(mesh, cell, k))
        return fmt::format("cells {} and {} do not share the edges of their facet", known.cell, cell);
      if (mesh.cell_component[known.cell] != mesh.cell_component[cell]) return "two components share a facet";
      connected.union_set(known.cell, cell);
    }
  }
  // As many connected sets as components, and a cell in each: each component is one of the sets.
  std::vector<char> has_cells(mesh.components.size(), 0);
  for (const int component : mesh.cell_component) has_cells[component] = 1;
  std::size_t sets = 0;
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell)
    if (connected.find_set(cell) == cell) ++sets;
  if (sets != mesh.components.size() || std::ranges::count(has_cells, 0) > 0)
    return "a component of the mesh does not hang together through facets";
  std::size_t open = 0;
  for (const CellsAtFacet& one : sides) {
    if (one.count == 0) return "a facet has no cell";
    open += one.count == 1;
  }
  std::vector<char> seen(sides.size(), 0);
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    const auto& facet = mesh.boundary[f];
    const int number = mesh.facet_numbers[facet.cell][facet.local];
    if (scene::facet_vertices(mesh, facet.cell, facet.local) != facet.vertices || seen[number] ||
        sides[number].count != 1)
      return fmt::format("boundary facet {} is not a facet with one cell, walked as its cell walks it", f);
    seen[number] = 1;
  }
  return open == mesh.boundary.size() ? "" : "a facet with one cell is not on the boundary";
}

}  // namespace bracket::bounds::space
