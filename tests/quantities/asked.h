// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "bounds/bounds.h"
#include "tests/support/scenes.h"

/// Quantities asked for in code.
namespace bracket::tests {

using scene::Quantity;
using scene::QuantityKind;

inline Quantity<2> quantity(QuantityKind kind, const std::string& of) {
  Quantity<2> result;
  result.name = name(kind) + " of " + of;
  result.kind = kind;
  result.of = of;
  return result;
}
inline Quantity<2> along(Quantity<2> quantity, double x, double y) {
  quantity.direction = Vector<2>(x, y);
  return quantity;
}
inline Quantity<2> component(Quantity<2> quantity, scene::StressComponent component) {
  quantity.component = component;
  quantity.name += " " + name(component);
  return quantity;
}
inline Quantity<2> weighted(Quantity<2> quantity, scene::Function<2> weight) {
  quantity.weight = std::move(weight);
  return quantity;
}

/// A scene refined as `refine` says, with the quantities on all levels.
inline bounds::Outcome<2> outcome_of(scene::Scene<2> scene, std::vector<Quantity<2>> quantities, scene::Refine refine) {
  for (std::size_t i = 0; i < quantities.size(); ++i) quantities[i].name += " " + std::to_string(i);
  scene.quantities = std::move(quantities);
  scene.refine = std::move(refine);
  scene.refine.all_levels = true;
  return bounds::run(scene);
}

}  // namespace bracket::tests
