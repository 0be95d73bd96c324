// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/estimate/on_mesh.h"

namespace bracket::bounds {

using scene::Support;
using scene::Vector;
using scene::Voigt;

namespace {

/// Sums over many cells are kept in extended precision: energies cancel to the width of the bracket.
using Sum = long double;

/// ∫ F·v over a cell.
template <int dim>
double body_force_work(const scene::Mesh<dim>& mesh, const scene::Displacement<dim>& displacement,
                       const Vector<dim>& force, int cell) {
  using Table = scene::Simplex<dim>;
  const bool quadratic = displacement.degree == 2;
  Vector<dim> sum = Vector<dim>::Zero();
  for (int k = 0; k <= dim; ++k)
    sum += (quadratic ? Table::quadratic_mean(k) : 1) * displacement.vertex[mesh.cells[cell][k]];
  for (int e = 0; e < Table::n_edges && quadratic; ++e)
    sum += Table::quadratic_mean(Table::n_vertices + e) * displacement.edge[mesh.cell_edges[cell][e]];
  return scene::volume(mesh, cell) / (quadratic ? Table::quadratic_means_of : Table::n_vertices) * force.dot(sum);
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
    strain += integrate(form, strain_at_vertices(mesh, displacement, cell), scene::volume(mesh, cell));
    if (!body.force.isZero(0)) work += body_force_work(mesh, displacement, body.force, cell);
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (!scene::is_loaded(data)) continue;
    const auto u = on_facet(mesh, displacement, static_cast<int>(f));
    const auto load = scene::load(problem, static_cast<int>(f));
    work += simpson(load[0].dot(u[0]), (load[0] + load[1]).dot(u[2]) / 2, load[1].dot(u[1]), 1);
  }
  return {static_cast<double>(strain), static_cast<double>(strain - work)};
}

template <int dim> double complementary_energy(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress) {
  const auto& mesh = problem.mesh;
  Sum energy = 0;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto& compliance = problem.bodies[mesh.cell_body[c]].material.compliance();
    const auto form = [&](const Voigt<dim>& s) { return 0.5 * s.dot(compliance * s); };
    const int cell = static_cast<int>(c);
    const double part = scene::volume(mesh, cell) / (dim + 1);
    for (int k = 0; k <= dim; ++k) energy += integrate(form, scene::stress_of_part(stress, cell, k), part);
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support != Support::fixed && data.support != Support::sliding) continue;
    const int facet = static_cast<int>(f);
    const auto t = tractions(mesh, stress, facet);
    const double length = scene::length(mesh, facet);
    std::array<double, dim> force, given;
    if (data.support == Support::fixed) {
      for (int c = 0; c < dim; ++c) {
        for (int i = 0; i < dim; ++i) force[i] = t[i][c], given[i] = data.displacement[i][c];
        energy -= scene::integral_of_product(force, given, length);
      }
    } else {
      for (int i = 0; i < dim; ++i) force[i] = t[i].dot(data.normal);
      energy -= scene::integral_of_product(force, data.normal_displacement, length);
    }
  }
  for (const auto& pair : problem.contact) {
    const auto [p0, p1] = plain_pressure(problem, stress, pair);
    energy += simpson(p0 * pair.upper[0], (p0 + p1) / 2 * scene::at_middle(pair.upper), p1 * pair.upper[2],
                      scene::length(mesh, pair.first));
  }
  return static_cast<double>(energy);
}

template PotentialEnergy potential_energy(const scene::Problem<2>&, const scene::Displacement<2>&);
template double complementary_energy(const scene::Problem<2>&, const scene::Stress<2>&);

}  // namespace bracket::bounds
