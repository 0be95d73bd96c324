// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "primal/nodes.h"
#include "primal/rows.h"

namespace bracket::primal {

/// What one process has of a mesh: the cells at the nodes that it owns. Nodes are numbered process by process.
struct Piece {
  int degree = 1;
  int first = 0, end = 0;  ///< its own nodes: [first, end)
  int n_nodes = 0;         ///< of all processes
  std::vector<int> cell_body;
  std::vector<int> cell_nodes;            ///< one cell after the other, in the order of scene::control_points()
  std::vector<scene::Vector<3>> corners;  ///< four a cell
};

/// A mesh in pieces.
struct Pieces {
  std::vector<Piece> of;             ///< each process
  std::vector<int> number;           ///< of each of Nodes::node
  std::vector<std::vector<int>> at;  ///< of each process: which of Nodes::node its cells have, sorted
};

/// Sorts numbers and leaves each of them once.
void make_distinct(std::vector<int>& numbers);

/// The mesh cut by METIS in as many parts as there are processes, bodies that touch seen as one.
/// \param linked nodes that contact may tie to each other; a process that owns one of them has the cells of all
Pieces cut(const scene::Problem<3>& problem, const Nodes<3>& nodes, const std::vector<std::vector<int>>& linked,
           int processes);

}  // namespace bracket::primal
