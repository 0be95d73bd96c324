// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "bounds/bounds.h"
#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/bounds/certificate/cases.h"
#include "tests/bounds/certificate/judge.h"
#include "tests/bounds/certificate/noise.h"
#include "tests/support/scenes.h"

namespace bracket::bounds {
namespace {

using scene::Vector;

/// Judges the certificates of all degrees on all cases.
template <class Check> void for_all_cases(const Check& check) {
  int seen = 0;
  for (const tests::Case& c : tests::cases())
    for (const int degree : {1, 2, 3, 4}) {
      if (++seen % tests::one_in != 0) continue;
      SCOPED_TRACE(c.name + ", degree " + std::to_string(degree));
      const auto problem = tests::problem_of(c);
      const auto displacements = primal::solve(problem, degree);
      const auto stresses = dual::solve(problem, scene::stress_degree(degree));
      ASSERT_EQ(displacements.termination, contact::Termination::solved) << displacements.reason;
      ASSERT_EQ(stresses.termination, contact::Termination::solved) << stresses.reason;
      const Certificate certificate = certify(problem, displacements.displacement, stresses.stress);
      ASSERT_TRUE(certificate.valid) << certificate.reason;
      check(problem, certificate, judged(problem, displacements.displacement, stresses.stress));
    }
}

TEST(Certificate, fields_are_admissible_exactly) {
  for_all_cases([](const scene::Problem<2>& problem, const Certificate&, const Judged& exact) {
    EXPECT_EQ(faults(problem, exact.displacement), std::vector<std::string>{});
    EXPECT_EQ(faults(problem, exact.stress), std::vector<std::string>{});
    const auto supports = supports_of(problem);
    for (const auto& pair : problem.contact)
      for (const Exact& r : penetration<Exact>(problem, supports, exact.field, pair)) EXPECT_LE(r, Exact(0));
  });
}

TEST(Certificate, energies_are_those_of_the_fields_exactly) {
  for_all_cases([](const scene::Problem<2>& problem, const Certificate&, const Judged& exact) {
    const auto supports = supports_of(problem);
    const Exact l = potential_energy(problem, exact.displacement, exact.stress.added);
    const Exact s = complementary_energy(problem, exact.stress, exact.displacement);
    EXPECT_EQ((field_energy<Exact, RationalSum>(problem, supports, exact.field, exact.stress.added).total), l);
    EXPECT_EQ((stress_energy<Exact, RationalSum>(problem, exact.loads)), s);
    EXPECT_EQ(l + s, distance(problem, exact.stress, exact.displacement));
  });
}

TEST(Certificate, contains_the_exact_energies_and_is_narrow) {
  for_all_cases([](const scene::Problem<2>& problem, const Certificate& certificate, const Judged& exact) {
    const Exact l = potential_energy(problem, exact.displacement, exact.stress.added);
    const Exact s = complementary_energy(problem, exact.stress, exact.displacement);
    EXPECT_LE(certificate.lower, certificate.upper);
    EXPECT_LE(Exact(certificate.lower), -s);
    EXPECT_GE(Exact(certificate.upper), l);
    const double size = std::max(std::abs(certificate.lower), std::abs(certificate.upper));
    // Stresses are second differences of what is integrated twice: six of nineteen digits may go.
    EXPECT_LE(rounded(-s - Exact(certificate.lower)), 1e-12 * size);
    EXPECT_LE(rounded(Exact(certificate.upper) - l), 1e-12 * size);
    const Exact strain = strain_energy(problem, exact.displacement);
    EXPECT_LE(Exact(certificate.strain_energy), strain);
    EXPECT_NEAR(certificate.strain_energy, rounded(strain), 1e-13 * rounded(strain));
  });
}

TEST(Certificate, with_enough_digits_contains_the_exact_energies_and_is_a_hundredth_wider) {
  int in_doubles = 0, seen = 0;
  for (const tests::Case& c : tests::cases())
    for (const int degree : {1, 2, 3, 4}) {
      if (++seen % tests::one_in != 0) continue;
      SCOPED_TRACE(c.name + ", degree " + std::to_string(degree));
      const auto problem = tests::problem_of(c);
      const auto u = primal::solve(problem, degree).displacement;
      const auto stress = dual::solve(problem, scene::stress_degree(degree)).stress;
      const Certificate narrow = certify(problem, u, stress), enough = certify(problem, u, stress, Digits::enough);
      ASSERT_TRUE(narrow.valid && enough.valid) << narrow.reason << enough.reason;
      const Judged exact = judged(problem, u, stress);
      EXPECT_EQ(faults(problem, enough, exact), std::vector<std::string>{});
      // The width between the middles, m, is at most R more than it is exactly, and R at most m/256; then the bounds
      // are rounded outward.
      const Exact between = potential_energy(problem, exact.displacement, exact.stress.added) +
                            complementary_energy(problem, exact.stress, exact.displacement);
      const double rounding = 4 * std::numeric_limits<double>::epsilon() * std::abs(enough.lower);
      EXPECT_LE(enough.upper - enough.lower,
                std::max(257.0 / 255 * rounded(between) + rounding, narrow.upper - narrow.lower));
      in_doubles += enough.upper - enough.lower > narrow.upper - narrow.lower ? 1 : 0;
    }
  EXPECT_GT(4 * in_doubles, seen / tests::one_in);
}

TEST(Certificate, with_enough_digits_knows_an_energy_of_zero) {
  // At rest without a load, and displacements that stretch the block; or displacements of rest, and stresses.
  scene::Scene<2> s;
  s.blocks = {tests::block("block", 0, 1, 0, 1, 3, 3)};
  s.bodies = {{"block", scene::isotropic<2>(2, 0.3, scene::Plane::strain)}};
  s.boundary = {{"block.bottom", tests::fixed(0, 0)}};
  const auto problem = scene::fix_data(s, scene::build_mesh(s));
  for (const int degree : {1, 2, 3, 4}) {
    const auto rest = primal::solve(problem, degree).displacement;
    const auto none = dual::solve(problem, scene::stress_degree(degree)).stress;
    auto stretch = rest;
    stretch.vertex.back() = {0.1, 0.1};
    const Certificate stretched = certify(problem, stretch, none, Digits::enough);
    EXPECT_EQ(stretched.lower, 0);
    EXPECT_GT(stretched.upper, 0);
    auto some = none;
    for (auto& cell : some.cell)
      for (auto& value : cell) value.setConstant(0.1);
    const Certificate stressed = certify(problem, rest, some, Digits::enough);
    EXPECT_LT(stressed.lower, 0);
    EXPECT_EQ(stressed.upper, 0);
  }
}

TEST(Certificate, nothing_penetrates_however_little) {
  // Along the wall as nearly as doubles can: some vertices go into it by less than the enclosures can tell from zero.
  tests::Case c = {"touching_at_rest", tests::touching_end(0), true};
  c.scene.blocks = {tests::block("block", 0, 1, 0, 1, 16, 1)};
  const auto problem = tests::problem_of(c);
  const auto supports = supports_of(problem);
  const Vector<2>& d = problem.facets[problem.contact[0].first].normal;
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> along(-1, 1);
  for (int trial = 0; trial < 500; ++trial) {
    scene::Displacement<2> u{1, std::vector<Vector<2>>(problem.mesh.vertices.size()), {}};
    for (Vector<2>& value : u.vertex) {
      value[0] = along(generator);
      value[1] = static_cast<double>(-static_cast<long double>(value[0]) * d[0] / d[1]);
    }
    const auto admissible = admissible_field(problem, u, supports);
    ASSERT_TRUE(admissible.field) << admissible.reason;
    for (const auto& pair : problem.contact)
      for (const Exact& r : penetration<Exact>(problem, supports, *admissible.field, pair)) ASSERT_LE(r, Exact(0));
  }
}

/// Two bodies and a wall in any direction, their shape, materials, supports, weights and gaps by chance; no tractions,
/// so that no length is needed.
scene::Problem<2> random_problem(std::mt19937& generator) {
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(generator);
  };
  const auto one_of = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(generator); };
  scene::Scene<2> s = tests::two_bodies(0, 1, uniform(0.1, 1), uniform(0.1, 1), 1 + one_of(3), 1 + one_of(2));
  if (one_of(2) == 0) s.plane = scene::Plane::stress;
  for (const std::string name : {"lower", "upper"}) {
    const double young = std::pow(10, uniform(-3, 3));
    scene::Body<2> body = scene::isotropic<2>(young, uniform(-0.5, 0.49999), s.plane);
    if (one_of(3) == 0) {
      const scene::Elasticity<2> root = scene::Elasticity<2>::NullaryExpr([&] { return uniform(-1, 1); });
      const scene::Elasticity<2> definite = root * root.transpose() + scene::Elasticity<2>::Identity();
      body.material = scene::anisotropic<2>(definite.selfadjointView<Eigen::Upper>());
    }
    body.force = {uniform(-1, 1), name == "upper" ? uniform(-2, 0) : uniform(-1, 1)};
    s.bodies.emplace(name, body);
    for (const std::string side : {"left", "right"}) switch (one_of(4)) {
        case 0: s.boundary[name + "." + side] = tests::fixed(0.1, 0.1); break;
        case 1: s.boundary[name + "." + side] = tests::sliding(side == "left" ? -0.1 : 0.1 * one_of(2)); break;
        default: break;
      }
  }
  if (one_of(3) == 0) s.boundary["upper.top"] = tests::fixed(0.1, 0.1);
  if (one_of(2) == 0)
    s.boundary["lower.bottom"] = tests::fixed(0.1, 0.1);
  else
    s.contact.push_back({"lower.bottom", "rigid", tests::constant(uniform(0.3, 0.4)), ""});
  const double bend = uniform(-0.1, 0.2);
  s.contact[0].gap = scene::enclosed<2>([bend](const auto& x) { return bend * x[0] * x[0] + 0.2 * std::abs(bend); });
  auto mesh = scene::build_mesh(s);
  const double stretch = uniform(0.3, 1), shear = uniform(-0.5, 0.5);
  const Eigen::Rotation2Dd turn(one_of(3) == 0 ? 0 : uniform(0, 6));
  for (Vector<2>& x : mesh.vertices) x = turn * Vector<2>(x[0] + shear * x[1], stretch * x[1]);
  if (one_of(3) == 0) s.contact[0].law = scene::Law::bilateral;
  return scene::fix_data(s, mesh);
}

