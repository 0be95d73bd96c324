// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "bounds/estimate/on_mesh.h"
#include "scene/problem/law.h"

namespace bracket::bounds {

using scene::Vector;
using scene::Voigt;

template <int dim>
std::vector<double> gap_left(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                             const scene::ContactFacetOf<dim>& pair) {
  const auto approach = jump(problem, displacement, pair, problem.facets[pair.first].normal);
  std::vector<double> left(pair.upper.begin(), pair.upper.end());
  if constexpr (dim == 2) left = scene::raised_to<double>(displacement.degree, std::move(left));
  for (std::size_t k = 0; k < left.size(); ++k) left[k] -= approach[k];
  return left;
}

namespace {

/// By how much λ_h n is rounded on each body: see contact_pressure().
template <int dim>
std::vector<double> rounding_of_tractions(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress) {
  const auto& mesh = problem.mesh;
  std::vector<double> largest(mesh.bodies.size(), 0), misfit = largest;
  for (std::size_t c = 0; c < stress.cell.size(); ++c)
    for (const auto& s : stress.cell[c]) largest[mesh.cell_body[c]] = std::max(largest[mesh.cell_body[c]], s.norm());
  const std::vector<char> rubs = with_friction(problem);
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support == scene::Support::fixed || rubs[f]) continue;
    const int facet = static_cast<int>(f);
    double& most = misfit[mesh.cell_body[mesh.boundary[f].cell]];
    const auto t = tractions(mesh, stress, facet);
    const auto load = loads(problem, facet, stress.degree);
    for (std::size_t i = 0; i < t.size(); ++i) {
      Vector<dim> unknown = t[i] - load[i] / scene::length(mesh, facet);
      if (data.support != scene::Support::traction) unknown -= (unknown.dot(data.normal) * data.normal).eval();
      most = std::max(most, unknown.norm());
    }
  }
  for (std::size_t b = 0; b < misfit.size(); ++b)
    misfit[b] = std::clamp(misfit[b], 1e-11 * largest[b], Checks::tolerance * largest[b]);
  return misfit;
}

}  // namespace

template <int dim>
std::vector<std::vector<double>> contact_pressure(const scene::Problem<dim>& problem,
                                                  const scene::Stress<dim>& stress) {
  const auto& mesh = problem.mesh;
  const std::vector<double> rounding = rounding_of_tractions(problem, stress);
  const auto of_body = [&](int facet) { return rounding[mesh.cell_body[mesh.boundary[facet].cell]]; };
  std::vector<std::vector<double>> pressure;
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

namespace {

/// The same stress, one degree after the other up to another; in space all have degree 1. \param own its degree
template <int dim> std::vector<Voigt<dim>> raised(std::vector<Voigt<dim>> stress, int own, int degree) {
  if constexpr (dim == 2)
    for (; own < degree; ++own) stress = scene::raised_on_triangle<double>(stress, own);
  return stress;
}

/// A stress on a cell, seen on its part k.
std::vector<Voigt<2>> on_part(const std::vector<Voigt<2>>& stress, int degree, int k) {
  return scene::on_centroid_part<double>(stress, degree, k);
}
std::vector<Voigt<3>> on_part(const std::vector<Voigt<3>>& stress, int, int k) {
  std::vector<Voigt<3>> result;
  for (const int corner : scene::Simplex<3>::facets[k]) result.push_back(stress[corner]);
  result.push_back((stress[0] + stress[1] + stress[2] + stress[3]) / 4);
  return result;
}

}  // namespace

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
    const int degree = std::max(stress.degree, scene::stress_degree(displacement.degree));
    const auto sigma = raised<dim>(displacement_stress(problem, displacement, cell),
                                   scene::stress_degree(displacement.degree), degree);
    const double part = scene::volume(mesh, cell) / (dim + 1);
    for (int k = 0; k <= dim; ++k) {
      std::vector<Voigt<dim>> difference = on_part(sigma, degree, k);
      const auto own = scene::stress_of_part(stress, cell, k);
      const auto lambda = raised<dim>({own.begin(), own.end()}, stress.degree, degree);
      for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= lambda[i];
      result.cell[c] += part * mean<dim>(form, difference);
    }
    sum += result.cell[c];
  }
  for (const auto& pair : problem.contact) {
    const double length = scene::length(mesh, pair.first);
    result.contact.push_back(
        length * mean_of_product<dim>(plain_pressure(problem, stress, pair), gap_left(problem, displacement, pair)));
    if constexpr (dim == 2) {
      result.contact.back() = result.contact.back() + law_energy(problem, displacement, pair) +
                              law_complementary_energy(problem, stress, pair);
      if (has_friction(pair.law))
        result.contact.back() -=
            length * scene::bernstein_product(
                         plain_shear(problem, stress, pair),
                         jump<dim>(problem, displacement, pair, scene::tangent(problem.facets[pair.first].normal)));
    }
    sum += result.contact.back();
  }
  result.sum = static_cast<double>(sum);
  return result;
}

template std::vector<double> gap_left(const scene::Problem<2>&, const scene::Displacement<2>&,
                                      const scene::ContactFacet&);
template std::vector<double> gap_left(const scene::Problem<3>&, const scene::Displacement<3>&,
                                      const scene::ContactFacetOf<3>&);
template std::vector<std::vector<double>> contact_pressure(const scene::Problem<2>&, const scene::Stress<2>&);
template std::vector<std::vector<double>> contact_pressure(const scene::Problem<3>&, const scene::Stress<3>&);
template std::vector<ContactState> contact_state(const scene::Problem<2>&, const scene::Displacement<2>&,
                                                 const scene::Stress<2>&);
template std::vector<ContactState> contact_state(const scene::Problem<3>&, const scene::Displacement<3>&,
                                                 const scene::Stress<3>&);
template Indicator indicator(const scene::Problem<2>&, const scene::Displacement<2>&, const scene::Stress<2>&);
template Indicator indicator(const scene::Problem<3>&, const scene::Displacement<3>&, const scene::Stress<3>&);

}  // namespace bracket::bounds
