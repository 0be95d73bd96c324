// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/quantities/known.h"
#include "tests/space/asked.h"
#include "tests/support/sanitized.h"

// Quantities of scenes whose solution is known: their exact values are in each level's interval.
namespace bracket {
namespace {

using namespace tests::space;
using scene::StressComponent;

using Exact = tests::KnownQuantity<3>;

void expect_inside(const scene::Scene<3>& scene, const std::vector<Exact>& known, const scene::Refine& refine,
                   std::size_t levels) {
  tests::expect_inside(outcome_of(scene, tests::quantities_of(known), refine), known, levels);
}

const int exact_levels = tests::sanitized ? 1 : 2;
const scene::Refine uniform = {.strategy = scene::Strategy::uniform, .max_levels = exact_levels};

template <class F> Function of(F f) { return scene::enclosed<3>(f); }

// p = 1e4 on a unit square, u_z linear, strain energy 50: statics and a linear problem. The bodies float sideways.
TEST(QuantitiesInSpace, of_a_patch_are_exact) {
  for (const double poisson : {0.3, 0.0}) {
    if (tests::sanitized && poisson == 0) break;
    const auto force = quantity(QuantityKind::force, "upper.back");
    expect_inside(patch(2, poisson),
                  {{force, 1e4, 1e-5},
                   {weighted(force, of([](const auto& x) { return x[0]; })), 5e3, 1e-5},
                   {along(quantity(QuantityKind::reaction, "upper.front"), 0, 0, 1), -1e4, 1e-5},
                   {quantity(QuantityKind::reaction, "lower.back"), -1e4, 1e-5},
                   {along(quantity(QuantityKind::body, "upper"), 0, 0, 1), -0.0075, 1e-10},
                   {along(quantity(QuantityKind::displacement, "lower.right"), 0, 0, -2), 0.0025, 1e-8},
                   {stress("lower", StressComponent::zz), -1e4, 1e-4},
                   {stress("upper", StressComponent::xx), 0, 1e-4},
                   {stress("upper", StressComponent::yz), 0, 1e-4},
                   {stress("upper", StressComponent::mean), -1e4 / 3, 1e-4},
                   {quantity(QuantityKind::opening, "upper.back"), 0, 1e-8},
                   {quantity(QuantityKind::energy, ""), 50, 1e-6}},
                  uniform, exact_levels);
  }
}

// docs/theory.md §12.5: σ_zz = −(1 − x/2 − y/4), u_z = (z + 1) σ_zz below and (1 + z/2) σ_zz above.
TEST(QuantitiesInSpace, of_a_linear_pressure_are_exact) {
  const auto force = quantity(QuantityKind::force, "upper.back");
  const auto top = quantity(QuantityKind::displacement, "upper.front");
  std::vector<Exact> known = {
      {force, 4, 1e-8},
      {weighted(force, of([](const auto& x) { return x[0]; })), -2.0 / 3, 1e-8},
      {weighted(force, of([](const auto& x) { return x[1]; })), -1.0 / 3, 1e-8},
      {weighted(force, of([](const auto& x) { return 1 - x[0] * x[0] + x[0] * x[1]; })), 8.0 / 3, 1e-6},
      {along(top, 0, 0, 1), -1.5, 1e-8},
      {top, -1.5, 1e-8},
      {along(quantity(QuantityKind::rotation, "upper.front"), 1, 0, 0), 0.375, 1e-7},
      {along(quantity(QuantityKind::rotation, "upper.front"), 0, -2, 0), 0.75, 1e-7},
      {along(quantity(QuantityKind::body, "upper"), 0, 0, 1), -1.25, 1e-8},
      {along(quantity(QuantityKind::reaction, "lower.back"), 0, 0, 3), 4, 1e-8},
      {stress("lower", StressComponent::zz), -1, 1e-8},
      {stress("upper", StressComponent::xy), 0, 1e-8},
      {stress("upper", StressComponent::yy), 0, 1e-8},
      {quantity(QuantityKind::opening, "upper.back"), 0, 1e-6},
      {quantity(QuantityKind::energy, ""), 3.3125, 1e-8}};
  // On the first mesh alone rounding leaves a little more.
  if (exact_levels > 1) known.push_back({along(quantity(QuantityKind::body, "lower"), 0, 0, 1), -0.5, 1e-8});
  expect_inside(linear_pressure(2, 0.3), known, uniform, exact_levels);
}

// A block that hangs from its top and does not reach the wall: the mean opening is the gap less what it sinks, ½ w.
TEST(QuantitiesInSpace, of_what_does_not_touch) {
  scene::Scene<3> s;
  s.blocks = {block("block", {0, 2}, {0, 1}, {0, 1}, {2, 1, 2})};
  s.bodies = {{"block", isotropic(1, 0)}};
  s.bodies.at("block").force = {0, 0, -0.125};
  s.boundary = {{"block.front", sliding()}, {"block.left", sliding()}, {"block.bottom", sliding()}};
  s.contact = {{"block.back", "rigid", of([](const auto& x) { return 0.25 + 0.125 * x[0]; }), ""}};
  const auto opening = quantity(QuantityKind::opening, "block.back");
  expect_inside(
      s,
      {{opening, 0.25 + 0.125 - 0.0625, 1e-6},
       {weighted(opening, of([](const auto& x) { return x[0]; })), 2 * 0.1875 + 1.0 / 3, 1e-6},
       {weighted(opening, of([](const auto& x) { return 1 - x[0]; })), 2 * 0.3125 - 2 * 0.1875 - 1.0 / 3, 1e-6},
       {quantity(QuantityKind::force, "block.back"), 0, 1e-6},
       {along(quantity(QuantityKind::reaction, "block.front"), 0, 0, 1), 0.25, 1e-8},
       {quantity(QuantityKind::energy, ""), 0.125 * 0.125 / 3, 1e-3}},
      uniform, exact_levels);
}

}  // namespace
}  // namespace bracket
