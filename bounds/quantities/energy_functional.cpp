// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "bounds/quantities/parts.h"

namespace bracket::bounds {

using scene::Perturbation;
using scene::Problem;
using scene::Quantity;
using scene::Support;

Functionals<2> half_of_data(const Problem<2>& first, const Quantity<2>& quantity) {
  if (!first.corrections.empty() && first.imbalance > 0)
    refuse(quantity, "the loads were changed to be in balance, and the energy of the change is not known");
  Perturbation<2> half = scene::no_perturbation(first);
  for (std::size_t b = 0; b < first.bodies.size(); ++b) half.force[b] = first.bodies[b].force / 2;
  for (std::size_t f = 0; f < first.facets.size(); ++f) {
    const auto& data = first.facets[f];
    for (int i = 0; i < 2; ++i) {
      half.facets[f].traction[i] = plain(data.traction[i] / 2);
      half.facets[f].pressure[i] = data.pressure[i] / 2;
      half.facets[f].higher_traction[i] = data.higher_traction[i] / 2;
      half.facets[f].higher_pressure[i] = data.higher_pressure[i] / 2;
      if (data.support == Support::fixed) half.facets[f].displacement[i] = plain(data.displacement[i] / 2);
      if (data.support == Support::sliding) half.facets[f].normal_displacement[i] = data.normal_displacement[i] / 2;
    }
  }
  const auto with = [&](bool upper) {
    Perturbation<2> result = half;
    for (std::size_t j = 0; j < first.contact.size(); ++j)
      for (int i = 0; i < 3; ++i)
        result.contact[j].gap[i] = (upper ? first.contact[j].upper[i] : first.contact[j].lower[i]) / 2;
    return std::make_shared<const Perturbation<2>>(std::move(result));
  };
  const bool one = std::ranges::all_of(first.contact, [](const auto& pair) { return pair.lower == pair.upper; });
  Functionals<2> result;
  result.above = with(false);
  result.below = one ? result.above : with(true);
  result.non_negative = true;
  return result;
}

FreeEnergy free_energy(const scene::Problem<2>& problem) {
  const Problem<2>& first = scene::first_of(problem);
  bool loads = false, supports = false;
  for (const auto& body : first.bodies) loads = loads || !body.force.isZero(0);
  for (const auto& data : first.facets) {
    loads = loads || scene::is_loaded(data);
    for (int i = 0; i < 2; ++i)
      supports = supports || (data.support == Support::fixed && !data.displacement[i].isZero(0)) ||
                 (data.support == Support::sliding && data.normal_displacement[i] != 0);
  }
  for (const auto& gap : first.gaps) supports = supports || static_cast<bool>(gap.function);
  for (const auto& pair : first.contact)
    for (int i = 0; i < 3; ++i) supports = supports || pair.lower[i] != 0 || pair.upper[i] != 0;
  return !supports ? FreeEnergy::of_loads : !loads ? FreeEnergy::of_supports : FreeEnergy::none;
}

}  // namespace bracket::bounds
