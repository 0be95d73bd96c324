// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/fields.h"

namespace bracket::apps {
namespace {

// ∇λ_k, in row k, of the barycentric coordinates of a cell.
Eigen::Matrix<double, 3, 2> barycentric_gradients(const scene::Mesh<2>& mesh, int cell) {
  const double twice_area = 2 * scene::volume(mesh, cell);
  Eigen::Matrix<double, 3, 2> gradients;
  for (int k = 0; k < 3; ++k) {
    const scene::Vector<2> side =
        mesh.vertices[mesh.cells[cell][(k + 2) % 3]] - mesh.vertices[mesh.cells[cell][(k + 1) % 3]];
    gradients.row(k) << -side.y() / twice_area, side.x() / twice_area;
  }
  return gradients;
}

}  // namespace

template <int dim>
Sample<dim> sample(const scene::Problem<dim>& problem, const primal::Displacement<dim>& displacement, int cell,
                   const scene::Vector<dim + 1>& at) {
  const Eigen::Matrix<double, 3, 2> slope = barycentric_gradients(problem.mesh, cell);
  scene::Vector<2> value = scene::Vector<2>::Zero();
  Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();  // ∂u_i / ∂x_j
  const auto add = [&](const scene::Vector<2>& coefficient, double shape, const Eigen::RowVector2d& shape_slope) {
    value += shape * coefficient;
    gradient += coefficient * shape_slope;
  };
  for (int k = 0; k < 3; ++k) {
    const scene::Vector<2>& vertex = displacement.vertex[problem.mesh.cells[cell][k]];
    if (displacement.degree == 1) {
      add(vertex, at[k], slope.row(k));
    } else {
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      add(vertex, at[k] * (2 * at[k] - 1), (4 * at[k] - 1) * slope.row(k));
      add(displacement.edge[problem.mesh.cell_edges[cell][k]], 4 * at[a] * at[b],
          4 * (at[a] * slope.row(b) + at[b] * slope.row(a)));
    }
  }
  const scene::Voigt<2> strain(gradient(0, 0), gradient(1, 1), gradient(0, 1) + gradient(1, 0));
  return {value, problem.bodies[problem.mesh.cell_body[cell]].stiffness * strain};
}

template Sample<2> sample(const scene::Problem<2>&, const primal::Displacement<2>&, int, const scene::Vector<3>&);

}  // namespace bracket::apps
