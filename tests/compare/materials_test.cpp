// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bounds/bounds.h"
#include "tests/support/scenes.h"

namespace bracket::tests {
namespace {

/// A bar of two materials in one piece, ν = 0, pulled by a force t per area: stress t, energy −½ t² (l₁/E₁ + l₂/E₂) by
/// its height, here 1. `split`: the share of its cells' columns that are of the first material.
struct Bar {
  double young_left, young_right, pull;
  int split;
};

scene::Problem<2> problem_of(const Bar& bar, bool on_wall) {
  scene::Scene<2> whole, s;
  whole.blocks = {block("bar", 0, 4, 0, 1, 4, 2)};
  whole.bodies = {{"bar", scene::isotropic<2>(1, 0, scene::Plane::strain)}};
  s.bodies = {{"left", scene::isotropic<2>(bar.young_left, 0, scene::Plane::strain)},
              {"right", scene::isotropic<2>(bar.young_right, 0, scene::Plane::strain)}};
  s.boundary = {{"bar.right", traction(constant(bar.pull), constant(0))}};
  if (on_wall)
    s.contact = {{"bar.left", "rigid", constant(0), ""}};
  else
    s.boundary["bar.left"] = sliding(0);
  scene::Mesh<2> mesh = scene::build_mesh(whole);
  mesh.bodies = {"left", "right"};
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    double x = 0;
    for (const int v : mesh.cells[c]) x += mesh.vertices[v][0] / 3;
    mesh.cell_body[c] = x < bar.split ? 0 : 1;
  }
  return scene::fix_data(s, mesh);
}

// What hangs together is held as one, whatever it is made of.
TEST(Materials, OfOnePieceAreSolvedTogether) {
  for (const Bar& bar : {Bar{1, 1, 0.3, 2}, Bar{1, 50, -0.2, 1}, Bar{1e6, 1e2, -1, 3}})
    for (const bool on_wall : {false, true}) {
      if (on_wall && bar.pull > 0) continue;  // it would be pulled off
      const auto first = problem_of(bar, on_wall);
      ASSERT_EQ(first.mesh.components.size(), 1u);
      const double exact =
          -0.5 * bar.pull * bar.pull * (bar.split / bar.young_left + (4 - bar.split) / bar.young_right);
      for (const int degree : {1, 2, 3, 4}) {
        scene::Scene<2> settings;
        settings.solve.degree = degree;
        settings.refine = {.strategy = scene::Strategy::uniform, .max_levels = 2};
        const auto outcome = bounds::run(settings, first);
        ASSERT_EQ(outcome.levels.size(), 2u) << outcome.reason;
        for (const auto& level : outcome.levels) {
          ASSERT_TRUE(level.certificate.valid) << level.certificate.reason;
          EXPECT_LE(level.bracket.lower, exact * (1 - 1e-15));
          EXPECT_GE(level.bracket.upper, exact * (1 + 1e-15));
          EXPECT_LE(level.bracket.upper - level.bracket.lower, 1e-11 * std::abs(exact));
        }
      }
    }
}

}  // namespace
}  // namespace bracket::tests
