// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/space/problem_faults.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bounds/certificate/certificate.h"
#include "bounds/certificate/space/links.h"
#include "tests/bounds/space/cases.h"

/// What the certificate in space does not take for a problem.
namespace bracket::bounds::space {
namespace {

using scene::Problem;
using scene::Support;
using scene::Vector;
using Change = std::function<void(Problem<3>&)>;
using Changes = std::vector<std::pair<Change, std::string>>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Problem<3> refined_of(const Problem<3>& problem) {
  std::mt19937 generator(7);
  return tests::refined(problem, 8, generator);
}

void expect_refused(const Problem<3>& problem, const Changes& changes) {
  ASSERT_EQ(problem_fault(problem), "");
  int number = 0;
  for (const auto& [change, named] : changes) {
    Problem<3> changed = problem;
    change(changed);
    const std::string fault = problem_fault(changed);
    EXPECT_FALSE(fault.empty()) << "change " << number << ", " << named;
    EXPECT_NE(fault.find(named), std::string::npos) << "change " << number << ": " << fault;
    ++number;
  }
}

scene::ContactFacetOf<3>& between_bodies(Problem<3>& problem) {
  for (auto& pair : problem.contact)
    if (pair.second >= 0) return pair;
  throw std::logic_error("no contact between bodies");
}

TEST(SpaceFault, on_the_first_mesh) {
  const Changes changes = {
      {[](auto& p) { p.mesh.cells.clear(); }, "no cells"},
      {[](auto& p) { p.facets[0].higher_pressure[0] = 1; }, "not linear"},
      {[](auto& p) { p.facets[0].higher_traction[1][2] = nan; }, "not linear"},
      {[](auto& p) { p.mesh.facet_numbers.pop_back(); }, "differ in number"},
      {[](auto& p) { std::swap(p.mesh.cells[0][0], p.mesh.cells[0][1]); }, "volume"},
      {[](auto& p) { p.mesh.cells[0][0] = 10000; }, "not there"},
      {[](auto& p) { p.mesh.cell_edges[0][2] = -1; }, "not there"},
      {[](auto& p) { p.mesh.facet_numbers[1][2] = 1 << 20; }, "not there"},
      {[](auto& p) { p.mesh.facet_count = -1; }, "not there"},
      {[](auto& p) { p.mesh.facet_count += 1; }, "no cell"},
      {[](auto& p) { p.mesh.boundary[3].local = 4; }, "not there"},
      {[](auto& p) { p.mesh.cell_edges[1] = p.mesh.cell_edges[0]; }, "join its corners"},
      {[](auto& p) { std::swap(p.mesh.cell_edges[1][0], p.mesh.cell_edges[1][5]); }, "join its corners"},
      {[](auto& p) { std::swap(p.mesh.facet_numbers[2][0], p.mesh.facet_numbers[2][1]); }, ""},
      {[](auto& p) { p.mesh.facet_numbers[4] = p.mesh.facet_numbers[3]; }, ""},
      {[](auto& p) { std::ranges::fill(p.mesh.cell_component, 0), p.mesh.components.pop_back(); }, "hang together"},
      {[](auto& p) { p.mesh.components.push_back("nothing"); }, "hang together"},
      {[](auto& p) { p.mesh.cell_component[0] = 1 - p.mesh.cell_component[0]; }, "components share a facet"},
      {[](auto& p) {  // an edge of its own where a facet is shared: displacements might jump there
         int& own = p.mesh.cell_edges[0][3];  // the diagonal
         p.mesh.edges.push_back(p.mesh.edges[own]);
         own = static_cast<int>(p.mesh.edges.size()) - 1;
       },
       "share the edges"},
      {[](auto& p) { p.mesh.boundary[1] = p.mesh.boundary[0]; }, "boundary facet 1"},
      {[](auto& p) { std::swap(p.mesh.boundary[1].vertices[0], p.mesh.boundary[1].vertices[1]); }, "boundary facet 1"},
      {[](auto& p) {
         const auto v = p.mesh.boundary[1].vertices;
         p.mesh.boundary[1].vertices = {v[1], v[2], v[0]};
       },
       "boundary facet 1"},
      {[](auto& p) {  // the last facet, free, left out
         while (p.facets.back().support != Support::traction) {
           std::rotate(p.facets.begin(), p.facets.end() - 1, p.facets.end());
           std::rotate(p.mesh.boundary.begin(), p.mesh.boundary.end() - 1, p.mesh.boundary.end());
           for (auto& pair : p.contact)
             for (int* side : {&pair.first, &pair.second})
               if (*side >= 0) *side = (*side + 1) % static_cast<int>(p.facets.size());
         }
         p.mesh.boundary.pop_back(), p.facets.pop_back();
       },
       "not on the boundary"},
      {[](auto& p) { p.mesh.vertices[0][2] = nan; }, "coordinate"},
      {[](auto& p) { p.facets[0].traction[2][0] = nan; }, "not finite"},
      {[](auto& p) { p.facets[0].pressure[2] = INFINITY; }, "not finite"},
      {[](auto& p) { p.facets[0].displacement[2][2] = INFINITY; }, "not finite"},
      {[](auto& p) { p.contact[0].upper[5] = nan; }, "gap"},
      {[](auto& p) { p.contact[0].upper[5] = p.contact[0].lower[5] - 1; }, "lower gap"},
      {[](auto& p) { p.bodies[0].force[1] = nan; }, "weight"},
      {[](auto& p) { p.facets[between_bodies(p).second].normal[0] += 1e-16; }, "opposite"},
      {[](auto& p) { p.facets[tests::facet_with(p, Support::sliding)].normal *= 2; }, "unit"},
      {[](auto& p) {
         p.facets[tests::facet_with(p, Support::sliding)].normal = {-0.6, 0.8, 0};
       },
       "25 degrees"},
      {[](auto& p) { p.contact[0].second = p.contact[1].second; }, ""},
      {[](auto& p) { p.contact[0].first = -1; }, "not there"},
      {[](auto& p) {
         between_bodies(p).meets = {1, 1, 2};
       },
       "not there"},
      {[](auto& p) { std::ranges::reverse(between_bodies(p).meets); }, "coincide"},
      {[](auto& p) { p.facets[p.contact[0].first].support = Support::traction; }, "support"},
      {[](auto& p) { p.contact.pop_back(); }, "in contact with nothing"},
      {[](auto& p) { p.mesh.vertices[p.mesh.boundary[between_bodies(p).second].vertices[0]][0] += 1e-12; }, "coincide"},
      {[](auto& p) {
         p.contact[0].law.modulus = {1, 1};
       },
       "springs or friction"},
      {[](auto& p) { p.contact[0].law.coulomb = 0.3; }, "springs or friction"},
      {[](auto& p) { p.contact[0].law.two_sided = true, p.contact[0].upper[3] += 1e-9; }, "up to rounding"},
      {[](auto& p) { p.facets[p.contact[0].first].traction[0] = Vector<3>(0, 1, 0); }, "in contact and is loaded"},
      {[](auto& p) { p.facets[tests::facet_with(p, Support::fixed)].displacement[1][0] += 1e-15; }, "where they meet"},
      {[](auto& p) {
         for (auto& facet : p.facets)
           if (facet.support == Support::sliding && facet.normal[1] < -0.5) facet.normal_displacement[1] += 1e-3;
       },
       "where they meet"},
  };
  expect_refused(tests::clamped().problem, changes);
}

TEST(SpaceFault, cells_on_one_side_of_their_facet) {
  Problem<3> problem;
  problem.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.25, 0.25, 1}};
  problem.mesh.cells = {{0, 1, 2, 3}, {0, 1, 2, 4}};
  problem.mesh.cell_body = {0, 0};
  problem.mesh.bodies = {"body"};
  problem.mesh = tests::with_topology(std::move(problem.mesh));
  EXPECT_NE(topology_fault(problem).find("two sides"), std::string::npos) << topology_fault(problem);
  problem.mesh.vertices[4][2] = -1;
  problem.mesh.cells[1] = {0, 2, 1, 4};
  problem.mesh = tests::with_topology(std::move(problem.mesh));
  EXPECT_EQ(topology_fault(problem), "");
}

