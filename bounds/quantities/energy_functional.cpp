// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/quantities/parts.h"
#include "bounds/quantities/weights.h"

namespace bracket::bounds {

using scene::Perturbation;
using scene::Problem;
using scene::Quantity;
using scene::Support;

namespace {

/// The first mesh's gaps, the lower or the upper ones, side by side one function.
template <int dim> FacetWeights<dim> gaps_of(const Problem<dim>& first, bool upper) {
  FacetWeights<dim> gaps;
  for (const auto& pair : first.contact) gaps.push_back(upper ? pair.upper : pair.lower);
  return continuous(first, std::move(gaps), upper);
}

}  // namespace

template <int dim> Functionals<dim> half_of_data(const Problem<dim>& first, const Quantity<dim>& quantity) {
  if (!first.corrections.empty() && first.imbalance > 0)
    refuse(quantity, "the loads were changed to be in balance, and the energy of the change is not known");
  Perturbation<dim> half = scene::no_perturbation(first);
  for (std::size_t b = 0; b < first.bodies.size(); ++b) half.force[b] = first.bodies[b].force / 2;
  for (std::size_t f = 0; f < first.facets.size(); ++f) {
    const auto& data = first.facets[f];
    for (int k = 0; k < 2; ++k) {
      half.facets[f].higher_traction[k] = data.higher_traction[k] / 2;
      half.facets[f].higher_pressure[k] = data.higher_pressure[k] / 2;
    }
    for (int i = 0; i < dim; ++i) {
      half.facets[f].traction[i] = plain<dim>(data.traction[i] / 2);
      half.facets[f].pressure[i] = data.pressure[i] / 2;
      if (data.support == Support::fixed) half.facets[f].displacement[i] = plain<dim>(data.displacement[i] / 2);
      if (data.support == Support::sliding) half.facets[f].normal_displacement[i] = data.normal_displacement[i] / 2;
    }
  }
  const auto with = [&](const FacetWeights<dim>& gaps) {
    Perturbation<dim> result = half;
    for (std::size_t j = 0; j < gaps.size(); ++j)
      for (std::size_t i = 0; i < gaps[j].size(); ++i) result.contact[j].gap[i] = gaps[j][i] / 2;
    return std::make_shared<const Perturbation<dim>>(std::move(result));
  };
  const FacetWeights<dim> below = gaps_of(first, false), above = gaps_of(first, true);
  for (std::size_t j = 0; j < below.size(); ++j)
    if (first.contact[j].law.two_sided && below[j] != above[j])
      refuse(quantity,
             "the gap of sides that keep together is rounded, and their pressure of either sign: no bounds of the "
             "energy follow");
  Functionals<dim> result;
  result.above = with(below);
  result.below = below == above ? result.above : with(above);
  result.non_negative = true;
  return result;
}

template <int dim> FreeEnergy free_energy(const Problem<dim>& problem) {
  const Problem<dim>& first = scene::first_of(problem);
  bool loads = false, supports = false;
  for (const auto& body : first.bodies) loads = loads || !body.force.isZero(0);
  for (const auto& data : first.facets) {
    loads = loads || scene::is_loaded(data);
    for (int i = 0; i < dim; ++i)
      supports = supports || (data.support == Support::fixed && !data.displacement[i].isZero(0)) ||
                 (data.support == Support::sliding && data.normal_displacement[i] != 0);
  }
  for (const auto& gap : first.gaps) supports = supports || static_cast<bool>(gap.function);
  for (const auto& pair : first.contact)
    for (std::size_t i = 0; i < pair.lower.size(); ++i) supports = supports || pair.lower[i] != 0 || pair.upper[i] != 0;
  return !supports ? FreeEnergy::of_loads : !loads ? FreeEnergy::of_supports : FreeEnergy::none;
}

template Functionals<2> half_of_data(const Problem<2>&, const Quantity<2>&);
template Functionals<3> half_of_data(const Problem<3>&, const Quantity<3>&);
template FreeEnergy free_energy(const Problem<2>&);
template FreeEnergy free_energy(const Problem<3>&);

}  // namespace bracket::bounds
