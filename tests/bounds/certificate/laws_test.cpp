// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Contact laws before the judge in rational arithmetic.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "dual/dual.h"
#include "primal/primal.h"
#include "scene/problem/law.h"
#include "tests/bounds/certificate/cases.h"
#include "tests/bounds/certificate/judge_parts.h"
#include "tests/bounds/certificate/noise.h"

namespace bracket::bounds {
namespace {

using scene::Law;

struct GivenLaw {
  std::string name;
  Law law;
  std::optional<scene::Function<2>> value = {};
  bool lifts_off = true;
};

/// Of numbers so short that pieces of facets have them without rounding.
std::vector<GivenLaw> laws() {
  const auto linear = [](double a, double b) {
    return scene::enclosed<2>([a, b](const auto& x) { return a + b * x[0]; });
  };
  return {{"bilateral", Law::bilateral},
          {"springs", Law::winkler, tests::constant(2)},
          {"linear springs", Law::winkler, linear(4, 0.5)},
          {"springs that pull", Law::winkler, linear(4, 0.5), false},
          {"friction", Law::tresca, tests::constant(1.0 / 64)},
          {"linear friction", Law::tresca, linear(0.125, 1.0 / 32)},
          {"friction without lift-off", Law::tresca, tests::constant(1.0 / 64), false}};
}

scene::Scene<2> with_law(scene::Scene<2> scene, const GivenLaw& law) {
  for (auto& pair : scene.contact) {
    pair.law = law.law;
    pair.value = law.value;
    pair.lifts_off = law.lifts_off;
  }
  return scene;
}

struct Fields {
  scene::Displacement<2> displacement;
  scene::Stress<2> stress;
};
/// Whatever the solvers end with.
Fields solved(const scene::Problem<2>& problem, int degree) {
  return {primal::solve(problem, degree).displacement, dual::solve(problem, scene::stress_degree(degree)).stress};
}

scene::Problem<2> refined(const scene::Problem<2>& first) {
  std::vector<char> marked(first.mesh.cells.size(), 0);
  marked.front() = marked.back() = 1;
  return scene::refine(first, marked).problem;
}

void expect_certificate(const scene::Problem<2>& problem, const Fields& fields) {
  const Certificate certificate = certify(problem, fields.displacement, fields.stress);
  ASSERT_TRUE(certificate.valid) << certificate.reason;
  EXPECT_LE(certificate.lower, certificate.upper);
  expect_holds_exactly(problem, certificate, judged(problem, fields.displacement, fields.stress));
}

/// All laws on scenes of their own, where they can be had.
template <class Check> void for_all_laws(const Check& check) {
  int checked = 0;
  for (const tests::Case& c : tests::cases())
    for (const GivenLaw& law : laws()) {
      if (c.scene.contact.empty() || c.disturb > 0) continue;
      SCOPED_TRACE(c.name + ", " + law.name);
      tests::Case changed = c;
      changed.scene = with_law(c.scene, law);
      scene::Problem<2> problem;
      try {
        problem = tests::problem_of(changed);
      } catch (const scene::Error&) {
        continue;  // friction of sides that do not coincide, a value that is not positive
      }
      check(problem, checked++);
    }
  EXPECT_GT(checked, 80);
}

TEST(CertificateOfLaws, holds_exactly_for_solutions) {
  for_all_laws([](const scene::Problem<2>& problem, int which) {
    const int degree = 1 + which % 4;
    const auto primal = primal::solve(problem, degree);
    if (primal.termination != contact::Termination::solved) return;  // no displacement of degree 1 keeps a curved gap
    expect_certificate(problem, {primal.displacement, dual::solve(problem, scene::stress_degree(degree)).stress});
  });
}

TEST(CertificateOfLaws, holds_exactly_whatever_the_fields) {
  std::mt19937 generator(1);
  int certified = 0;
  for_all_laws([&](const scene::Problem<2>& first, int which) {
    const scene::Problem<2> problem = which % 2 == 0 ? first : refined(first);
    const int degree = 2 + which % 3;
    auto [u, stress] = solved(problem, degree);
    u = tests::noisy(u, 1, 1e-2, generator);
    stress = tests::noisy(stress, 1, 1e-2, generator);
    const Certificate certificate = certify(problem, u, stress);
    if (!certificate.valid) return;
    ++certified;
    expect_holds_exactly(problem, certificate, judged(problem, u, stress));
  });
  EXPECT_GT(certified, 60);
}

/// Two blocks with a law of their own, refined; the sides are pressed and pulled, sheared both ways.
scene::Problem<2> two_blocks(const GivenLaw& law, bool fine = true) {
  tests::Case c = {"two_blocks", with_law(tests::two_blocks(2), law)};
  const auto first = tests::problem_of(c);
  return fine ? refined(first) : first;
}

GivenLaw law_named(const std::string& name) {
  const auto all = laws();
  return *std::ranges::find(all, name, &GivenLaw::name);
}

struct Certified {
  Certificate certificate;
  Judged exact;
};
Certified certified(const scene::Problem<2>& problem) {
  std::mt19937 generator(7);
  auto [u, stress] = solved(problem, 2);
  u = tests::noisy(u, 1, 1e-2, generator);
  stress = tests::noisy(stress, 1, 1e-2, generator);
  Certified result{certify(problem, u, stress), judged(problem, u, stress)};
  EXPECT_TRUE(result.certificate.valid) << result.certificate.reason;
  EXPECT_EQ(faults(problem, result.certificate, result.exact), std::vector<std::string>{});
  return result;
}

bool mentions(const std::vector<std::string>& faults, const std::string& what) {
  return std::ranges::any_of(faults, [&](const std::string& one) { return one.find(what) != std::string::npos; });
}

/// With other pressures and shears.
std::vector<std::string> faults_of_loads(const scene::Problem<2>& problem, const Certified& sound,
                                         const std::function<void(EdgeLoads<Exact>&)>& change) {
  EdgeLoads<Exact> loads = sound.exact.loads;
  change(loads);
  spread_loads(problem, loads);
  Judged exact = sound.exact;
  exact.stress = exact_stress(problem, loads, exact.stress.added);
  return faults(problem, sound.certificate, exact);
}

TEST(SabotageOfLaws, tension_where_sides_lift_off) {
  for (const char* name : {"springs", "friction"}) {
    const auto problem = two_blocks(law_named(name));
    const int facet = problem.contact[0].first;
    const auto found = faults_of_loads(problem, certified(problem),
                                       [&](EdgeLoads<Exact>& loads) { loads.along_normal[facet][0] = Exact(-1e-12); });
    EXPECT_TRUE(mentions(found, "tension")) << name;
  }
}

TEST(SabotageOfLaws, tension_that_was_dropped) {
  for (const char* name : {"bilateral", "springs that pull"}) {
    const auto problem = two_blocks(law_named(name));
    const Certified sound = certified(problem);
    bool pulls = false;
    const auto found = faults_of_loads(problem, sound, [&](EdgeLoads<Exact>& loads) {
      for (const auto& pair : problem.contact)
        for (Exact& p : loads.along_normal[pair.first]) {
          pulls = pulls || p < Exact(0);
          p = std::max(p, Exact(0));
        }
    });
    EXPECT_TRUE(pulls);
    EXPECT_FALSE(found.empty()) << name;
  }
}

TEST(SabotageOfLaws, shear_beyond_its_bound) {
  const auto problem = two_blocks(law_named("friction"));
  const auto& pair = problem.contact[0];
  const FirstContacts contacts = first_contacts(problem);
  for (const int sign : {-1, 1}) {
    const auto found = faults_of_loads(problem, certified(problem), [&](EdgeLoads<Exact>& loads) {
      const Exact most = shear_bound<Exact>(problem, contacts, pair, loads.degree)[1];
      loads.along_tangent[pair.first][1] = Exact(sign) * (most + Exact(1e-15));
    });
    EXPECT_TRUE(mentions(found, "beyond its bound"));
  }
}

TEST(SabotageOfLaws, shear_of_one_side_alone) {
  const auto problem = two_blocks(law_named("friction"));
  const Certified sound = certified(problem);
  EdgeLoads<Exact> loads = sound.exact.loads;
  const auto& second = problem.mesh.boundary[problem.contact[0].second];
  loads.edge[second.edge][0].x = Exact(0);
  loads.edge[second.edge][1].x = Exact(0);
  Judged exact = sound.exact;
  exact.stress = exact_stress(problem, loads, exact.stress.added);
  EXPECT_TRUE(mentions(faults(problem, sound.certificate, exact), "pressures differ"));
}

TEST(SabotageOfLaws, sides_that_part) {
  for (const char* name : {"bilateral", "friction without lift-off"}) {
    const auto problem = two_blocks(law_named(name));
    const Certified sound = certified(problem);
    Supports untied = supports_of(problem);
    untied.tie_of.clear();
    untied.ties.clear();
    Judged exact = sound.exact;
    exact.displacement = exact_displacement(problem, exact.field, untied);
    EXPECT_TRUE(mentions(faults(problem, sound.certificate, exact), "apart")) << name;
  }
}

TEST(SabotageOfLaws, half_the_energy_of_springs_and_friction) {
  for (const char* name : {"springs", "linear springs", "springs that pull", "friction"}) {
    const auto problem = two_blocks(law_named(name));
    Certified sound = certified(problem);
    const Around energy = law_energy(problem, sound.exact.displacement);
    ASSERT_GT(energy.lower, Exact(0));
    EXPECT_LE(rounded(energy.upper - energy.lower), 1e-3 * rounded(energy.upper));
    sound.certificate.upper -= rounded(energy.lower) / 2;
    EXPECT_TRUE(mentions(faults(problem, sound.certificate, sound.exact), "below L")) << name;
  }
}

// 1/k by its tangents in the middle, below it, in place of the cubic above it.
TEST(SabotageOfLaws, compliance_from_below) {
  const auto steep = scene::enclosed<2>([](const auto& x) { return 0.25 + 8 * x[0]; });
  for (const bool lifts_off : {true, false}) {
    const auto problem = two_blocks({"steep", Law::winkler, steep, lifts_off}, false);
    Certified sound = certified(problem);
    Exact missing;
    for (const auto& pair : problem.contact) {
      const auto& [k0, k1] = pair.law.modulus;
      const Exact middle = half * (Exact(k0) + Exact(k1)), one(1);
      const Exact slope = half * (Exact(k1) - Exact(k0)) / (middle * middle);
      const Polynomial tangent = Polynomial::linear({one / middle + slope, one / middle - slope});
      const Polynomial p = pressure(problem, sound.exact.stress, pair);
      missing += compliance_energy(problem, first_contacts(problem), pair, sound.exact.loads.along_normal[pair.first]) -
                 half / length_of(problem, pair) * (p * p * tangent).mean();
    }
    EXPECT_GT(missing, Exact(0));
    sound.certificate.lower += rounded(missing);
    EXPECT_TRUE(mentions(faults(problem, sound.certificate, sound.exact), "above −S"));
  }
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

TEST(ProblemFaultOfLaws, are_named) {
  const auto refused = [](const std::string& law, bool fine, const std::function<void(scene::Problem<2>&)>& change,
                          const std::string& named) {
    auto problem = two_blocks(law_named(law), fine);
    const auto [u, stress] = solved(problem, 2);
    ASSERT_TRUE(certify(problem, u, stress).valid) << certify(problem, u, stress).reason;
    change(problem);
    const Certificate certificate = certify(problem, u, stress);
    EXPECT_FALSE(certificate.valid) << named;
    EXPECT_NE(certificate.reason.find(named), std::string::npos) << certificate.reason;
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  refused(
      "springs", false, [](auto& p) { p.contact[0].law.modulus[1] = 0; }, "springs at one end");
  refused(
      "springs", false, [](auto& p) { p.contact[0].law.modulus[1] = nan; }, "not finite");
  refused(
      "springs", false,
      [](auto& p) {
        p.contact[0].law.friction = {1, 1};
      },
      "springs and friction");
  refused(
      "friction", false, [](auto& p) { p.contact[0].law.friction[0] = -1; }, "negative");
  refused(
      "bilateral", false, [](auto& p) { p.contact[0].upper[1] += 1e-9; }, "known up to rounding");
  refused(
      "bilateral", false,
      [](auto& p) {
        for (auto* g : {&p.contact[0].lower, &p.contact[0].upper}) (*g)[0] += 1e-9;
      },
      "jumps");
  for (const char* law : {"springs", "bilateral", "friction"})
    refused(
        law, true, [](auto& p) { p.contact[0].law = {}; }, "another law");
  refused(
      "springs", true, [](auto& p) { p.contact[0].law.modulus[0] *= 1 + 1e-9; }, "another law");
}

// Displacements that are prescribed where sides keep together have to meet their gap.
TEST(ProblemFaultOfLaws, prescribed_displacements_meet_the_gap) {
  for (const double gap : {0.1, 0.125}) {
    auto s = with_law(tests::touching_end(0.1), law_named("bilateral"));
    s.contact[0].gap = tests::constant(gap);
    const auto problem = balanced(tests::problem(s), 2);
    const auto u = primal::solve(problem, 2).displacement;
    scene::Stress<2> stress;
    stress.cell.assign(problem.mesh.cells.size(), std::vector<scene::Voigt<2>>(9, scene::Voigt<2>::Zero()));
    const Certificate certificate = certify(problem, u, stress);
    EXPECT_EQ(certificate.valid, gap == 0.1) << certificate.reason;
    if (gap != 0.1) EXPECT_NE(certificate.reason.find("miss the gap"), std::string::npos) << certificate.reason;
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
      if (i % 8 == 0 || k0 == k1) EXPECT_EQ(one, Exact(1));
    }
  }
}

}  // namespace
}  // namespace bracket::bounds
