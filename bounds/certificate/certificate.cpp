// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/certificate.h"

#include <algorithm>
#include <cmath>
#include <future>

#include "bounds/certificate/arithmetic.h"
#include "bounds/certificate/equilibrate.h"
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
struct Side {
  std::string reason;  ///< if there is no bound
  Enclosure energy, strain;
};

Side from_stress(const scene::Problem<2>& problem, const std::vector<Corrected<Enclosure>>& corrections,
                 const scene::Stress<2>& stress) {
  if (std::string fault = arithmetic_fault(); !fault.empty()) return {fault, {}, {}};
  const auto [loads, reason] = balanced<Enclosure, LongSum>(problem, corrections, plain_loads(problem, stress));
  if (!loads) return {reason, {}, {}};
  return {"", -stress_energy<Enclosure, LongSum>(problem, *loads), {}};
}

Side from_displacement(const scene::Problem<2>& problem, const std::vector<Corrected<Enclosure>>& corrections,
                       const scene::Displacement<2>& displacement) {
  const auto supports = vertex_supports(problem);
  const auto [field, reason] = admissible_field(problem, displacement, supports);
  if (!field) return {reason, {}, {}};
  const auto energy = field_energy<Enclosure, LongSum>(problem, supports, *field, corrections);
  return {"", energy.total, energy.strain};
}

}  // namespace

template <int dim>
Certificate certify(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                    const scene::Stress<dim>& stress) {
  if (std::string fault = arithmetic_fault(); !fault.empty()) return {.reason = fault};
  if (std::string fault = problem_fault(problem); !fault.empty()) return {.reason = fault};
  if (std::string fault = field_fault(problem, displacement, stress); !fault.empty()) return {.reason = fault};
  const auto [corrections, unbalanced] = corrected<Enclosure, LongSum>(problem);
  if (!unbalanced.empty()) return {.reason = unbalanced};
  auto other =
      std::async(std::launch::async, [&, &added = corrections] { return from_stress(problem, added, stress); });
  const Side above = from_displacement(problem, corrections, displacement);
  const Side below = other.get();

  Certificate certificate;
  certificate.reason = below.reason.empty() ? above.reason : below.reason;
  if (!certificate.reason.empty()) return certificate;
  certificate.lower = lower(below.energy) + 0.0;  // not −0
  certificate.upper = upper(above.energy) + 0.0;
  certificate.strain_energy = std::max(0.0, lower(above.strain));
  certificate.valid = std::isfinite(certificate.lower) && std::isfinite(certificate.upper);
  if (!certificate.valid)
    certificate.reason = "the energies could not be enclosed: numbers too large or too small, or cells too thin";
  return certificate;
}

template Certificate certify(const scene::Problem<2>&, const scene::Displacement<2>&, const scene::Stress<2>&);

}  // namespace bracket::bounds