TEST(Certificate, holds_exactly_on_random_scenes) {
  constexpr int scenes = 40;
  int certified = 0;
  for (int seed = 0; seed < scenes; seed += tests::one_in) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 generator(seed);
    const int degree = 1 + seed % 4;
    scene::Problem<2> problem;
    try {
      problem = balanced(random_problem(generator), degree);
    } catch (const scene::Error&) {
      continue;  // supports that contradict each other, or bodies that nothing holds
    }
    const auto displacements = primal::solve(problem, degree);
    const auto stresses = dual::solve(problem, scene::stress_degree(degree));
    if (displacements.termination != contact::Termination::solved ||
        stresses.termination != contact::Termination::solved)
      continue;
    const double noise = seed % 3 == 0 ? 1e-3 : 0;
    const auto u = tests::noisy(displacements.displacement, 1, noise, generator);
    const auto stress = tests::noisy(stresses.stress, 1, noise, generator);
    const Certificate certificate = certify(problem, u, stress);
    ASSERT_TRUE(certificate.valid) << certificate.reason;
    ++certified;
    const Judged exact = judged(problem, u, stress);
    expect_holds_exactly(problem, certificate, exact);
    EXPECT_EQ(faults(problem, certify(problem, u, stress, Digits::enough), exact), std::vector<std::string>{});
  }
  EXPECT_GT(3 * certified, scenes / tests::one_in);
}

}  // namespace
}  // namespace bracket::bounds
