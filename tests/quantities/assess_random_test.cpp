// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "bounds/assess.h"
#include "primal/primal.h"
#include "tests/support/random_grid.h"
#include "tests/support/random_scenes.h"
#include "tests/support/sanitized.h"

namespace bracket::tests {
namespace {

/// Waves of any length and size, also such that most of the field is noise.
scene::Displacement<2> with_noise(const scene::Problem<2>& problem, scene::Displacement<2> u, Random& random) {
  double largest = 0;
  for (const auto& x : u.vertex) largest = std::max(largest, x.norm());
  const double size = largest * std::pow(10, random.uniform(-6, 1)), phase = random.uniform(0, 6);
  const double a = random.uniform(-9, 9) / problem.length_scale, b = random.uniform(-9, 9) / problem.length_scale;
  const auto wave = [&](const Vector<2>& x) {
    return Vector<2>(size * std::sin(a * x[0] + b * x[1] + phase), size * std::cos(b * x[0] - a * x[1] + phase));
  };
  const auto& mesh = problem.mesh;
  for (std::size_t v = 0; v < u.vertex.size(); ++v) u.vertex[v] += wave(mesh.vertices[v]);
  for (std::size_t e = 0; e < u.edge.size(); ++e)
    u.edge[e] += wave((mesh.vertices[mesh.edges[e][0]] + mesh.vertices[mesh.edges[e][1]]) / 2);
  return u;
}

using AssessRandom = Long;

// A contradiction of levels, or of the two kinds of bounds, ends without a guarantee.
TEST_F(AssessRandom, intervals_never_exclude_each_other) {
  int judged = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const RandomScene of = random_scene(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + of.text);
    Random random(seed ^ 0x9e3779b9);
    scene::Scene<2> scene = of.scene;
    scene.refine = {.strategy = scene::Strategy::uniform, .max_levels = 3};
    scene::FieldOnScene field;
    try {
      field.problem = scene::fix_data(scene, of.mesh);
      const auto own = primal::solve(bounds::balanced(field.problem, 2), random.chance(0.5) ? 1 : 2);
      if (!own.reason.empty()) continue;
      field.given.displacement = with_noise(field.problem, own.displacement, random);
      const auto found = bounds::assess(scene, std::move(field));
      EXPECT_EQ(found.reason.find("fault of this program"), std::string::npos) << found.reason;
      if (found.guarantee == "none") continue;
      EXPECT_LE(found.error.lower, found.error.upper);
      ++judged;
    } catch (const scene::Error&) {  // ill-posed
    }
  }
  EXPECT_GE(judged, 20);
}

}  // namespace
}  // namespace bracket::tests
