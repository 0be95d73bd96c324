// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "scene/function.h"
#include "scene/options.h"

/// What is asked of a scene beside its energy.
namespace bracket::scene {

/// A stretch of a contact line by arc length of its first side, from the left end as seen from inside of its body.
struct LineStretch {
  double from = 0, to = 0;
};

/// A quantity of interest, to be had as an interval.
template <int dim> struct Quantity {
  std::string name;  ///< one of its own in the scene
  QuantityKind kind = QuantityKind::energy;
  std::string of;  ///< displacement, rotation, reaction: a boundary part; body, stress: a body; force, opening,
                   ///< slip: a contact, by its name or its first part; empty for the energy
  std::optional<Vector<dim>> direction;  ///< of displacement, body and reaction, of any length; nothing: the outward
                                         ///< normal (not of bodies); in space the axis of a rotation
  StressComponent component = StressComponent::mean;
  ForceComponent of_force = ForceComponent::normal;  ///< ∫ p of a contact, or ∫ τ (scene/problem/law.h)
  std::optional<LineStretch> stretch;                ///< of a contact; nothing: the whole of it
  Function<dim> weight;  ///< in place of a stretch: ∫ weight · p, ∫ weight · opening; empty: none
  double target = 0;     ///< width to reach by the larger of the bounds' sizes; 0: none asked
  double absolute = 0;   ///< width to reach, in the quantity's own units; 0: none asked
  std::string where = {};
};

/// Whether it is a force along the normal of a contact.
template <int dim> bool is_pressing_force(const Quantity<dim>& quantity) {
  return quantity.kind == QuantityKind::force && quantity.of_force == ForceComponent::normal;
}
/// Whether it is of a contact.
template <int dim> bool is_of_contact(const Quantity<dim>& quantity) {
  using enum QuantityKind;
  return quantity.kind == force || quantity.kind == opening || quantity.kind == slip;
}

}  // namespace bracket::scene
