// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/compare/admissible.h"
#include "tests/compare/exact.h"
#include "tests/compare/scene_files.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

namespace bracket::tests {
namespace {

/// Slope of log(width) over log(cells) by least squares, on the levels with cells in the range.
double slope(const std::vector<bounds::Level>& levels, int least, int most) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& level : levels) {
    if (level.cells < least || level.cells > most) continue;
    const double a = std::log(level.cells), b = std::log(level.bracket.upper - level.bracket.lower);
    n += 1;
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

bounds::Outcome<2> refined(scene::Scene<2> scene, int degree, int max_cells) {
  scene.solve.degree = degree;
  scene.refine = {.strategy = scene::Strategy::adaptive, .max_levels = 100, .max_cells = max_cells};
  return bounds::run(scene);
}

using Adaptive = Long;
using Effectivity = Long;

TEST_F(Adaptive, lift_off_reaches_the_full_order_of_quadratics) {
  const auto outcome = refined(two_blocks(4), 2, 40000);
  expect_admissible(outcome);
  for (const auto& level : outcome.levels) {
    EXPECT_LE(level.bracket.lower, -0.00156588566432);
    EXPECT_GE(level.bracket.upper, -0.00156588569415);
  }
  EXPECT_LE(slope(outcome.levels, 1000, 40000), -1.9);
  EXPECT_LE(slope(refined(two_blocks(4), 1, 20000).levels, 1000, 20000), -0.95);
}

TEST_F(Adaptive, other_singular_scenes_reach_it_too) {
  // From 4000 cells on: their coarse meshes are fine where nothing happens, and refining the corners alone is steeper.
  for (const char* name : {"l_shape", "three_halves"}) {
    const auto outcome = refined(from_file(name), 2, 30000);
    expect_admissible(outcome);
    EXPECT_LE(slope(outcome.levels, 4000, 30000), -1.9) << name;
  }
}

TEST_F(Adaptive, every_level_contains_the_exact_energy) {
  const double exact = three_halves_energy(1, 0.3);
  for (const int degree : {1, 2}) {
    const auto outcome = refined(from_file("three_halves"), degree, 5000);
    expect_admissible(outcome);
    for (const auto& level : outcome.levels) expect_between(level, exact, 1e-12);
    const double wavy = westergaard_energy({1, 0.3, 0.01, 2, 0.25});
    for (const auto& level : refined(from_file("westergaard"), degree, 5000).levels) expect_between(level, wavy, 1e-12);
  }
}

TEST_F(Effectivity, is_one_without_contact) {
  // Prager and Synge: ‖u − u_h‖² + ‖σ − λ_h‖² = ‖σ(u_h) − λ_h‖² = 2 width, and without contact each field's error is
  // twice the distance of its energy to the exact one.
  for (const int degree : {1, 2}) {
    const auto outcome = refined(smooth(2), degree, 3000);
    int compared = 0;
    for (const auto& level : outcome.levels) {
      const double u = 2 * (level.bracket.upper - smooth_energy), s = 2 * (smooth_energy - level.bracket.lower);
      if (std::min(u, s) < 1e-9) continue;  // rounding of the energies
      ++compared;
      EXPECT_NEAR(level.bracket.error_bound / std::sqrt(u + s), 1, 1e-5);
      EXPECT_GE(level.bracket.error_bound, std::sqrt(std::max(u, s)) * (1 - 1e-12));
    }
    EXPECT_GT(compared, 3) << "degree " << degree;
  }
}

/// ∫ f over (0, 1), f smooth but for a root at an end: Gauss–Legendre with two points on each of many equal parts.
template <class Function> double integral(const Function& f) {
  constexpr int parts = 50;
  const double offset = 0.5 / std::sqrt(3.0);
  double sum = 0;
  for (int i = 0; i < parts; ++i)
    for (const double sign : {-1.0, 1.0}) sum += f((i + 0.5 + sign * offset) / parts) / (2 * parts);
  return sum;
}

// With contact the square of the bound has two more terms than the errors [docs/theory.md §1.3]:
//     2 width = ‖u − u_h‖² + ‖σ − λ_h‖² + 2 ∫ p (g − r_h) + 2 ∫ p_h (g − r).
// On three_halves.toml p = √|x| where x < 0, and where x > 0 the gap left is 4 (1 − ν²)/(3 E) x^(3/2).
TEST_F(Effectivity, is_at_least_one_with_a_free_contact_boundary_and_stays_near_it) {
  const double exact = three_halves_energy(1, 0.3);
  auto file = from_file("three_halves");
  // The tractions, linear on each edge of this mesh, shift the energy by less than the widths.
  file.blocks[0].cells = {64, 32};
  ASSERT_NEAR(file.bodies.begin()->second.material.compliance()(0, 0), 1 - 0.09, 1e-12);
  for (int levels = 1; levels <= 5; ++levels) {
    auto scene = file;
    scene.refine = {.strategy = scene::Strategy::adaptive, .max_levels = levels};
    const auto outcome = bounds::run(scene);
    const auto& level = outcome.levels.back();
    double by_exact = 0, by_computed = 0;  // ∫ p (g − r_h), ∫ p_h (g − r)
    const auto states = bounds::contact_state(outcome.problem, outcome.displacement, outcome.stress);
    for (std::size_t j = 0; j < states.size(); ++j) {
      const auto& [a, b] = outcome.problem.mesh.boundary[outcome.problem.contact[j].first].vertices;
      const double x0 = outcome.problem.mesh.vertices[a][0], x1 = outcome.problem.mesh.vertices[b][0];
      const auto& [p, gap] = states[j];
      const double length = std::abs(x1 - x0);
      by_exact += length * integral([&](double s) {
                    const double x = (1 - s) * x0 + s * x1, left = (1 - s) * (1 - 2 * s) * gap[0] +
                                                                   s * (2 * s - 1) * gap[1] + 4 * s * (1 - s) * gap[2];
                    return x < 0 ? std::sqrt(-x) * left : 0;
                  });
      by_computed += length * integral([&](double s) {
                       const double x = (1 - s) * x0 + s * x1;
                       return x > 0 ? ((1 - s) * p[0] + s * p[1]) * 4 * (1 - 0.09) / 3 * x * std::sqrt(x) : 0;
                     });
    }
    const double u = 2 * (level.bracket.upper - exact - by_exact), s = 2 * (exact - level.bracket.lower - by_computed);
    const double bound = level.bracket.error_bound;
    const double oscillation = level.oscillation_energy / (level.bracket.upper - level.bracket.lower);
    EXPECT_GE(bound / std::sqrt(u + s), 1 - oscillation) << level.cells;
    EXPECT_LE(bound / std::sqrt(u + s), 1.1 + oscillation) << level.cells;
    EXPECT_GE(bound, std::sqrt(std::max(u, s)) * (1 - oscillation)) << level.cells;
  }
}

// The re-entrant corner is the middle of the body, where cells become the smallest: balance is not handed on through
// them. Each edge there has 2⁻¹⁵ of the largest's length; what is left is rounding of stresses.
TEST_F(Adaptive, a_corner_costs_the_certificate_nothing_but_rounding) {
  scene::Scene<2> s = from_file("l_shape");
  s.solve.degree = 3;
  s.refine = {.strategy = scene::Strategy::adaptive, .bulk = 0.8, .max_levels = 20, .max_cells = 10000};
  s.quantities.clear();
  const auto outcome = bounds::run(s);
  for (const auto& level : outcome.levels)
    EXPECT_LE(level.plain.lower - level.certificate.lower, 1e-11 * std::abs(level.plain.lower)) << level.cells;
}

}  // namespace
}  // namespace bracket::tests
