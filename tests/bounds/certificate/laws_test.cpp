// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Contact laws before the judge in rational arithmetic.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "bounds/estimate/on_mesh.h"
#include "scene/problem/law.h"
#include "tests/bounds/certificate/judge.h"
#include "tests/bounds/certificate/laws_cases.h"
#include "tests/bounds/certificate/noise.h"

namespace bracket::bounds::of_laws {
namespace {

void expect_certificate(const scene::Problem<2>& problem, const Fields& fields) {
  const Certificate certificate = certify(problem, fields.displacement, fields.stress);
  ASSERT_TRUE(certificate.valid) << certificate.reason;
  EXPECT_LE(certificate.lower, certificate.upper);
  expect_holds_exactly(problem, certificate, judged(problem, fields.displacement, fields.stress));
}

/// All laws on scenes of their own, where they can be had, with what the solvers make of them.
template <class Check> void for_all_laws(const Check& check) {
  int seen = 0, checked = 0;
  for (const tests::Case& c : tests::cases())
    for (const GivenLaw& law : laws()) {
      if (c.scene.contact.empty() || c.disturb > 0 || ++seen % tests::one_in != 0) continue;
      const int degree = 1 + checked % 4;
      SCOPED_TRACE(testing::Message() << c.name << ", " << law.name << ", degree " << degree);
      tests::Case changed = c;
      changed.scene = with_law(c.scene, law);
      try {
        const auto problem = tests::problem_of(changed);
        const Fields fields = solved(problem, degree);
        ++checked;
        check(problem, fields);
      } catch (const scene::Error&) {       // a value that is not positive, a curved gap of displacements of degree 1
      } catch (const std::domain_error&) {  // a side whose length is irrational
      }
    }
  EXPECT_GT(checked, 90 / tests::one_in);
}

TEST(CertificateOfLaws, holds_exactly_for_solutions) { for_all_laws(expect_certificate); }

TEST(CertificateOfLaws, holds_exactly_whatever_the_fields) {
  std::mt19937 generator(1);
  int certified = 0;
  for_all_laws([&](const scene::Problem<2>& problem, const Fields& fields) {
    const auto u = tests::noisy(fields.displacement, 1, 1e-2, generator);
    const auto stress = tests::noisy(fields.stress, 1, 1e-2, generator);
    const Certificate certificate = certify(problem, u, stress);
    if (!certificate.valid) return;
    ++certified;
    expect_holds_exactly(problem, certificate, judged(problem, u, stress));
  });
  EXPECT_GT(certified, 70 / tests::one_in);
}

/// Two bodies over a wall, along axes or inclined, with any law between each two; what supports and loads there are by
/// chance, of short numbers.
scene::Problem<2> random_mix(std::mt19937& generator) {
  const auto one_of = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(generator); };
  const auto eighths = [&](int from, int to) { return (from + one_of(to - from + 1)) / 8.0; };
  scene::Scene<2> s = tests::two_bodies(0, 1, eighths(2, 8), eighths(2, 8), 1 << one_of(2), 1);
  s.bodies = {{"lower", scene::isotropic<2>(eighths(4, 32), eighths(-2, 3), scene::Plane::strain)},
              {"upper", scene::isotropic<2>(eighths(4, 32), eighths(-2, 3), scene::Plane::strain)}};
  s.bodies.at("lower").force = {eighths(-1, 1), -eighths(0, 2)};
  s.contact.push_back({"lower.bottom", "rigid", tests::constant(eighths(-1, 1)), ""});
  const double bend = eighths(-1, 1), lift = eighths(-1, 1);
  s.contact[0].gap = scene::enclosed<2>([bend, lift](const auto& x) { return bend * x[0] * x[0] + lift; });
  for (const char* side : {"lower.left", "upper.right", "upper.top"}) switch (one_of(4)) {
      case 0: s.boundary[side] = tests::fixed(eighths(-1, 1), eighths(-1, 1)); break;
      case 1: s.boundary[side] = tests::sliding(eighths(-1, 1)); break;
      case 2:
        s.boundary[side] = tests::traction(tests::constant(eighths(-2, 2)), tests::constant(eighths(-2, 2)));
        break;
      default: break;
    }
  const auto all = laws();
  for (auto& pair : s.contact) {
    const GivenLaw& law = all[one_of(static_cast<int>(all.size()))];
    pair.law = law.law;
    pair.value = law.value;
    pair.lifts_off = law.lifts_off;
    if (law.jumps) set_jump(pair);
  }
  const auto first = tests::problem_of({"random", s, one_of(2) == 0});
  return one_of(2) == 0 && first.corrections.empty() ? refined(first) : first;
}

/// Whether some pair whose sides may part rubs although it presses nowhere: the certificate makes no use of its shear,
/// and refuses what nothing else holds (docs/limits.md).
bool rubs_without_pressing(const scene::Problem<2>& problem, const scene::Stress<2>& stress) {
  std::map<int, double> pressure, shear;
  for (const auto& pair : problem.contact) {
    if (!has_friction(pair.law) || pair.law.two_sided) continue;
    for (const double p : plain_pressure(problem, stress, pair))
      pressure[pair.pair] = std::max(pressure[pair.pair], std::abs(p));
    for (const double t : plain_shear(problem, stress, pair))
      shear[pair.pair] = std::max(shear[pair.pair], std::abs(t));
  }
  return std::ranges::any_of(shear,
                             [&](const auto& of) { return of.second > 0 && pressure[of.first] <= 1e-9 * of.second; });
}

TEST(CertificateOfLaws, holds_exactly_on_random_scenes) {
  int certified = 0;
  constexpr int scenes = 200;  // many have a gap or jump that linear displacements cannot follow
  for (int seed = 0; seed < scenes; seed += tests::one_in) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 generator(seed);
    const int degree = 1 + seed % 4;
    const double noise = seed % 3 == 0 ? 1e-3 : 0;
    try {
      const scene::Problem<2> problem = random_mix(generator);
      const auto primal = primal::solve(problem, degree);
      const auto dual = dual::solve(problem, scene::stress_degree(degree));
      if (!primal.reason.empty() || !dual.reason.empty()) continue;
      if (rubs_without_pressing(problem, dual.stress)) continue;
      ++certified;
      expect_certificate(problem, {tests::noisy(primal.displacement, 1, noise, generator),
                                   tests::noisy(dual.stress, 1, noise, generator)});
    } catch (const scene::Error&) {  // supports that contradict each other or a gap, bodies that nothing holds
    }
  }
  EXPECT_GE(certified, 37 / tests::one_in);
}

