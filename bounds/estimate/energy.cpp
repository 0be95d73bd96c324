// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/estimate/on_mesh.h"

namespace bracket::bounds {

using scene::Support;
using scene::Vector;
using scene::Voigt;

namespace {

/// Sums over many cells are kept in extended precision: energies cancel to the width of the bracket.
using Sum = long double;

/// ∫ F·v over a cell: the mean of its Bernstein coefficients.
template <int dim>
double body_force_work(const scene::Mesh<dim>& mesh, const scene::Displacement<dim>& displacement,
                       const Vector<dim>& force, int cell) {
  Vector<dim> linear = Vector<dim>::Zero(), beside = linear;
  for (const int v : mesh.cells[cell]) linear += displacement.vertex[v] / (dim + 1);
  for (const Vector<dim>& offset : scene::offsets_on_cell(mesh, displacement, cell)) beside += offset;
  return scene::volume(mesh, cell) * force.dot(linear + beside / scene::n_bernstein<dim>(displacement.degree));
}

}  // namespace

template <int dim>
PotentialEnergy potential_energy(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement) {
  const auto& mesh = problem.mesh;
  Sum strain = 0, work = 0;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int cell = static_cast<int>(c);
    const auto& body = problem.bodies[mesh.cell_body[c]];
    const auto form = [&](const Voigt<dim>& e) { return 0.5 * e.dot(body.material.stiffness() * e); };
    strain += scene::volume(mesh, cell) * mean<dim>(form, bounds::strain(mesh, displacement, cell));
    if (!body.force.isZero(0)) work += body_force_work(mesh, displacement, body.force, cell);
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (!scene::is_loaded(data)) continue;
    const auto u = on_facet(mesh, displacement, static_cast<int>(f));
    const auto load = loads(problem, static_cast<int>(f), degree_of_load(data));
    for (int c = 0; c < dim; ++c) {
      const Vector<dim> axis = Vector<dim>::Unit(c);
      work += mean_of_product<dim>(along<dim>(load, axis), along<dim>(u, axis));
    }
  }
  Sum of_laws = 0;
  if constexpr (dim == 2)
    for (const auto& pair : problem.contact) of_laws += law_energy(problem, displacement, pair);
  return {static_cast<double>(strain), static_cast<double>(strain - work + of_laws)};
}

template <int dim> double complementary_energy(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress) {
  const auto& mesh = problem.mesh;
  Sum energy = 0;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto& compliance = problem.bodies[mesh.cell_body[c]].material.compliance();
    const auto form = [&](const Voigt<dim>& s) { return 0.5 * s.dot(compliance * s); };
    const int cell = static_cast<int>(c);
    const double part = scene::volume(mesh, cell) / (dim + 1);
    for (int k = 0; k <= dim; ++k) energy += part * mean<dim>(form, scene::stress_of_part(stress, cell, k));
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support != Support::fixed && data.support != Support::sliding) continue;
    const int facet = static_cast<int>(f);
    const auto t = tractions(mesh, stress, facet);
    const double length = scene::length(mesh, facet);
    for (int c = 0; c < dim && data.support == Support::fixed; ++c) {
      const Vector<dim> axis = Vector<dim>::Unit(c);
      energy -= length * mean_of_product<dim>(along<dim>(t, axis),
                                              along<dim>({data.displacement.begin(), data.displacement.end()}, axis));
    }
    if (data.support == Support::sliding) {
      const std::vector<double> given(data.normal_displacement.begin(), data.normal_displacement.end());
      energy -= length * mean_of_product<dim>(along<dim>(t, data.normal), given);
    }
  }
  for (const auto& pair : problem.contact) {
    const std::vector<double> gap(pair.upper.begin(), pair.upper.end());
    energy += scene::length(mesh, pair.first) * mean_of_product<dim>(plain_pressure(problem, stress, pair), gap);
    if constexpr (dim == 2) energy += law_complementary_energy(problem, stress, pair);
  }
  return static_cast<double>(energy);
}

template PotentialEnergy potential_energy(const scene::Problem<2>&, const scene::Displacement<2>&);
template PotentialEnergy potential_energy(const scene::Problem<3>&, const scene::Displacement<3>&);
template double complementary_energy(const scene::Problem<2>&, const scene::Stress<2>&);
template double complementary_energy(const scene::Problem<3>&, const scene::Stress<3>&);

}  // namespace bracket::bounds
