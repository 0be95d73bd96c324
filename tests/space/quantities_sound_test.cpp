// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bounds/asked.h"
#include "bounds/quantities/evaluate.h"
#include "tests/space/asked.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

// Quantities of scenes whose solution is not known.
namespace bracket {
namespace {

using namespace tests::space;
using scene::StressComponent;

scene::Quantity<2> in_plane(const Quantity& quantity) {
  scene::Quantity<2> result;
  result.name = quantity.name;
  result.kind = quantity.kind;
  result.of = quantity.of;
  result.component = quantity.component;
  if (quantity.direction) result.direction = scene::Vector<2>(quantity.direction->head<2>());
  return result;
}

// A plane scene extruded by ½ between sliding ends: forces and energies are half of the plane's, all else is the same.
TEST(QuantitiesInSpace, of_an_extruded_scene_meet_those_of_the_plane) {
  const std::vector<std::pair<Quantity, double>> asked = {
      {quantity(QuantityKind::force, "upper.bottom"), 0.5},
      {along(quantity(QuantityKind::displacement, "upper.top"), 0, 1, 0), 1},
      {quantity(QuantityKind::displacement, "lower.right"), 1},
      {along(quantity(QuantityKind::body, "upper"), 1, 2, 0), 1},
      {quantity(QuantityKind::opening, "upper.bottom"), 1},
      {along(quantity(QuantityKind::reaction, "lower.bottom"), 0, 1, 0), 0.5},
      {quantity(QuantityKind::reaction, "upper.left"), 0.5},
      {stress("upper", StressComponent::xx), 1},
      {stress("lower", StressComponent::xy), 1},
      {quantity(QuantityKind::energy, ""), 0.5}};
  std::vector<Quantity> of_space;
  scene::Scene<2> plane = tests::two_blocks(4);
  for (const auto& [one, factor] : asked) {
    of_space.push_back(one);
    plane.quantities.push_back(in_plane(one));
  }
  const int levels = tests::sanitized ? 2 : 3;
  plane.refine = {.strategy = scene::Strategy::adaptive, .max_cells = tests::sanitized ? 1000 : 4000};
  const auto known = bounds::run(plane);
  const auto found = outcome_of(two_blocks(2), of_space, {.strategy = scene::Strategy::adaptive, .max_levels = levels});
  ASSERT_EQ(known.guarantee, "rounding-safe") << known.reason;
  ASSERT_EQ(found.guarantee, "rounding-safe") << found.reason;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    SCOPED_TRACE(asked[i].first.name);
    const auto &exact = known.quantities[i], &interval = found.quantities[i];
    EXPECT_EQ(interval.reason, "");
    ASSERT_EQ(interval.levels.size(), static_cast<std::size_t>(levels));
    const double factor = asked[i].second, rounding = 1e-14 * std::abs(exact.upper);
    for (const auto& level : interval.levels) {
      EXPECT_LE(level.lower, factor * exact.upper + rounding);
      EXPECT_GE(level.upper, factor * exact.lower - rounding);
      EXPECT_GT(level.upper - level.lower, factor * (exact.upper - exact.lower));  // coarse
    }
    const auto width = [](const bounds::QuantityLevel& level) { return level.upper - level.lower; };
    EXPECT_LT(width(interval.levels.back()), width(interval.levels.front()));
  }
}

/// Some of each kind of what scenes with the parts of everything() can be asked.
std::vector<Quantity> some_of_each(std::mt19937& generator) {
  std::uniform_real_distribution<double> number(-1, 1);
  const auto direction = [&](Quantity of) {
    const double x = number(generator), y = number(generator);
    return along(std::move(of), x, y, number(generator));
  };
  const double a = number(generator), b = number(generator), c = number(generator);
  const auto linear = scene::enclosed<3>([=](const auto& x) { return a * x[0] + b * x[2] + c; });
  const auto bent = scene::enclosed<3>([=](const auto& x) { return a * x[0] * x[2] + b * x[0] * x[0] + c; });
  return {direction(quantity(QuantityKind::displacement, "upper.top")),
          quantity(QuantityKind::displacement, "upper.left"),
          direction(quantity(QuantityKind::body, "lower")),
          quantity(QuantityKind::force, "upper.bottom"),
          weighted(quantity(QuantityKind::force, "upper.bottom"), bent),
          quantity(QuantityKind::opening, "lower.bottom"),
          weighted(quantity(QuantityKind::opening, "upper.bottom"), linear),
          direction(quantity(QuantityKind::reaction, "upper.right")),
          quantity(QuantityKind::reaction, "lower.left"),
          stress("upper", StressComponent::xz),
          stress("lower", StressComponent::zz),
          stress("lower", StressComponent::mean),
          quantity(QuantityKind::energy, "")};
}

/// everything(), with random moduli, loads and gaps.
scene::Scene<3> something(int n, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(0, 1);
  scene::Scene<3> s = everything(n);
  s.bodies.at("upper") = isotropic(0.5 + 5 * number(generator), 0.45 * number(generator));
  const double pull = 0.2 * number(generator) - 0.1, open = 0.02 * number(generator) - 0.01,
               bent = 0.05 * number(generator);
  s.boundary.at("upper.top") = traction(pull, -0.05, number(generator) / 20);
  s.contact[0].gap = scene::enclosed<3>([=](const auto& x) { return open + bent * (x[0] - 0.5) * x[2]; });
  if (seed % 2 == 0) s.contact[1].law = scene::Law::bilateral;
  return s;
}

// Each is an interval around one number, on whatever mesh; where its weight falls to zero over the faces of the first
// mesh, on those that begin with the same.
TEST(QuantitiesInSpace, of_three_meshes_never_exclude_each_other) {
  const unsigned seeds = tests::sanitized ? 2 : 4;
  unsigned narrow = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    std::mt19937 generator(seed);
    std::vector<Quantity> asked = some_of_each(generator);
    if (seed % 2 == 0)  // the sides keep together
      std::erase_if(asked,
                    [](const Quantity& one) { return one.kind == QuantityKind::opening && one.of == "lower.bottom"; });
    const auto coarse = outcome_of(something(1, seed), asked, {.strategy = scene::Strategy::adaptive, .max_levels = 2});
    const auto fine = outcome_of(something(tests::sanitized ? 1 : 2, seed), asked, {});
    ASSERT_EQ(coarse.guarantee, "rounding-safe") << coarse.reason;
    ASSERT_EQ(fine.guarantee, "rounding-safe") << fine.reason;
    for (std::size_t i = 0; i < asked.size(); ++i) {
      SCOPED_TRACE(asked[i].name + " of seed " + std::to_string(seed));
      double lower = -INFINITY, upper = INFINITY;
      for (const auto* of : {&coarse.quantities[i], &fine.quantities[i]}) {
        EXPECT_EQ(of->reason, "");
        if (of->weighted && of == &fine.quantities[i]) continue;
        for (const auto& level : of->levels) {
          lower = std::max(lower, level.lower);
          upper = std::min(upper, level.upper);
        }
      }
      EXPECT_LE(lower, upper);
      narrow += upper - lower < 0.2 * std::max(std::abs(lower), std::abs(upper));
    }
  }
  if (!tests::sanitized) {  // there the meshes are coarse
    EXPECT_GE(narrow, 12U);
  }
}

