// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bounds/certificate/space/problem_faults.h"
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

}  // namespace
}  // namespace bracket::bounds::space
