// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/corrections.h"
#include "scene/problem/psi.h"

/// The functional J of a perturbation, at fields that are admissible for a problem perturbed by it.
namespace bracket::bounds {

/// Whether corrections are but rounding of the perturbation's loads; else it does work in a motion that nothing holds.
bool are_rounding(const scene::Problem<2>& alone, const std::vector<Corrected<Enclosure>>& corrections);

/// Q(v) = ∫ F_q·v + ∫ P_q·v.
/// \param corrections of the perturbation's loads, as corrected() has them for perturbation_alone()
template <class Number, class Sum>
Number perturbing_work(const scene::Problem<2>& problem, const Supports& supports, const PlainField& field,
                       const std::vector<Corrected<Number>>& corrections) {
  const auto& mesh = problem.mesh;
  const auto& by = *problem.perturbed.by;
  const MovedField<Number> all = moved<Number>(problem, supports, field);
  Sum work;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    if (const scene::Vector<2>& force = by.force[mesh.cell_body[c]]; !force.isZero(0))
      work.add(cell_work(problem, field, all, vector2<Number>(force), static_cast<int>(c)));
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const int facet = static_cast<int>(f);
    const bool loaded = has_perturbing_load(problem, facet);
    if (!loaded && corrections.empty()) continue;
    WholeLoad<Number> load;
    if (loaded) load = perturbing_load<Number>(problem, facet);
    add_corrections(problem, corrections, facet, load.linear);
    work.add(facet_work<Number>(mesh, field, all, facet, load));
  }
  for (const auto& pair : problem.contact) work.add(contact_load_work<Number>(problem, supports, field, pair));
  return work.value();
}

/// R(λ) = ∫_Γu λn·U (to which only the linear part of λn is not orthogonal) + ∫_Γ0 (λn)_n U_n −
/// ∫_ΓK (p ψ + τ ψ_t). \param loads balanced
template <class Number, class Sum>
Number perturbing_reactions(const scene::Problem<2>& problem, const EdgeLoads<Number>& loads) {
  const auto& mesh = problem.mesh;
  const auto& by = *problem.perturbed.by;
  const auto fixed = fixed_vertices(scene::first_of(problem));
  Sum sum;
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const int facet = static_cast<int>(f);
    if (problem.facets[f].support == scene::Support::fixed) {
      const SideLoad<Number> load = oriented(loads.edge[mesh.boundary[f].edge], forward(mesh.boundary[f]));
      const auto [begin, end] = holds_of(problem, facet);
      sum.add(linear_product<Number>(load, {added<Number>(begin), added<Number>(end)}));
    } else if (problem.facets[f].support == scene::Support::sliding) {
      const auto [begin, end] = slides_of(problem, fixed, facet);
      sum.add(scene::bernstein_product(loads.along_normal[f],
                                       std::vector<Number>{added<Number>(begin), added<Number>(end)}));
    }
  }
  const FirstContacts contacts = first_contacts(problem);
  for (const auto& pair : problem.contact) {
    const scene::Piece<1> piece = scene::piece_of_facet(problem, pair.first);
    auto psi = scene::psi<Number>(by.contact[by.contact_of[piece.of]], problem.facets[pair.first].normal, piece);
    if (pair.law.two_sided)
      psi = scene::on_stretch(kept_psi<Number>(contacts.kept[by.contact_of[piece.of]]), piece.corner[0][0],
                              piece.corner[1][0]);
    sum.add(-scene::bernstein_product(loads.along_normal[pair.first], std::vector<Number>(psi.begin(), psi.end())));
    if (scene::has_friction(pair.law))
      sum.add(-scene::bernstein_product(loads.along_tangent[pair.first], perturbing_slip<Number>(problem, pair)));
  }
  return sum.value();
}

/// What springs count as: a part of κ, or bodies, whose shares of the width are squares as those of cells are. Of these
/// κ has but ∫ p (g + s − r), s what they are shortened by.
enum class Springs { of_law, as_bodies };

/// κ = ∫ [φ(r, v_t) + φ*(p, τ) − p r − τ v_t] with the laws' energies from above: without a law ∫ p (g − r(v)), g the
/// upper gap; friction's share is of what it sees of v_t.
template <class Number, class Sum>
Number contact_work(const scene::Problem<2>& problem, const Supports& supports, const PlainField& field,
                    const EdgeLoads<Number>& loads, Springs springs = Springs::of_law) {
  Sum sum;
  for (const auto& pair : problem.contact) {
    const std::vector<Number>& pressure = loads.along_normal[pair.first];
    const bool bodies = springs == Springs::as_bodies && scene::has_springs(pair.law);
    if (bodies && pair.law.two_sided) continue;  // s = r − g
    if (!keeps_together(pair.law)) {
      const std::vector<Number> r = approach_on<Number>(problem, supports, field, pair);
      std::vector<Number> left = gap_paid<Number>(problem, supports.contacts, pair, field.degree);
      for (std::size_t k = 0; k < r.size(); ++k) left[k] -= r[k];
      sum.add(scene::bernstein_product(pressure, left));
    }
    if (!has_law(pair.law)) continue;
    if (bodies) {
      const auto modulus = law_on<Number>(problem, supports.contacts, pair).modulus;
      sum.add(scene::bernstein_product(pressure, springs_shortened(problem, supports, field, pair, modulus)));
      continue;
    }
    sum.add(law_energy<Number>(problem, supports, field, pair));
    sum.add(compliance_energy(problem, supports.contacts, pair, pressure));
    if (scene::has_friction(pair.law))
      sum.add(-scene::bernstein_product(loads.along_tangent[pair.first],
                                        rubbing_on<Number>(problem, supports, field, pair)));
  }
  return sum.value();
}

}  // namespace bracket::bounds
