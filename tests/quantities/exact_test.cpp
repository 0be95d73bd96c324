// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/quantities/asked.h"
#include "tests/quantities/known.h"

// Quantities of scenes whose solution is known: their exact values are in each level's interval.
namespace bracket::tests {
namespace {

using Known = KnownQuantity<2>;

void expect_inside(const scene::Scene<2>& scene, const std::vector<Known>& known, const scene::Refine& refine,
                   std::size_t levels) {
  tests::expect_inside(outcome_of(scene, quantities_of(known), refine), known, levels);
}

const scene::Refine three_uniform = {.strategy = scene::Strategy::uniform, .max_levels = 3};

double modulus(double young, double poisson) { return young / (1 - poisson * poisson); }  // E'

// A confined block: M = E (1 − ν)/((1 + ν)(1 − 2 ν)) = 6, the top goes down by p H/M. The functional's load is that of
// the pressure, so that s = p leaves none of it; a shear along a wall is no polynomial's, and s as small as rounding
// lets.
TEST(ExactQuantities, pressure_that_the_perturbation_may_take_off) {
  for (const double p : {1.0, 2.0, 3.0, 4.0}) {
    scene::Scene<2> s;
    s.blocks = {block("seal", 0, 4, 0, 3, 4, 3)};
    s.bodies = {{"seal", scene::isotropic<2>(5, 0.25, scene::Plane::strain)}};
    s.boundary = {{"seal.left", sliding(0)}, {"seal.right", sliding(0)}, {"seal.top", pressure(constant(p))}};
    s.contact = {{"seal.bottom", "rigid", constant(0), ""}};
    expect_inside(s,
                  {{along(quantity(QuantityKind::displacement, "seal.top"), 0, -1), p / 2, 1e-9},
                   {along(quantity(QuantityKind::displacement, "seal.left"), 0, -1), p / 4, 1e-6},
                   {along(quantity(QuantityKind::displacement, "seal.left"), 3, -4), 0.2 * p, 1e-6},
                   {quantity(QuantityKind::displacement, "seal.bottom"), 0, 1e-9},
                   {quantity(QuantityKind::force, "seal.bottom"), 4 * p, 1e-9}},
                  three_uniform, 3);
  }
}

// docs/theory.md §9.3: p = p₀ (1 − c x), uniaxial stresses, quadratic displacements: statics, and a linear problem.
TEST(ExactQuantities, linear_pressure) {
  const LinearPressure p;  // p₀ = 1, c = ½, t = 1 and ½, E = 1 and 2, ν = 0.3
  const double lower = modulus(p.young_lower, p.poisson), upper = modulus(p.young_upper, p.poisson);
  const auto force = quantity(QuantityKind::force, "upper.bottom");
  const auto x = scene::enclosed<2>([](const auto& at) { return at[0]; });
  const auto bend = scene::enclosed<2>([](const auto& at) { return at[0] * at[0]; });
  // Over both layers u_y(top) = −∫ p/E', whose mean over x is that of p; and a turn of the top by c p₀ Σ t/E'.
  const double soft = p.t_lower / lower + p.t_upper / upper;
  const auto stress = [](const std::string& body, scene::StressComponent of) {
    return component(quantity(QuantityKind::stress, body), of);
  };
  expect_inside(linear_pressure(p, 4, 2),
                {{force, 2, 2e-10},
                 {weighted(force, x), -2 * p.c / 3, 1e-10},
                 {weighted(force, bend), 2.0 / 3, 1e-7},
                 {weighted(force, scene::enclosed<2>([](const auto& at) { return 1 - at[0] * at[0]; })), 4.0 / 3, 1e-7},
                 {along(quantity(QuantityKind::displacement, "upper.top"), 0, 1), -soft, 1e-9},
                 {along(quantity(QuantityKind::displacement, "upper.top"), 0, -2), soft, 1e-9},
                 {quantity(QuantityKind::displacement, "upper.top"), -soft, 1e-9},
                 {along(quantity(QuantityKind::body, "lower"), 0, 1), -p.t_lower / lower / 2, 1e-8},
                 {along(quantity(QuantityKind::displacement, "upper.bottom"), 0, 1), -p.t_lower / lower, 1e-9},
                 {quantity(QuantityKind::displacement, "lower.top"), -p.t_lower / lower, 1e-9},
                 {along(quantity(QuantityKind::reaction, "lower.bottom"), 0, 1), 2, 2e-10},
                 {quantity(QuantityKind::reaction, "lower.bottom"), -2, 2e-10},
                 {stress("lower", scene::StressComponent::yy), -1, 1e-10},
                 {stress("upper", scene::StressComponent::yy), -1, 1e-10},
                 {stress("upper", scene::StressComponent::xx), 0, 1e-10},
                 {stress("upper", scene::StressComponent::xy), 0, 1e-10},
                 {stress("lower", scene::StressComponent::mean), -0.5, 1e-10},
                 {quantity(QuantityKind::opening, "upper.bottom"), 0, 1e-7},
                 {quantity(QuantityKind::energy, ""), (1 + p.c * p.c / 3) * soft, 1e-9}},
                three_uniform, 3);
}

// docs/theory.md §9.1: p = E Δ on unit height (ν = 0), strain energy ½ p Δ. The energy follows from no loads.
// The mean stress' width is rounding by s, and s a power of two: from processor to processor it is up to twice as wide.
TEST(ExactQuantities, patch) {
  expect_inside(patch(1e6, 0, 0.01, 2),
                {{quantity(QuantityKind::force, "upper.bottom"), 1e4, 1e-6},
                 {along(quantity(QuantityKind::reaction, "upper.top"), 0, 1), -1e4, 1e-6},
                 {quantity(QuantityKind::reaction, "lower.bottom"), -1e4, 1e-6},
                 {along(quantity(QuantityKind::body, "upper"), 0, 1), -0.0075, 1e-12},
                 {component(quantity(QuantityKind::stress, "lower"), scene::StressComponent::yy), -1e4, 4e-6},
                 {quantity(QuantityKind::energy, ""), 50, 1e-8}},
                three_uniform, 3);
}

// A block that does not reach the wall: the mean opening is the gap less what the weight lets it sink.
TEST(ExactQuantities, opening_that_stays) {
  scene::Scene<2> s;
  s.blocks = {block("block", 0, 2, 0, 1, 2, 2)};
  s.bodies = {{"block", scene::isotropic<2>(1, 0, scene::Plane::strain)}};
  s.bodies.at("block").force = {0, -0.125};
  s.boundary = {{"block.top", sliding(0)}, {"block.left", sliding(0)}};
  s.contact = {{"block.bottom", "rigid", scene::enclosed<2>([](const auto& x) { return 0.25 + 0.125 * x[0]; }), ""}};
  // It hangs from its top: u_y(bottom) = −½ w. Strain energy ½ ∫ (w y)² over 2 × 1.
  const auto opening = quantity(QuantityKind::opening, "block.bottom");
  auto stretch = opening;
  stretch.stretch = scene::LineStretch{0, 1};  // from the left end as seen from inside: x from 2 down to 1
  expect_inside(
      s,
      {{opening, 0.25 + 0.125 - 0.0625, 1e-7},
       {stretch, 0.25 + 0.125 * 1.5 - 0.0625, 0.5},
       {weighted(opening, scene::enclosed<2>([](const auto& x) { return x[0]; })), 2 * 0.1875 + 1.0 / 3, 1e-7},
       {quantity(QuantityKind::force, "block.bottom"), 0, 1e-7},
       {along(quantity(QuantityKind::reaction, "block.top"), 0, 1), 0.25, 1e-9},
       {quantity(QuantityKind::energy, ""), 0.125 * 0.125 / 3, 1e-4}},
      three_uniform, 3);
}

// docs/theory.md §9.5: p = √|x| for x < 0, from the mesh of three_halves.toml, which carries the tractions to 1e-7.
TEST(ExactQuantities, free_contact_boundary) {
  const auto scene = scene::read_scene<2>(BRACKET_SCENES "/three_halves.toml", {"mesh.block.0.cells=[32, 16]"});
  const auto force = quantity(QuantityKind::force, "block.bottom");
  const auto falling = scene::enclosed<2>([](const auto& x) {
    return scene::choose(x[0] < -0.5, 0 * x[0] + 1, scene::choose(x[0] < -0.25, -4 * x[0] - 1, 0 * x[0]));
  });
  const auto slope = scene::enclosed<2>([](const auto& x) { return -x[0]; });
  const auto bend = scene::enclosed<2>([](const auto& x) { return x[0] * x[0]; });
  const double exact = 2.0 / 3 * (1 - std::pow(0.5, 1.5)) + 1.6 * (std::pow(0.5, 2.5) - std::pow(0.25, 2.5)) -
                       2.0 / 3 * (std::pow(0.5, 1.5) - std::pow(0.25, 1.5));
  ASSERT_NEAR(exact, 0.5114382, 1e-7);
  auto stretch = force;
  stretch.stretch = scene::LineStretch{1.5, 2};  // x from −½ to −1
  expect_inside(scene,
                {{weighted(force, falling), exact, 5e-5},
                 {weighted(force, slope), 0.4, 5e-5},
                 {weighted(force, bend), 2.0 / 7, 5e-5},
                 {stretch, 2.0 / 3 * (1 - std::pow(0.5, 1.5)), 0.1}},
                {.strategy = scene::Strategy::adaptive, .max_levels = 4}, 4);
}

// From theory's first mesh, widths not above its table (64 cells: 5.8e-3, 786: 7.1e-5, slope between) by more than 1.2.
TEST(ExactQuantities, widths_fall_as_the_theory_says) {
  const auto scene = scene::read_scene<2>(BRACKET_SCENES "/three_halves.toml", {"mesh.block.0.cells=[8, 4]"});
  const auto falling = scene::enclosed<2>([](const auto& x) {
    return scene::choose(x[0] < -0.5, 0 * x[0] + 1, scene::choose(x[0] < -0.25, -4 * x[0] - 1, 0 * x[0]));
  });
  auto plain = bounds::balanced(scene::fix_data(scene, scene::build_mesh(scene)), 2);  // its data are not resolved
  scene::Scene<2> with = scene;
  with.quantities = {weighted(quantity(QuantityKind::force, "block.bottom"), falling)};
  with.refine = {.strategy = scene::Strategy::adaptive, .max_cells = 1200, .all_levels = true};
  const auto outcome = bounds::run(with, plain);
  ASSERT_EQ(outcome.quantities.size(), 1u);
  ASSERT_GE(outcome.quantities[0].levels.size(), 5u);
  for (const auto& level : outcome.quantities[0].levels) {
    const double order = std::log(5.8e-3 / 7.1e-5) / std::log(786.0 / 64);
    const double expected = 5.8e-3 * std::pow(64.0 / level.cells, order);
    EXPECT_LE(level.upper - level.lower, 1.2 * expected) << level.cells << " cells";
  }
}

}  // namespace
}  // namespace bracket::tests
