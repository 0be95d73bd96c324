// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/tree.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace bracket::bounds {

namespace {

/// Of each body the cell nearest to its reference point, of those that are not small.
std::vector<int> roots(const scene::Mesh<2>& mesh, const std::vector<Reference>& references) {
  std::vector<double> area, largest(mesh.components.size(), 0);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    area.push_back(scene::volume(mesh, static_cast<int>(c)));
    double& of_body = largest[mesh.cell_component[c]];
    of_body = std::max(of_body, area.back());
  }
  std::vector<int> root(mesh.components.size(), -1);
  std::vector<double> nearest(mesh.components.size(), std::numeric_limits<double>::infinity());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int body = mesh.cell_component[c];
    const double distance = (mesh.vertices[mesh.cells[c][0]] - references[body].point).norm();
    if (distance >= nearest[body] || area[c] < largest[body] / 4) continue;
    nearest[body] = distance;
    root[body] = static_cast<int>(c);
  }
  return root;
}

/// A cell that can be reached from another by an edge, and how far it would be from the root.
struct Reach {
  double distance;
  std::size_t order;  ///< of finding: of the same distance the first comes first
  Branch branch;
  bool operator<(const Reach& other) const {  // the nearest is on top
    return std::pair(distance, order) > std::pair(other.distance, other.order);
  }
};

}  // namespace

// What a step strains grows as the cells on its way are smaller: for a force F with F², for a moment M with M² e⁻², e
// the length of the edge. Steps are as long as e⁻¹, between the two: paths keep to large cells, and where all are equal
// they have few steps.
std::vector<Branch> trees(const scene::Mesh<2>& mesh, const std::vector<Reference>& references) {
  std::vector<std::array<int, 2>> cells_at(mesh.edges.size(), {-1, -1});
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const int edge : mesh.cell_edges[c]) cells_at[edge][cells_at[edge][0] >= 0] = static_cast<int>(c);
  std::priority_queue<Reach> reachable;
  for (const int cell : roots(mesh, references)) reachable.push({0, reachable.size(), {cell, -1, -1}});
  std::vector<Branch> order;
  std::vector<char> reached(mesh.cells.size(), 0);
  std::size_t found = reachable.size();
  while (!reachable.empty()) {
    const auto [distance, _, branch] = reachable.top();
    reachable.pop();
    if (reached[branch.cell]) continue;
    reached[branch.cell] = 1;
    order.push_back(branch);
    for (const int edge : mesh.cell_edges[branch.cell])
      for (const int other : cells_at[edge]) {
        if (other < 0 || reached[other]) continue;
        const auto& [a, b] = mesh.edges[edge];
        const auto& edges = mesh.cell_edges[other];  // edge m lies between the corners m + 1 and m + 2
        const int m = static_cast<int>(std::find(edges.begin(), edges.end(), edge) - edges.begin());
        reachable.push(
            {distance + 1 / (mesh.vertices[b] - mesh.vertices[a]).norm(), found++, {other, branch.cell, (m + 1) % 3}});
      }
  }
  return order;
}

}  // namespace bracket::bounds
