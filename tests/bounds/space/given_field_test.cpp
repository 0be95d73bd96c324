// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// What is certified of displacements from elsewhere, against rational numbers.
#include "bounds/certificate/given_field.h"

#include <gtest/gtest.h>

#include <limits>

#include "scene/problem/refine.h"
#include "tests/bounds/space/cases.h"
#include "tests/bounds/space/judge.h"
#include "tests/support/sanitized.h"

namespace bracket::bounds::space {
namespace {

using scene::Displacement;
using scene::Problem;
using scene::Simplex;

Point exact_point(const scene::Vector<3>& v) { return {Exact(v[0]), Exact(v[1]), Exact(v[2])}; }

/// u_x at the vertices and middles of edges of a cell, of the first mesh or of a finer one.
std::array<Point, 10> given_on(const Problem<3>& problem, const Displacement<3>& given, int cell) {
  const auto [of, corner] = scene::piece_of_cell(problem, cell);
  const scene::Mesh<3>& first = scene::first_of(problem).mesh;
  std::array<std::array<Exact, 4>, 10> at;  // barycentric coordinates in the first mesh's cell
  for (int i = 0; i < 4; ++i) {
    at[i][0] = Exact(1);
    for (int k = 0; k < 3; ++k) {
      at[i][k + 1] = Exact(corner[i][k]);
      at[i][0] -= at[i][k + 1];
    }
  }
  for (int e = 0; e < 6; ++e)
    for (int k = 0; k < 4; ++k)
      at[4 + e][k] = (at[Simplex<3>::edges[e][0]][k] + at[Simplex<3>::edges[e][1]][k]) / Exact(2);
  std::array<Point, 10> result;
  for (int node = 0; node < 10; ++node) {
    const auto& l = at[node];
    for (int i = 0; i < 4; ++i) {
      const Exact hat = given.degree == 1 ? l[i] : l[i] * (Exact(2) * l[i] - Exact(1));
      result[node] = result[node] + hat * exact_point(given.vertex[first.cells[of][i]]);
    }
    for (int e = 0; e < 6 && given.degree == 2; ++e) {
      const auto& [a, b] = Simplex<3>::edges[e];
      result[node] = result[node] + Exact(4) * l[a] * l[b] * exact_point(given.edge[first.cell_edges[of][e]]);
    }
  }
  return result;
}

/// x u + y v
Judged combined(Judged u, const Exact& x, const std::vector<std::array<Point, 10>>& v, const Exact& y) {
  for (std::size_t cell = 0; cell < v.size(); ++cell)
    for (int node = 0; node < 10; ++node)
      u.displacement[cell][node] = x * u.displacement[cell][node] + y * v[cell][node];
  return u;
}

std::vector<std::array<Point, 10>> given_on_all(const Problem<3>& problem, const Displacement<3>& given) {
  std::vector<std::array<Point, 10>> result;
  for (int cell = 0; cell < static_cast<int>(problem.mesh.cells.size()); ++cell)
    result.push_back(given_on(problem, given, cell));
  return result;
}

/// ‖σ(u) − λ‖² of what is judged.
Exact misfit(const Problem<3>& problem, const Judged& exact) {
  return Exact(2) * (distance(problem, exact) - contact_term(problem, exact));
}

void expect_root_between(double lower, double upper, const Exact& square) {
  EXPECT_LE(Exact(lower) * Exact(lower), square);
  EXPECT_GE(Exact(upper) * Exact(upper), square);
  EXPECT_LE(upper - lower, 1e-12 * upper);
}

// σ(u_x) − ½ (σ(u_h) + λ_h) is half of σ(2 u_x − u_h) − λ_h.
void expect_distance(const Problem<3>& problem, const Displacement<3>& given, const scene::Voigt<3>& mean,
                     std::mt19937& generator) {
  const auto u = tests::random_displacement(problem, 2, 0.01, generator);
  const auto stress = tests::random_stress(problem, mean, 0.02, generator);
  const GivenDistance found = certify_distance(problem, u, stress, given);
  ASSERT_TRUE(found.valid) << found.reason;
  const Judged own = judged(problem, u, stress);
  ASSERT_EQ(own.reason, "");
  const Judged twice = combined(own, Exact(-1), given_on_all(problem, given), Exact(2));
  expect_root_between(found.lower, found.upper, misfit(problem, twice) / Exact(4));
  const Exact squared_error = misfit(problem, own) / Exact(4) + contact_term(problem, own);
  EXPECT_GE(Exact(found.stress_error) * Exact(found.stress_error), squared_error);
  EXPECT_LE(found.stress_error, std::sqrt(rounded(squared_error)) * (1 + 1e-12));
  expect_root_between(found.norm_lower, found.norm_upper, Exact(2) * strain_energy(problem, own));
  double cells = 0;
  ASSERT_EQ(found.cell.size(), scene::first_of(problem).mesh.cells.size());
  for (const double share : found.cell) cells += share;
  EXPECT_NEAR(std::sqrt(cells), found.upper, 1e-12 * found.upper);
}

TEST(SpaceGiven, the_distance_from_the_mean_stress_is_enclosed) {
  std::mt19937 generator(11);
  for (const auto& [name, problem, mean] : tests::all_cases())
    for (const int degree : {2, 1}) {
      if (tests::sanitized && degree == 1) break;
      SCOPED_TRACE(name);
      const auto given = tests::random_displacement(problem, degree, 0.02, generator);
      expect_distance(problem, given, mean, generator);
      expect_distance(tests::refined(problem, 5, generator), given, mean, generator);
    }
}

TEST(SpaceGiven, its_energy_on_the_supports_is_enclosed) {
  std::mt19937 generator(12);
  for (const auto& [name, problem, mean] : tests::all_cases())
    for (const int degree : {1, 2}) {
      if (degree == 1 && std::string(name) == "together, bent") continue;
      SCOPED_TRACE(name);
      const auto given = tests::random_displacement(problem, degree, 0.02, generator);
      const GivenEnergyOf<3> found = certify_given(problem, given);
      ASSERT_TRUE(found.valid) << found.reason;
      Judged on = judged(problem, tests::random_displacement(problem, degree, 0.01, generator),
                         tests::random_stress(problem, mean, 0.02, generator));
      ASSERT_EQ(on.reason, "");
      // u_s: by what plain_field() and shifts() stand for.
      const PlainField field = plain_field(problem, given, on.supports);
      const auto moved = shifts<Exact>(on.supports, field);
      for (std::size_t cell = 0; cell < problem.mesh.cells.size(); ++cell) {
        auto& u = on.displacement[cell];
        for (int i = 0; i < 4; ++i) u[i] = at_node(field, moved, problem.mesh.cells[cell][i]);
        for (int e = 0; e < 6; ++e) {
          const auto& [a, b] = Simplex<3>::edges[e];
          const Point offset = at_node(field, moved, node_of_edge(problem.mesh, problem.mesh.cell_edges[cell][e]));
          u[4 + e] = Exact(Rational(1, 2)) * (u[a] + u[b] + (degree == 2 ? offset : Point{}));
        }
      }
      for (const std::string& fault : displacement_faults(problem, on))  // but for the contact
        EXPECT_EQ(fault.find("approach"), 0u) << fault;
      const Exact energy = potential_energy(problem, on);
      EXPECT_LE(Exact(found.lower), energy);
      EXPECT_GE(Exact(found.upper), energy);
      EXPECT_LE(found.upper - found.lower, 1e-12 * std::abs(found.upper));
      const Judged move = combined(on, Exact(1), given_on_all(problem, given), Exact(-1));
      EXPECT_GE(Exact(found.moved) * Exact(found.moved), Exact(2) * strain_energy(problem, move));
      double misfit = 0;
      for (const auto& cell : move.displacement)
        for (const Point& by : cell) misfit = std::max(misfit, std::sqrt(rounded(dot(by, by))));
      EXPECT_NEAR(found.misfit, misfit, 1e-12);
      for (std::size_t j = 0; j < problem.contact.size(); ++j) {
        const auto& pair = problem.contact[j];
        const auto r = approach_on<Exact>(problem, on.supports, field, pair);
        for (int k = 0; k < 6 && !pair.law.two_sided; ++k) {
          EXPECT_LE(Exact(found.below[j][k]), Exact(pair.lower[k]) - r[k]);
          EXPECT_GE(Exact(found.above[j][k]), Exact(pair.upper[k]) - r[k]);
        }
      }
    }
}

TEST(SpaceGiven, what_is_no_displacement_of_the_mesh_is_refused) {
  std::mt19937 generator(13);
  const auto [name, problem, mean] = tests::clamped();
  const auto u = tests::random_displacement(problem, 2, 0.01, generator);
  const auto stress = tests::random_stress(problem, mean, 0.02, generator);
  const auto expect_refused = [&, &problem = problem](const Displacement<3>& given, const std::string& why) {
    const GivenEnergyOf<3> energy = certify_given(problem, given);
    EXPECT_FALSE(energy.valid);
    EXPECT_NE(energy.reason.find(why), std::string::npos) << energy.reason;
    EXPECT_FALSE(certify_distance(problem, u, stress, given).valid);
  };
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Displacement<3> given = u;
    given.vertex[2][1] = bad;
    expect_refused(given, "not finite");
    given = u;
    given.edge[3][2] = bad;
    expect_refused(given, "not finite");
  }
  Displacement<3> given = u;
  given.degree = 3;
  expect_refused(given, "no degree");
  given = u;
  given.edge.pop_back();
  expect_refused(given, "not those of this mesh");
  given = u;
  for (auto& v : given.vertex) v *= 1e200;
  expect_refused(given, "enclosed");
}

}  // namespace
}  // namespace bracket::bounds::space
