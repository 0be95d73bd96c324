// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/space/corrections.h"
#include "bounds/certificate/space/displacement_energy.h"

/// The functional J of a perturbation, at fields that are admissible for a problem perturbed by it.
namespace bracket::bounds::space {

/// Whether corrections are but rounding of the perturbation's loads; else it does work in a motion that nothing holds.
bool are_rounding(const scene::Problem<3>& alone, const std::vector<Corrected<Enclosure>>& corrections);

/// Q(v) = ∫ F_q·v + ∫ P_q·v.
/// \param corrections of the perturbation's loads, as corrected() has them for perturbation_alone()
template <class Number, class Sum>
Number perturbing_work(const scene::Problem<3>& problem, const Supports& supports, const PlainField& field,
                       const std::vector<Corrected<Number>>& corrections) {
  const auto& mesh = problem.mesh;
  const auto& by = *problem.perturbed.by;
  const auto all = shifts<Number>(supports, field);
  Sum work;
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell)
    if (const scene::Vector<3>& force = by.force[mesh.cell_body[cell]]; !force.isZero(0))
      work.add(cell_work(problem, field, all, displaced_cell(problem, field, all, cell), vector3<Number>(force), cell));
  for (int facet = 0; facet < static_cast<int>(problem.facets.size()); ++facet) {
    const bool loaded = has_perturbing_load(problem, facet);
    if (!loaded && corrections.empty()) continue;
    FacetVectors<Number> load{};
    if (loaded) load = perturbing_load<Number>(problem, facet);
    add_corrections(problem, corrections, facet, load);
    work.add(facet_work<Number>(mesh, field, all, facet, load));
  }
  for (const auto& pair : problem.contact)
    work.add(
        bernstein_product(opening_load<Number>(problem, pair), approach_on<Number>(problem, supports, field, pair)));
  return work.value();
}

/// R(λ) = ∫_Γu λn·U + ∫_Γ0 (λn)_n U_n − ∫_ΓK p ψ. \param loads balanced
template <class Number, class Sum>
Number perturbing_reactions(const scene::Problem<3>& problem, const Supports& supports, const Loads<Number>& loads) {
  const auto& by = *problem.perturbed.by;
  Sum sum;
  for (int f = 0; f < static_cast<int>(problem.facets.size()); ++f) {
    if (problem.facets[f].support == scene::Support::fixed) {
      const auto holds = holds_of(problem, f);
      sum.add(mean_product<Number>(loads.face[face_of(problem.mesh, f)],
                                   {added<Number>(holds[0]), added<Number>(holds[1]), added<Number>(holds[2])}));
    } else if (problem.facets[f].support == scene::Support::sliding) {
      const auto slides = slides_of(problem, supports.fixed, f);
      sum.add(mean_product<Number>(loads.along_normal[f],
                                   {added<Number>(slides[0]), added<Number>(slides[1]), added<Number>(slides[2])}));
    }
  }
  for (const auto& pair : problem.contact) {
    const scene::Piece<2> piece = scene::piece_of_facet(problem, pair.first);
    const auto psi = scene::psi<Number>(by.contact[by.contact_of[piece.of]], problem.facets[pair.first].normal, piece);
    sum.add(-bernstein_product(loads.along_normal[pair.first], psi));
  }
  return sum.value();
}

}  // namespace bracket::bounds::space
