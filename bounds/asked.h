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

/// A quantity before any level.
template <int dim> QuantityInterval unknown(const Asked<dim>& asked);
/// The last level of a run, for what is asked of it.   \pre `examined` is of it
template <int dim> SolvedLevel<dim> solved_level(const Outcome<dim>& outcome, const Examined<dim>& examined);

/// A quantity as it is known after the last level of a run.
/// \param so_far after the levels before   \param examined that level
/// \param one_problem whether the levels are: then they are intersected
template <int dim>
QuantityInterval on_last_level(const Outcome<dim>& outcome, const scene::Scene<dim>& scene, Asked<dim>& asked,
                               QuantityInterval so_far, const Examined<dim>& examined, bool one_problem);

/// Whether the quantity has a target that it has not reached.
template <int dim> bool is_wanting(const Asked<dim>& asked, const QuantityInterval& interval);

/// Which of the targets asked for are met.
struct Targets {
  bool any = false;        ///< whether any was asked for
  bool energy = true;      ///< met, or not asked for
  bool quantities = true;  ///< likewise, of all
  bool met() const { return any && energy && quantities; }
};
template <int dim>
Targets targets(const Outcome<dim>& outcome, const scene::Refine& refine, const std::vector<Asked<dim>>& asked);

/// The quantities that are to be computed on the last level although it may not be the last of the run.
template <int dim>
std::vector<std::size_t> due(const Outcome<dim>& outcome, const scene::Refine& refine,
                             const std::vector<Asked<dim>>& asked);
/// All that are not known on it.
template <int dim> std::vector<std::size_t> missing(const Outcome<dim>& outcome, const std::vector<Asked<dim>>& asked);

/// The indicator by which cells are marked: the energy's, or that of the goal where it has one.
template <int dim>
const Indicator& steering(const Outcome<dim>& outcome, const scene::Refine& refine,
                          const std::vector<Asked<dim>>& asked);

/// That an interval is empty, or those of two levels exclude each other; else nothing.
std::string contradiction(const std::vector<QuantityInterval>& quantities);

}  // namespace bracket::bounds
