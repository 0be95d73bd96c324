// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/compare/exact.h"

#include <gtest/gtest.h>

#include "tests/compare/admissible.h"
#include "tests/compare/scene_files.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

namespace bracket::tests {
namespace {

std::string cells(int block, int nx, int ny) {
  return "mesh.block." + std::to_string(block) + ".cells=[" + std::to_string(nx) + "," + std::to_string(ny) + "]";
}

TEST(Exact, patch_on_every_mesh) {  // docs/theory.md §9.1
  for (const double poisson : {0.0, 0.3, 0.49})
    for (const int n : {1, 2, 5})
      for (const int degree : {1, 2, 3, 4}) {
        auto scene = patch(1e6, poisson, 0.01, n);
        scene.solve.degree = degree;
        const auto outcome = bounds::run(scene);
        expect_admissible(outcome);
        const double exact = patch_energy(plane_modulus(1e6, poisson), 0.01, 1, 1);
        EXPECT_NEAR(outcome.levels[0].bracket.lower, exact, 1e-12 * exact);
        EXPECT_NEAR(outcome.levels[0].bracket.upper, exact, 1e-12 * exact);
      }
}

double exact_energy(const LinearPressure& p) {
  return linear_pressure_energy(p.p0, p.c, {p.t_lower, plane_modulus(p.young_lower, p.poisson)},
                                {p.t_upper, plane_modulus(p.young_upper, p.poisson)});
}

TEST(Exact, linear_pressure_on_every_mesh) {  // docs/theory.md §9.3
  for (const double share : {-1.0, 0.0, 0.5, 1.0})
    for (const auto& [nx, ny] : {std::pair{1, 1}, {4, 2}, {7, 5}})
      for (const int degree : {1, 2, 3, 4}) {
        // Where the pressure of a single edge vanishes at its end, rounding decides whether there is one.
        const double c = nx == 1 ? 0.9 * share : share;
        const LinearPressure p{.p0 = 3, .c = c};
        auto scene = linear_pressure(p, nx, ny);
        scene.solve.degree = degree;
        const auto outcome = bounds::run(scene);
        expect_admissible(outcome);
        const double exact = exact_energy(p);
        const auto& bracket = outcome.levels[0].bracket;
        EXPECT_NEAR(bracket.lower, exact, 1e-12 * std::abs(exact)) << c << " " << nx << " " << degree;
        if (degree > 1) {
          EXPECT_NEAR(bracket.upper, exact, 1e-12 * std::abs(exact)) << c << " " << nx;
        } else {
          EXPECT_GE(bracket.upper, exact - 1e-12 * std::abs(exact));
        }
      }
}

TEST(Exact, modulus_ratios_from_1e_minus_12_to_1e12) {
  for (const double ratio : {1e-12, 1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9, 1e12}) {
    const LinearPressure p{.young_lower = 1, .young_upper = ratio};
    const auto outcome = bounds::run(linear_pressure(p, 6, 4));
    const double exact = exact_energy(p);
    EXPECT_EQ(outcome.guarantee, "rounding-safe") << ratio << ": " << outcome.reason;
    EXPECT_NEAR(outcome.levels[0].bracket.lower, exact, 1e-9 * std::abs(exact)) << ratio;
    EXPECT_NEAR(outcome.levels[0].bracket.upper, exact, 1e-9 * std::abs(exact)) << ratio;
  }
}

TEST(Exact, units_do_not_matter) {
  for (const double length : {1e-9, 1e9})
    for (const double force : {1e-9, 1e9}) {
      auto scene = linear_pressure(
          {.young_lower = force / (length * length), .young_upper = 2 * force / (length * length)}, 4, 2);
      scene.boundary["upper.top"] = pressure(
          scene::enclosed<2>([=](const auto& x) { return force / (length * length) * (1 - 0.5 * x[0] / length); }));
      for (auto& b : scene.blocks)
        for (auto& range : b.range)
          for (double& x : range) x *= length;
      const auto outcome = bounds::run(scene);
      const double exact = exact_energy({}) * force;  // per unit thickness: force/length · length
      EXPECT_NEAR(outcome.levels[0].bracket.lower, exact, 1e-12 * std::abs(exact));
      EXPECT_NEAR(outcome.levels[0].bracket.upper, exact, 1e-12 * std::abs(exact));
    }
}

TEST(Exact, wavy_wall_at_every_level) {  // docs/theory.md §9.4
  const double exact = westergaard_energy({1, 0.3, 0.01, 2, 0.25});
  EXPECT_NEAR(exact, -4.32369522656338e-5, 1e-18);
  for (const int n : {2, 4, 8, 16})
    for (const int degree : {1, 2, 3, 4}) {
      const auto outcome =
          bounds::run(from_file("westergaard", {cells(0, n, 4 * n), "solve.degree=" + std::to_string(degree)}));
      expect_admissible(outcome);
      expect_between(outcome.levels[0], exact, 1e-12);
    }
}

TEST(Exact, free_contact_boundary_at_every_level) {  // docs/theory.md §9.5
  const double exact = three_halves_energy(1, 0.3);
  EXPECT_NEAR(exact, -0.6465903804122597, 1e-15);
  for (const int n : {2, 4, 8, 16})
    for (const int degree : {1, 2, 3, 4}) {
      const auto outcome =
          bounds::run(from_file("three_halves", {cells(0, 2 * n, n), "solve.degree=" + std::to_string(degree)}));
      expect_admissible(outcome);
      expect_between(outcome.levels[0], exact, 1e-12);
    }
}

TEST(Exact, weight_on_an_inclined_wall_is_exact_on_its_mesh) {
  const auto outcome = bounds::run(from_file("gravity"));
  expect_admissible(outcome);
  const auto& bracket = outcome.levels[0].bracket;
  EXPECT_LT(bracket.relative_width, 1e-12);
}

TEST(TwoBlocks, agree_with_an_independent_computation) {  // docs/theory.md §9.2
  const auto p2 = bounds::run(two_blocks(8)).levels[0].bracket;
  EXPECT_NEAR(p2.lower, -0.0015696752755447576, 1e-9 * 0.00157);
  EXPECT_NEAR(p2.upper, -0.001560550938463558, 1e-9 * 0.00157);
  auto closed = two_blocks(8, 0.02);
  closed.solve.degree = 1;
  const auto p1 = bounds::run(closed).levels[0].bracket;
  EXPECT_NEAR(p1.lower, -0.0016718327284658456, 1e-9 * 0.00167);
  EXPECT_NEAR(p1.upper, -0.001617648390857087, 1e-9 * 0.00167);
}

TEST(TwoBlocks, contain_the_known_interval_at_every_level) {
  for (const int n : {2, 4, 8, 16, 32})
    for (const int degree : {1, 2, 3, 4}) {
      if (sanitized && n > 4) continue;
      auto open = two_blocks(n);
      open.solve.degree = degree;
      const auto outcome = bounds::run(open);
      expect_admissible(outcome);
      EXPECT_LE(outcome.levels[0].bracket.lower, -0.00156588566432);
      EXPECT_GE(outcome.levels[0].bracket.upper, -0.00156588569415);
      auto closed = two_blocks(n, 0.02);
      closed.solve.degree = degree;
      const auto other = bounds::run(closed);
      expect_admissible(other);
      EXPECT_LE(other.levels[0].bracket.lower, -0.0016695802);
      EXPECT_GE(other.levels[0].bracket.upper, -0.0016699750);
    }
}

}  // namespace
}  // namespace bracket::tests
