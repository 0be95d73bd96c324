// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/tree.h"

#include <algorithm>
#include <limits>

namespace bracket::bounds {

std::vector<Branch> trees(const scene::Mesh<2>& mesh, const std::vector<Reference>& references) {
  std::vector<std::array<int, 2>> cells_at(mesh.edges.size(), {-1, -1});
  std::vector<int> root(mesh.components.size(), -1);
  std::vector<double> nearest(mesh.components.size(), std::numeric_limits<double>::infinity());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for (const int edge : mesh.cell_edges[c]) cells_at[edge][cells_at[edge][0] >= 0] = static_cast<int>(c);
    const int body = mesh.cell_component[c];
    const double distance = (mesh.vertices[mesh.cells[c][0]] - references[body].point).norm();
    if (distance >= nearest[body]) continue;
    nearest[body] = distance;
    root[body] = static_cast<int>(c);
  }
  std::vector<Branch> order;
  std::vector<char> reached(mesh.cells.size(), 0);
  for (const int cell : root) {
    order.push_back({cell, -1, -1});
    reached[cell] = 1;
  }
  for (std::size_t k = 0; k < order.size(); ++k) {
    const int cell = order[k].cell;
    for (const int edge : mesh.cell_edges[cell])
      for (const int other : cells_at[edge]) {
        if (other < 0 || reached[other]) continue;
        reached[other] = 1;
        const auto& edges = mesh.cell_edges[other];  // edge m lies between the corners m + 1 and m + 2
        const int m = static_cast<int>(std::find(edges.begin(), edges.end(), edge) - edges.begin());
        order.push_back({other, cell, (m + 1) % 3});
      }
  }
  return order;
}

}  // namespace bracket::bounds
