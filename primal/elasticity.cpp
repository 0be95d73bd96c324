// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "primal/elasticity.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/grid/tria.h>

#include "scene/voigt.h"

namespace bracket::primal {

namespace {

/// Some cells as a deal.II triangulation; cell i of it is cells[i] of the mesh.
template <int dim>
void triangulate(const scene::Mesh<dim>& mesh, const std::vector<int>& cells,
                 dealii::Triangulation<dim>& triangulation) {
  std::vector<int> number(mesh.vertices.size(), -1);
  std::vector<dealii::Point<dim>> points;
  std::vector<dealii::CellData<dim>> data(cells.size(), dealii::CellData<dim>(dim + 1));
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (int v = 0; v <= dim; ++v) {
      const int vertex = mesh.cells[cells[i]][v];
      if (number[vertex] < 0) {
        number[vertex] = static_cast<int>(points.size());
        dealii::Point<dim> point;
        for (int c = 0; c < dim; ++c) point[c] = mesh.vertices[vertex][c];
        points.push_back(point);
      }
      data[i].vertices[v] = number[vertex];
    }
  triangulation.create_triangulation(points, data, dealii::SubCellData());
}

/// Place among a mesh cell's nodes of deal.II's node i: its lines run 0–1, 1–2, 2–0.
int place(int i) { return i < 3 ? i : 3 + scene::Simplex<2>::edge_between(i - 3, (i - 2) % 3); }

}  // namespace

template <int dim>
void for_each_cell(const scene::Problem<dim>& problem, int component, int degree, const UseCell& use) {
  static_assert(dim == 2, "the places of the nodes are those of a triangle");
  const auto& mesh = problem.mesh;
  std::vector<int> cells;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    if (mesh.cell_component[c] == component) cells.push_back(static_cast<int>(c));

  dealii::Triangulation<dim> triangulation;
  triangulate(mesh, cells, triangulation);
  const dealii::FE_SimplexP<dim> element(degree);
  const dealii::MappingFE<dim> mapping(dealii::FE_SimplexP<dim>(1));
  const dealii::QGaussSimplex<dim> quadrature(2);  // exact for quadratics: gradients of degree 1, squared
  dealii::FEValues<dim> values(mapping, element, quadrature, dealii::update_gradients | dealii::update_JxW_values);

  const int n = static_cast<int>(element.n_dofs_per_cell());
  Eigen::MatrixXd stiffness(dim * n, dim * n);
  Eigen::MatrixXd strain(scene::n_voigt<dim>, dim * n);
  for (const auto& cell : triangulation.active_cell_iterators()) {
    values.reinit(cell);
    stiffness.setZero();
    const auto& elasticity = body_of(problem, cells[cell->active_cell_index()]).stiffness;
    for (const unsigned int q : values.quadrature_point_indices()) {
      for (int i = 0; i < n; ++i) {
        const auto gradient = values.shape_grad(i, q);
        const int column = dim * place(i);
        for (int c = 0; c < dim; ++c) {
          Eigen::Matrix<double, dim, dim> of_displacement = Eigen::Matrix<double, dim, dim>::Zero();
          for (int j = 0; j < dim; ++j) of_displacement(c, j) = gradient[j];
          strain.col(column + c) = scene::strain<dim>(of_displacement);
        }
      }
      stiffness.noalias() += strain.transpose() * (values.JxW(q) * elasticity * strain).eval();
    }
    use(cells[cell->active_cell_index()], stiffness);
  }
}

template void for_each_cell(const scene::Problem<2>&, int, int, const UseCell&);

}  // namespace bracket::primal
