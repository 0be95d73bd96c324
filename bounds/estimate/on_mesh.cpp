// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/estimate/on_mesh.h"

#include <algorithm>
#include <cmath>

namespace bracket::bounds {

using scene::Vector;
using scene::Voigt;

template <int dim>
std::vector<Voigt<dim>> strain(const scene::Mesh<dim>& mesh, const scene::Displacement<dim>& displacement, int cell) {
  const auto& v = mesh.cells[cell];
  const int degree = displacement.degree;
  const auto gradient = scene::hat_gradients<dim>(scene::positions(mesh, v));
  // Differences to one vertex, so that a large rigid translation does not cancel in the gradient.
  Eigen::Matrix<double, dim, dim> linear = Eigen::Matrix<double, dim, dim>::Zero();
  for (int j = 1; j <= dim; ++j)
    linear += (displacement.vertex[v[j]] - displacement.vertex[v[0]]) * gradient[j].transpose();
  if (degree == 1) return {std::size_t{dim} + 1, scene::strain<dim>(linear)};
  const auto offset = scene::offsets_on_cell(mesh, displacement, cell);
  std::vector<Voigt<dim>> strain;
  for (const auto& i : scene::bernstein_indices<dim>(degree - 1)) {
    Eigen::Matrix<double, dim, dim> g = linear;
    for (int corner = 0; corner <= dim; ++corner) {
      auto above = i;
      ++above[corner];
      g += degree * offset[scene::bernstein_place(above)] * gradient[corner].transpose();
    }
    strain.push_back(scene::strain<dim>(g));
  }
  return strain;
}

template <int dim>
std::vector<Voigt<dim>> displacement_stress(const scene::Problem<dim>& problem,
                                            const scene::Displacement<dim>& displacement, int cell) {
  auto field = strain(problem.mesh, displacement, cell);
  for (auto& value : field) value = (problem.bodies[problem.mesh.cell_body[cell]].material.stiffness() * value).eval();
  return field;
}

template <int dim>
std::vector<Vector<dim>> on_facet(const scene::Mesh<dim>& mesh, const scene::Displacement<dim>& displacement,
                                  int facet) {
  std::array<Vector<dim>, dim> at_vertices;
  for (int i = 0; i < dim; ++i) at_vertices[i] = displacement.vertex[mesh.boundary[facet].vertices[i]];
  std::vector<Vector<dim>> u = scene::offsets_on_facet(mesh, displacement, facet);
  const auto linear = coefficients(at_vertices, displacement.degree);
  for (std::size_t k = 0; k < u.size(); ++k) u[k] += linear[k];
  return u;
}

template <int dim>
std::vector<Vector<dim>> tractions(const scene::Mesh<dim>& mesh, const scene::Stress<dim>& stress, int facet) {
  const auto& f = mesh.boundary[facet];
  const Vector<dim> n = scene::normal(mesh, facet);
  std::vector<Vector<dim>> result;
  for (const Voigt<dim>& value :
       scene::stress_of_part(stress, f.cell, f.local).first(scene::n_on_facet<dim>(stress.degree)))
    result.push_back(scene::traction<dim>(value, n));
  return result;
}

template <int dim>
std::vector<Vector<dim>> contact_tractions(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress,
                                           const scene::ContactFacetOf<dim>& pair) {
  auto t = tractions(problem.mesh, stress, pair.first);
  if (!scene::is_loaded(problem.facets[pair.first])) return t;
  const auto load = loads(problem, pair.first, stress.degree);
  for (std::size_t k = 0; k < t.size(); ++k) t[k] -= load[k] / scene::length(problem.mesh, pair.first);
  return t;
}

template <int dim>
std::vector<double> plain_pressure(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress,
                                   const scene::ContactFacetOf<dim>& pair) {
  return along<dim>(contact_tractions(problem, stress, pair), -problem.facets[pair.first].normal);
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

template std::vector<Voigt<2>> strain(const scene::Mesh<2>&, const scene::Displacement<2>&, int);
template std::vector<Voigt<3>> strain(const scene::Mesh<3>&, const scene::Displacement<3>&, int);
template std::vector<Voigt<2>> displacement_stress(const scene::Problem<2>&, const scene::Displacement<2>&, int);
template std::vector<Voigt<3>> displacement_stress(const scene::Problem<3>&, const scene::Displacement<3>&, int);
template std::vector<Vector<2>> on_facet(const scene::Mesh<2>&, const scene::Displacement<2>&, int);
template std::vector<Vector<3>> on_facet(const scene::Mesh<3>&, const scene::Displacement<3>&, int);
template std::vector<Vector<2>> tractions(const scene::Mesh<2>&, const scene::Stress<2>&, int);
template std::vector<Vector<3>> tractions(const scene::Mesh<3>&, const scene::Stress<3>&, int);
template std::vector<Vector<2>> contact_tractions(const scene::Problem<2>&, const scene::Stress<2>&,
                                                  const scene::ContactFacet&);
template std::vector<Vector<3>> contact_tractions(const scene::Problem<3>&, const scene::Stress<3>&,
                                                  const scene::ContactFacetOf<3>&);
template std::vector<double> plain_pressure(const scene::Problem<2>&, const scene::Stress<2>&,
                                            const scene::ContactFacet&);
template std::vector<double> plain_pressure(const scene::Problem<3>&, const scene::Stress<3>&,
                                            const scene::ContactFacetOf<3>&);
template double largest_at_vertices(const scene::Displacement<2>&);
template double largest_at_vertices(const scene::Displacement<3>&);
template double largest_stress(const scene::Stress<2>&);
template double largest_stress(const scene::Stress<3>&);
template double largest_given(const scene::Problem<2>&);
template double largest_given(const scene::Problem<3>&);

}  // namespace bracket::bounds
