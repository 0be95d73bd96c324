// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/quantities/functional.h"
#include "bounds/quantities/quantities.h"
#include "bounds/quantities/search.h"

/// A quantity on one mesh.
namespace bracket::bounds {

/// Ends of an interval that are infinite, as some motion that nothing resists changes the quantity.
struct Undetermined {
  bool below = false, above = false;
  std::string motion;  ///< one line
};

/// What a quantity has learned from the meshes before.
struct Learned {
  std::array<Guess, 2> guess;  ///< of the functional below, and of that above
  double energy_width = 0;     ///< of that mesh; 0: there was none
};

/// A solved level.
template <int dim> struct SolvedLevel {
  const scene::Problem<dim>& problem;
  Solvers<dim> solvers;
  Closed closed;
  double lower, upper;         ///< of L(u), certified
  const Indicator& indicator;  ///< of the energy
};

template <int dim> struct EvaluatedQuantity {
  QuantityLevel level;
  bool weighted = false;
  /// The width's own local terms that a finer mesh makes smaller, in the quantity's units; empty where there are none.
  Indicator indicator;
  double plain_width = 0;  ///< the width as the fields have it as computed, a sum of squares
  Learned learned;
};

/// \throw scene::Error (input) as functionals()
template <int dim>
EvaluatedQuantity<dim> evaluate(const scene::Scene<dim>& scene, const scene::Quantity<dim>& quantity,
                                const SolvedLevel<dim>& level, const Undetermined& undetermined, Learned learned);

/// The same of what functionals() has found, or of others; not of the energy where it is free.
template <int dim>
EvaluatedQuantity<dim> evaluate(const Functionals<dim>& asked, const SolvedLevel<dim>& level,
                                const Undetermined& undetermined, Learned learned);

}  // namespace bracket::bounds
