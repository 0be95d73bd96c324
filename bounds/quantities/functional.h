// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "scene/enclosure.h"
#include "scene/scene.h"

/// What is asked of a scene, as functionals of perturbations (docs/theory.md §10).
namespace bracket::bounds {

/// A quantity q as (J + offset) / scale of two functionals: of a lower bound of the first and an upper bound of the
/// second. They are one where the quantity is linear itself.
template <int dim> struct Functionals {
  std::shared_ptr<const scene::Perturbation<dim>> below, above;
  scene::Enclosure offset_below, offset_above;
  scene::Enclosure scale = scene::Enclosure(1);  ///< > 0
  bool non_negative = false;                     ///< the quantity is so, whatever the solution is
  bool weighted = false;  ///< the quantity is not the one that its name says: near an end its weight falls to zero
};

/// \param problem on its first mesh, fix_data() of the scene, with its loads in balance
/// \throw scene::Error (input) if the scene has no such quantity: unknown names, directions of zero, stretches outside
///        of their line, weights that are not quadratic on its edges, parts on which the asked is not defined
/// \pre the energy is not had without: see free_energy()
template <int dim>
Functionals<dim> functionals(const scene::Scene<dim>& scene, const scene::Problem<dim>& problem,
                             const scene::Quantity<dim>& quantity);

/// J = −∫ p ψ of a ψ between two weights on each contact facet of the first mesh, Bernstein coefficients as
/// ContactFacetOf has the gap's: as p ≥ 0, bounds of those of the weights bound it.
template <int dim>
Functionals<dim> contact_work_functionals(const scene::Problem<dim>& problem,
                                          const std::vector<scene::FacetQuadratic<dim>>& below,
                                          const std::vector<scene::FacetQuadratic<dim>>& above);

/// Whether the strain energy follows from the bracket of L(u) itself: −L(u) where the loads do all of the work, as
/// without gaps and prescribed displacements, and L(u) where there are no loads.
enum class FreeEnergy { none, of_loads, of_supports };
template <int dim> FreeEnergy free_energy(const scene::Problem<dim>& problem);

/// The pair that a name means: index into Scene::contact.
/// \throw scene::Error (input), at `where`, if it is none or not unique
template <int dim> int pair_named(const scene::Scene<dim>& scene, const std::string& name, const std::string& where);

}  // namespace bracket::bounds