/// ½ ‖Δ‖² of what a foundation and a bar above it, in series, are shortened by: by docs/theory.md §9.1 and p = k s.
TEST(CertificateOfLaws, encloses_a_bar_on_springs) {
  const double young = 4, poisson = 0.25, down = 0.125, k = 3;
  for (const bool lifts_off : {true, false})
    for (const int degree : {1, 2, 3, 4}) {
      scene::Scene<2> s;
      s.blocks = {tests::block("bar", 0, 2, 0, 1, 2, 2)};
      s.bodies = {{"bar", scene::isotropic<2>(young, poisson, scene::Plane::strain)}};
      s.boundary = {{"bar.top", tests::sliding(-down)}, {"bar.left", tests::sliding(0)}};
      s.contact = {{"bar.bottom", "rigid", tests::constant(0), ""}};
      const auto problem =
          balanced(tests::problem(with_law(s, {"", Law::winkler, tests::constant(k), lifts_off})), degree);
      const auto [u, stress] = solved(problem, degree);
      const Certificate certificate = certify(problem, u, stress);
      ASSERT_TRUE(certificate.valid) << certificate.reason;
      const Rational nu(poisson), soft = (1 - nu * nu) / Rational(young) + 1 / Rational(k);
      const Rational energy = Rational(down) * Rational(down) / soft;  // half of it, over a width of two
      EXPECT_LE(Rational(certificate.lower), energy);
      EXPECT_GE(Rational(certificate.upper), energy);
      EXPECT_LE(certificate.upper - certificate.lower, 1e-12 * certificate.upper);
    }
}

// The block of Poisson's ratio 0 that is pressed down and carried along: G γ where it sticks; where it slips, g, over
// what is left of the way.
TEST(CertificateOfLaws, encloses_a_block_that_sticks_and_slips) {
  const double young = 2, down = 0.25;
  for (const bool lifts_off : {true, false})
    for (const double along : {-0.125, 0.125, 0.75})
      for (const int degree : {1, 2, 3, 4}) {
        const double bound = 0.5, carried = std::clamp(along, -bound, bound);  // G = 1
        scene::Scene<2> s;
        s.blocks = {tests::block("b", 0, 2, 0, 1, 2, 2)};
        s.bodies = {{"b", scene::isotropic<2>(young, 0, scene::Plane::strain)}};
        s.boundary = {{"b.top", tests::fixed(along, -down)},
                      {"b.right", tests::traction(tests::constant(0), tests::constant(carried))},
                      {"b.left", tests::traction(tests::constant(0), tests::constant(-carried))}};
        s.contact = {{"b.bottom", "rigid", {}, ""}};
        const auto problem =
            balanced(tests::problem(with_law(s, {"", Law::tresca, tests::constant(bound), lifts_off})), degree);
        const auto [u, stress] = solved(problem, degree);
        const Certificate certificate = certify(problem, u, stress);
        ASSERT_TRUE(certificate.valid) << certificate.reason;
        const double slip = std::abs(along - carried);
        const double energy = young * down * down + carried * carried + 2 * bound * slip;  // short numbers: exact
        EXPECT_LE(certificate.lower, energy);
        EXPECT_GE(certificate.upper, energy);
        EXPECT_LE(certificate.upper - certificate.lower, 1e-12 * certificate.upper);
      }
}

// C ≥ 1/k, exactly, and with both at the ends and in the middle.
TEST(Compliance, is_not_below_the_inverse) {
  for (const auto& [k0, k1] :
       {std::array{1.0, 1.0}, std::array{1.0, 1.5}, std::array{0.25, 64.0}, std::array{8.0, 1.0}}) {
    const auto c = scene::compliance_on(Exact(k0), Exact(k1));
    for (int i = 0; i <= 16; ++i) {
      const Exact t(Rational(i, 16)), s = Exact(1) - t, three(3);
      const Exact at = s * s * s * c[0] + three * s * s * t * c[1] + three * s * t * t * c[2] + t * t * t * c[3];
      const Exact one = at * (s * Exact(k0) + t * Exact(k1));
      EXPECT_GE(one, Exact(1));
      if (i % 8 == 0 || k0 == k1) {
        EXPECT_EQ(one, Exact(1));
      }
    }
  }
}

}  // namespace
}  // namespace bracket::bounds::of_laws
