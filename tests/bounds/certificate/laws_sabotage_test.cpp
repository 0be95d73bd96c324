// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// What breaks a contact law is found, by the judge or by the certificate.
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "tests/bounds/certificate/judge_parts.h"
#include "tests/bounds/certificate/laws_cases.h"
#include "tests/bounds/certificate/noise.h"

namespace bracket::bounds::of_laws {
namespace {

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
        for (auto* g : {&p.contact[0].lower, &p.contact[0].upper}) (*g)[0] += 1e-9, (*g)[2] += 1e-9;
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
  auto problem = balanced(tests::problem(with_law(tests::touching_end(0.1), law_named("bilateral"))), 2);
  const auto [u, stress] = solved(problem, 2);
  ASSERT_TRUE(certify(problem, u, stress).valid) << certify(problem, u, stress).reason;
  for (auto& pair : problem.contact) pair.lower = pair.upper = {0.125, 0.125, 0.125};
  const Certificate certificate = certify(problem, u, stress);
  EXPECT_FALSE(certificate.valid);
  EXPECT_NE(certificate.reason.find("miss the gap"), std::string::npos) << certificate.reason;
}

}  // namespace
}  // namespace bracket::bounds::of_laws
