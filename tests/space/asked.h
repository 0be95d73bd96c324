// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/bounds.h"
#include "tests/space/scenes.h"

/// Quantities asked for in code.
namespace bracket::tests::space {

using scene::QuantityKind;
using Quantity = scene::Quantity<3>;

inline Quantity quantity(QuantityKind kind, const std::string& of) {
  Quantity result;
  result.name = name(kind) + " of " + of;
  result.kind = kind;
  result.of = of;
  return result;
}
inline Quantity along(Quantity quantity, double x, double y, double z) {
  quantity.direction = scene::Vector<3>(x, y, z);
  return quantity;
}
inline Quantity stress(const std::string& body, scene::StressComponent component) {
  Quantity result = quantity(QuantityKind::stress, body);
  result.component = component;
  result.name += " " + name(component);
  return result;
}
inline Quantity weighted(Quantity quantity, Function weight) {
  quantity.weight = std::move(weight);
  return quantity;
}

/// A scene refined as `refine` says, with the quantities on all levels.
inline bounds::Outcome<3> outcome_of(scene::Scene<3> scene, std::vector<Quantity> quantities, scene::Refine refine) {
  for (std::size_t i = 0; i < quantities.size(); ++i) quantities[i].name += " " + std::to_string(i);
  scene.quantities = std::move(quantities);
  scene.refine = std::move(refine);
  scene.refine.all_levels = true;
  return bounds::run(scene);
}

}  // namespace bracket::tests::space
