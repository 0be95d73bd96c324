// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/space/sides.h"

#include <algorithm>
#include <future>

#include "bounds/certificate/space/problem_faults.h"
#include "bounds/certificate/space/stress_energy.h"

namespace bracket::bounds::space {

namespace {

bool is_finite(const auto& values) {
  return std::ranges::all_of(values, [](const auto& value) { return value.allFinite(); });
}

/// A comparison with what is not a number is false, and might pass for a pressure of zero.
std::string stress_fault(const scene::Mesh<3>& mesh, const scene::Stress<3>& stress) {
  if (stress.degree != 1) return "the stresses are of no degree that there is in space";
  if (stress.cell.size() != mesh.cells.size() ||
      !std::ranges::all_of(stress.cell, [](const auto& cell) { return cell.size() == 16; }))
    return "the fields are not those of this mesh";
  if (!std::ranges::all_of(stress.cell, [](const auto& cell) { return is_finite(cell); }))
    return "the stresses are not finite";
  return "";
}

struct Below {
  std::string reason;
  Enclosure energy;
  Loads<Enclosure> loads;
};
Below from_stress(const scene::Problem<3>& problem, const std::vector<Corrected<Enclosure>>& corrections,
                  const Supports& supports, const scene::Stress<3>& stress) try {
  check_arithmetic();
  const std::vector<Face> faces = faces_of(problem.mesh);
  auto [loads, reason] = balanced<Enclosure, LongSum>(problem, faces, corrections, plain_loads(problem, faces, stress));
  if (!loads) return {reason, {}, {}};
  const Enclosure energy = stress_energy<Enclosure, LongSum>(problem, faces, supports, *loads);
  return {"", energy, std::move(*loads)};
} catch (const ArithmeticFault& fault) {
  return {fault.what(), {}, {}};
}

}  // namespace

Sides both_sides(const scene::Problem<3>& problem, const std::vector<Corrected<Enclosure>>& corrections,
                 const scene::Displacement<3>& displacement, const scene::Stress<3>& stress) {
  Sides sides;
  sides.supports = supports_of(problem, displacement.degree);
  sides.reason = sides.supports.fault;
  if (!sides.reason.empty()) return sides;
  auto other =
      std::async(std::launch::async, [&] { return from_stress(problem, corrections, sides.supports, stress); });
  auto [field, reason] = admissible_field(problem, displacement, sides.supports);
  try {
    if (field) sides.above = field_energy<Enclosure, LongSum>(problem, sides.supports, *field, corrections);
  } catch (const ArithmeticFault& fault) {
    reason = fault.what();
  }
  if (field) sides.field = std::move(*field);
  Below below = other.get();
  sides.reason = below.reason.empty() ? reason : below.reason;
  sides.below = below.energy;
  sides.loads = std::move(below.loads);
  return sides;
}

std::string displacement_fault(const scene::Mesh<3>& mesh, const scene::Displacement<3>& displacement) {
  if (displacement.degree < 1 || displacement.degree > 2)
    return "the displacements are of no degree that there is in space";
  if (displacement.vertex.size() != mesh.vertices.size() ||
      displacement.edge.size() != (displacement.degree - 1) * mesh.edges.size() || !displacement.cell.empty())
    return "the fields are not those of this mesh";
  if (!is_finite(displacement.vertex) || !is_finite(displacement.edge)) return "the displacements are not finite";
  return "";
}

std::string fault_of(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
                     const scene::Stress<3>& stress) {
  if (std::string fault = arithmetic_fault(); !fault.empty()) return fault;
  if (std::string fault = problem_fault(problem); !fault.empty()) return fault;
  if (std::string fault = displacement_fault(problem.mesh, displacement); !fault.empty()) return fault;
  return stress_fault(problem.mesh, stress);
}

}  // namespace bracket::bounds::space
