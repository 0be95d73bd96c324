// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Quantities beside springs, which are bodies to the theorem (docs/theory.md §10, §11).
#include <gtest/gtest.h>

#include "bounds/quantities/evaluate.h"
#include "tests/laws/pairs.h"
#include "tests/quantities/asked.h"

namespace bracket::tests {
namespace {

using scene::Law;

std::vector<NamedLaw> springs() {
  std::vector<NamedLaw> result;
  for (const NamedLaw& law : laws())
    if (law.law == Law::winkler) result.push_back(law);
  return result;
}

// What is certified is the sum of squares of the two pairs of fields, but for rounding.
TEST(LawQuantities, WidthsBesideSpringsAreSumsOfSquares) {
  int wide = 0;
  for (const NamedLaw& law : springs())
    for (const double pull : {0.09, 0.02}) {
      const auto scene = with_law(two_blocks(4, pull), law);
      const auto problem = bounds::balanced(tests::problem(scene), 2);
      const auto displacements = std::make_shared<const primal::Solver<2>>(problem, 2);
      const auto stresses = std::make_shared<const dual::Solver<2>>(problem, 1);
      const auto u = displacements->solve(problem);
      const auto lambda = stresses->solve(problem);
      const auto certificate = bounds::certify(problem, u.displacement, lambda.stress);
      const bounds::SolvedLevel<2> level{problem,
                                         {displacements, stresses, nullptr},
                                         {u.closed, lambda.closed},
                                         certificate.lower,
                                         certificate.upper,
                                         bounds::indicator(problem, u.displacement, lambda.stress)};
      for (const auto& asked : {along(quantity(QuantityKind::displacement, "upper.top"), 1, 2),
                                quantity(QuantityKind::rotation, "upper.top"),
                                weighted(quantity(QuantityKind::force, "upper.bottom"),
                                         scene::enclosed<2>([](const auto& x) { return x[0]; })),
                                along(quantity(QuantityKind::reaction, "lower.bottom"), 1, 0)}) {
        SCOPED_TRACE(testing::Message() << law.name << " " << pull << " " << asked.name);
        const auto found = bounds::evaluate(scene, asked, level, {}, {});
        EXPECT_EQ(found.level.reason, "");
        const double width = found.level.upper - found.level.lower;
        EXPECT_GE(width, 0);
        const double rounding =
            1e-14 * std::abs(certificate.lower) / found.level.s + 1e-14 * std::abs(found.level.upper) + 1e-17;
        if (found.level.lower != 0) {  // else a force that is known not to pull, cut off
          EXPECT_NEAR(found.plain_width, width, 1e-9 * width + rounding);
        }
        EXPECT_NEAR(found.indicator.sum, found.plain_width, found.plain_width);
        wide += width > 1e-7;
      }
    }
  EXPECT_GE(wide, 16);  // of 32: others are known by statics
}

// Where p has either sign a weight or a gap between two bounds would bound nothing.
TEST(LawQuantities, OfSidesThatKeepTogetherHaveOneWeight) {
  auto scene = with_law(two_blocks(3), {"", Law::bilateral});
  const auto third = scene::enclosed<2>([](const auto& x) { return x[0] * x[0] / 3; });
  const auto force = weighted(quantity(QuantityKind::force, "upper.bottom"), third);
  const auto functional = bounds::functionals(scene, tests::problem(scene), force);
  EXPECT_EQ(functional.above, functional.below);
  auto free = scene;
  free.contact[0].law = Law::frictionless;
  EXPECT_NE(bounds::functionals(free, tests::problem(free), force).above, functional.above);

  const auto energy = quantity(QuantityKind::energy, "");
  const scene::Function<2> rounded = scene::enclosed<2>([](const auto& x) { return 0.1 * x[0] * x[0] / 3 + 0.1; });
  const scene::Function<2> exact = scene::enclosed<2>([](const auto& x) { return 0.25 + 0 * x[0]; });
  for (auto* s : {&scene, &free}) {
    s->contact[0].gap = exact;
    EXPECT_NO_THROW(bounds::functionals(*s, tests::problem(*s), energy));
  }
  scene.contact[0].gap = free.contact[0].gap = rounded;
  EXPECT_NO_THROW(bounds::functionals(free, tests::problem(free), energy));
  EXPECT_THROW(bounds::functionals(scene, tests::problem(scene), energy), scene::Error);
}

// A footing of ν = 0 under the pressure a + b x, x from its middle: u_y = −(a + b x)(y/E + 1/k), as far as the springs
// press or pull. Both spaces have it, and none of the interval is left.
TEST(LawQuantities, AFootingOnSpringsIsExact) {
  constexpr double own_young = 20, k = 4, b = 0.2, give = 1 / own_young + 1 / k;
  for (const bool pulls : {false, true}) {
    const double a = pulls ? 0.05 : 0.3;
    scene::Scene<2> s;
    s.blocks = {block("footing", -1, 1, 0, 1, 4, 2)};
    s.bodies = {{"footing", scene::isotropic<2>(own_young, 0, scene::Plane::strain)}};
    s.boundary = {{"footing.top", pressure(scene::enclosed<2>([a](const auto& x) { return a + 0.2 * x[0]; }))}};
    s.contact = {{"footing.bottom", "rigid", {}, ""}};
    const auto outcome =
        outcome_of(with_law(s, {"", Law::winkler, constant(k), !pulls}),
                   {along(quantity(QuantityKind::displacement, "footing.top"), 0, -1),
                    quantity(QuantityKind::rotation, "footing.top"), quantity(QuantityKind::force, "footing.bottom")},
                   {.strategy = scene::Strategy::uniform, .max_levels = 2});
    ASSERT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
    const std::vector<double> exact = {a * give, -b * give, 2 * a};
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const auto& found = outcome.quantities.at(i);
      SCOPED_TRACE(found.name);
      EXPECT_LE(found.lower, exact[i]);
      EXPECT_GE(found.upper, exact[i]);
      EXPECT_LE(found.upper - found.lower, 1e-6 * std::abs(exact[i]));
    }
  }
}

}  // namespace
}  // namespace bracket::tests
