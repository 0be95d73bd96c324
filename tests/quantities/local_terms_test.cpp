// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bounds/quantities/evaluate.h"
#include "tests/quantities/asked.h"

namespace bracket::tests {
namespace {

std::vector<Quantity<2>> some_of_each() {
  auto stretch = quantity(QuantityKind::force, "upper.bottom");
  stretch.stretch = scene::LineStretch{0.25, 1};
  return {
      along(quantity(QuantityKind::displacement, "upper.top"), 1, 2),
      quantity(QuantityKind::displacement, "upper.top"),
      quantity(QuantityKind::rotation, "upper.top"),
      along(quantity(QuantityKind::body, "upper"), 0, 1),
      weighted(quantity(QuantityKind::force, "upper.bottom"), scene::enclosed<2>([](const auto& x) { return x[0]; })),
      quantity(QuantityKind::opening, "upper.bottom"),
      along(quantity(QuantityKind::reaction, "lower.bottom"), 1, 0),
      quantity(QuantityKind::reaction, "upper.left"),
      component(quantity(QuantityKind::stress, "upper"), scene::StressComponent::xx)};
}

// The width is a sum of squares of the two pairs of fields, over cells and contact facets: what is certified is that,
// but for rounding. Cells are marked by what a finer mesh makes smaller of it.
TEST(LocalTerms, add_up_to_the_width) {
  const auto scene = two_blocks(6);
  const auto problem = bounds::balanced(tests::problem(scene), 2);
  const auto displacements = std::make_shared<const primal::Solver<2>>(problem, 2);
  const auto stresses = std::make_shared<const dual::Solver<2>>(problem, 1);
  const auto u = displacements->solve(problem);
  const auto lambda = stresses->solve(problem);
  const auto certificate = bounds::certify(problem, u.displacement, lambda.stress);
  const auto indicator = bounds::indicator(problem, u.displacement, lambda.stress);
  const bounds::SolvedLevel<2> level{
      problem,  {displacements, stresses, nullptr}, {u.closed, lambda.closed}, certificate.lower, certificate.upper,
      indicator};
  int wide = 0;
  for (const auto& asked : some_of_each()) {
    SCOPED_TRACE(asked.name);
    const auto found = bounds::evaluate(scene, asked, level, {}, {});
    EXPECT_EQ(found.level.reason, "");
    const double width = found.level.upper - found.level.lower;
    EXPECT_LE(found.level.lower, found.level.upper);
    // Rounding of the energies, by s.
    const double rounding =
        1e-14 * std::abs(certificate.lower) / found.level.s + 1e-14 * std::abs(found.level.upper) + 1e-17;
    EXPECT_NEAR(found.plain_width, width, 1e-9 * width + rounding);
    double sum = 0;
    for (const auto& shares : {found.indicator.cell, found.indicator.contact})
      for (const double share : shares) {
        EXPECT_GE(share, -1e-12 * found.indicator.sum);
        sum += share;
      }
    EXPECT_NEAR(sum, found.indicator.sum, 1e-12 * sum);
    EXPECT_EQ(found.indicator.cell.size(), problem.mesh.cells.size());
    EXPECT_EQ(found.indicator.contact.size(), problem.contact.size());
    wide += width > 1e-6;
  }
  EXPECT_GE(wide, 6);  // of 9: others are known by statics
}

// Marked by the quantity's own terms, as few cells as carry half of them: its width falls faster than when the energy
// steers.
TEST(LocalTerms, steer_to_the_goal) {
  auto scene = two_blocks(4);
  const auto asked = along(quantity(QuantityKind::displacement, "upper.top"), 0, 1);
  scene.quantities = {asked};
  const auto widths = [&](const std::string& goal) {
    scene.refine = {.strategy = scene::Strategy::adaptive, .max_cells = 1500, .goal = goal, .all_levels = true};
    return bounds::run(scene).quantities.at(0).levels;
  };
  const auto by_energy = widths(""), by_goal = widths(asked.name);
  const auto constant_of = [](const std::vector<bounds::QuantityLevel>& levels) {  // width · cells^(4/3)
    return (levels.back().upper - levels.back().lower) * std::pow(levels.back().cells, 4.0 / 3);
  };
  EXPECT_LE(constant_of(by_goal), 1.1 * constant_of(by_energy));
}

}  // namespace
}  // namespace bracket::tests
