// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "scene/scene.h"

namespace bracket::primal {

/// Nodes of a cell: its vertices 0, 1, 2, and for degree 2 the midpoints of its edges 0, 1, 2 (numbered as in
/// Mesh::cell_edges). Two unknowns a node, x then y.
inline int nodes_per_cell(int degree) { return degree == 1 ? 3 : 6; }

/// What one cell adds: its stiffness ∫ ε(φ_i) : C ε(φ_j).
using UseCell = std::function<void(int cell, const Eigen::MatrixXd& stiffness)>;

/// Calls `use` for each cell of a component of the mesh, in its order.
template <int dim>
void for_each_cell(const scene::Problem<dim>& problem, int component, int degree, const UseCell& use);

}  // namespace bracket::primal
