// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/unstrained.h"

#include <algorithm>

#include "bounds/estimate/on_mesh.h"

namespace bracket::bounds {

namespace {

template <int dim> bool has_loads(const scene::Problem<dim>& problem) {
  return std::any_of(problem.bodies.begin(), problem.bodies.end(),
                     [](const scene::Body<dim>& body) { return !body.force.isZero(0); }) ||
         std::any_of(problem.facets.begin(), problem.facets.end(), scene::is_loaded<dim>);
}

}  // namespace

template <int dim> double energy_of_noise(const scene::Problem<dim>& problem, int degree, double size) {
  const auto& mesh = problem.mesh;
  double energy = 0;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    double slopes = 0;
    for (const auto& slope : scene::hat_gradients<dim>(scene::positions(mesh, mesh.cells[c]))) slopes += slope.norm();
    const double strain = degree * degree * size * slopes;
    energy += scene::volume(mesh, static_cast<int>(c)) / 2 *
              problem.bodies[mesh.cell_body[c]].material.stiffness().norm() * strain * strain;
  }
  return energy;
}

template <int dim>
bool is_unstrained(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement) {
  if (has_loads(problem)) return false;
  constexpr double rounding = 1e-14;                       // of displacements, relative: some tens of the last place
  return potential_energy(problem, displacement).total <=  // without loads: strains, and what contact laws store
         energy_of_noise(problem, 1, rounding * largest_given(problem));
}

template <int dim> scene::Stress<dim> no_stress(const scene::Mesh<dim>& mesh, int degree) {
  const std::size_t coefficients = (dim + 1) * scene::n_bernstein<dim>(degree);
  return {degree, {mesh.cells.size(), {coefficients, scene::Voigt<dim>::Zero()}}};
}

template <int dim>
scene::Displacement<dim> translated(const scene::Mesh<dim>& mesh, int degree, const scene::Vector<dim>& translation) {
  scene::Displacement<dim> displacement{degree, {}, {}, {}};
  displacement.vertex.assign(mesh.vertices.size(), translation);
  displacement.edge.assign(scene::n_inside_edge(degree) * mesh.edges.size(), translation);
  displacement.cell.assign(scene::n_inside_cell(degree) * mesh.cells.size(), translation);
  return displacement;
}

#define INSTANTIATE(dim)                                                                    \
  template double energy_of_noise(const scene::Problem<dim>&, int, double);                 \
  template bool is_unstrained(const scene::Problem<dim>&, const scene::Displacement<dim>&); \
  template scene::Stress<dim> no_stress(const scene::Mesh<dim>&, int);                      \
  template scene::Displacement<dim> translated(const scene::Mesh<dim>&, int, const scene::Vector<dim>&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::bounds
