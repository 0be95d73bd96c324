// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/certificate.h"

#include <algorithm>
#include <cmath>

#include "bounds/certificate/perturbation_alone.h"
#include "bounds/certificate/space/functional.h"
#include "bounds/certificate/space/sides.h"

namespace bracket::bounds {

namespace space {
namespace {

/// The corrections of both kinds: base + factor · added, of the same facets.
std::vector<Corrected<Enclosure>> with_added(std::vector<Corrected<Enclosure>> base, double factor,
                                             const std::vector<Corrected<Enclosure>>& added) {
  for (auto correction : added) {
    for (auto& at : correction.load) at = Enclosure(factor) * at;
    base.push_back(correction);
  }
  return base;
}

/// What the loads of the perturbation lack of balance along motions that nothing holds, where there are any.
Corrections<Enclosure> functional_corrections(const scene::Problem<3>& problem, const scene::Stress<3>& stress) {
  const scene::Problem<3>& first = scene::first_of(problem);
  if (first.corrections.empty()) return {};
  const PlainLoads loads = plain_loads(problem, faces_of(problem.mesh), stress);
  const scene::Problem<3> alone = perturbation_alone(first, problem.perturbed.by, carrying_pairs(problem, loads));
  Corrections<Enclosure> added = corrected<Enclosure, LongSum>(alone);
  if (added.reason.empty() && !are_rounding(alone, added.loads))
    added.reason = "the functional does work in a motion that nothing holds";
  return added;
}

}  // namespace
}  // namespace space

template <>
Certificate certify(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
                    const scene::Stress<3>& stress, Digits) {
  using scene::Enclosure, scene::LongSum;
  if (std::string fault = space::fault_of(problem, displacement, stress); !fault.empty()) return {.reason = fault};
  const auto [corrections, unbalanced] = space::corrected<Enclosure, LongSum>(scene::first_of(problem));
  if (!unbalanced.empty()) return {.reason = unbalanced};
  const space::Sides sides = space::both_sides(problem, corrections, displacement, stress);
  if (!sides.reason.empty()) return {.reason = sides.reason};

  Certificate certificate;
  certificate.lower = lower(-sides.below) + 0.0;  // not −0
  certificate.upper = upper(sides.above.total) + 0.0;
  certificate.strain_energy = std::max(0.0, lower(sides.above.strain));
  certificate.contact = std::max(0.0, upper(space::contact_work<Enclosure, LongSum>(
                                          problem, sides.supports, sides.field, sides.loads.along_normal)));
  certificate.valid = std::isfinite(certificate.lower) && std::isfinite(certificate.upper);
  if (!certificate.valid)
    certificate.reason = "the energies could not be enclosed: numbers too large or too small, or cells too thin";
  return certificate;
}

template <>
FunctionalBound certify_functional(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
                                   const scene::Stress<3>& stress) {
  using scene::Enclosure, scene::LongSum;
  if (std::string fault = space::fault_of(problem, displacement, stress); !fault.empty()) return {.reason = fault};
  const auto& [by, factor, kinematics] = problem.perturbed;
  if (!by || factor != kinematics || factor == 0) return {.reason = "the problem is not perturbed by one factor"};
  const auto [own, unbalanced] = space::corrected<Enclosure, LongSum>(scene::first_of(problem));
  if (!unbalanced.empty()) return {.reason = unbalanced};
  const auto [added, also_unbalanced] = space::functional_corrections(problem, stress);
  if (!also_unbalanced.empty()) return {.reason = also_unbalanced};
  const space::Sides sides = space::both_sides(problem, space::with_added(own, factor, added), displacement, stress);
  if (!sides.reason.empty()) return {.reason = sides.reason};

  const auto& [reason, above, supports, field, below, loads] = sides;
  const Enclosure work = space::perturbing_work<Enclosure, LongSum>(problem, supports, field, added);
  const Enclosure reactions = space::perturbing_reactions<Enclosure, LongSum>(problem, supports, loads);
  const Enclosure contact = space::contact_work<Enclosure, LongSum>(problem, supports, field, loads.along_normal);
  const Enclosure width = above.total + below;
  FunctionalBound bound;
  bound.above = upper(Enclosure(factor) * (work + reactions) + (width + contact) / Enclosure(2));
  bound.valid = std::isfinite(bound.above);
  if (!bound.valid) bound.reason = "the functional could not be enclosed: numbers too large or too small";
  return bound;
}

}  // namespace bracket::bounds
