// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/certificate.h"

#include <algorithm>
#include <cmath>
#include <future>

#include "bounds/certificate/arithmetic.h"
#include "bounds/certificate/equilibrate.h"
#include "bounds/certificate/functional.h"
#include "bounds/certificate/problem_faults.h"

namespace bracket::bounds {

namespace {

/// A comparison with what is not a number is false, and might pass for a pressure of zero.
std::string field_fault(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                        const scene::Stress<2>& stress) {
  const auto finite = [](const auto& value) { return value.allFinite(); };
  if (displacement.degree != 1 && displacement.degree != 2) return "the displacements are neither linear nor quadratic";
  const auto& mesh = problem.mesh;
  if (displacement.vertex.size() != mesh.vertices.size() ||
      displacement.edge.size() != (displacement.degree == 2 ? mesh.edges.size() : 0) ||
      stress.cell.size() != mesh.cells.size())
    return "the fields are not those of this mesh";
  if (!std::ranges::all_of(displacement.vertex, finite) || !std::ranges::all_of(displacement.edge, finite))
    return "the displacements are not finite";
  for (const auto& cell : stress.cell)
    if (!std::ranges::all_of(cell, finite)) return "the stresses are not finite";
  return "";
}

/// What one of the two threads found.
struct Below {
  std::string reason;  ///< if there is no bound
  Enclosure energy;    ///< S
  EdgeLoads<Enclosure> loads;
};
struct Above {
  std::string reason;
  FieldEnergy<Enclosure> energy;
  std::vector<VertexSupport> supports;
  PlainField field;
};

Below from_stress(const scene::Problem<2>& problem, const std::vector<Corrected<Enclosure>>& corrections,
                  const scene::Stress<2>& stress) {
  if (std::string fault = arithmetic_fault(); !fault.empty()) return {fault, {}, {}};
  auto [loads, reason] = balanced<Enclosure, LongSum>(problem, corrections, plain_loads(problem, stress));
  if (!loads) return {reason, {}, {}};
  const Enclosure energy = stress_energy<Enclosure, LongSum>(problem, *loads);
  return {"", energy, std::move(*loads)};
}

Above from_displacement(const scene::Problem<2>& problem, const std::vector<Corrected<Enclosure>>& corrections,
                        const scene::Displacement<2>& displacement) {
  Above above{"", {}, vertex_supports(problem), {}};
  auto [field, reason] = admissible_field(problem, displacement, above.supports);
  above.reason = reason;
  if (!field) return above;
  above.energy = field_energy<Enclosure, LongSum>(problem, above.supports, *field, corrections);
  above.field = std::move(*field);
  return above;
}

/// Both fields as they have been moved, or why there are none.
struct Sides {
  std::string reason;
  Above above;
  Below below;
};
Sides both_sides(const scene::Problem<2>& problem, const std::vector<Corrected<Enclosure>>& corrections,
                 const scene::Displacement<2>& displacement, const scene::Stress<2>& stress) {
  auto other = std::async(std::launch::async, [&] { return from_stress(problem, corrections, stress); });
  Above above = from_displacement(problem, corrections, displacement);
  Below below = other.get();
  std::string reason = below.reason.empty() ? above.reason : below.reason;
  return {std::move(reason), std::move(above), std::move(below)};
}

std::string fault_of(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                     const scene::Stress<2>& stress) {
  if (std::string fault = arithmetic_fault(); !fault.empty()) return fault;
  if (std::string fault = problem_fault(problem); !fault.empty()) return fault;
  return field_fault(problem, displacement, stress);
}

/// The corrections of both kinds: base + factor · added, of the same facets.
std::vector<Corrected<Enclosure>> sum(std::vector<Corrected<Enclosure>> base, double factor,
                                      const std::vector<Corrected<Enclosure>>& added) {
  for (auto correction : added) {
    for (auto& end : correction.load) end = Enclosure(factor) * end;
    base.push_back(correction);
  }
  return base;
}

}  // namespace

template <int dim>
Certificate certify(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                    const scene::Stress<dim>& stress) {
  if (std::string fault = fault_of(problem, displacement, stress); !fault.empty()) return {.reason = fault};
  const auto [corrections, unbalanced] = corrected<Enclosure, LongSum>(scene::first_of(problem));
  if (!unbalanced.empty()) return {.reason = unbalanced};
  const Sides sides = both_sides(problem, corrections, displacement, stress);
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
  const scene::Problem<dim> alone = perturbation_alone(problem, carrying_pairs(problem, plain_loads(problem, stress)));
  const auto [added, also_unbalanced] = corrected<Enclosure, LongSum>(alone);
  if (!unbalanced.empty() || !also_unbalanced.empty())
    return {.reason = unbalanced.empty() ? also_unbalanced : unbalanced};
  if (!are_rounding(alone, added)) return {.reason = "the functional does work in a motion that nothing holds"};
  const auto [reason, above, below] = both_sides(problem, sum(own, factor, added), displacement, stress);
  if (!reason.empty()) return {.reason = reason};

  const Enclosure work = perturbing_work<Enclosure, LongSum>(problem, above.supports, above.field, added);
  const Enclosure reactions = perturbing_reactions<Enclosure, LongSum>(problem, below.loads);
  const Enclosure contact = contact_work<Enclosure, LongSum>(problem, above.supports, above.field, below.loads);
  const Enclosure width = above.energy.total + below.energy;
  FunctionalBound bound;
  bound.above = upper(Enclosure(factor) * (work + reactions) + (width + contact) / Enclosure(2));
  bound.valid = std::isfinite(bound.above);
  if (!bound.valid) bound.reason = "the functional could not be enclosed: numbers too large or too small";
  return bound;
}

template FunctionalBound certify_functional(const scene::Problem<2>&, const scene::Displacement<2>&,
                                            const scene::Stress<2>&);
template Certificate certify(const scene::Problem<2>&, const scene::Displacement<2>&, const scene::Stress<2>&);

}  // namespace bracket::bounds
