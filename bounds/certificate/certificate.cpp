// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/certificate.h"

#include <algorithm>
#include <cmath>

#include "bounds/certificate/functional.h"
#include "bounds/certificate/perturbation_alone.h"
#include "bounds/certificate/sides.h"

namespace bracket::bounds {

namespace {

/// The corrections of both kinds: base + factor · added, of the same facets.
std::vector<Corrected<Enclosure>> sum(std::vector<Corrected<Enclosure>> base, double factor,
                                      const std::vector<Corrected<Enclosure>>& added) {
  for (auto correction : added) {
    for (auto& end : correction.load) end = Enclosure(factor) * end;
    base.push_back(correction);
  }
  return base;
}

/// What the loads of the perturbation lack of balance along motions that nothing holds, where there are any.
Corrections<Enclosure> functional_corrections(const scene::Problem<2>& problem, const scene::Stress<2>& stress) {
  const scene::Problem<2>& first = scene::first_of(problem);
  if (first.corrections.empty()) return {};
  const scene::Problem<2> alone =
      perturbation_alone(first, problem.perturbed.by, carrying_pairs(problem, plain_loads(problem, stress)));
  Corrections<Enclosure> added = corrected<Enclosure, LongSum>(alone);
  if (added.reason.empty() && !are_rounding(alone, added.loads))
    added.reason = "the functional does work in a motion that nothing holds";
  return added;
}

}  // namespace

template <int dim>
Certificate certify(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                    const scene::Stress<dim>& stress, Digits digits) {
  if (std::string fault = fault_of(problem, displacement, stress); !fault.empty()) return {.reason = fault};
  const auto [corrections, unbalanced] = corrected<Enclosure, LongSum>(scene::first_of(problem));
  if (!unbalanced.empty()) return {.reason = unbalanced};
  const Sides sides = both_sides(problem, corrections, displacement, stress, digits);
  if (!sides.reason.empty()) return {.reason = sides.reason};

  Certificate certificate;
  certificate.lower = lower(-sides.below.energy) + 0.0;  // not −0
  certificate.upper = upper(sides.above.energy.total) + 0.0;
  certificate.strain_energy = std::max(0.0, lower(sides.above.energy.strain));
  certificate.contact = std::max(0.0, upper(contact_work<Enclosure, LongSum>(problem, sides.above.supports,
                                                                             sides.above.field, sides.below.loads)));
  certificate.valid = std::isfinite(certificate.lower) && std::isfinite(certificate.upper);
  if (!certificate.valid)
    certificate.reason = "the energies could not be enclosed: numbers too large or too small, or cells too thin";
  return certificate;
}

template <int dim>
FunctionalBound certify_functional(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                                   const scene::Stress<dim>& stress) {
  if (std::string fault = fault_of(problem, displacement, stress); !fault.empty()) return {.reason = fault};
  const auto& [by, factor, kinematics] = problem.perturbed;
  if (!by || factor != kinematics || factor == 0) return {.reason = "the problem is not perturbed by one factor"};
  const auto [own, unbalanced] = corrected<Enclosure, LongSum>(scene::first_of(problem));
  if (!unbalanced.empty()) return {.reason = unbalanced};
  const auto [added, also_unbalanced] = functional_corrections(problem, stress);
  if (!also_unbalanced.empty()) return {.reason = also_unbalanced};
  const auto [reason, above, below] =
      both_sides(problem, sum(own, factor, added), displacement, stress, Digits::extended);
  if (!reason.empty()) return {.reason = reason};

  const Enclosure work = perturbing_work<Enclosure, LongSum>(problem, above.supports, above.field, added);
  const Enclosure reactions = perturbing_reactions<Enclosure, LongSum>(problem, below.loads);
  const Enclosure contact =
      contact_work<Enclosure, LongSum>(problem, above.supports, above.field, below.loads, Springs::as_bodies);
  const Enclosure width = above.energy.total + below.energy;
  FunctionalBound bound;
  bound.above = upper(Enclosure(factor) * (work + reactions) + (width + contact) / Enclosure(2));
  bound.valid = std::isfinite(bound.above);
  if (!bound.valid) bound.reason = "the functional could not be enclosed: numbers too large or too small";
  return bound;
}

template FunctionalBound certify_functional(const scene::Problem<2>&, const scene::Displacement<2>&,
                                            const scene::Stress<2>&);
template Certificate certify(const scene::Problem<2>&, const scene::Displacement<2>&, const scene::Stress<2>&, Digits);

}  // namespace bracket::bounds
