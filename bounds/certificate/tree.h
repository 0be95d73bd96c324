// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/arithmetic.h"
#include "bounds/certificate/totals.h"

/// How cells hand on what they lack of balance.
namespace bracket::bounds {

/// A cell in its body's tree of cells.
struct Branch {
  int cell;
  int parent;  ///< −1: the root
  int side;    ///< i → i + 1, at which it touches its parent
};
/// All cells, each after its parent: the shortest paths to a large cell in the middle, through large cells.
std::vector<Branch> trees(const scene::Mesh<2>& mesh, const std::vector<Reference>& references);

/// Balances every cell of bodies that are held: each cell, from the leaves of its body's tree on, hands what it lacks
/// to its parent, through their common edge; the root lacks nothing.
template <class Number>
EdgeLoads<Number> handed_on(const scene::Problem<2>& problem, const std::vector<Reference>& about,
                            const EdgeLoads<Number>& loads) {
  const auto& mesh = problem.mesh;
  // What a cell lacks with all that hangs on it, about its first corner. It is handed on as a resultant: taken again
  // from the loads that carry it, its enclosure would grow from cell to cell.
  std::vector<Wrench<Number>> lacks(mesh.cells.size());
  scene::in_chunks(static_cast<int>(lacks.size()), [&](int, int begin, int end) {
    check_arithmetic();
    for (int c = begin; c < end; ++c) lacks[c] = imbalance(problem, loaded_cell(problem, loads, c), c);
  });
  const auto add_to = [](Wrench<Number>& sum, const Wrench<Number>& part) {
    sum.force = sum.force + part.force;
    sum.moment += part.moment;
  };
  const std::vector<Branch> branches = trees(mesh, about);
  EdgeLoads<Number> result = loads;
  for (auto branch = branches.rbegin(); branch != branches.rend(); ++branch) {
    if (branch->parent < 0) continue;
    const int i = branch->side;
    const LoadedCell<Number> cell = loaded_cell(problem, loads, branch->cell);
    const Wrench<Number>& own = lacks[branch->cell];
    const SideLoad<Number> carried =
        oriented(load_with({-own.force, -own.moment}, cell.x[i], cell.x[(i + 1) % 3] - cell.x[i]), cell.forward[i]);
    auto& edge = result.edge[cell.edge[i]];
    for (int end = 0; end < 2; ++end) edge[end] = edge[end] + carried[end];
    // From the parent's first corner to that of the cell, by way of a corner that they share.
    const auto& of_parent = mesh.cells[branch->parent];
    const auto shared = std::find(of_parent.begin(), of_parent.end(), mesh.cells[branch->cell][i]) - of_parent.begin();
    const Vector2<Number> to_cell = corners<Number>(problem, branch->parent)[shared] - cell.x[i];
    add_to(lacks[branch->parent], {own.force, own.moment + cross(to_cell, own.force)});
  }
  return result;
}

}  // namespace bracket::bounds
