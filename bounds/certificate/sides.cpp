// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/sides.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>

#include "bounds/certificate/arithmetic.h"
#include "bounds/certificate/problem_faults.h"

namespace bracket::bounds {

namespace {

bool is_finite(const auto& values) {
  return std::ranges::all_of(values, [](const auto& value) { return value.allFinite(); });
}

std::string stress_fault(const scene::Problem<2>& problem, const scene::Stress<2>& stress) {
  if (stress.degree < 1 || stress.degree > scene::stress_degree(scene::largest_degree))
    return "the stresses are of no degree that there is";
  if (const int degree = scene::degree_of_loads(problem); degree > stress.degree)
    return fmt::format("the tractions have degree {}, stresses of degree {} cannot carry them", degree, stress.degree);
  const std::size_t values = 3 * scene::n_bernstein(stress.degree);
  if (stress.cell.size() != problem.mesh.cells.size() ||
      !std::ranges::all_of(stress.cell, [&](const auto& cell) { return cell.size() == values; }))
    return "the fields are not those of this mesh";
  if (!std::ranges::all_of(stress.cell, [](const auto& cell) { return is_finite(cell); }))
    return "the stresses are not finite";
  return "";
}

Below from_stress(const scene::Problem<2>& problem, const std::vector<Corrected<Enclosure>>& corrections,
                  const scene::Stress<2>& stress) try {
  check_arithmetic();
  auto [loads, reason] = balanced<Enclosure, LongSum>(problem, corrections, plain_loads(problem, stress));
  if (!loads) return {reason, {}, {}};
  const Enclosure energy = stress_energy<Enclosure, LongSum>(problem, *loads);
  return {"", energy, std::move(*loads)};
} catch (const ArithmeticFault& fault) {
  return {fault.what(), {}, {}};
}

Above from_displacement(const scene::Problem<2>& problem, const std::vector<Corrected<Enclosure>>& corrections,
                        const scene::Displacement<2>& displacement) try {
  Above above{"", {}, supports_of(problem), {}};
  auto [field, reason] = admissible_field(problem, displacement, above.supports);
  above.reason = reason;
  if (!field) return above;
  above.energy = field_energy<Enclosure, LongSum>(problem, above.supports, *field, corrections);
  above.field = std::move(*field);
  return above;
} catch (const ArithmeticFault& fault) {
  return {fault.what(), {}, {}, {}};
}

}  // namespace

Sides both_sides(const scene::Problem<2>& problem, const std::vector<Corrected<Enclosure>>& corrections,
                 const scene::Displacement<2>& displacement, const scene::Stress<2>& stress) {
  auto other = std::async(std::launch::async, [&] { return from_stress(problem, corrections, stress); });
  Above above = from_displacement(problem, corrections, displacement);
  Below below = other.get();
  std::string reason = below.reason.empty() ? above.reason : below.reason;
  return {std::move(reason), std::move(above), std::move(below)};
}

/// A comparison with what is not a number is false, and might pass for a pressure of zero.
std::string displacement_fault(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement) {
  if (displacement.degree < 1 || displacement.degree > scene::largest_degree)
    return "the displacements are of no degree that there is";
  const auto& mesh = problem.mesh;
  if (displacement.vertex.size() != mesh.vertices.size() ||
      displacement.edge.size() != scene::n_inside_edge(displacement.degree) * mesh.edges.size() ||
      displacement.cell.size() != scene::n_inside_cell(displacement.degree) * mesh.cells.size())
    return "the fields are not those of this mesh";
  if (!is_finite(displacement.vertex) || !is_finite(displacement.edge) || !is_finite(displacement.cell))
    return "the displacements are not finite";
  return "";
}

std::string fault_of(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                     const scene::Stress<2>& stress) {
  if (std::string fault = arithmetic_fault(); !fault.empty()) return fault;
  if (std::string fault = problem_fault(problem); !fault.empty()) return fault;
  if (std::string fault = displacement_fault(problem, displacement); !fault.empty()) return fault;
  return stress_fault(problem, stress);
}

}  // namespace bracket::bounds
