// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Loads that are cubics along the edges: degree 4 has them as they are written.
#include <gtest/gtest.h>

#include "tests/compare/admissible.h"
#include "tests/support/scenes.h"

namespace bracket::tests {
namespace {

/// The Airy stress −Re z⁵ on the unit square: σ_xx = −σ_yy = 20 x³ − 60 x y², σ_xy = 20 y³ − 60 x² y, so that ε = (1 +
/// ν)/E σ, on a rigid wall at y = 0 with the pressure 20 x³, its other three sides loaded; it floats sideways.
/// Displacements have degree 4. L(u) = −(1 + ν)/E ∫ (σ_xx² + σ_xy²) = −(1 + ν)/E · 400 ∫ |z|⁶.
scene::Scene<2> cubic_loads(int degree, int nx, int ny) {
  scene::Scene<2> s;
  s.blocks = {block("b", 0, 1, 0, 1, nx, ny)};
  s.bodies = {{"b", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
  const auto on = [](auto f) { return scene::enclosed<2>(f); };
  s.boundary = {{"b.right", traction(on([](const auto& x) { return 20 - 60 * x[1] * x[1]; }),
                                     on([](const auto& x) { return 20 * x[1] * x[1] * x[1] - 60 * x[1]; }))},
                {"b.top", traction(on([](const auto& x) { return 20 - 60 * x[0] * x[0]; }),
                                   on([](const auto& x) { return 60 * x[0] - 20 * x[0] * x[0] * x[0]; }))},
                {"b.left", traction(constant(0), on([](const auto& x) { return -20 * x[1] * x[1] * x[1]; }))}};
  s.contact = {{"b.bottom", "rigid", constant(0), ""}};
  s.solve.degree = degree;
  return s;
}
constexpr double cubic_loads_energy = -1.3 * 1920 / 7;  // ∫ |z|⁶ = 24/35

TEST(CubicLoads, exact_on_every_mesh_with_degree_4) {
  for (const auto& [nx, ny] : {std::pair{1, 1}, {3, 2}}) {
    auto scene = cubic_loads(4, nx, ny);
    scene.refine = {.strategy = scene::Strategy::uniform, .max_levels = 3};
    const auto outcome = bounds::run(scene);
    expect_admissible(outcome);
    EXPECT_LE(outcome.problem.oscillation.traction, 1e-15);
    ASSERT_EQ(outcome.levels.size(), 3u);
    for (const bounds::Level& level : outcome.levels) {
      EXPECT_LE(level.oscillation_energy, 1e-15 * std::abs(cubic_loads_energy));
      EXPECT_NEAR(level.bracket.lower, cubic_loads_energy, 1e-11 * std::abs(cubic_loads_energy));
      EXPECT_NEAR(level.bracket.upper, cubic_loads_energy, 1e-11 * std::abs(cubic_loads_energy));
      EXPECT_LE(level.bracket.lower, level.bracket.upper);
    }
  }
}

// With degree 3 they are quadratics on the first mesh's edges; what that does is estimated, and halving these edges
// makes it less, of the order of its square.
TEST(CubicLoads, what_degree_3_leaves_out_is_told) {
  double before = 0;
  for (const int n : {2, 4}) {
    auto scene = cubic_loads(3, n, n);
    scene.refine = {.strategy = scene::Strategy::none};
    const bounds::Level told = bounds::run(scene).levels.front();
    const auto coarse = problem(scene);
    scene.refine = {.strategy = scene::Strategy::uniform, .max_levels = 4};
    const auto outcome = bounds::run(scene, coarse);
    const double width = outcome.upper - outcome.lower;
    const double moved = std::abs(outcome.lower + width / 2 - cubic_loads_energy);
    EXPECT_LE(width, 0.1 * told.oscillation_energy);
    EXPECT_LE(moved, told.oscillation_energy + width);
    EXPECT_GE(moved, 1e-3 * told.oscillation_energy);
    if (before > 0) {
      EXPECT_LE(told.oscillation_energy, before / 16);
    }
    before = told.oscillation_energy;
  }
}

// A block that nothing holds, between two pressures P_2(x), which are in balance each. What is linear of them is
// rounding, by which the balance must not be judged; nor must data that are carried be told to be lost, far from the
// origin.
TEST(CubicLoads, without_a_resultant_are_in_balance) {
  for (const double x0 : {0.0, 0x1p20})
    for (const int degree : {3, 4})
      for (const int n : {1, 3}) {
        scene::Scene<2> s;
        s.blocks = {block("b", x0, x0 + 1, 0, 1, n, 1)};
        s.bodies = {{"b", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
        const auto wave = scene::enclosed<2>([=](const auto& x) {
          const auto t = x[0] - x0;
          return 6 * t * (t - 1) + 1;
        });
        s.boundary = {{"b.top", pressure(wave)}, {"b.bottom", pressure(wave)}};
        s.solve.degree = degree;
        s.refine = {.strategy = scene::Strategy::uniform, .max_levels = 4};
        const auto outcome = bounds::run(s);
        expect_admissible(outcome);
        EXPECT_LE(outcome.problem.imbalance, 1e-8);
        EXPECT_EQ(outcome.levels.back().oscillation_energy, 0);
        EXPECT_LE(outcome.relative_error_bound, 0.02);
        EXPECT_NEAR(outcome.lower, -0.0655048524, 1e-4 * 0.0655);
      }
}

}  // namespace
}  // namespace bracket::tests