// At a corner of three slides a fourth that does not fit, and one that does.
TEST(SpaceFault, slides_that_contradict_each_other) {
  Problem<3> problem = tests::clamped().problem;
  for (auto& facet : problem.facets)
    if (facet.support == Support::sliding) facet.normal_displacement = {0, 0, 0};
  EXPECT_EQ(problem_fault(problem), "");
  std::vector<int> sliding;
  for (int f = 0; f < static_cast<int>(problem.facets.size()); ++f)
    if (problem.facets[f].support == Support::sliding && problem.facets[f].normal[1] < -0.5) sliding.push_back(f);
  auto& one = problem.facets[sliding.at(0)];  // a little off its neighbour's normal
  one.normal = Vector<3>(0.125, -1, 0).normalized();
  EXPECT_EQ(problem_fault(problem), "");
  one.normal_displacement = {1e-3, 1e-3, 1e-3};
  EXPECT_NE(problem_fault(problem).find("where they meet"), std::string::npos) << problem_fault(problem);
}

TEST(SpaceFault, after_refinement) {
  const auto divided_facet = [](const Problem<3>& p) {
    for (std::size_t f = 0; f < p.facets.size(); ++f)
      if (p.origin.facets[f].corner != scene::whole<2>(0).corner) return static_cast<int>(f);
    throw std::logic_error("no facet is divided");
  };
  const Changes changes = {
      {[](auto& p) { p.origin.cells[5].corner[1][0] += 0.25; }, ""},
      {[](auto& p) { p.origin.cells[5].corner[1][0] = 0.1; }, ""},
      {[](auto& p) {
         p.origin.cells[5].corner[2] = {0.5, 0.5, 0.25};
       },
       "outside"},
      {[](auto& p) { p.origin.cells[0].of = -1; }, "no piece"},
      {[](auto& p) { p.origin.cells[0].of = p.origin.cells.back().of; }, ""},
      {[](auto& p) { std::swap(p.origin.cells[4], p.origin.cells[5]); }, ""},
      {[](auto& p) { p.origin.cells.pop_back(); }, "differ in number"},
      {[&](auto& p) { p.origin.facets[divided_facet(p)] = scene::whole<2>(0); }, "boundary facet"},
      {[&](auto& p) {
         auto& corner = p.origin.facets[divided_facet(p)].corner;
         std::swap(corner[0], corner[1]);
       },
       "boundary facet"},
      {[](auto& p) { p.facets[tests::facet_with(p, Support::fixed)].support = Support::traction; }, "support"},
      {[](auto& p) {
         p.facets[tests::facet_with(p, Support::sliding)].normal = {0, 0, 1};
       },
       "direction"},
      {[](auto& p) { p.contact[0].lower[1] += 1e-9, p.contact[0].upper[1] += 1e-9; }, "gaps"},
      {[](auto& p) { p.contact[1].upper[4] -= 1e-9, p.contact[1].lower[4] -= 2e-9; }, "gaps"},
      {[](auto& p) { std::swap(p.contact[0].second, p.contact[1].second); }, ""},
      {[](auto& p) { p.contact[0].pair += 1; }, "none of the first mesh"},
      {[](auto& p) { p.contact[0].law.two_sided = true; }, ""},
      {[](auto& p) { p.bodies[1].material = tests::steel(5, 0.375); }, "material or weight"},
      {[](auto& p) { p.bodies[0].force[1] += 2; }, "material or weight"},
  };
  expect_refused(refined_of(tests::clamped().problem), changes);
}

