// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "bounds/estimate/on_mesh.h"
#include "scene/problem/stretch.h"
#include "scene/quadrature.h"

namespace bracket::bounds {

using scene::between_ends;
using scene::Support;
using scene::Vector;

template <int dim>
PlainEnergies plain_energies(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                             const scene::Stress<dim>& stress, const Indicator& indicator) {
  const PotentialEnergy potential = potential_energy(problem, displacement);
  PlainEnergies plain{0 - complementary_energy(problem, stress), potential.total, potential.strain, 0};
  const double misfit = std::abs(indicator.sum - (plain.upper - plain.lower));
  if (misfit > 0)
    plain.gap_identity = misfit / std::max({std::abs(plain.lower), std::abs(plain.upper), potential.strain});
  return plain;
}

Bracket bracket(double lower, double upper, double strain_energy, const Indicator& indicator) {
  const double width = upper - lower;
  double contact = 0;
  for (const double share : indicator.contact) contact += share;
  Bracket result{lower, upper};
  if (width == 0) return result;
  result.relative_width = width / std::max(std::abs(lower), std::abs(upper));
  result.error_bound = std::sqrt(2 * width);
  result.mean_stress_error_bound = std::sqrt(std::max(0.0, (width + contact) / 2));
  result.relative_error_bound = result.error_bound / std::sqrt(2 * strain_energy);
  return result;
}

namespace {

/// ∫ f over a facet, f a function of the position s in (0,1) along it.
template <class Function> double over_facet(double length, const Function& f) {
  double sum = 0;
  for (const auto& [x, weight] : scene::gauss_points<5>()) sum += length * weight / 2 * f((1 + x) / 2);
  return sum;
}

double bernstein(const std::array<double, 3>& c, double s) {
  return (1 - s) * ((1 - s) * c[0] + 2 * s * c[1]) + s * s * c[2];
}

/// Values at 0, 1 and ½.
template <class Value> Value quadratic(const std::array<Value, 3>& v, double s) {
  return (1 - s) * (1 - 2 * s) * v[0] + s * (2 * s - 1) * v[1] + 4 * s * (1 - s) * v[2];
}

}  // namespace

template <int dim>
double oscillation_energy(const scene::Scene<dim>& scene, const scene::Problem<dim>& problem,
                          const scene::Displacement<dim>& displacement, const scene::Stress<dim>& stress) {
  using scene::ConditionKind;
  const auto& mesh = problem.mesh;
  double energy = 0;
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const int part = mesh.boundary[f].part;
    const auto condition = part < 0 ? scene.boundary.end() : scene.boundary.find(mesh.parts[part]);
    if (condition == scene.boundary.end()) continue;
    const int facet = static_cast<int>(f);
    const auto& data = problem.facets[f];
    const auto& given = condition->second;
    const auto& ends = mesh.boundary[f].vertices;
    const std::array<Vector<dim>, 2> x = {mesh.vertices[ends[0]], mesh.vertices[ends[1]]};
    const Vector<dim>& n = data.normal;
    const auto vector_at = [&](double s) -> Vector<dim> {
      const Vector<dim> at = between_ends(x, s);
      if (given.value.size() == 1)
        return given.value[0](at) *
               (given.kind == ConditionKind::pressure ? Vector<dim>(-scene::normal(mesh, facet)) : n);
      return Vector<dim>(given.value[0](at), given.value[1](at));
    };
    const double length = scene::length(mesh, facet);
    if (data.support == Support::traction) {
      // What was taken off is orthogonal to linear functions; of linear displacements only the mean is taken off, as
      // what they lack of the exact ones is not known.
      const auto u = on_facet(mesh, displacement, facet);
      const auto load = scene::load(problem, facet);
      const std::array<Vector<dim>, 2> traction = {load[0] / length, load[1] / length};
      const std::array<Vector<dim>, 2> ends_of_u = {u[0], u[1]};
      const Vector<dim> mean = (u[0] + u[1]) / 2;
      energy += over_facet(length, [&](double s) {
        const Vector<dim> rest = displacement.degree == 2 ? Vector<dim>(quadratic(u, s) - between_ends(ends_of_u, s))
                                                          : Vector<dim>(between_ends(ends_of_u, s) - mean);
        return (vector_at(s) - between_ends(traction, s)).norm() * rest.norm();
      });
    } else {
      const auto t = tractions(mesh, stress, facet);
      energy += over_facet(length, [&](double s) {
        const Vector<dim> fixed = data.support == Support::fixed
                                      ? between_ends(data.displacement, s)
                                      : Vector<dim>(between_ends(data.normal_displacement, s) * n);
        return std::abs((vector_at(s) - fixed).dot(between_ends(t, s)));
      });
    }
  }
  const auto states = contact_state(problem, displacement, stress);
  for (std::size_t j = 0; j < states.size(); ++j) {
    const auto& pair = problem.contact[j];
    if (!scene.contact[pair.pair].gap) continue;  // as drawn: linear
    const auto& ends = mesh.boundary[pair.first].vertices;
    const std::array<Vector<dim>, 2> x = {mesh.vertices[ends[0]], mesh.vertices[ends[1]]};
    energy += over_facet(scene::length(mesh, pair.first), [&](double s) {
      const double moved = (*scene.contact[pair.pair].gap)(between_ends(x, s)) - bernstein(pair.lower, s);
      return std::abs(between_ends(states[j].pressure, s) * moved);
    });
  }
  return energy;
}

template PlainEnergies plain_energies(const scene::Problem<2>&, const scene::Displacement<2>&, const scene::Stress<2>&,
                                      const Indicator&);
template double oscillation_energy(const scene::Scene<2>&, const scene::Problem<2>&, const scene::Displacement<2>&,
                                   const scene::Stress<2>&);

}  // namespace bracket::bounds
