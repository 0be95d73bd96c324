// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "scene/scene.h"

namespace bracket::primal {

/// ∫ ε(B_i) : C ε(B_j) over a cell for the Bernstein polynomials of scene::control_points(), as many rows a point as
/// there are dimensions.
template <int dim>
void set_cell_stiffness(const std::array<scene::Vector<dim>, dim + 1>& corners,
                        const scene::Elasticity<dim>& elasticity, int degree, Eigen::MatrixXd& stiffness);

/// What one cell adds: its stiffness, as set_cell_stiffness() has it.
using UseCell = std::function<void(int cell, const Eigen::MatrixXd& stiffness)>;

/// Calls `use` for each cell of a component of the mesh, in its order.
template <int dim>
void for_each_cell(const scene::Problem<dim>& problem, int component, int degree, const UseCell& use);

}  // namespace bracket::primal