// A gap that varies is compared on pieces exactly.
TEST(SpaceFault, of_gaps_on_pieces) {
  const Problem<3> problem = refined_of(tests::cornered().problem);
  ASSERT_EQ(problem_fault(problem), "");
  for (std::size_t j = 0; j < problem.contact.size(); ++j)
    for (int k = 0; k < 6; ++k)
      for (const bool lower : {true, false}) {
        Problem<3> changed = problem;
        (lower ? changed.contact[j].lower[k] : changed.contact[j].upper[k]) += lower ? 1e-12 : -1e-12;
        EXPECT_NE(problem_fault(changed).find("enclose"), std::string::npos) << problem_fault(changed);
      }
}

TEST(SpaceFault, of_corrections) {
  const auto [name, problem, mean] = tests::floating();
  const Changes changes = {
      {[](auto& p) { p.carries.clear(); }, "which contacts carry"},
      {[](auto& p) { p.corrections[0].facet = -1; }, "correction"},
      {[](auto& p) { p.corrections[1].unit[2][1] = nan; }, "correction"},
  };
  expect_refused(problem, changes);
  std::mt19937 generator(3);
  const auto u = tests::random_displacement(problem, 2, 0.01, generator);
  const auto stress = tests::random_stress(problem, mean, 0.01, generator);
  ASSERT_TRUE(certify(problem, u, stress).valid);
  Problem<3> fewer = problem;
  fewer.corrections.pop_back();
  EXPECT_FALSE(certify(fewer, u, stress).valid);
  Problem<3> dependent = problem;
  dependent.corrections[0] = dependent.corrections[1];
  EXPECT_FALSE(certify(dependent, u, stress).valid);
  Problem<3> open = problem;
  open.carries = {0};
  EXPECT_FALSE(certify(open, u, stress).valid);
  Problem<3> none = problem;
  none.corrections.clear();
  EXPECT_FALSE(certify(none, u, stress).valid);
}

TEST(SpaceLinks, leave_the_motions_that_they_do_not_act_on) {
  EXPECT_EQ(unheld_motions(tests::clamped().problem, {1}), 0);
  EXPECT_EQ(unheld_motions(tests::clamped().problem, {0}), 1);  // the upper one rises
  EXPECT_EQ(unheld_motions(tests::floating().problem, {1}), 6);
  EXPECT_EQ(unheld_motions(tests::floating().problem, {0}), 3 + 6);
  const Problem<3> cornered = tests::cornered().problem;
  EXPECT_EQ(unheld_motions(cornered, std::vector<char>(3, 1)), 0);
  EXPECT_EQ(unheld_motions(cornered, std::vector<char>(3, 0)), 6);
  int one_wall = 0;
  for (int pair = 0; pair < 3; ++pair) {
    std::vector<char> carrying(3, 1);
    carrying[pair] = 0;
    one_wall += unheld_motions(cornered, carrying);  // two directions hold all turns
  }
  EXPECT_EQ(one_wall, 3);
  EXPECT_EQ(unheld_motions(tests::cornered(tests::turned_away()).problem, {1, 1, 0}), 1);
  EXPECT_EQ(unheld_motions(tests::cornered(tests::turned_away()).problem, {0, 1, 0}), 3);
}

}  // namespace
}  // namespace bracket::bounds::space
