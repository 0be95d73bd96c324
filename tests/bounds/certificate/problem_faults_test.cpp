// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/problem_faults.h"

#include <gtest/gtest.h>

#include "bounds/bounds.h"
#include "bounds/certificate/links.h"
#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/support/scenes.h"

/// What the certificate does not take for a problem.
namespace bracket::bounds {
namespace {

using scene::Problem;
using scene::Support;
using scene::Vector;
using Change = std::function<void(Problem<2>&)>;

Problem<2> sound() { return balanced(tests::problem(tests::everything(2, 2, 2)), 2); }

Problem<2> refined() {
  const Problem<2> first = sound();
  return scene::refine(first, std::vector<char>(first.mesh.cells.size(), 1)).problem;
}

/// The certificate of the problem's own fields once it has been changed.
void expect_refused(const Problem<2>& problem, const Change& change, const std::string& named) {
  const auto u = primal::solve(problem, 2).displacement;
  const auto stress = dual::solve(problem, 1).stress;
  ASSERT_TRUE(certify(problem, u, stress).valid);
  Problem<2> changed = problem;
  change(changed);
  const Certificate certificate = certify(changed, u, stress);
  EXPECT_FALSE(certificate.valid) << named;
  EXPECT_NE(certificate.reason.find(named), std::string::npos) << certificate.reason;
}

int facet_with(const Problem<2>& problem, Support support) {
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (problem.facets[f].support == support) return static_cast<int>(f);
  throw std::logic_error("no such facet");
}

const scene::ContactFacet& between_bodies(const Problem<2>& problem) {
  for (const auto& pair : problem.contact)
    if (pair.second >= 0) return pair;
  throw std::logic_error("no contact between bodies");
}

TEST(ProblemFault, none_of_sound_problems) {
  EXPECT_EQ(problem_fault(sound()), "");
  EXPECT_EQ(problem_fault(refined()), "");
  std::vector<char> some(refined().mesh.cells.size(), 0);
  some[3] = some[17] = 1;
  EXPECT_EQ(problem_fault(scene::refine(refined(), some).problem), "");
}

TEST(ProblemFault, on_the_first_mesh) {
  const auto nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<Change, std::string>> changes = {
      {[](auto& p) { std::swap(p.mesh.cells[0][0], p.mesh.cells[0][1]); }, "area"},
      {[](auto& p) { p.mesh.cells[0][0] = 10000; }, "not there"},
      {[](auto& p) { std::ranges::fill(p.mesh.cell_component, 0), p.mesh.components.pop_back(); }, "hang together"},
      {[](auto& p) { p.mesh.components.push_back("nothing"); }, "hang together"},
      {[](auto& p) { p.mesh.cell_component[0] = 1 - p.mesh.cell_component[0]; }, "components share an edge"},
      {[](auto& p) { p.mesh.cell_component[3] = 2; }, "not there"},
      {[](auto& p) { p.mesh.cell_edges[1] = p.mesh.cell_edges[0]; }, "corners"},
      {[](auto& p) { p.mesh.boundary[1] = p.mesh.boundary[0]; }, "boundary facet 1"},
      {[](auto& p) { p.mesh.boundary.pop_back(), p.facets.pop_back(); }, ""},
      {[=](auto& p) { p.mesh.vertices[0][0] = nan; }, "coordinate"},
      {[=](auto& p) { p.facets[0].traction[1][0] = nan; }, "not finite"},
      {[=](auto& p) { p.facets[0].pressure[0] = nan; }, "not finite"},
      {[=](auto& p) { p.contact[0].upper[1] = nan; }, "gap"},
      {[=](auto& p) { p.contact[0].upper[1] = p.contact[0].lower[1] - 1; }, "lower gap"},
      {[=](auto& p) { p.bodies[0].force[1] = nan; }, "weight"},
      {[](auto& p) { p.facets[between_bodies(p).second].normal[0] += 1e-16; }, "opposite"},
      {[](auto& p) { p.facets[facet_with(p, Support::sliding)].normal *= 2; }, "unit"},
      {[](auto& p) {
         p.facets[facet_with(p, Support::sliding)].normal = {0.6, 0.8};
       },
       "25 degrees"},
      {[](auto& p) { p.contact[0].second = p.contact[1].second; }, ""},
      {[](auto& p) { p.facets[p.contact[0].first].support = Support::traction; }, "support"},
      {[](auto& p) { p.contact.pop_back(); }, "in contact with nothing"},
      {[](auto& p) {  // one side of a contact moved along it
         Vector<2>& x = p.mesh.vertices[p.mesh.boundary[between_bodies(p).second].vertices[0]];
         x[0] += 0.03;
       },
       "face each other"},
  };
  for (const auto& [change, named] : changes) expect_refused(sound(), change, named);
}

TEST(ProblemFault, after_refinement) {
  const std::vector<std::pair<Change, std::string>> changes = {
      {[](auto& p) { p.origin.cells[5].corner[1][0] += 0.25; }, ""},
      {[](auto& p) { p.origin.cells[5].of += 1; }, ""},
      {[](auto& p) { std::swap(p.origin.cells[4], p.origin.cells[5]); }, ""},
      {[](auto& p) { p.origin.cells.pop_back(); }, "differ in number"},
      {[](auto& p) { p.origin.facets[3].corner[1][0] = 0.75; }, "boundary facet 3"},
      {[](auto& p) { p.facets[facet_with(p, Support::fixed)].support = Support::traction; }, "support"},
      {[](auto& p) {
         p.facets[facet_with(p, Support::sliding)].normal = {0, 1};
       },
       "direction"},
      {[](auto& p) { p.contact[0].lower[1] += 1e-9, p.contact[0].upper[1] += 1e-9; }, "gaps"},
      {[](auto& p) { p.contact[1].upper[0] -= 1e-9, p.contact[1].lower[0] -= 2e-9; }, "gaps"},
      {[](auto& p) { std::swap(p.contact[0].second, p.contact[1].second); }, ""},
      {[](auto& p) { p.bodies[1].material = scene::isotropic<2>(5, 0.375, scene::Plane::strain); },
       "material or weight"},
      {[](auto& p) { p.bodies[0].force[1] *= 2; }, "material or weight"},
  };
  for (const auto& [change, named] : changes) expect_refused(refined(), change, named);
}

TEST(ProblemFault, of_corrections) {
  const auto floating = balanced(tests::problem(tests::linear_pressure({}, 2, 1)), 2);
  ASSERT_EQ(floating.corrections.size(), 2u);
  expect_refused(
      floating, [](auto& p) { p.carries.clear(); }, "which contacts carry");
  expect_refused(
      floating, [](auto& p) { p.corrections[0].facet = -1; }, "correction");
  expect_refused(
      floating, [](auto& p) { p.corrections.pop_back(); }, "");
  expect_refused(
      floating, [](auto& p) { p.corrections[0] = p.corrections[1]; }, "");
}

TEST(ProblemFault, fields_of_another_mesh_are_refused) {
  const auto problem = sound();
  const auto u = primal::solve(problem, 2).displacement;
  auto stress = dual::solve(problem, 1).stress;
  auto shorter = u;
  shorter.edge.pop_back();
  EXPECT_FALSE(certify(problem, shorter, stress).valid);
  shorter.degree = 3;
  EXPECT_FALSE(certify(problem, shorter, stress).valid);
  stress.cell.pop_back();
  EXPECT_FALSE(certify(problem, u, stress).valid);
}

// Loads that nothing holds and that nobody has brought into balance.
TEST(ProblemFault, loads_out_of_balance_have_no_certificate) {
  scene::Scene<2> s = tests::linear_pressure({}, 2, 1);
  const auto problem = tests::problem(s);
  const auto u = primal::solve(problem, 2).displacement;
  const auto stress = dual::solve(problem, 1).stress;
  EXPECT_FALSE(certify(problem, u, stress).valid);
  EXPECT_TRUE(certify(balanced(problem, 2), u, stress).valid);
}

TEST(Links, leave_the_motions_that_they_do_not_act_on) {
  const auto count = [](const scene::Scene<2>& s, std::vector<char> carrying) {
    return unheld_motions(tests::problem(s), carrying);
  };
  EXPECT_EQ(count(tests::smooth(2), {}), 3);
  EXPECT_EQ(count(tests::two_blocks(2), {1}), 0);
  EXPECT_EQ(count(tests::two_blocks(2), {0}), 1);              // the upper one slides along its left side
  EXPECT_EQ(count(tests::linear_pressure({}, 2, 1), {1}), 2);  // both sideways
  EXPECT_EQ(count(tests::linear_pressure({}, 2, 1), {0}), 1 + 3);
  auto free = tests::linear_pressure({}, 2, 1);
  free.boundary.erase("lower.bottom");
  EXPECT_EQ(count(free, {1}), 3 + 1);  // as one, and along each other
  auto held = tests::linear_pressure({}, 2, 1);
  held.boundary["upper.left"] = tests::sliding(0);
  EXPECT_EQ(count(held, {1}), 1);
}

/// The certificate of a functional, once its perturbation has been changed.
void expect_functional_refused(const std::function<void(scene::Perturbation<2>&)>& change, const std::string& named) {
  const Problem<2> problem = refined();
  scene::Perturbation<2> by = scene::no_perturbation(problem);
  for (auto& contact : by.contact) contact.gap = {1, 1, 1};
  const auto u = primal::solve(problem, 2).displacement;
  const auto stress = dual::solve(problem, 1).stress;
  const auto certified = [&](double loads, double kinematics) {
    auto shared = std::make_shared<const scene::Perturbation<2>>(by);
    return certify_functional(scene::perturbed(problem, std::move(shared), loads, kinematics), u, stress);
  };
  ASSERT_TRUE(certified(0.125, 0.125).valid) << certified(0.125, 0.125).reason;
  EXPECT_FALSE(certified(0.125, 0.25).valid);  // not one functional
  EXPECT_FALSE(certified(0, 0).valid);
  change(by);
  const FunctionalBound bound = certified(0.125, 0.125);
  EXPECT_FALSE(bound.valid) << named;
  EXPECT_NE(bound.reason.find(named), std::string::npos) << bound.reason;
}

TEST(ProblemFault, in_perturbations) {
  const Problem<2> problem = refined();
  const Problem<2>& first = scene::first_of(problem);
  const scene::TwofoldVector<2> one{{1, 0}, {0, 0}};
  scene::Perturbation<2> few = scene::no_perturbation(problem);
  Problem<2> perturbed = scene::perturbed(problem, std::make_shared<const scene::Perturbation<2>>(few), 0.125, 0.125);
  few.contact.pop_back();
  perturbed.perturbed.by = std::make_shared<const scene::Perturbation<2>>(few);
  EXPECT_NE(problem_fault(perturbed).find("differ in number"), std::string::npos) << problem_fault(perturbed);
  expect_functional_refused([](auto& by) { by.force[0][1] = NAN; }, "not finite");
  expect_functional_refused([](auto& by) { by.contact[0].gap[1] = INFINITY; }, "not finite");
  expect_functional_refused(
      [&](auto& by) {
        by.facets[facet_with(first, Support::fixed)].traction = {one, one};
      },
      "whose displacement is prescribed");
  for (const auto support : {Support::contact, Support::sliding})
    expect_functional_refused(
        [&](auto& by) {
          by.facets[facet_with(first, support)].higher_pressure = {1, 0};
        },
        "is not linear");
  expect_functional_refused(
      [&](auto& by) {
        by.facets[facet_with(first, Support::fixed)].displacement = {one, one};
      },
      "displacements jumps");
  expect_functional_refused([](auto& by) { by.contact[0].gap = {1, 1, 2}; }, "gap jumps");
}

TEST(ProblemFault, a_load_on_a_contact) {
  for (const auto& [support, named] : {std::pair(Support::contact, "in contact"), {Support::sliding, "slides"}})
    expect_refused(
        sound(), [support = support](Problem<2>& p) { p.facets[facet_with(p, support)].traction[0] = Vector<2>(0, 1); },
        std::string(named) + " and is loaded");
}

}  // namespace
}  // namespace bracket::bounds