// The problems with data added, loads on contact faces among them, have both formulations and the gap identity.
TEST(QuantitiesInSpace, perturb_problems_that_are_problems) {
  scene::Scene<3> s = everything(tests::sanitized ? 1 : 2);
  const auto problem = bounds::balanced(scene::fix_data(s, scene::build_mesh(s)), 2);
  const primal::Solver<3> displacements(problem, 2, true);
  const bounds::LocalStresses<3> stresses(displacements, problem, 1, true);
  std::mt19937 generator(11);
  for (const auto& one : some_of_each(generator)) {
    SCOPED_TRACE(one.name);
    const auto by = bounds::functionals(s, problem, one).above;
    for (const double loads : {0.0078125, -0.0078125}) {
      const auto perturbed = scene::perturbed(problem, by, loads, -loads);
      const auto u = displacements.solve(perturbed);
      const auto lambda = stresses.solve(perturbed);
      ASSERT_EQ(u.reason + lambda.reason, "");
      const auto certificate = bounds::certify(perturbed, u.displacement, lambda.stress);
      ASSERT_TRUE(certificate.valid) << certificate.reason;
      const auto indicator = bounds::indicator(perturbed, u.displacement, lambda.stress);
      const auto plain = bounds::plain_energies(perturbed, u.displacement, lambda.stress, indicator);
      EXPECT_LE(plain.gap_identity, 1e-10);
      EXPECT_NEAR(plain.upper, certificate.upper, 1e-10 * std::abs(plain.upper));
      EXPECT_NEAR(plain.lower, certificate.lower, 1e-10 * std::abs(plain.lower));
    }
  }
}

