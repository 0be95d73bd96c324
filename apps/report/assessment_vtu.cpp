// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>

#include "apps/report/assessment.h"
#include "apps/report/vtk_file.h"

namespace bracket::apps {

template <int dim> std::string assessment_vtu(const bounds::AssessmentOf<dim>& assessment) {
  const scene::Mesh<dim>& mesh = assessment.field.problem.mesh;
  const scene::Displacement<dim>& u = assessment.field.given.displacement;
  const bool quadratic = u.degree == 2;
  const int linear_type = dim == 2 ? 5 : 10, quadratic_type = dim == 2 ? 22 : 24;
  VtkGrid grid{.cell_type = quadratic ? quadratic_type : linear_type,
               .points_per_cell = quadratic ? scene::Simplex<dim>::n_quadratic : dim + 1};
  LargeArray<double> displacements, share, density;
  const auto append = [](LargeArray<double>& values, const scene::Vector<dim>& vector) {
    values.insert(values.end(), vector.begin(), vector.end());
    if (dim == 2) values.push_back(0);
  };
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const auto& vertices = mesh.cells[cell];
    for (const int vertex : vertices) {
      append(grid.points, mesh.vertices[vertex]);
      append(displacements, u.vertex[vertex]);
    }
    for (const auto& [a, b] : scene::edges_in_files<dim>()) {
      if (!quadratic) break;
      append(grid.points, (mesh.vertices[vertices[a]] + mesh.vertices[vertices[b]]) / 2);
      append(displacements, u.edge[mesh.cell_edges[cell][scene::Simplex<dim>::edge_between(a, b)]]);
    }
    share.push_back(assessment.cell[cell]);
    density.push_back(assessment.cell[cell] / scene::volume(mesh, static_cast<int>(cell)));
  }
  grid.point_data = {vtk_array("displacement", "Float64", displacements, {"x", "y", "z"})};
  grid.cell_data = {vtk_array("body", "Int32", LargeArray<std::int32_t>(mesh.cell_body.begin(), mesh.cell_body.end())),
                    vtk_array("error_squared", "Float64", share), vtk_array("error_density", "Float64", density)};
  return vtu(std::move(grid));
}

template std::string assessment_vtu(const bounds::AssessmentOf<2>&);
template std::string assessment_vtu(const bounds::AssessmentOf<3>&);

}  // namespace bracket::apps
