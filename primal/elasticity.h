// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "scene/scene.h"

namespace bracket::primal {

/// What one cell adds: its stiffness ∫ ε(B_i) : C ε(B_j) for the Bernstein polynomials of scene::control_points(), as
/// many rows a point as there are dimensions.
using UseCell = std::function<void(int cell, const Eigen::MatrixXd& stiffness)>;

/// Calls `use` for each cell of a component of the mesh, in its order.
template <int dim>
void for_each_cell(const scene::Problem<dim>& problem, int component, int degree, const UseCell& use);

}  // namespace bracket::primal
