// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// The errors of displacements from elsewhere, where the contact has a law.
#include "bounds/assess.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "primal/primal.h"
#include "tests/laws/pairs.h"

namespace bracket::tests {
namespace {

using scene::Displacement;
using scene::Law;
using scene::Scene;

using Motion = std::function<Vector<2>(const Vector<2>& x)>;

Displacement<2> quadratic(const scene::Mesh<2>& mesh, const Motion& motion) {
  Displacement<2> result{2, {}, {}};
  for (const auto& x : mesh.vertices) result.vertex.push_back(motion(x));
  for (const auto& [a, b] : mesh.edges) result.edge.push_back(motion((mesh.vertices[a] + mesh.vertices[b]) / 2));
  return result;
}

bounds::Assessment assessed(Scene<2> scene, const scene::Problem<2>& problem, const Displacement<2>& u, int levels) {
  scene.refine = {.strategy = levels > 1 ? scene::Strategy::uniform : scene::Strategy::none, .max_levels = levels};
  scene::FieldOnScene field;
  field.problem = problem;
  field.given.displacement = u;
  return bounds::assess(scene, field);
}

/// Of a motion and of others near it: their distance is in the interval of each level, and at last little else is.
void expect_distances(const Scene<2>& scene, const Motion& exact) {
  const scene::Problem<2> problem = tests::problem(scene);
  const Motion noise = [](const Vector<2>& x) { return Vector<2>(std::sin(2 * x[0] + x[1]), std::cos(x[0] - x[1])); };
  const double norm = std::sqrt(2 * bounds::potential_energy(problem, quadratic(problem.mesh, noise)).strain);
  for (const double size : {0.0, 1e-3, 0.1}) {
    SCOPED_TRACE(size);
    const auto found =
        assessed(scene, problem,
                 quadratic(problem.mesh, [&](const auto& x) { return Vector<2>(exact(x) + size * noise(x)); }), 2);
    ASSERT_NE(found.guarantee, "none") << found.reason;
    for (const auto& level : found.levels)
      for (const auto& interval : {level.by_stress, level.by_energy}) {
        EXPECT_LE(interval.lower, size * norm * (1 + 1e-12));
        EXPECT_GE(interval.upper, size * norm * (1 - 1e-12));
      }
    EXPECT_LE(found.error.upper - found.error.lower, 1e-7);
  }
}

constexpr double young = 3;

TEST(AssessLaws, friction_that_holds_or_slips) {
  constexpr double shear = young / 2, down = 0.25;
  for (const bool lifts_off : {true, false}) {
    SCOPED_TRACE(lifts_off);
    const NamedLaw law = {"", Law::tresca, constant(0.375), lifts_off};
    expect_distances(block_on_wall(young, 0.125, down, shear * 0.125, law),
                     [](const Vector<2>& x) { return Vector<2>(0.125 * x[1], -down * x[1]); });
    expect_distances(block_on_wall(young, 0.75, down, 0.375, law),
                     [](const Vector<2>& x) { return Vector<2>(0.5 + 0.25 * x[1], -down * x[1]); });
  }
}

TEST(AssessLaws, springs_give_way) {
  constexpr double k = 3, down = 0.25, pressure = down / (1 / young + 1 / k);
  for (const bool lifts_off : {true, false})
    for (const double sign : lifts_off ? std::vector<double>{1} : std::vector<double>{1, -1})
      expect_distances(block_on_wall(young, 0, sign * down, 0, {"", Law::winkler, constant(k), lifts_off}),
                       [=](const Vector<2>& x) { return Vector<2>(0, -sign * pressure * (1 / k + x[1] / young)); });
}

TEST(AssessLaws, sides_that_keep_together) {
  for (const double down : {0.25, -0.25})
    expect_distances(block_on_wall(young, 0, down, 0, {"", Law::bilateral}),
                     [=](const Vector<2>& x) { return Vector<2>(0, -down * x[1]); });
}

// Displacements that cross into each other, with and without what the law resists.
TEST(AssessLaws, intervals_of_two_meshes_meet) {
  for (const NamedLaw& law : laws()) {
    SCOPED_TRACE(law.name);
    const Scene<2> scene = with_law(two_blocks(3), law);
    const scene::Problem<2> problem = tests::problem(scene);
    const auto own = primal::solve(problem, 2);
    ASSERT_EQ(own.reason, "");
    for (const double size : {1e-3, 1.0}) {
      SCOPED_TRACE(size);
      Displacement<2> u = own.displacement;
      const auto noise = quadratic(problem.mesh, [](const Vector<2>& x) {
        return Vector<2>(std::cos(3 * x[1] + x[0]), std::sin(2 * x[0] + 5 * x[1]));
      });
      double largest = 0;
      for (const auto& one : u.vertex) largest = std::max(largest, one.norm());
      for (std::size_t v = 0; v < u.vertex.size(); ++v) u.vertex[v] += size * largest * noise.vertex[v];
      for (std::size_t e = 0; e < u.edge.size(); ++e) u.edge[e] += size * largest * noise.edge[e];
      const auto coarse = assessed(scene, problem, u, 1), fine = assessed(scene, problem, u, 3);
      ASSERT_NE(coarse.guarantee, "none") << coarse.reason;
      ASSERT_NE(fine.guarantee, "none") << fine.reason;
      EXPECT_LE(std::max(coarse.error.lower, fine.error.lower), std::min(coarse.error.upper, fine.error.upper));
      EXPECT_GT(fine.error.lower, 0);
    }
  }
}

}  // namespace
}  // namespace bracket::tests
