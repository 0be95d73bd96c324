// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/estimate/on_mesh.h"

namespace bracket::bounds {

using scene::Vector;
using scene::Voigt;

template <int dim>
std::vector<ContactState> contact_state(const scene::Problem<dim>& problem,
                                        const scene::Displacement<dim>& displacement,
                                        const scene::Stress<dim>& stress) {
  const auto& mesh = problem.mesh;
  std::vector<ContactState> states;
  states.reserve(problem.contact.size());
  for (const auto& pair : problem.contact) {
    const Vector<dim> d = problem.facets[pair.first].normal;
    const auto t = tractions(mesh, stress, pair.first);
    auto relative = on_facet(mesh, displacement, pair.first);
    if (pair.second >= 0) {
      const auto other = on_facet(mesh, displacement, pair.second);
      relative[0] -= other[1];  // the second side runs the other way
      relative[1] -= other[0];
      relative[2] -= other[2];
    }
    ContactState state;
    for (int i = 0; i < 2; ++i) state.pressure[i] = -t[i].dot(d);
    const std::array<double, 3> gap = {pair.upper[0], pair.upper[2], scene::at_middle(pair.upper)};
    for (int i = 0; i < 3; ++i) state.gap_left[i] = gap[i] - relative[i].dot(d);
    states.push_back(state);
  }
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
    const Voigt<dim> middle = (sigma[0] + sigma[1] + sigma[2]) / 3;
    const auto& lambda = stress.cell[c];
    const double part = scene::volume(mesh, cell) / 3;
    for (int k = 0; k < 3; ++k) {
      const std::array<Voigt<dim>, 3> difference = {sigma[(k + 1) % 3] - lambda[3 * k],
                                                    sigma[(k + 2) % 3] - lambda[3 * k + 1], middle - lambda[3 * k + 2]};
      result.cell[c] += integrate(form, difference, part);
    }
    sum += result.cell[c];
  }
  const auto states = contact_state(problem, displacement, stress);
  for (std::size_t j = 0; j < states.size(); ++j) {
    const auto& [p, gap] = states[j];
    result.contact.push_back(simpson(p[0] * gap[0], (p[0] + p[1]) / 2 * gap[2], p[1] * gap[1],
                                     scene::length(mesh, problem.contact[j].first)));
    sum += result.contact.back();
  }
  result.sum = static_cast<double>(sum);
  return result;
}

template std::vector<ContactState> contact_state(const scene::Problem<2>&, const scene::Displacement<2>&,
                                                 const scene::Stress<2>&);
template Indicator indicator(const scene::Problem<2>&, const scene::Displacement<2>&, const scene::Stress<2>&);

}  // namespace bracket::bounds
