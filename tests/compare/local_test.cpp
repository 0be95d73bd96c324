// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bounds/bounds.h"
#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/support/scenes.h"

namespace bracket {
namespace {

using scene::Problem;

/// A problem with its displacements and the least S that there is on its mesh, with the pressure of that.
struct Solved {
  Problem<2> problem;
  scene::Displacement<2> displacement;
  std::vector<std::array<double, 2>> pressure;
  double upper, least;

  explicit Solved(const scene::Scene<2>& scene) : problem(bounds::balanced(tests::problem(scene), 2)) {
    displacement = primal::solve(problem, 2).displacement;
    const scene::Stress<2> stress = dual::solve(problem, 1).stress;
    for (const auto& p : bounds::contact_pressure(problem, stress)) pressure.push_back({p[0], p[1]});
    upper = bounds::potential_energy(problem, displacement).total;
    least = bounds::complementary_energy(problem, stress);
  }
  scene::Stress<2> local(const scene::Displacement<2>& u, int sweeps) const {
    return dual::local<2>(problem, pressure, u, sweeps).stress;
  }
  double s(const scene::Stress<2>& stress) const { return bounds::complementary_energy(problem, stress); }
  double size() const { return std::max(std::abs(upper), std::abs(least)); }
};

const double rounding = 1e-11;

void expect_admissible(const Solved& solved, const scene::Stress<2>& stress, const std::string& what) {
  const bounds::Checks checks = bounds::admissibility(solved.problem, solved.displacement, stress);
  for (const auto& check : checks.all()) EXPECT_LE(check.value, 1e-10) << what << ": " << check.name;
  const double width = solved.upper + solved.s(stress);
  EXPECT_NEAR(bounds::indicator(solved.problem, solved.displacement, stress).sum, width, 1e-10 * solved.size()) << what;
}

std::vector<std::pair<std::string, scene::Scene<2>>> scenes() {
  scene::Scene<2> unlike = tests::two_blocks(6);
  unlike.bodies.at("upper") = scene::isotropic<2>(1000, 0.4999, scene::Plane::strain);
  return {{"everything", tests::everything(5, 4, 3)},
          {"lift-off", tests::two_blocks(6)},
          {"unlike moduli", unlike},
          {"smooth", tests::smooth(4)},
          {"floating", tests::linear_pressure({}, 6, 3)}};
}

TEST(LocalStress, is_balanced_and_no_sweep_raises_its_energy) {
  for (const auto& [name, scene] : scenes()) {
    const Solved solved(scene);
    double before = std::numeric_limits<double>::infinity();
    for (int sweeps = 0; sweeps < 3; ++sweeps) {
      const auto stress = solved.local(solved.displacement, sweeps);
      expect_admissible(solved, stress, fmt::format("{}, {} sweeps", name, sweeps));
      const double s = solved.s(stress);
      EXPECT_GE(s, solved.least - rounding * solved.size()) << name;
      EXPECT_LE(s, before + rounding * solved.size()) << name;
      before = s;
    }
    EXPECT_LE(solved.upper + before, 1.3 * (solved.upper + solved.least)) << name;
  }
}

TEST(LocalStress, is_balanced_whatever_displacement_it_starts_from) {
  for (const auto& [name, scene] : scenes()) {
    const Solved solved(scene);
    scene::Displacement<2> none = solved.displacement;
    for (auto* values : {&none.vertex, &none.edge})
      for (auto& u : *values) u.setZero();
    expect_admissible(solved, solved.local(none, 1), name);
  }
}

TEST(LocalStress, finds_what_is_in_its_space) {
  for (const double poisson : {0.3, 0.49, 0.4999}) {
    const Solved linear(tests::linear_pressure({.poisson = poisson}, 6, 3)), patch(tests::patch(1e6, poisson, 0.01, 3));
    for (const Solved* solved : {&linear, &patch})
      EXPECT_NEAR(-solved->s(solved->local(solved->displacement, 0)), solved->upper, 1e-9 * std::abs(solved->upper));
  }
}

}  // namespace
}  // namespace bracket
