// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "bounds/certificate/geometry.h"
#include "bounds/quantities/functional.h"

/// The functionals by kind, and what they are made of.
namespace bracket::bounds {

/// \throw scene::Error (input) with the quantity's place and name
[[noreturn]] void refuse(const scene::Quantity<2>& quantity, const std::string& why);

/// Both bounds of one functional.
Functionals<2> linear(scene::Perturbation<2> perturbation, const scene::Enclosure& scale,
                      const scene::Enclosure& offset = {});

std::vector<int> facets_of(const scene::Problem<2>& first, const scene::Quantity<2>& quantity);
int body_named(const scene::Problem<2>& first, const scene::Quantity<2>& quantity);
scene::Enclosure facet_length(const scene::Problem<2>& first, int facet);
scene::Enclosure body_area(const scene::Problem<2>& first, int body);
inline scene::Enclosure size(const scene::Vector<2>& x) {
  return root(dot(vector2<scene::Enclosure>(x), vector2<scene::Enclosure>(x)));
}
inline scene::TwofoldVector<2> plain(const scene::Vector<2>& x) { return {x, scene::Vector<2>::Zero()}; }

Functionals<2> mean_displacement(const scene::Problem<2>& first, const scene::Quantity<2>& quantity);
Functionals<2> body_displacement(const scene::Problem<2>& first, const scene::Quantity<2>& quantity);
/// ∫ (x − c)^⊥·u / ∫ |x − c|², c the middle of the part.
Functionals<2> rotation(const scene::Problem<2>& first, const scene::Quantity<2>& quantity);
/// ∫ σn·e: U = e, but zero where another boundary facet does not let it go on.
Functionals<2> reaction(const scene::Problem<2>& first, const scene::Quantity<2>& quantity);
/// J = ∫ p w, for p ≥ 0 between those of weights below and above.
Functionals<2> contact_force(const scene::Scene<2>& scene, const scene::Problem<2>& first,
                             const scene::Quantity<2>& quantity);
/// J = ∫ τ over a contact.
Functionals<2> shear_force(const scene::Scene<2>& scene, const scene::Problem<2>& first,
                           const scene::Quantity<2>& quantity);
/// J = ∫ v_t over a contact, by its length.
Functionals<2> mean_slip(const scene::Scene<2>& scene, const scene::Problem<2>& first,
                         const scene::Quantity<2>& quantity);
/// J = −∫ w r; the opening is ∫ w g more.
Functionals<2> opening(const scene::Scene<2>& scene, const scene::Problem<2>& problem,
                       const scene::Quantity<2>& quantity);
/// By Green's formula ∫ σ:E₀ = ∫ σn·E₀x + ∫ F·E₀x: what is not prescribed of σn is J.
Functionals<2> mean_stress(const scene::Problem<2>& first, const scene::Quantity<2>& quantity);
/// ½ A(u,u) = ½ ℓ(u) + ½ R₀(σ), R₀ with the data themselves: J of half of them. ∫ p g is between those of the gaps.
Functionals<2> half_of_data(const scene::Problem<2>& first, const scene::Quantity<2>& quantity);

}  // namespace bracket::bounds
