// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "scene/scene.h"

namespace bracket::primal {

/// Nodes of a cell: its vertices, and for degree 2 the midpoints of its edges, in the order of scene::Simplex. As many
/// unknowns a node as there are dimensions.
template <int dim> int nodes_per_cell(int degree) {
  return degree == 1 ? scene::Simplex<dim>::n_vertices : scene::Simplex<dim>::n_quadratic;
}

/// What one cell adds: its stiffness ∫ ε(φ_i) : C ε(φ_j).
using UseCell = std::function<void(int cell, const Eigen::MatrixXd& stiffness)>;

/// Calls `use` for each cell of a component of the mesh, in its order.
template <int dim>
void for_each_cell(const scene::Problem<dim>& problem, int component, int degree, const UseCell& use);

}  // namespace bracket::primal