// The width is a sum of squares of the two pairs of fields, over cells and contact facets: what is certified is that,
// but for rounding, on a refined mesh, too.
TEST(QuantitiesInSpace, have_local_terms_that_add_up_to_the_width) {
  scene::Scene<3> s = everything(tests::sanitized ? 1 : 2);
  const auto first = bounds::balanced(scene::fix_data(s, scene::build_mesh(s)), 2);
  std::vector<char> marked(first.mesh.cells.size(), 0);
  marked[3] = 1;
  std::mt19937 generator(7);
  const auto asked = some_of_each(generator);
  for (const auto& problem : {first, scene::refine(first, marked).problem}) {
    const auto displacements = std::make_shared<const primal::Solver<3>>(problem, 2, true);
    const auto u = displacements->solve(problem);
    const auto stresses = std::make_shared<const bounds::LocalStresses<3>>(*displacements, problem, 1, true);
    const auto lambda = stresses->solve(problem);
    const auto certificate = bounds::certify(problem, u.displacement, lambda.stress);
    ASSERT_TRUE(certificate.valid) << certificate.reason;
    const auto indicator = bounds::indicator(problem, u.displacement, lambda.stress);
    const bounds::SolvedLevel<3> level{
        problem,  {displacements, nullptr, stresses}, {u.closed, lambda.closed}, certificate.lower, certificate.upper,
        indicator};
    for (const auto& one : asked) {
      SCOPED_TRACE(one.name);
      const auto found = bounds::evaluate(s, one, level, {}, {});
      EXPECT_EQ(found.level.reason, "");
      const double width = found.level.upper - found.level.lower;
      EXPECT_GT(width, 0);
      const auto functional = bounds::functionals(s, problem, one);
      const double two =
          (upper(functional.offset_above - functional.offset_below) + 1e-13 * std::abs(found.level.upper)) /
          static_cast<double>(functional.scale.middle);  // weights and gaps known up to rounding
      const double rounding = 1e-14 * std::abs(certificate.lower) / found.level.s + two;
      if (found.level.lower != 0) {  // else it is known not to be negative
        EXPECT_NEAR(found.plain_width, width, 1e-8 * width + rounding);
      }
      double sum = 0;
      for (const auto& shares : {found.indicator.cell, found.indicator.contact})
        for (const double share : shares) {
          EXPECT_GE(share, -1e-12 * found.indicator.sum);
          sum += share;
        }
      EXPECT_NEAR(sum, found.indicator.sum, 1e-12 * sum);
    }
  }
}

// Marked by the quantity's own terms its width falls faster than when the energy steers.
TEST(QuantitiesInSpace, steer_to_the_goal) {
  scene::Scene<3> s = two_blocks(2);
  const Quantity asked = along(quantity(QuantityKind::displacement, "upper.top"), 0, 1, 0);
  s.quantities = {asked};
  const auto last = [&](const std::string& goal) {
    s.refine = {.strategy = scene::Strategy::adaptive,
                .max_cells = tests::sanitized ? 150 : 500,
                .goal = goal,
                .all_levels = true};
    const auto levels = bounds::run(s).quantities.at(0).levels;
    return (levels.back().upper - levels.back().lower) * levels.back().cells;
  };
  EXPECT_LE(last(asked.name), 1.1 * last(""));
}

}  // namespace
}  // namespace bracket
