// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Loads of degree 2 and 3 on the facets of the first mesh.
#include <gtest/gtest.h>

#include <random>

#include "bounds/bounds.h"
#include "bounds/quantities/functional.h"
#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/bounds/certificate/cases.h"
#include "tests/bounds/certificate/judge.h"
#include "tests/bounds/certificate/noise.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

namespace bracket::bounds::of_higher_loads {
namespace {

using scene::Vector;

/// Short numbers, so that what is cut off at halves of facets is exact.
double drawn(std::mt19937& generator) { return std::uniform_int_distribution<int>(-16, 16)(generator) / 64.0; }

/// Two bodies between supports and loads of all kinds, the coefficients beside the linear loads by chance.
/// \param degree of the loads   \param inclined turned and stretched, so that sides keep rational lengths
scene::Problem<2> loaded(int degree, bool inclined, unsigned seed) {
  scene::Scene<2> s = tests::two_bodies(0, 2, 1, 1, 2, 1);
  s.bodies = {{"lower", scene::isotropic<2>(1, 0.25, scene::Plane::strain)},
              {"upper", scene::isotropic<2>(4, 0.125, scene::Plane::strain)}};
  s.bodies.at("lower").force = {1.0 / 64, -1.0 / 32};
  s.boundary = {{"lower.bottom", tests::fixed(1.0 / 64, 0)},
                {"lower.left", tests::pressure(tests::constant(0.25))},
                {"upper.right", tests::sliding(1.0 / 32)},
                {"upper.top", tests::traction(tests::constant(0.0625), tests::constant(-0.5))}};
  std::mt19937 generator(seed);
  scene::Problem<2> problem = tests::problem_of({"loaded", s, inclined});
  const auto& mesh = problem.mesh;
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    auto& data = problem.facets[f];
    if (data.support != scene::Support::traction) continue;
    const std::string& part = mesh.parts[mesh.boundary[f].part];
    for (int k = 0; k < degree - 1; ++k) {
      if (part != "lower.left") data.higher_traction[k] = {drawn(generator), drawn(generator)};
      if (part != "upper.top") data.higher_pressure[k] = drawn(generator);
    }
  }
  return problem;
}

struct Fields {
  scene::Displacement<2> displacement;
  scene::Stress<2> stress;
};
Fields solved(const scene::Problem<2>& problem, int degree) {
  const auto u = primal::solve(problem, degree);
  const auto lambda = dual::solve(problem, scene::stress_degree(degree));
  EXPECT_EQ(u.termination, contact::Termination::solved) << u.reason;
  EXPECT_EQ(lambda.termination, contact::Termination::solved) << lambda.reason;
  return {u.displacement, lambda.stress};
}

scene::Problem<2> refined(const scene::Problem<2>& problem, int times) {
  scene::Problem<2> result = problem;
  for (int i = 0; i < times; ++i) {
    std::vector<char> marked(result.mesh.cells.size(), 0);
    marked[0] = marked[marked.size() / 2] = marked.back() = 1;
    result = scene::refine(result, marked).problem;
  }
  return result;
}

/// \param check gets the problem, the degree of displacements and the fields
template <class Check> void for_all(const Check& check) {
  for (const int degree : {3, 4})
    for (const bool inclined : {false, true})
      for (const int times : {0, 2}) {
        if (tests::sanitized && (inclined != (degree == 4) || inclined != (times == 0))) continue;
        SCOPED_TRACE(testing::Message() << "degree " << degree << ", inclined " << inclined << ", refined " << times);
        const auto problem = refined(loaded(degree - 1, inclined, 10 * degree + inclined), times);
        check(problem, degree, solved(problem, degree));
      }
}

TEST(HigherLoads, certificates_hold_exactly) {
  for_all([](const scene::Problem<2>& problem, int, const Fields& fields) {
    const Certificate certificate = certify(problem, fields.displacement, fields.stress);
    ASSERT_TRUE(certificate.valid) << certificate.reason;
    expect_holds_exactly(problem, certificate, judged(problem, fields.displacement, fields.stress));
    EXPECT_LE(certificate.upper - certificate.lower, 0.05 * std::abs(certificate.upper));
  });
}

TEST(HigherLoads, certificates_hold_exactly_for_spoilt_fields) {
  std::mt19937 generator(1);
  for_all([&](const scene::Problem<2>& problem, int, const Fields& fields) {
    const auto u = tests::noisy(fields.displacement, 1, 1e-3, generator);
    const auto stress = tests::noisy(fields.stress, 1, 1e-3, generator);
    const Certificate certificate = certify(problem, u, stress);
    ASSERT_TRUE(certificate.valid) << certificate.reason;
    expect_holds_exactly(problem, certificate, judged(problem, u, stress));
  });
}

// What the fields say as they were computed: λ_h n is the load, and L + S the sum of the indicators.
TEST(HigherLoads, fields_keep_them_to_rounding) {
  for_all([](const scene::Problem<2>& problem, int, const Fields& fields) {
    Checks checks = admissibility(problem, fields.displacement, fields.stress);
    const Indicator indicators = indicator(problem, fields.displacement, fields.stress);
    const PlainEnergies plain = plain_energies(problem, fields.displacement, fields.stress, indicators);
    checks.gap_identity = plain.gap_identity;
    EXPECT_LE(checks.worst().value, 1e-11) << checks.worst().name;
    const Certificate certificate = certify(problem, fields.displacement, fields.stress);
    EXPECT_NEAR(plain.upper, certificate.upper, 1e-11 * std::abs(certificate.upper));
    EXPECT_NEAR(plain.lower, certificate.lower, 1e-11 * std::abs(certificate.lower));
  });
}

TEST(HigherLoads, stresses_of_a_lower_degree_are_refused) {
  for (const int degree : {2, 3}) {
    const auto problem = loaded(degree, false, 5), linear = loaded(1, false, 5);
    const auto [u, stress] = solved(linear, degree);
    const Certificate certificate = certify(problem, u, stress);
    EXPECT_FALSE(certificate.valid);
    EXPECT_NE(certificate.reason.find("cannot carry"), std::string::npos) << certificate.reason;
    EXPECT_THROW(dual::solve(problem, degree - 1), std::invalid_argument);
  }
}

TEST(HigherLoads, one_that_is_not_finite_is_refused) {
  auto problem = loaded(3, false, 6);
  const auto [u, stress] = solved(problem, 4);
  for (auto& data : problem.facets) {
    const auto kept = data;
    for (int k = 0; k < 2; ++k) {
      data.higher_traction[k][k] = std::numeric_limits<double>::quiet_NaN();
      EXPECT_FALSE(certify(problem, u, stress).valid);
      data = kept;
      data.higher_pressure[k] = std::numeric_limits<double>::infinity();
      EXPECT_FALSE(certify(problem, u, stress).valid);
      data = kept;
    }
  }
  EXPECT_TRUE(certify(problem, u, stress).valid);
}

// Half of all data, f times, and all of them are (1 + f/2) times the data; so are the fields.
TEST(HigherLoads, belong_to_half_of_the_data) {
  scene::Quantity<2> energy;
  energy.kind = scene::QuantityKind::energy;
  const double f = 0.5, factor = 1.25;
  for_all([&](const scene::Problem<2>& problem, int, Fields fields) {
    const Certificate plain = certify(problem, fields.displacement, fields.stress);
    ASSERT_TRUE(plain.valid) << plain.reason;
    const auto by = bounds::functionals(scene::Scene<2>{}, problem, energy).above;
    for (auto* values : {&fields.displacement.vertex, &fields.displacement.edge, &fields.displacement.cell})
      for (Vector<2>& value : *values) value *= factor;
    for (auto& cell : fields.stress.cell)
      for (auto& value : cell) value *= factor;
    const auto more = scene::perturbed(problem, by, f, f);
    const Certificate certificate = certify(more, fields.displacement, fields.stress);
    ASSERT_TRUE(certificate.valid) << certificate.reason;
    const double rounding = 1e-13 * std::abs(plain.lower);
    EXPECT_NEAR(certificate.lower, factor * factor * plain.lower, rounding);
    EXPECT_NEAR(certificate.upper, factor * factor * plain.upper, rounding);
  });
}

}  // namespace
}  // namespace bracket::bounds::of_higher_loads
