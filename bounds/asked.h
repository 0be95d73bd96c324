// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/level.h"
#include "bounds/quantities/evaluate.h"

/// The quantities of a run.
namespace bracket::bounds {

/// A quantity that is asked for, and what the levels have taught of it.
template <int dim> struct Asked {
  scene::Quantity<dim> quantity;
  int contact = -1, zone = -1;  ///< as QuantityInterval
  Undetermined undetermined = {};
  Learned learned = {};
  Indicator indicator = {};  ///< of the last level that it was computed on
};

template <int dim> bool asks_for_quantities(const scene::Scene<dim>& scene) {
  return !scene.quantities.empty() ||
         std::any_of(scene.contact.begin(), scene.contact.end(), [](const auto& pair) { return pair.zones > 0; });
}

/// The scene's quantities, then the zones of its contacts.
/// \param problem on its first mesh, with its loads in balance
/// \throw scene::Error (input) as functionals(); (ill_posed) where motions that nothing resists raise and lower one
template <int dim> std::vector<Asked<dim>> asked(const scene::Scene<dim>& scene, const scene::Problem<dim>& problem);

/// The outcome, whose last level is given, with a quantity computed on that level.
/// \param one_problem whether the levels are: then they are intersected
template <int dim>
Outcome<dim> with_quantity(Outcome<dim> outcome, const scene::Scene<dim>& scene, std::vector<Asked<dim>>& asked,
                           std::size_t which, const Examined<dim>& examined, bool one_problem);

/// Whether the quantity has a target that it has not reached.
template <int dim> bool is_wanting(const Asked<dim>& asked, const QuantityInterval& interval);

/// That an interval is empty, or those of two levels exclude each other; else nothing.
std::string contradiction(const std::vector<QuantityInterval>& quantities);

}  // namespace bracket::bounds
