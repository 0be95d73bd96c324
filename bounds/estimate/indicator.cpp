// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "bounds/estimate/on_mesh.h"

namespace bracket::bounds {

using scene::Vector;
using scene::Voigt;

namespace {

/// g − r(u_h) at the vertices and the midpoint.
template <int dim>
std::array<double, 3> gap_left(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                               const scene::ContactFacet& pair) {
  const Vector<dim> d = problem.facets[pair.first].normal;
  auto relative = on_facet(problem.mesh, displacement, pair.first);
  if (pair.second >= 0) {
    const auto other = on_facet(problem.mesh, displacement, pair.second);
    relative[0] -= other[1];  // the second side runs the other way
    relative[1] -= other[0];
    relative[2] -= other[2];
  }
  std::array<double, 3> left = {pair.upper[0], pair.upper[2], scene::at_middle(pair.upper)};
  for (int i = 0; i < 3; ++i) left[i] -= relative[i].dot(d);
  return left;
}

/// By how much λ_h n is rounded on each body: see contact_pressure().
template <int dim>
std::vector<double> rounding_of_tractions(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress) {
  const auto& mesh = problem.mesh;
  std::vector<double> largest(mesh.bodies.size(), 0), misfit = largest;
  for (std::size_t c = 0; c < stress.cell.size(); ++c)
    for (const auto& s : stress.cell[c]) largest[mesh.cell_body[c]] = std::max(largest[mesh.cell_body[c]], s.norm());
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support == scene::Support::fixed) continue;
    const int facet = static_cast<int>(f);
    double& most = misfit[mesh.cell_body[mesh.boundary[f].cell]];
    const auto t = tractions(mesh, stress, facet);
    const auto load = scene::load(problem, facet);
    for (int i = 0; i < dim; ++i) {
      const bool given = data.support == scene::Support::traction;
      const Vector<dim> known =
          given ? Vector<dim>(load[i] / scene::length(mesh, facet)) : Vector<dim>(t[i].dot(data.normal) * data.normal);
      most = std::max(most, (t[i] - known).norm());
    }
  }
  for (std::size_t b = 0; b < misfit.size(); ++b)
    misfit[b] = std::clamp(misfit[b], 1e-11 * largest[b], Checks::tolerance * largest[b]);
  return misfit;
}

}  // namespace

template <int dim>
std::vector<std::array<double, 2>> contact_pressure(const scene::Problem<dim>& problem,
                                                    const scene::Stress<dim>& stress) {
  const auto& mesh = problem.mesh;
  const std::vector<double> rounding = rounding_of_tractions(problem, stress);
  const auto of_body = [&](int facet) { return rounding[mesh.cell_body[mesh.boundary[facet].cell]]; };
  std::vector<std::array<double, 2>> pressure;
  pressure.reserve(problem.contact.size());
  for (const auto& pair : problem.contact) {
    const double none = std::max(of_body(pair.first), pair.second < 0 ? 0 : of_body(pair.second));
    pressure.push_back(plain_pressure(problem, stress, pair));
    for (double& p : pressure.back())
      if (std::abs(p) <= none) p = 0;
  }
  return pressure;
}

template <int dim>
std::vector<ContactState> contact_state(const scene::Problem<dim>& problem,
                                        const scene::Displacement<dim>& displacement,
                                        const scene::Stress<dim>& stress) {
  const auto pressure = contact_pressure(problem, stress);
  std::vector<ContactState> states;
  states.reserve(pressure.size());
  for (std::size_t j = 0; j < pressure.size(); ++j)
    states.push_back({pressure[j], gap_left(problem, displacement, problem.contact[j])});
  return states;
}

template <int dim>
Indicator indicator(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                    const scene::Stress<dim>& stress) {
  const auto& mesh = problem.mesh;
  Indicator result;
  long double sum = 0;
  result.cell.resize(mesh.cells.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int cell = static_cast<int>(c);
    const auto& compliance = problem.bodies[mesh.cell_body[c]].material.compliance();
    const auto form = [&](const Voigt<dim>& s) { return 0.5 * s.dot(compliance * s); };
    const auto sigma = displacement_stress(problem, displacement, cell);
    Voigt<dim> middle = sigma[0];
    for (int k = 1; k <= dim; ++k) middle += sigma[k];
    middle /= dim + 1;
    const double part = scene::volume(mesh, cell) / (dim + 1);
    for (int k = 0; k <= dim; ++k) {
      const auto lambda = scene::stress_of_part(stress, cell, k);
      std::array<Voigt<dim>, dim + 1> difference;
      for (int i = 0; i < dim; ++i) difference[i] = sigma[scene::Simplex<dim>::facets[k][i]] - lambda[i];
      difference[dim] = middle - lambda[dim];
      result.cell[c] += integrate(form, difference, part);
    }
    sum += result.cell[c];
  }
  for (const auto& pair : problem.contact) {
    const auto p = plain_pressure(problem, stress, pair);
    const auto gap = gap_left(problem, displacement, pair);
    result.contact.push_back(
        simpson(p[0] * gap[0], (p[0] + p[1]) / 2 * gap[2], p[1] * gap[1], scene::length(mesh, pair.first)));
    sum += result.contact.back();
  }
  result.sum = static_cast<double>(sum);
  return result;
}

template std::vector<std::array<double, 2>> contact_pressure(const scene::Problem<2>&, const scene::Stress<2>&);
template std::vector<ContactState> contact_state(const scene::Problem<2>&, const scene::Displacement<2>&,
                                                 const scene::Stress<2>&);
template Indicator indicator(const scene::Problem<2>&, const scene::Displacement<2>&, const scene::Stress<2>&);

}  // namespace bracket::bounds
