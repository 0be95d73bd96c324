// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/estimate/on_mesh.h"

namespace bracket::bounds {

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

Bracket bracket(double lower, double upper, double strain_energy, double contact) {
  const auto up = [](double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); };
  const double width = upper == lower ? 0 : up(upper - lower);
  Bracket result{lower, upper};
  if (width == 0) return result;
  result.relative_width = width / std::max(std::abs(lower), std::abs(upper));
  result.error_bound = up(std::sqrt(2 * width));
  // κ is a part of the width
  result.mean_stress_error_bound = up(std::sqrt(std::max(0.0, up(width + std::min(contact, width)) / 2)));
  result.relative_error_bound = up(result.error_bound / std::nextafter(std::sqrt(2 * strain_energy), 0.0));
  return result;
}

template PlainEnergies plain_energies(const scene::Problem<2>&, const scene::Displacement<2>&, const scene::Stress<2>&,
                                      const Indicator&);
template PlainEnergies plain_energies(const scene::Problem<3>&, const scene::Displacement<3>&, const scene::Stress<3>&,
                                      const Indicator&);

}  // namespace bracket::bounds
