// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/estimate/on_mesh.h"

#include <algorithm>
#include <cmath>

namespace bracket::bounds {

using scene::Vector;
using scene::Voigt;

template <int dim>
std::array<Voigt<dim>, 3> strain_at_vertices(const scene::Mesh<dim>& mesh, const scene::Displacement<dim>& displacement,
                                             int cell) {
  const auto& v = mesh.cells[cell];
  const double twice_area = 2 * scene::volume(mesh, cell);
  std::array<Vector<dim>, 3> gradient;  // of the barycentric coordinates
  for (int k = 0; k < 3; ++k) {
    const Vector<dim> opposite = mesh.vertices[v[(k + 2) % 3]] - mesh.vertices[v[(k + 1) % 3]];
    gradient[k] = Vector<dim>(-opposite[1], opposite[0]) / twice_area;
  }
  std::array<Voigt<dim>, 3> strain;
  for (int m = 0; m < 3; ++m) {
    // Differences to the vertex itself, so that a large rigid translation does not cancel in the gradient.
    const Vector<dim>& u = displacement.vertex[v[m]];
    Eigen::Matrix<double, dim, dim> g = Eigen::Matrix<double, dim, dim>::Zero();
    for (int j = 0; j < 3; ++j) {
      if (j == m) continue;
      Vector<dim> slope = displacement.vertex[v[j]] - u;
      if (displacement.degree == 2) slope = 4 * (displacement.edge[mesh.cell_edges[cell][3 - m - j]] - u) - slope;
      g += slope * gradient[j].transpose();
    }
    strain[m] = {g(0, 0), g(1, 1), g(0, 1) + g(1, 0)};
  }
  return strain;
}

template <int dim>
std::array<Voigt<dim>, 3> displacement_stress(const scene::Problem<dim>& problem,
                                              const scene::Displacement<dim>& displacement, int cell) {
  auto field = strain_at_vertices(problem.mesh, displacement, cell);
  for (auto& value : field) value = (problem.bodies[problem.mesh.cell_body[cell]].material.stiffness() * value).eval();
  return field;
}

template <int dim>
std::array<Vector<dim>, 3> on_facet(const scene::Mesh<dim>& mesh, const scene::Displacement<dim>& displacement,
                                    int facet) {
  const auto& f = mesh.boundary[facet];
  const Vector<dim>&a = displacement.vertex[f.vertices[0]], &b = displacement.vertex[f.vertices[1]];
  return {a, b, displacement.degree == 2 ? displacement.edge[f.edge] : Vector<dim>((a + b) / 2)};
}

template <int dim>
std::array<Vector<dim>, 2> tractions(const scene::Mesh<dim>& mesh, const scene::Stress<dim>& stress, int facet) {
  const auto& f = mesh.boundary[facet];
  const Vector<dim> n = scene::normal(mesh, facet);
  const auto& corners = stress.cell[f.cell];
  return {traction<dim>(corners[3 * f.local], n), traction<dim>(corners[3 * f.local + 1], n)};
}

template <int dim> double largest_given(const scene::Problem<dim>& problem) {
  double largest = 0;
  for (const auto& data : problem.facets)
    for (int i = 0; i < dim; ++i)
      largest = std::max({largest, data.displacement[i].norm(), std::abs(data.normal_displacement[i])});
  for (const auto& pair : problem.contact)
    for (const double gap : pair.upper) largest = std::max(largest, std::abs(gap));
  return largest;
}

template std::array<Voigt<2>, 3> strain_at_vertices(const scene::Mesh<2>&, const scene::Displacement<2>&, int);
template std::array<Voigt<2>, 3> displacement_stress(const scene::Problem<2>&, const scene::Displacement<2>&, int);
template std::array<Vector<2>, 3> on_facet(const scene::Mesh<2>&, const scene::Displacement<2>&, int);
template std::array<Vector<2>, 2> tractions(const scene::Mesh<2>&, const scene::Stress<2>&, int);
template double largest_given(const scene::Problem<2>&);

}  // namespace bracket::bounds
