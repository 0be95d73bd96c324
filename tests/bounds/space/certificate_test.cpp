// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bounds/certificate/space/problem_faults.h"
#include "scene/problem/refine.h"
#include "tests/bounds/space/cases.h"
#include "tests/bounds/space/judge.h"

namespace bracket::bounds::space {
namespace {

using scene::Problem;

/// The certificate of such fields holds exactly.
void expect_holds(const Problem<3>& problem, int degree, const scene::Voigt<3>& mean, double noise,
                  std::mt19937& generator) {
  const auto u = tests::random_displacement(problem, degree, 0.01, generator);
  const auto stress = tests::random_stress(problem, mean, noise, generator);
  const Certificate certificate = certify(problem, u, stress);
  ASSERT_TRUE(certificate.valid) << certificate.reason;
  expect_holds_exactly(problem, certificate, judged(problem, u, stress));
}

TEST(SpaceCertificate, random_fields_are_admissible_exactly) {
  std::mt19937 generator(1);
  for (const auto& [name, problem, mean] : tests::all_cases())
    for (const int degree : {1, 2}) {
      SCOPED_TRACE(name);
      if (degree == 1 && std::string(name) == "together, bent") continue;
      expect_holds(problem, degree, mean, 0.02, generator);
    }
}

TEST(SpaceCertificate, after_refinement_they_are_so_for_the_first_mesh) {
  std::mt19937 generator(2);
  for (const auto& [name, problem, mean] : tests::all_cases()) {
    SCOPED_TRACE(name);
    const Problem<3> finer = tests::refined(problem, 6, generator);
    EXPECT_LE(finer.mesh.cells.size(), 48u);
    EXPECT_EQ(problem_fault(finer), "");
    expect_holds(finer, 2, mean, 0.02, generator);
  }
}

TEST(SpaceCertificate, takes_what_refine_makes) {
  std::mt19937 generator(3);
  for (auto& [name, problem, mean] : tests::all_cases()) {
    SCOPED_TRACE(name);
    Problem<3> finer = problem;
    for (int level = 0; level < 5; ++level) {
      std::vector<char> marked(finer.mesh.cells.size(), 0);
      for (char& one : marked) one = std::uniform_int_distribution<int>(0, 3)(generator) == 0;
      finer = scene::refine(finer, marked).problem;
      ASSERT_EQ(problem_fault(finer), "");
      const auto u = tests::random_displacement(finer, 2, 0.01, generator);
      const auto stress = tests::random_stress(finer, mean, 1e-3, generator);
      const Certificate certificate = certify(finer, u, stress);
      ASSERT_TRUE(certificate.valid) << certificate.reason;
      EXPECT_LE(certificate.lower, certificate.upper);
      if (level == 0) expect_holds_exactly(finer, certificate, judged(finer, u, stress));
    }
  }
}

// Where both sides are held the gap that they keep has to be what is prescribed.
TEST(SpaceCertificate, of_sides_that_keep_together_and_cannot_move) {
  std::mt19937 generator(4);
  auto [name, problem, mean] = tests::together(0);
  for (auto& facet : problem.facets)
    if (facet.support == scene::Support::sliding) facet.support = scene::Support::fixed;
  ASSERT_EQ(problem_fault(problem), "");
  const auto u = tests::random_displacement(problem, 2, 0.01, generator);
  const auto stress = tests::random_stress(problem, mean, 0.02, generator);
  EXPECT_NE(certify(problem, u, stress).reason.find("no room"), std::string::npos)
      << certify(problem, u, stress).reason;
  for (auto& pair : problem.contact) {
    const auto x = positions(problem.mesh, problem.mesh.boundary[pair.first].vertices);
    for (int k = 0; k < 6; ++k) {  // zero at y = 0
      const auto& [a, b] = k < 3 ? std::array<int, 2>{k, k} : scene::Simplex<2>::edges[k - 3];
      pair.lower[k] = pair.upper[k] = 0.0625 * x[a][1] * x[b][1];
    }
  }
  const Certificate certificate = certify(problem, u, stress);
  ASSERT_TRUE(certificate.valid) << certificate.reason;
  expect_holds_exactly(problem, certificate, judged(problem, u, stress));
}

}  // namespace
}  // namespace bracket::bounds::space
