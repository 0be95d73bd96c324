// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/compare/admissible.h"
#include "tests/compare/scene_files.h"

/// Examples 1, 2 and 3 of HH81 §2: solvable loads, loads at the limit and beyond it.
namespace bracket::tests {
namespace {

using scene::Vector;

scene::Scene<2> example(int number, const std::vector<std::string>& overrides = {}) {
  return from_file("example_" + std::to_string(number), overrides);
}

/// The force of the stresses' pressure.
double contact_force(const bounds::Outcome<2>& outcome) {
  double force = 0;
  const auto states = bounds::contact_state(outcome.problem, outcome.displacement, outcome.stress);
  for (std::size_t j = 0; j < states.size(); ++j)
    force += scene::length(outcome.problem.mesh, outcome.problem.contact[j].first) *
             (states[j].pressure[0] + states[j].pressure[1]) / 2;
  return force;
}

double largest_contact_pressure(const bounds::Outcome<2>& outcome) {
  double largest = 0;
  for (const auto& state : bounds::contact_state(outcome.problem, outcome.displacement, outcome.stress))
    largest = std::max({largest, state.pressure[0], state.pressure[1]});
  return largest;
}

TEST(Paper, contact_carries_what_the_free_motion_leaves_of_the_loads) {  // (2.1), (2.3), (2.6)
  const double n1 = 2 / std::sqrt(5.0);                                  // of the inclined line of Example 2
  const std::array<double, 3> force = {0.1, 0.1 / n1, 0.1};
  for (int i = 1; i <= 3; ++i) {
    const auto outcome = bounds::run(example(i));
    EXPECT_EQ(outcome.status, scene::Status::done) << outcome.reason;
    expect_admissible(outcome);
    EXPECT_NEAR(contact_force(outcome), force[i - 1], 1e-11) << "example " << i;
  }
}

/// At the limit only motions that gain nothing are free: there is a solution, without pressure.
struct Limit {
  int example;
  std::vector<std::string> overrides;
};
std::vector<Limit> limits() {
  return {{1, {"boundary.slider.left.pressure=0"}},
          {2, {"boundary.slider.left.pressure=0", "bodies.slider.body_force=[0, -0.1]"}},
          {3, {"boundary.upper.top.traction=[0, 0]"}}};
}

TEST(Paper, at_the_limit_of_solvability_nothing_presses) {  // V1 = 0 (2.4), V2 = 0
  for (const auto& [number, overrides] : limits()) {
    const auto outcome = bounds::run(example(number, overrides));
    EXPECT_EQ(outcome.status, scene::Status::done) << outcome.reason;
    expect_admissible(outcome);
    EXPECT_LT(outcome.upper, 0) << "the bodies are strained";
    EXPECT_LT(largest_contact_pressure(outcome), 1e-12) << "example " << number;
  }
}

TEST(Paper, beyond_the_limit_the_motion_is_the_reason) {  // (1.16)
  struct Case {
    int example;
    std::string override, motion;
  };
  const std::vector<Case> cases = {
      {1, "boundary.slider.left.pressure=-1e-6", "'slider' is pushed off: moving it by (-1, 0)"},
      {2, "boundary.slider.left.pressure=-1e-6", "'slider' is pushed off: moving it by (-1, 0)"},
      {3, "boundary.upper.top.traction=[0, 1e-6]", "'upper' is pushed off: moving it by (0, 1)"},
      {3, "boundary.upper.top.traction=[0.01, -0.1]", "'upper' is pushed off: moving it by (1, 0)"},
      // The resultant passes through x = 2.5, beside the contact, which ends at x = 2.
      {3, "boundary.upper.top.traction=[\"0\", \"x < 1 ? 0.05 : -0.1\"]", "turning it clockwise about (2, "},
  };
  for (const auto& [number, override, motion] : cases) try {
      bounds::run(example(number, {override}));
      ADD_FAILURE() << override << ": accepted";
    } catch (const scene::Error& error) {
      EXPECT_EQ(error.status(), scene::Status::ill_posed) << override;
      EXPECT_NE(std::string(error.what()).find(motion), std::string::npos) << override << ": " << error.what();
    }
}

TEST(Paper, a_resultant_through_the_end_of_the_contact_has_no_pressure_on_any_mesh) {
  // (1.16) fails in the second line: turning about the end costs nothing. A force at the end would hold the body, but
  // that is not a stress in L².
  const std::string load = "boundary.upper.top.traction=[\"0\", \"x < 1 ? 0.05 : -0.15\"]";
  try {
    bounds::run(example(3, {load, "refine.strategy=uniform", "refine.max_levels=3"}));
    ADD_FAILURE() << "solved";
  } catch (const scene::Error& error) {
    EXPECT_EQ(error.status(), scene::Status::ill_posed);
    EXPECT_NE(std::string(error.what()).find("end of a contact line"), std::string::npos) << error.what();
  }
}

scene::Displacement<2> moved(const scene::Problem<2>& problem, scene::Displacement<2> displacement,
                             const std::string& body, const Vector<2>& by) {
  std::vector<char> vertex(problem.mesh.vertices.size(), 0), edge(problem.mesh.edges.size(), 0);
  for (std::size_t c = 0; c < problem.mesh.cells.size(); ++c) {
    if (problem.mesh.bodies[problem.mesh.cell_body[c]] != body) continue;
    for (const int v : problem.mesh.cells[c]) vertex[v] = 1;
    for (const int e : problem.mesh.cell_edges[c]) edge[e] = 1;
  }
  for (std::size_t v = 0; v < vertex.size(); ++v)
    if (vertex[v]) displacement.vertex[v] += by;
  for (std::size_t e = 0; e < displacement.edge.size(); ++e)
    if (edge[e]) displacement.edge[e] += by;
  return displacement;
}

/// The interval and the pressures do not change when a body is moved in a way that loads and contact leave free. The
/// motion is at most 10, the strains at rounding level of it: 1e-15 of it by the cell, about 0.1; times stress 0.1.
void expect_the_same(const bounds::Outcome<2>& outcome, const scene::Displacement<2>& other) {
  const auto before = bounds::certify(outcome.problem, outcome.displacement, outcome.stress);
  const auto after = bounds::certify(outcome.problem, other, outcome.stress);
  ASSERT_TRUE(before.valid && after.valid) << before.reason << after.reason;
  // What rounding leaves of the loads could work along the motion: the certificate allows for it.
  EXPECT_NEAR(after.lower, before.lower, 1e-12 * std::abs(before.lower));
  EXPECT_NEAR(after.upper, before.upper, 1e-14);
  EXPECT_LT(1e-13, before.upper - before.lower) << "else this says nothing";
  const auto p = bounds::contact_state(outcome.problem, outcome.displacement, outcome.stress);
  const auto q = bounds::contact_state(outcome.problem, other, outcome.stress);
  for (std::size_t j = 0; j < p.size(); ++j) EXPECT_EQ(p[j].pressure, q[j].pressure);
}

TEST(Paper, energy_and_pressure_do_not_depend_on_which_displacement_came_out) {  // Remark 1.2
  const auto floating = bounds::run(example(3, {"refine.strategy=none", "refine.target=0"}));
  for (const double by : {-10.0, -0.3, 0.7, 10.0})
    expect_the_same(floating, moved(floating.problem, floating.displacement, "upper", Vector<2>(by, 0)));
  // At its limit the slider may go away from the stop. A load that jumps makes the interval a real one.
  const auto slider =
      bounds::run(example(1, {"refine.strategy=none", "refine.target=0", "boundary.slider.left.pressure=0",
                              "boundary.slider.top.traction=[\"0\", \"x < 0.5 ? 0 : -0.2\"]"}));
  for (const double by : {-10.0, -0.3})
    expect_the_same(slider, moved(slider.problem, slider.displacement, "slider", Vector<2>(by, 0)));
}

}  // namespace
}  // namespace bracket::tests
