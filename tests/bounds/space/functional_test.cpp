// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/bounds/space/cases.h"
#include "tests/bounds/space/judge.h"

/// Bounds of functionals in space. What is added to the data is short, so that the sums are numbers, too: then the
/// perturbed problem, taken for one of its own, has the same energies.
namespace bracket::bounds::space {
namespace {

using scene::Perturbation;
using scene::Problem;
using scene::Support;

/// Loads and kinematics of all kinds.
Perturbation<3> everything(const Problem<3>& first) {
  Perturbation<3> by = scene::no_perturbation(first);
  by.force[1] = {0.25, 0, 0.5};
  const auto at = [&](int f, int i) -> const scene::Vector<3>& {
    return first.mesh.vertices[first.mesh.boundary[f].vertices[i]];
  };
  for (int f = 0; f < static_cast<int>(first.facets.size()); ++f)
    for (int i = 0; i < 3; ++i) {
      auto& added = by.facets[f];
      const scene::Vector<3>& x = at(f, i);
      if (first.facets[f].support == Support::traction && first.facets[f].normal[2] > 0.5)
        added.traction[i].value = {0.5 * x[0], 0.25, -0.125};
      if (first.facets[f].support == Support::traction && first.facets[f].normal[0] > 0.5) added.pressure[i] = 0.25;
      if (first.facets[f].support == Support::fixed) added.displacement[i].value = {0.25 * x[1], 0, 0.125 * x[0]};
      if (first.facets[f].support == Support::sliding) added.displacement[i].value = {0.25 * x[1], 0, 0.125 * x[0]};
      if (first.facets[f].support == Support::sliding) added.traction[i].value = {0.125, 0.25 * x[0], 0.0625};
      if (first.facets[f].support == Support::contact) added.traction[i].value = {0.25 * x[1], -0.125, 0.0625};
      if (first.facets[f].support == Support::contact) added.pressure[i] = -0.125;
    }
  for (std::size_t j = 0; j < first.contact.size(); ++j) {
    auto& added = by.contact[j];
    for (int k = 0; k < 6; ++k) {
      const auto& [a, b] = k < 3 ? std::array<int, 2>{k, k} : scene::Simplex<2>::edges[k - 3];
      added.gap[k] = 0.5 + 0.0625 * (at(first.contact[j].first, a)[0] + at(first.contact[j].first, b)[0]);
    }
    added.opening = {0.125, 0.125, 0.125};
  }
  return by;
}

/// The perturbed problem as one of its own.
Problem<3> by_itself(Problem<3> problem) {
  for (const auto& pair : problem.contact)
    for (const int side : {pair.first, pair.second})
      if (side >= 0) problem.facets[side].traction.fill(scene::Vector<3>::Zero());
  problem.perturbed = {};
  problem.origin = {};
  return problem;
}

std::vector<tests::SpaceCase> cases() {
  std::vector<tests::SpaceCase> result = {tests::clamped(), tests::cornered()};
  for (auto& [name, problem, mean] : result) {  // short numbers
    for (auto& facet : problem.facets)
      for (int i = 0; i < 3; ++i) {
        for (double& t : facet.traction[i]) t = std::round(64 * t) / 64;
        for (double& u : facet.displacement[i]) u = std::round(1024 * u) / 1024;
        facet.pressure[i] = std::round(64 * facet.pressure[i]) / 64;
        facet.normal_displacement[i] = std::round(1024 * facet.normal_displacement[i]) / 1024;
      }
    for (auto& body : problem.bodies)
      for (double& force : body.force) force = std::round(64 * force) / 64;
    for (auto& pair : problem.contact)
      for (int k = 0; k < 6; ++k) pair.lower[k] = pair.upper[k] = std::round(1024 * pair.lower[k]) / 1024;
  }
  return result;
}

TEST(SpaceFunctional, is_bounded_by_both_energies) {
  std::mt19937 generator(1);
  for (const auto& [name, problem, mean] : cases()) {
    SCOPED_TRACE(name);
    auto by = std::make_shared<Perturbation<3>>(everything(problem));
    for (auto& contact : by->contact) contact.opening = {0, 0, 0};  // which data of its own have not, …
    for (std::size_t f = 0; f < by->facets.size(); ++f) {           // … nor loads there
      if (problem.facets[f].support == Support::traction) continue;
      by->facets[f].traction.fill({});
      by->facets[f].pressure = {0, 0, 0};
    }
    const auto u = tests::random_displacement(problem, 2, 0.01, generator);
    const auto stress = tests::random_stress(problem, mean, 0.02, generator);
    for (const double f : {0.125, -0.125}) {
      const auto own = [&](double loads, double kinematics) {
        const Certificate result = certify(by_itself(scene::perturbed<3>(problem, by, loads, kinematics)), u, stress);
        EXPECT_TRUE(result.valid) << result.reason;
        return result;
      };
      const FunctionalBound bound = certify_functional(scene::perturbed<3>(problem, by, f, f), u, stress);
      ASSERT_TRUE(bound.valid) << bound.reason;
      // L is by f Q(v) less with the loads, S by f R(λ) with the kinematics.
      const Certificate all = own(f, f), kinematics = own(0, f), loads = own(f, 0);
      const double work = kinematics.upper - all.upper, reactions = all.lower - loads.lower;
      const double above = work + reactions + (all.upper - all.lower + all.contact) / 2;
      EXPECT_NEAR(bound.above, above, 1e-12 * (std::abs(all.upper) + std::abs(all.lower)));
    }
  }
}

TEST(SpaceFunctional, has_bounds_that_never_cross) {
  std::mt19937 generator(2);
  for (auto& [name, problem, mean] : tests::all_cases()) {
    if (std::string(name) == "floating") continue;
    SCOPED_TRACE(name);
    const auto by = std::make_shared<const Perturbation<3>>(everything(problem));
    const Problem<3> finer = tests::refined(problem, 4, generator);
    double least = INFINITY, highest = -INFINITY;
    for (int trial = 0; trial < 6; ++trial)
      for (const double f : {0.25, -0.25}) {
        const Problem<3>& on = trial % 2 == 0 ? problem : finer;
        const auto u = tests::random_displacement(on, 2, 0.01, generator);
        const auto stress = tests::random_stress(on, mean, 0.02, generator);
        const FunctionalBound bound = certify_functional(scene::perturbed<3>(on, by, f, f), u, stress);
        ASSERT_TRUE(bound.valid) << bound.reason;
        (f > 0 ? least : highest) = f > 0 ? std::min(least, bound.above / f) : std::max(highest, bound.above / f);
      }
    EXPECT_LE(highest, least);
  }
}

TEST(SpaceFunctional, of_a_motion_that_nothing_holds_is_refused) {
  std::mt19937 generator(3);
  const auto [name, problem, mean] = tests::floating();
  const auto u = tests::random_displacement(problem, 2, 0.01, generator);
  const auto stress = tests::random_stress(problem, mean, 0.01, generator);
  Perturbation<3> by = scene::no_perturbation(problem);
  for (auto& contact : by.contact) contact.gap.fill(1);
  const auto bound_of = [&](const Perturbation<3>& of) {
    return certify_functional(scene::perturbed<3>(problem, std::make_shared<const Perturbation<3>>(of), 0.125, 0.125),
                              u, stress);
  };
  EXPECT_TRUE(bound_of(by).valid) << bound_of(by).reason;
  by.force[1] = {1, 0, 0};
  EXPECT_NE(bound_of(by).reason.find("nothing holds"), std::string::npos) << bound_of(by).reason;
}

TEST(SpaceFunctional, with_faults_is_refused) {
  std::mt19937 generator(4);
  const auto [name, problem, mean] = tests::clamped();
  const auto u = tests::random_displacement(problem, 2, 0.01, generator);
  const auto stress = tests::random_stress(problem, mean, 0.01, generator);
  const auto reason = [&](const Perturbation<3>& of, double loads, double kinematics) {
    const auto by = std::make_shared<const Perturbation<3>>(of);
    return certify_functional(scene::perturbed<3>(problem, by, loads, kinematics), u, stress).reason;
  };
  const Perturbation<3> sound = everything(problem);
  EXPECT_EQ(reason(sound, 0.125, 0.125), "");
  EXPECT_NE(reason(sound, 0.125, 0.25), "");
  EXPECT_NE(reason(sound, 0, 0), "");
  const auto expect = [&](const std::function<void(Perturbation<3>&)>& change, const std::string& named) {
    Perturbation<3> changed = sound;
    change(changed);
    EXPECT_NE(reason(changed, 0.125, 0.125).find(named), std::string::npos) << named << ": " << reason(changed, 1, 1);
  };
  const int fixed = tests::facet_with(problem, Support::fixed);
  int sliding = static_cast<int>(problem.facets.size()) - 1;  // on the upper body, where nothing is fixed
  while (problem.facets[sliding].support != Support::sliding) --sliding;
  expect([](auto& by) { by.force[0][1] = NAN; }, "not finite");
  expect([](auto& by) { by.contact[0].gap[4] = INFINITY; }, "not finite");
  expect([=](auto& by) { by.facets[fixed].pressure = {1, 1, 1}; }, "whose displacement is prescribed");
  expect([=](auto& by) { by.facets[fixed].displacement[0].value[1] += 1; }, "displacements jumps");
  expect([=](auto& by) { by.facets[sliding].normal_displacement = {1, 1, 1}; }, "displacements jumps");
  expect([](auto& by) { by.contact[0].gap.fill(7); }, "gap jumps");
}

}  // namespace
}  // namespace bracket::bounds::space
