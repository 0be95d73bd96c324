// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bounds/quantities/functional.h"

/// The functionals by kind, and what they are made of.
namespace bracket::bounds {

/// \throw scene::Error (input) with the quantity's place and name
template <int dim> [[noreturn]] void refuse(const scene::Quantity<dim>& quantity, const std::string& why);
/// What a facet is called in messages.
template <int dim> constexpr const char* facet_name = dim == 2 ? "edge" : "face";

/// Both bounds of one functional.
template <int dim>
Functionals<dim> linear(scene::Perturbation<dim> perturbation, const scene::Enclosure& scale,
                        const scene::Enclosure& offset = {});

template <int dim> std::vector<int> facets_of(const scene::Problem<dim>& first, const scene::Quantity<dim>& quantity);
template <int dim> int body_named(const scene::Problem<dim>& first, const scene::Quantity<dim>& quantity);
/// The length of a facet, in space its area; the area of a body, in space its volume.
scene::Enclosure facet_size(const scene::Problem<2>& first, int facet);
scene::Enclosure facet_size(const scene::Problem<3>& first, int facet);
scene::Enclosure body_size(const scene::Problem<2>& first, int body);
scene::Enclosure body_size(const scene::Problem<3>& first, int body);
/// The mean over a facet of |v|², v linear on it.
scene::Enclosure mean_square(const std::array<scene::TwofoldVector<2>, 2>& v);
scene::Enclosure mean_square(const std::array<scene::TwofoldVector<3>, 3>& v);
scene::Enclosure size(const scene::Vector<2>& x);
scene::Enclosure size(const scene::Vector<3>& x);
template <int dim> scene::TwofoldVector<dim> plain(const scene::Vector<dim>& x) {
  return {x, scene::Vector<dim>::Zero()};
}

/// Whether a component that is known along some directions is known along d, too. \param known none is another's ±
bool is_known_along(const scene::Vector<2>& d, const std::vector<scene::Vector<2>>& known);
/// \pre, and in space up to 1e-6, as normals that agree so far are one (FacetData::normal)
bool is_known_along(const scene::Vector<3>& d, const std::vector<scene::Vector<3>>& known);
/// Adds a direction that is no other's ±.
template <int dim> void add_direction(const scene::Vector<dim>& d, std::vector<scene::Vector<dim>>& known) {
  for (const auto& one : known)
    if (d == one || d == -one) return;
  known.push_back(d);
}

/// What the data of a component do in displacements u that are linear on all of it: ∫ F·u + ∫_Γτ P·u.
struct DataWork {
  scene::Enclosure work;
  std::string reason;  ///< if it cannot be had: one line
};
/// \param u at the vertices of the first mesh
DataWork work_of_data(const scene::Problem<2>& first, int component,
                      const std::function<scene::TwofoldVector<2>(int vertex)>& u);
DataWork work_of_data(const scene::Problem<3>& first, int component,
                      const std::function<scene::TwofoldVector<3>(int vertex)>& u);

template <int dim>
Functionals<dim> mean_displacement(const scene::Problem<dim>& first, const scene::Quantity<dim>& quantity);
template <int dim>
Functionals<dim> body_displacement(const scene::Problem<dim>& first, const scene::Quantity<dim>& quantity);
/// ∫ (x − c)^⊥·u / ∫ |x − c|², c the middle of the part; in space ∫ (a × (x − c))·u / ∫ |a × (x − c)|², a an axis of
/// the coordinates.
template <int dim> Functionals<dim> rotation(const scene::Problem<dim>& first, const scene::Quantity<dim>& quantity);
/// ∫ σn·e: U = e, but zero where another boundary facet does not let it go on.
template <int dim> Functionals<dim> reaction(const scene::Problem<dim>& first, const scene::Quantity<dim>& quantity);
/// J = ∫ p w, for p ≥ 0 between those of weights below and above.
template <int dim>
Functionals<dim> contact_force(const scene::Scene<dim>& scene, const scene::Problem<dim>& first,
                               const scene::Quantity<dim>& quantity);
/// J = ∫ τ over a contact.
Functionals<2> shear_force(const scene::Scene<2>& scene, const scene::Problem<2>& first,
                           const scene::Quantity<2>& quantity);
/// J = ∫ v_t over a contact, by its length.
Functionals<2> mean_slip(const scene::Scene<2>& scene, const scene::Problem<2>& first,
                         const scene::Quantity<2>& quantity);
/// J = −∫ w r; the opening is ∫ w g more.
template <int dim>
Functionals<dim> opening(const scene::Scene<dim>& scene, const scene::Problem<dim>& problem,
                         const scene::Quantity<dim>& quantity);
/// By Green's formula ∫ σ:E₀ = ∫ σn·E₀x + ∫ F·E₀x: what is not prescribed of σn is J.
template <int dim> Functionals<dim> mean_stress(const scene::Problem<dim>& first, const scene::Quantity<dim>& quantity);
/// ½ A(u,u) = ½ ℓ(u) + ½ R₀(σ), R₀ with the data themselves: J of half of them. ∫ p g is between those of the gaps.
template <int dim>
Functionals<dim> half_of_data(const scene::Problem<dim>& first, const scene::Quantity<dim>& quantity);

}  // namespace bracket::bounds
