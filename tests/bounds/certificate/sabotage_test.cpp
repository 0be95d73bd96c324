// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bounds/bounds.h"
#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/bounds/certificate/exact_scenes.h"
#include "tests/bounds/certificate/judge.h"
#include "tests/bounds/certificate/noise.h"
#include "tests/support/sanitized.h"

/// The certificate of fields that no solver gave: it holds, or there is none.
namespace bracket::bounds {
namespace {

std::vector<tests::ExactProblem> problems() {
  return {tests::exact_patch(1e6, 0.3, 0.01, 2), tests::exact_patch(1, 0.49, 0.1, 4),
          tests::exact_linear_pressure({}, 4, 2), tests::exact_linear_pressure({.c = 0.875}, 8, 4),
          tests::exact_linear_pressure({.young_lower = 1e6, .poisson = 0.4999}, 4, 2)};
}

struct Fields {
  scene::Displacement<2> displacement;
  scene::Stress<2> stress;
};
Fields solved(const scene::Problem<2>& problem, int degree) {
  return {primal::solve(problem, degree).displacement, dual::solve(problem, scene::stress_degree(degree)).stress};
}

void expect_holds(const Certificate& certificate, const Rational& energy) {
  EXPECT_LE(Rational(certificate.lower), energy);
  EXPECT_GE(Rational(certificate.upper), energy);
}

TEST(Sabotage, noise_makes_the_interval_wider_and_never_wrong) {
  std::mt19937 generator(1);
  for (const auto& [problem, energy] : problems())
    for (const int degree : {1, 2, 3, 4}) {
      const auto [u, stress] = solved(problem, degree);
      const Certificate clean = certify(problem, u, stress);
      ASSERT_TRUE(clean.valid) << clean.reason;
      expect_holds(clean, energy);
      for (const double size : {1e-9, 1e-3, 1e-1})
        for (int trial = 0; trial < 5; ++trial) {
          const Certificate noisy =
              certify(problem, tests::noisy(u, 1, size, generator), tests::noisy(stress, 1, size, generator));
          ASSERT_TRUE(noisy.valid || size > 1e-2) << noisy.reason;
          if (!noisy.valid) {
            EXPECT_FALSE(noisy.reason.empty());
            continue;
          }
          expect_holds(noisy, energy);
          EXPECT_GT(noisy.upper - noisy.lower, clean.upper - clean.lower);
        }
    }
}

TEST(Sabotage, each_bound_stands_for_itself) {
  std::mt19937 generator(2);
  for (const auto& [problem, energy] : problems()) {
    const auto [u, stress] = solved(problem, 2);
    const Certificate clean = certify(problem, u, stress);
    EXPECT_EQ(certify(problem, tests::noisy(u, 1, 1e-3, generator), stress).lower, clean.lower);
    EXPECT_EQ(certify(problem, u, tests::noisy(stress, 1, 1e-3, generator)).upper, clean.upper);
  }
}

TEST(Sabotage, garbage_gives_a_wide_interval_or_a_reason) {
  std::mt19937 generator(3);
  int valid = 0;
  for (const auto& [problem, energy] : problems())
    for (const int degree : {1, 2, 3, 4}) {
      const auto [u, stress] = solved(problem, degree);
      for (int trial = 0; trial < 10; ++trial) {
        const Digits digits = trial % 2 == 0 ? Digits::extended : Digits::enough;
        const Certificate certificate =
            certify(problem, tests::noisy(u, 0, 1, generator), tests::noisy(stress, 0, 1, generator), digits);
        EXPECT_NE(certificate.valid, !certificate.reason.empty());
        if (!certificate.valid) continue;
        ++valid;
        expect_holds(certificate, energy);
      }
    }
  EXPECT_GT(valid, 0);
}

TEST(Sabotage, spoilt_fields_are_admissible_exactly) {
  std::mt19937 generator(4);
  int seen = 0;
  for (const auto& [problem, energy] : problems())
    for (const int degree : {1, 2, 3, 4}) {
      if (++seen % (tests::sanitized ? 5 : 1) != 0) continue;  // each degree, each on another problem
      const auto [u, stress] = solved(problem, degree);
      const auto noisy_u = tests::noisy(u, 1, 1e-3, generator);
      const auto noisy_stress = tests::noisy(stress, 1, 1e-3, generator);
      const Certificate certificate = certify(problem, noisy_u, noisy_stress);
      ASSERT_TRUE(certificate.valid) << certificate.reason;
      const Judged exact = judged(problem, noisy_u, noisy_stress);
      expect_holds_exactly(problem, certificate, exact);
      const Certificate enough = certify(problem, noisy_u, noisy_stress, Digits::enough);
      EXPECT_EQ(faults(problem, enough, exact), std::vector<std::string>{});
    }
}

TEST(Sabotage, what_is_not_finite_is_refused_wherever_it_is) {
  const auto [problem, energy] = tests::exact_linear_pressure({}, 2, 1);
  const auto [u, stress] = solved(problem, 2);
  ASSERT_TRUE(certify(problem, u, stress).valid);
  const auto refused = [&](const scene::Displacement<2>& v, const scene::Stress<2>& s) {
    const Certificate certificate = certify(problem, v, s);
    EXPECT_FALSE(certificate.valid);
    EXPECT_NE(certificate.reason.find("not finite"), std::string::npos) << certificate.reason;
  };
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (std::size_t i = 0; i < u.vertex.size(); ++i) {
      auto v = u;
      v.vertex[i][i % 2] = bad;
      refused(v, stress);
    }
    for (std::size_t i = 0; i < u.edge.size(); ++i) {
      auto v = u;
      v.edge[i][i % 2] = -bad;
      refused(v, stress);
    }
    for (auto [c, i] = std::pair(std::size_t{0}, std::size_t{0}); c < stress.cell.size();
         i = (i + 1) % 9, c += i == 0) {
      auto s = stress;
      s.cell[c][i][static_cast<Eigen::Index>(i % 3)] = bad;
      refused(u, s);
    }
  }
}

TEST(Sabotage, what_overflows_is_refused) {
  const auto [problem, energy] = tests::exact_linear_pressure({}, 2, 1);
  auto [u, stress] = solved(problem, 2);
  for (auto& value : u.vertex) value *= 1e200;
  for (auto& value : u.edge) value *= 1e200;
  const Certificate certificate = certify(problem, u, stress);
  EXPECT_FALSE(certificate.valid);
  EXPECT_NE(certificate.reason.find("enclosed"), std::string::npos) << certificate.reason;
}

}  // namespace
}  // namespace bracket::bounds
