// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Quantities where each mesh is a polygon, and a problem, of its own.
#include <gtest/gtest.h>

#include "tests/quantities/asked.h"
#include "tests/support/sanitized.h"

namespace bracket::tests {
namespace {

/// The quarter of a bush in a hub with interference, its arcs followed.
scene::Scene<2> shrink_fit() {
  scene::Scene<2> scene = scene::read_scene<2>(BRACKET_SCENES "/shrink_fit.toml");
  for (const char* part : {"bush.outer", "hub.inner"}) scene.curves[part] = {};
  return scene;
}

TEST(QuantitiesOnArcs, are_those_of_the_last_polygon) {
  scene::Scene<2> scene = shrink_fit();
  scene.contact[0].zones = 3;
  const std::vector<Quantity<2>> asked = {
      quantity(QuantityKind::force, "bush.outer"),
      component(quantity(QuantityKind::stress, "hub"), scene::StressComponent::mean)};
  const auto outcome = outcome_of(scene, asked, {.strategy = scene::Strategy::uniform, .max_levels = 2});
  ASSERT_NE(outcome.guarantee, "none") << outcome.reason;
  ASSERT_EQ(outcome.quantities.size(), 5u);
  for (const auto& one : outcome.quantities) {
    ASSERT_EQ(one.levels.size(), 2u);
    EXPECT_EQ(one.lower, one.levels[1].lower);
    EXPECT_EQ(one.upper, one.levels[1].upper);
  }
  // The line has become longer, and the zones with it: from both of its ends the scene is the same.
  const auto &begin = outcome.quantities[2], &end = outcome.quantities[4];
  EXPECT_LT(std::abs(begin.lower - end.lower), 0.1 * (begin.upper - begin.lower));
  EXPECT_LT(std::abs(begin.upper - end.upper), 0.1 * (begin.upper - begin.lower));
  // Another polygon, another stress: intersected they would contradict each other.
  EXPECT_LT(outcome.quantities[1].levels[0].upper, outcome.quantities[1].levels[1].lower);

  if (sanitized) return;
  // That polygon as a problem of its own, on the same mesh with a higher degree.
  scene.curves.clear();
  scene.solve.degree = 3;
  scene.quantities = asked;
  scene.refine = {.strategy = scene::Strategy::none};
  const auto polygon = bounds::run(scene, outcome.problem);
  ASSERT_NE(polygon.guarantee, "none") << polygon.reason;
  for (std::size_t i = 0; i < polygon.quantities.size(); ++i) {
    const auto &one = outcome.quantities[i], &known = polygon.quantities[i];
    SCOPED_TRACE(one.name);
    EXPECT_LE(std::max(one.lower, known.lower), std::min(one.upper, known.upper));
  }
}

}  // namespace
}  // namespace bracket::tests
