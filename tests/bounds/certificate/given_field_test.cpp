// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/given_field.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/bounds/certificate/cases.h"
#include "tests/bounds/certificate/given_fields.h"
#include "tests/bounds/certificate/judge_given.h"
#include "tests/bounds/certificate/judge_parts.h"

/// What is said of displacements from anywhere, judged by rational numbers on the scenes of the certificate.
namespace bracket::bounds {
namespace {

using scene::Displacement;
using scene::Problem;

/// Judges the four on each case; their degree and that of the fields that they are compared with change from case to
/// case.
template <class Check> void for_all_given(const Check& check) {
  std::mt19937 generator(1);
  int i = 0;
  for (const tests::Case& c : tests::cases()) {
    const int degree = i % 3 + 1, given = i % 2 + 1;
    if (++i % tests::one_in != 0) continue;
    SCOPED_TRACE(fmt::format("{}, degree {}, given {}", c.name, degree, given));
    const Problem<2> first = tests::problem_of(c);
    check(first, degree, tests::given_fields(first, given, generator));
  }
}

/// What keeps a field from being on the supports.
std::vector<std::string> faults_of_supports(const Problem<2>& problem, const ExactDisplacement& u) {
  std::vector<std::string> result = faults(problem, u);
  std::erase_if(result, [](const std::string& fault) { return fault.starts_with("into contact"); });
  return result;
}

/// The largest |u| at the nodes of quadratics.
double largest_at_nodes(const ExactDisplacement& u) {
  double largest = 0;
  for (const Field& of_cell : u.cell)
    for (int i = 0; i < 3; ++i) {
      const Field side = on_side(of_cell, i, (i + 1) % 3);
      const auto at_middle = [](const Polynomial& p) {
        const Polynomial middle = Polynomial::constant(2, half);
        return rounded(p.of({middle, middle, Polynomial(2)}).mean());
      };
      largest = std::max(largest, std::hypot(rounded(side[0].at_end(0)), rounded(side[1].at_end(0))));
      largest = std::max(largest, std::hypot(at_middle(side[0]), at_middle(side[1])));
    }
  return largest;
}

void expect_energy(const Problem<2>& first, const Displacement<2>& given) {
  const GivenEnergy found = certify_given(first, given);
  ASSERT_TRUE(found.valid) << found.reason;
  const ExactDisplacement x = from_nodes(first.mesh, given), s = on_supports(first, given);
  EXPECT_EQ(faults_of_supports(first, s), std::vector<std::string>{});
  const auto [corrections, reason] = corrected<Exact, RationalSum>(first);
  const Exact energy = potential_energy(first, s, corrections);
  EXPECT_LE(Exact(found.lower), energy);
  EXPECT_GE(Exact(found.upper), energy);
  const ExactDisplacement moved = combination(Exact(1), s, Exact(-1), x);
  EXPECT_GE(Exact(found.moved) * Exact(found.moved), Exact(2) * strain_energy(first, moved));
  EXPECT_NEAR(found.misfit, largest_at_nodes(moved), 1e-15 * largest_at_nodes(x));
  ASSERT_EQ(found.below.size(), first.contact.size());
  ASSERT_EQ(found.above.size(), first.contact.size());
  for (std::size_t j = 0; j < first.contact.size(); ++j) {
    const auto& pair = first.contact[j];
    const Polynomial r = approach(first, s, pair);
    EXPECT_TRUE((gap_of(found.below[j]) - (gap_of(pair.lower) - r)).is_not_positive());
    EXPECT_TRUE((gap_of(pair.upper) - r - gap_of(found.above[j])).is_not_positive());
  }
}

TEST(GivenField, its_energy_and_its_way_to_the_contact_are_enclosed) {
  for_all_given([](const Problem<2>& first, int, const auto& fields) {
    for (const auto& [name, given] : fields) {
      SCOPED_TRACE(name);
      expect_energy(first, given);
    }
  });
}

void expect_distance(const Problem<2>& problem, const tests::Fields& own, const Judged& exact,
                     const Displacement<2>& given) {
  const GivenDistance found = certify_distance(problem, own.displacement, own.stress, given);
  ASSERT_TRUE(found.valid) << found.reason;
  const ExactDisplacement x = from_nodes(problem.mesh, given);
  const std::vector<Exact> shares = squared_distances(problem, exact, x);
  Exact square;
  for (std::size_t c = 0; c < shares.size(); ++c) {
    EXPECT_GE(Exact(found.cell[c]), shares[c]);
    square += shares[c];
  }
  EXPECT_EQ(square, squared_distance_by_energies(problem, exact, x));
  expect_root_inside(found.lower, found.upper, square);
  const Exact norm = Exact(2) * strain_energy(problem, exact.displacement);
  expect_root_inside(found.norm_lower, found.norm_upper, norm);
  const Exact t = half * (distance(problem, exact.stress, exact.displacement) +
                          contact_term(problem, exact.stress, exact.displacement));
  expect_root_inside(0, found.stress_error, t);
  // A sum of squares keeps its digits, however small it is beside the energies, but for those of the stresses, whose
  // difference it is: some ten operations, each with u = 2⁻⁶⁴ of a stress that volume makes √(K/μ) ≤ 100 times as
  // large.
  const double of_stresses = 10 * 100 * 0x1p-64 * std::sqrt(rounded(norm));
  EXPECT_LE(found.stress_error, (1 + 1e-9) * std::sqrt(rounded(t)) + of_stresses);
}

TEST(GivenField, its_distance_to_the_mean_stress_is_enclosed) {
  for_all_given([](const Problem<2>& first, int degree, const auto& fields) {
    const tests::Fields own = tests::solved(first, degree);
    const Judged exact = judged(first, own.displacement, own.stress);
    for (const auto& [name, given] : fields) {
      SCOPED_TRACE(name);
      expect_distance(first, own, exact, given);
    }
  });
}

}  // namespace
}  // namespace bracket::bounds
