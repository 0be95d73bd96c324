// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/estimate/on_mesh.h"

#include <algorithm>
#include <cmath>

namespace bracket::bounds {

using scene::Vector;
using scene::Voigt;

template <int dim>
std::array<Voigt<dim>, dim + 1> strain_at_vertices(const scene::Mesh<dim>& mesh,
                                                   const scene::Displacement<dim>& displacement, int cell) {
  using Table = scene::Simplex<dim>;
  const auto& v = mesh.cells[cell];
  const auto gradient = scene::hat_gradients<dim>(scene::positions(mesh, v));
  std::array<Voigt<dim>, dim + 1> strain;
  for (int m = 0; m <= dim; ++m) {
    // Differences to the vertex itself, so that a large rigid translation does not cancel in the gradient.
    const Vector<dim>& u = displacement.vertex[v[m]];
    Eigen::Matrix<double, dim, dim> g = Eigen::Matrix<double, dim, dim>::Zero();
    for (int j = 0; j <= dim; ++j) {
      if (j == m) continue;
      Vector<dim> slope = displacement.vertex[v[j]] - u;
      if (displacement.degree == 2)
        slope = 4 * (displacement.edge[mesh.cell_edges[cell][Table::edge_between(m, j)]] - u) - slope;
      g += slope * gradient[j].transpose();
    }
    strain[m] = scene::strain<dim>(g);
  }
  return strain;
}

template <int dim>
std::array<Voigt<dim>, dim + 1> displacement_stress(const scene::Problem<dim>& problem,
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
std::array<Vector<dim>, std::size_t{dim}> tractions(const scene::Mesh<dim>& mesh, const scene::Stress<dim>& stress,
                                                    int facet) {
  const auto& f = mesh.boundary[facet];
  const Vector<dim> n = scene::normal(mesh, facet);
  const auto corners = scene::stress_of_part(stress, f.cell, f.local);
  std::array<Vector<dim>, dim> result;
  for (int i = 0; i < dim; ++i) result[i] = scene::traction<dim>(corners[i], n);
  return result;
}

template <int dim>
std::array<double, std::size_t{dim}> plain_pressure(const scene::Problem<dim>& problem,
                                                    const scene::Stress<dim>& stress, const scene::ContactFacet& pair) {
  const Vector<dim>& d = problem.facets[pair.first].normal;
  auto t = tractions(problem.mesh, stress, pair.first);
  if (scene::is_loaded(problem.facets[pair.first])) {
    const auto load = scene::load(problem, pair.first);
    for (int i = 0; i < dim; ++i) t[i] -= load[i] / scene::length(problem.mesh, pair.first);
  }
  std::array<double, dim> pressure;
  for (int i = 0; i < dim; ++i) pressure[i] = -t[i].dot(d);
  return pressure;
}

template <int dim> double largest_at_vertices(const scene::Displacement<dim>& displacement) {
  double largest = 0;
  for (const auto& u : displacement.vertex) raise(largest, u.norm());
  return largest;
}

template <int dim> double largest_stress(const scene::Stress<dim>& stress) {
  double largest = 0;
  for (const auto& cell : stress.cell)
    for (const auto& s : cell) raise(largest, s.norm());
  return largest;
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
template std::array<double, 2> plain_pressure(const scene::Problem<2>&, const scene::Stress<2>&,
                                              const scene::ContactFacet&);
template double largest_at_vertices(const scene::Displacement<2>&);
template double largest_stress(const scene::Stress<2>&);
template double largest_given(const scene::Problem<2>&);

}  // namespace bracket::bounds
