// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/compare/admissible.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

namespace bracket::tests {
namespace {

/// −log₂ of the ratio of the widths of successive meshes, each twice as fine as the one before.
std::vector<double> orders(const std::function<scene::Scene<2>(int)>& scene, int degree,
                           const std::vector<int>& meshes) {
  std::vector<double> orders;
  double previous = 0;
  for (const int n : meshes) {
    auto s = scene(n);
    s.solve.degree = degree;
    const auto outcome = bounds::run(s);
    expect_admissible(outcome);
    const double width = outcome.levels[0].bracket.upper - outcome.levels[0].bracket.lower;
    if (previous > 0) orders.push_back(std::log2(previous / width));
    previous = width;
  }
  return orders;
}

using Rates = Long;

TEST_F(Rates, smooth_scene_is_bracketed) {
  for (const int n : {1, 2, 8}) {
    const auto outcome = bounds::run(smooth(n));
    expect_admissible(outcome);
    expect_between(outcome.levels[0], smooth_energy, 1e-13);
  }
}

TEST_F(Rates, smooth_scene_linears) {
  for (const double order : orders(smooth, 1, {4, 8, 16, 32})) EXPECT_NEAR(order, 2, 0.1);
}

TEST_F(Rates, smooth_scene_quadratics) {
  for (const double order : orders(smooth, 2, {4, 8, 16, 32})) EXPECT_NEAR(order, 4, 0.1);
}

TEST_F(Rates, lift_off_is_limited_by_its_singularities) {
  // Corners and the ends of the contact leave the quadratics a width of order h² under uniform refinement, and the
  // linears a little less: their own h² stands beside the singular part.
  const auto lift_off = [](int n) { return two_blocks(n); };
  for (const double order : orders(lift_off, 1, {8, 16, 32, 64})) {
    EXPECT_GT(order, 1.6);
    EXPECT_LT(order, 2);
  }
  for (const double order : orders(lift_off, 2, {8, 16, 32, 64})) EXPECT_NEAR(order, 2, 0.15);
}

}  // namespace
}  // namespace bracket::tests
