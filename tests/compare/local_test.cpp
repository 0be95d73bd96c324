// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <optional>

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
    EXPECT_LE(solved.upper + before, 1.3 * (solved.upper + solved.least) + rounding * solved.size()) << name;
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

scene::Scene<2> local(scene::Scene<2> scene, scene::Strategy strategy, int levels, std::optional<int> sweeps = {}) {
  scene.solve = {.dual = scene::Dual::local, .sweeps = sweeps};
  scene.refine.strategy = strategy;
  scene.refine.max_levels = levels;
  return scene;
}
scene::Scene<2> hybrid(scene::Scene<2> scene) {
  scene.solve = {};
  return scene;
}
scene::Scene<2> with_poisson(scene::Scene<2> scene, double poisson) {
  scene.bodies = {{"lower", scene::isotropic<2>(1, poisson, scene::Plane::strain)},
                  {"upper", scene::isotropic<2>(2, poisson, scene::Plane::strain)}};
  return scene;
}

void expect_sound(const bounds::Outcome<2>& outcome, const std::string& what) {
  ASSERT_FALSE(outcome.levels.empty()) << what << ": " << outcome.reason;
  EXPECT_EQ(outcome.guarantee, "rounding-safe") << what << ": " << outcome.reason;
  for (const bounds::Level& level : outcome.levels) {
    EXPECT_TRUE(level.certificate.valid) << what << ": " << level.certificate.reason;
    EXPECT_TRUE(level.checks.passed()) << what << ": " << level.checks.worst().name;
    EXPECT_LE(level.checks.gap_identity, 1e-10) << what;
  }
}

TEST(LocalRun, contains_the_exact_energy_on_every_level) {
  struct Case {
    scene::Scene<2> scene;
    double least, most;  // between which it lies
  };
  std::vector<Case> cases = {{tests::smooth(3), tests::smooth_energy, tests::smooth_energy},
                             {tests::two_blocks(4), -0.00156588569415, -0.00156588566432},
                             {tests::two_blocks(4, 0.02), -0.0016699750, -0.0016695802}};
  for (const double poisson : {0.3, 0.4999}) {
    const double modulus = 1e6 / (1 - poisson * poisson), unit = 1 / (1 - poisson * poisson);
    const double of_patch = 0.5 * modulus * 1e-4, of_linear = -(1 + 0.25 / 3) * (1 + 0.25) / unit;
    cases.push_back({tests::patch(1e6, poisson, 0.01, 3), of_patch, of_patch});
    cases.push_back({tests::linear_pressure({.poisson = poisson}, 4, 2), of_linear, of_linear});
  }
  for (const auto& [scene, least, most] : cases)
    for (const auto strategy : {scene::Strategy::uniform, scene::Strategy::adaptive}) {
      const auto outcome = bounds::run(local(scene, strategy, 4));
      expect_sound(outcome, fmt::format("{}", least));
      for (const bounds::Level& level : outcome.levels) {
        EXPECT_LE(level.bracket.lower, most);
        EXPECT_GE(level.bracket.upper, least);
      }
    }
}

std::vector<std::pair<std::string, scene::Scene<2>>> all_kinds() {
  auto result = std::vector<std::pair<std::string, scene::Scene<2>>>{
      {"everything", tests::everything(5, 4, 3)}, {"smooth", tests::smooth(4)}, {"closed", tests::two_blocks(4, 0.02)}};
  for (const double poisson : {0.3, 0.49, 0.4999})
    result.emplace_back(fmt::format("lift-off, ν = {}", poisson), with_poisson(tests::two_blocks(6), poisson));
  result.emplace_back("held together", tests::two_blocks(4));
  result.back().second.contact[0].law = scene::Law::bilateral;
  result.emplace_back("bonded", tests::two_blocks(4));
  result.back().second.bonds = {{"upper.bottom", "lower.top"}};
  result.back().second.contact.clear();
  return result;
}

TEST(LocalRun, is_little_wider_than_the_hybrid_on_every_level_and_has_its_upper_bound) {
  for (const auto& [name, scene] : all_kinds()) {
    const auto own = local(scene, scene::Strategy::uniform, 3);
    const auto outcome = bounds::run(own), best = bounds::run(hybrid(own));
    expect_sound(outcome, name);
    ASSERT_EQ(outcome.levels.size(), best.levels.size()) << name;
    for (std::size_t i = 0; i < best.levels.size(); ++i) {
      const auto &wide = outcome.levels[i].bracket, &least = best.levels[i].bracket;
      const double size = std::abs(least.upper);
      EXPECT_NEAR(wide.upper, least.upper, 1e-10 * size) << name;
      EXPECT_LE(wide.lower, least.lower + 1e-10 * size) << name;
      EXPECT_LE(wide.upper - wide.lower, 1.3 * (least.upper - least.lower)) << name << ", level " << i;
    }
  }
}

TEST(LocalRun, no_further_sweep_lowers_the_lower_bound) {
  for (const auto& [name, scene] : all_kinds()) {
    double before = -std::numeric_limits<double>::infinity();
    for (const int sweeps : {1, 2, 5}) {
      const auto outcome = bounds::run(local(scene, scene::Strategy::none, 1, sweeps));
      expect_sound(outcome, name);
      EXPECT_GE(outcome.lower, before - 1e-10 * std::abs(outcome.upper)) << name << ", " << sweeps;
      before = outcome.lower;
    }
  }
}

TEST(LocalRun, follows_arcs) {
  const double at = std::sqrt(0.5);
  scene::Scene<2> scene = tests::two_blocks(1, 0.02);
  scene.curves = {{"upper.top", {scene::Circle{{0.5, 1.5}, at}, ""}}};
  const auto outcome = bounds::run(local(scene, scene::Strategy::uniform, 3));
  expect_sound(outcome, "arc");
  EXPECT_EQ(outcome.levels.size(), 3u);
}

TEST(LocalRun, refuses_problems_with_springs_or_friction) {
  const scene::Scene<2> scene = local(tests::two_blocks(4), scene::Strategy::none, 1);
  for (const scene::FacetLaw& law : {scene::FacetLaw{.modulus = {1, 1}}, scene::FacetLaw{.friction = {0, 1}}}) {
    Problem<2> problem = tests::problem(scene);
    problem.contact[0].law = law;
    try {
      bounds::run(scene, std::move(problem));
      ADD_FAILURE() << "accepted";
    } catch (const scene::Error& error) {
      EXPECT_EQ(error.status(), scene::Status::input);
      EXPECT_NE(std::string(error.what()).find("solve.dual = \"hybrid\""), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace bracket
