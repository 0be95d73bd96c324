// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/sides.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>

#include "bounds/certificate/arithmetic.h"
#include "bounds/certificate/double_enclosure.h"
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

/// The energy of cells by `in_doubles` if that may do and tells it from zero: what is zero is exactly so by `extended`
/// alone.
Enclosure of_cells(Digits digits, const auto& in_doubles, const auto& extended) {
  if (digits == Digits::enough)
    if (const Enclosure energy = in_doubles(); energy.middle > energy.radius) return energy;
  return extended();
}

Enclosure energy_of_stresses(const scene::Problem<2>& problem, const EdgeLoads<Enclosure>& loads, Digits digits) {
  const auto forms = elastic_forms<Enclosure>(problem);
  return of_cells(
      digits,
      [&] {
        return energy_of_blocks<Enclosure, LongSum>(problem, forms_as<DoubleEnclosure>(forms),
                                                    on_edges<DoubleEnclosure>(loads));
      },
      [&] { return energy_of_blocks<Enclosure, LongSum>(problem, forms, loads); });
}

Enclosure energy_of_strains(const scene::Problem<2>& problem, const PlainField& field,
                            const MovedField<Enclosure>& moved, Digits digits) {
  const auto forms = elastic_forms<Enclosure>(problem);
  return of_cells(
      digits,
      [&] {
        return strain_energy<Enclosure, LongSum>(problem, forms_as<DoubleEnclosure>(forms), field,
                                                 moved_as<DoubleEnclosure>(moved));
      },
      [&] { return strain_energy<Enclosure, LongSum>(problem, forms, field, moved); });
}

Below from_stress(const scene::Problem<2>& problem, const std::vector<Corrected<Enclosure>>& corrections,
                  const scene::Stress<2>& stress, Digits digits) try {
  check_arithmetic();
  auto [loads, reason] = balanced<Enclosure, LongSum>(problem, corrections, plain_loads(problem, stress));
  if (!loads) return {reason, {}, {}, {}};
  const Enclosure boundary = energy_of_boundary<Enclosure, LongSum>(problem, *loads);
  return {"", energy_of_stresses(problem, *loads, digits) + boundary, boundary, std::move(*loads)};
} catch (const ArithmeticFault& fault) {
  return {fault.what(), {}, {}, {}};
}

Above from_displacement(const scene::Problem<2>& problem, const std::vector<Corrected<Enclosure>>& corrections,
                        const scene::Displacement<2>& displacement, Digits digits) try {
  Above above{"", {}, {}, supports_of(problem), {}};
  auto [field, reason] = admissible_field(problem, displacement, above.supports);
  above.reason = reason;
  if (!field) return above;
  const MovedField<Enclosure> all = moved<Enclosure>(problem, above.supports, *field);
  above.of_loads = load_energy<Enclosure, LongSum>(problem, above.supports, *field, all, corrections);
  above.energy.strain = energy_of_strains(problem, *field, all, digits);
  above.energy.total = above.energy.strain + above.of_loads;
  above.field = std::move(*field);
  return above;
} catch (const ArithmeticFault& fault) {
  return {fault.what(), {}, {}, {}, {}};
}

/// Whether the radii of the energies are no more than 1/256 of the width between them: with radii that are zero it
/// would not be less than 255/257 of what it is.
bool are_narrow(const Above& above, const Below& below) {
  const Enclosure width = above.energy.total + below.energy;
  return 256 * width.radius <= width.middle;  // of what is not a number: no
}

/// Both energies once more, in extended precision.
void narrow(const scene::Problem<2>& problem, Above& above, Below& below) {
  auto other = std::async(std::launch::async, [&] {
    below.energy = energy_of_stresses(problem, below.loads, Digits::extended) + below.of_boundary;
  });
  above.energy.strain =
      energy_of_strains(problem, above.field, moved<Enclosure>(problem, above.supports, above.field), Digits::extended);
  above.energy.total = above.energy.strain + above.of_loads;
  other.get();
}

}  // namespace

Sides both_sides(const scene::Problem<2>& problem, const std::vector<Corrected<Enclosure>>& corrections,
                 const scene::Displacement<2>& displacement, const scene::Stress<2>& stress, Digits digits) try {
  auto other = std::async(std::launch::async, [&] { return from_stress(problem, corrections, stress, digits); });
  Above above = from_displacement(problem, corrections, displacement, digits);
  Below below = other.get();
  std::string reason = below.reason.empty() ? above.reason : below.reason;
  if (digits == Digits::enough && reason.empty() && !are_narrow(above, below)) narrow(problem, above, below);
  return {std::move(reason), std::move(above), std::move(below)};
} catch (const ArithmeticFault& fault) {
  return {fault.what(), {}, {}};
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
