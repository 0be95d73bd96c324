// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "bounds/bounds.h"
#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/support/scenes.h"

namespace bracket::tests {
namespace {

/// The same bodies, supports and contact with data of their own: weights, loads, prescribed displacements and gaps.
/// They are changed alike on facets that meet, so that a vertex is told one displacement.
scene::Problem<2> with_other_data(scene::Problem<2> problem, double factor) {
  const auto moved = [factor](Vector<2> u) { return Vector<2>(factor * u + Vector<2>(2e-3, -1e-3)); };
  for (auto& body : problem.bodies) body.force = -0.5 * body.force + Vector<2>(0.003, 0.001);
  for (auto& facet : problem.facets)
    for (int i = 0; i < 2; ++i) {
      facet.traction[i] *= factor;
      if (facet.support == scene::Support::fixed) facet.displacement[i] = moved(facet.displacement[i]);
      if (facet.support == scene::Support::sliding)
        facet.normal_displacement[i] = factor * facet.normal_displacement[i] + Vector<2>(2e-3, -1e-3).dot(facet.normal);
    }
  for (auto& pair : problem.contact)
    for (int k = 0; k < 3; ++k) pair.lower[k] = pair.upper[k] = 0.7 * pair.lower[k];
  return problem;
}

// What a solver has factorised serves every problem of the same bodies: it finds what a solver of that problem finds.
TEST(SecondProblem, NeedsNoFactorisation) {
  int solved = 0;
  for (const auto& scene : {everything(6, 3, 5), two_blocks(5)}) {
    const auto first = problem(scene);
    for (const double factor : {1.0, 0.3, -2.0}) {
      const auto second = with_other_data(first, factor);
      for (const int degree : {1, 2, 3, 4}) {
        const primal::Solver<2> displacements(first, degree);
        const dual::Solver<2> stresses(first, scene::stress_degree(degree));
        const auto found = displacements.solve(second), anew = primal::solve(second, degree);
        ASSERT_EQ(found.termination, anew.termination) << found.reason << anew.reason;
        if (found.termination != contact::Termination::solved) continue;
        ++solved;
        EXPECT_EQ(found.closed, anew.closed);
        const double energy = bounds::potential_energy(second, found.displacement).total;
        EXPECT_EQ(energy, bounds::potential_energy(second, anew.displacement).total);
        EXPECT_TRUE(bounds::certify(second, found.displacement, stresses.solve(second).stress).valid);
      }
    }
    for (const double factor : {1.0, 0.3, -2.0})
      for (const int degree : {1, 2, 3}) {
        const auto second = with_other_data(first, factor);
        const auto found = dual::Solver<2>(first, degree).solve(second), anew = dual::solve(second, degree);
        ASSERT_EQ(found.termination, anew.termination) << found.reason << anew.reason;
        EXPECT_EQ(found.closed, anew.closed);
        if (found.termination != contact::Termination::solved) continue;
        ++solved;
        EXPECT_EQ(bounds::complementary_energy(second, found.stress),
                  bounds::complementary_energy(second, anew.stress));
      }
  }
  EXPECT_GE(solved, 28);  // of 42
}

// Other supports are other bodies, not another right side.
TEST(SecondProblem, OfOtherBodiesIsRefused) {
  const auto first = problem(everything(4, 2, 3));
  auto freed = first, apart = first;
  for (auto& facet : freed.facets)
    if (facet.support == scene::Support::fixed) facet.support = scene::Support::traction;
  apart.contact.pop_back();
  for (const auto& other : {freed, apart}) {
    EXPECT_THROW(primal::Solver<2>(first, 2).solve(other), std::invalid_argument);
    EXPECT_THROW(dual::Solver<2>(first, 1).solve(other), std::invalid_argument);
  }
  for (const int degree : {-1, 0, 5}) EXPECT_THROW(primal::Solver<2>(first, degree), scene::Error);
  for (const int degree : {-1, 0, 4}) EXPECT_THROW(dual::Solver<2>(first, degree), std::invalid_argument);
}

}  // namespace
}  // namespace bracket::tests
