// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>

#include "bounds/certificate/certificate.h"
#include "bounds/certificate/equilibrate.h"

namespace bracket::bounds {

namespace {

bool all_finite(const scene::Displacement<2>& displacement) {
  const auto finite = [](const scene::Vector<2>& u) { return u.allFinite(); };
  return std::all_of(displacement.vertex.begin(), displacement.vertex.end(), finite) &&
         std::all_of(displacement.edge.begin(), displacement.edge.end(), finite);
}

bool all_finite(const scene::Stress<2>& stress) {
  return std::all_of(stress.cell.begin(), stress.cell.end(), [](const auto& cell) {
    return std::all_of(cell.begin(), cell.end(), [](const scene::Voigt<2>& s) { return s.allFinite(); });
  });
}

/// How much the loads added to the data are of all loads on edges.
double relative_size(const Loads<Enclosure>& loads) {
  double all = 0, added = 0;
  const auto size = [](const SideLoad<Enclosure>& load) {
    return magnitude(load[0].x) + magnitude(load[0].y) + magnitude(load[1].x) + magnitude(load[1].y);
  };
  for (const auto& load : loads.edge) all = std::max(all, size(load));
  for (const auto& [facet, load] : loads.added) added = std::max(added, size(load));
  return added > 0 ? added / all : 0;
}

/// Not less than the work that the loads added to the data can do in this scene: their size times the largest
/// displacement or gap. By so much the energies may differ of data that rounding cannot tell apart.
Enclosure work_of_rounding(const scene::Problem<2>& problem, const PlainField& field,
                           const std::vector<AddedLoad<Enclosure>>& added) {
  double farthest = 0;
  for (const auto& u : field.vertex) farthest = std::max(farthest, u.norm());
  for (const auto& pair : problem.contact)
    for (const double gap : pair.gap) farthest = std::max(farthest, std::abs(gap));
  Enclosure work;
  for (const auto& [facet, load] : added)
    for (const auto& end : load)
      work += Enclosure(magnitude(end.x)) + Enclosure(magnitude(end.y));
  return work * Enclosure(2 * farthest);  // a body may be moved by gap and displacement
}

/// What the stresses give: −S from below, and what they lack of balance with the data.
struct FromStress {
  std::string reason;  ///< if there is no bound
  Enclosure energy;
  std::vector<AddedLoad<Enclosure>> added;
  double added_load = 0;
};
FromStress from_stress(const scene::Problem<2>& problem, const std::vector<VertexSupport>& supports,
                       const scene::Stress<2>& stress) {
  constexpr double negligible = 1e-10;
  FromStress result;
  auto [loads, reason] = balanced<Enclosure, LongSum>(problem, plain_loads(problem, stress));
  result.reason = std::move(reason);
  if (!loads) return result;
  result.added_load = relative_size(*loads);
  if (!(result.added_load <= negligible))
    result.reason = fmt::format("the loads are out of balance by {:.2g} of the largest where nothing can take it",
                                result.added_load);
  else result.energy = -stress_energy<Enclosure, LongSum>(problem, supports, *loads);
  result.added = std::move(loads->added);
  return result;
}

}  // namespace

template <int dim>
Certificate certify(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                    const scene::Stress<dim>& stress) {
  // A comparison with what is not a number is false, and might pass for a pressure of zero.
  if (!all_finite(displacement)) return {.reason = "the displacements are not finite"};
  if (!all_finite(stress)) return {.reason = "the stresses are not finite"};
  const auto supports = vertex_supports(problem);
  auto stresses = std::async(std::launch::async, [&] { return from_stress(problem, supports, stress); });
  const auto [field, penetrating] = admissible_field(problem, displacement, supports);
  FieldEnergy<Enclosure> energy;
  if (field) energy = field_energy<Enclosure, LongSum>(problem, supports, *field);
  const FromStress from_stresses = stresses.get();

  Certificate certificate;
  certificate.added_load = from_stresses.added_load;
  certificate.reason = from_stresses.reason.empty() ? penetrating : from_stresses.reason;
  if (!certificate.reason.empty()) return certificate;
  LongSum total;
  total.add(energy.total);
  for (const auto& [facet, load] : from_stresses.added)
    total.add(-facet_work(problem.mesh, supports, *field, facet, load));
  const Enclosure open = work_of_rounding(problem, *field, from_stresses.added);
  certificate.lower = lower(from_stresses.energy - open) + 0.0;  // not −0
  certificate.upper = upper(total.value() + open);
  certificate.strain_energy = std::max(0.0, lower(energy.strain));
  certificate.valid = std::isfinite(certificate.lower) && std::isfinite(certificate.upper);
  if (!certificate.valid)
    certificate.reason = "the energies could not be enclosed: numbers too large or too small, or cells too thin";
  return certificate;
}

template Certificate certify(const scene::Problem<2>&, const scene::Displacement<2>&, const scene::Stress<2>&);

}  // namespace bracket::bounds
