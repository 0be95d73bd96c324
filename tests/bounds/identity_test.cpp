// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "bounds/bounds.h"
#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/support/scenes.h"

namespace bracket::bounds {
namespace {

using scene::Support;
using scene::Vector;

/// Adds noise where nothing is prescribed.
scene::Displacement<2> disturbed(const scene::Problem<2>& problem, scene::Displacement<2> u, double size,
                                 unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> noise(-size, size);
  std::vector<char> keep_vertex(u.vertex.size(), 0), keep_edge(u.edge.size(), 0);
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (problem.facets[f].support != Support::fixed && problem.facets[f].support != Support::sliding) continue;
    const auto& facet = problem.mesh.boundary[f];
    for (const int v : facet.vertices) keep_vertex[v] = 1;
    if (!keep_edge.empty()) keep_edge[facet.edge] = 1;
  }
  for (std::size_t v = 0; v < u.vertex.size(); ++v)
    if (!keep_vertex[v]) u.vertex[v] += Vector<2>(noise(generator), noise(generator));
  for (std::size_t e = 0; e < u.edge.size(); ++e)
    if (!keep_edge[e / (u.degree - 1)]) u.edge[e] += Vector<2>(noise(generator), noise(generator));
  for (Vector<2>& value : u.cell) value += Vector<2>(noise(generator), noise(generator));
  return u;
}

TEST(GapIdentity, holds_for_any_displacement_that_keeps_the_supports) {
  const auto problem = tests::problem(tests::everything(3, 4, 2));
  for (const int degree : {1, 2, 3, 4}) {
    const auto stresses = dual::solve(problem, scene::stress_degree(degree));
    ASSERT_EQ(stresses.termination, contact::Termination::solved) << stresses.reason;
    const double s = complementary_energy(problem, stresses.stress);
    const auto displacements = primal::solve(problem, degree);
    ASSERT_EQ(displacements.termination, contact::Termination::solved) << displacements.reason;
    for (const double size : {0.0, 1e-3, 1.0}) {
      const auto u = disturbed(problem, displacements.displacement, size, 5);
      const auto energy = potential_energy(problem, u);
      const double sum = indicator(problem, u, stresses.stress).sum;
      EXPECT_NEAR(sum, energy.total + s, 1e-14 * (energy.strain + std::abs(s)))
          << "degree " << degree << ", noise " << size;
    }
  }
}

/// v, turned back to u where it goes outward at a contact facet; between the ends of those v − u is linear.
scene::Displacement<2> opening(const scene::Problem<2>& problem, const scene::Displacement<2>& u,
                               scene::Displacement<2> v) {
  std::vector<int> facets;
  for (const auto& pair : problem.contact) {
    facets.push_back(pair.first);
    if (pair.second >= 0) facets.push_back(pair.second);
  }
  for (const int f : facets)
    for (const int i : problem.mesh.boundary[f].vertices) {
      const Vector<2>& normal = problem.facets[f].normal;
      v.vertex[i] -= std::max(0.0, normal.dot(v.vertex[i] - u.vertex[i])) * normal;
    }
  if (u.edge.empty()) return v;
  for (const int f : facets) {
    const auto& [a, b] = problem.mesh.boundary[f].vertices;
    const int edge = problem.mesh.boundary[f].edge;
    v.edge[edge] = u.edge[edge] + (v.vertex[a] - u.vertex[a] + v.vertex[b] - u.vertex[b]) / 2;
  }
  return v;
}

TEST(Energies, solutions_are_minima) {
  const auto problem = tests::problem(tests::everything(3, 4, 2));
  const auto stress = dual::solve(problem, 1).stress;
  for (const int degree : {1, 2}) {
    const auto u = primal::solve(problem, degree).displacement;
    const double least = potential_energy(problem, u).total;
    int admissible = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
      const auto v = opening(problem, u, disturbed(problem, u, 1e-4, seed));
      if (admissibility(problem, v, stress).penetration > 1e-12) continue;
      ++admissible;
      EXPECT_GT(potential_energy(problem, v).total, least);
    }
    EXPECT_GT(admissible, 10) << "degree " << degree;
  }
}

TEST(Indicator, every_share_is_non_negative) {
  const auto problem = tests::problem(tests::everything(3, 4, 2));
  const auto u = primal::solve(problem, 2).displacement;
  const auto stress = dual::solve(problem, 1).stress;
  const auto shares = indicator(problem, u, stress);
  for (const double share : shares.cell) EXPECT_GE(share, 0);
  for (const double share : shares.contact) EXPECT_GE(share, -1e-15);
  const PlainEnergies plain = plain_energies(problem, u, stress, shares);
  const Bracket b = bracket(plain.lower, plain.upper, plain.strain,
                            std::accumulate(shares.contact.begin(), shares.contact.end(), 0.0));
  EXPECT_LT(b.lower, b.upper);
  EXPECT_NEAR(b.error_bound, std::sqrt(2 * (b.upper - b.lower)), 1e-10 * b.error_bound);
  EXPECT_LE(b.mean_stress_error_bound, b.error_bound);
}

TEST(Energies, nothing_happens_without_loads) {
  auto scene = tests::two_blocks(2, 0);
  scene.boundary["upper.top"] = tests::fixed(0, 0);
  const auto outcome = run(scene);
  EXPECT_EQ(outcome.levels[0].bracket.lower, 0);
  EXPECT_EQ(outcome.levels[0].bracket.upper, 0);
  EXPECT_EQ(outcome.levels[0].bracket.relative_error_bound, 0);
  EXPECT_EQ(outcome.guarantee, "rounding-safe");
}

}  // namespace
}  // namespace bracket::bounds
