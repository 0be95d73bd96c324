// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <set>

#include "bounds/bounds.h"
#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/support/scenes.h"

namespace bracket::bounds {
namespace {

using scene::Voigt;

/// A misfit of size 1 spoils the strains of the cells at it too, by which it is measured: a few tens over the length.
constexpr double seen = 1e-2;

/// Solutions of the two-block scene, to be spoilt.
struct Solved {
  scene::Problem<2> problem = tests::problem(tests::two_blocks(4));
  scene::Displacement<2> u = primal::solve(problem, 2).displacement;
  scene::Stress<2> stress = dual::solve(problem, 1).stress;
  Checks checks() const { return admissibility(problem, u, stress); }
  int contact_cell() const { return problem.mesh.boundary[problem.contact[0].first].cell; }
};

TEST(Checks, pass_on_solutions) {
  const Checks checks = Solved().checks();
  EXPECT_TRUE(checks.passed());
  EXPECT_LT(checks.penetration, 1e-13);
  EXPECT_LT(checks.equilibrium, 1e-12);
  EXPECT_LT(checks.interface_jump, 1e-12);
  EXPECT_LT(checks.boundary_traction, 1e-12);
  EXPECT_LT(checks.tension, 1e-14);
}

TEST(Checks, see_penetration_at_and_between_nodes) {
  Solved s;
  const auto& facet = s.problem.mesh.boundary[s.problem.contact[0].first];
  s.u.vertex[facet.vertices[0]][1] -= 1;
  EXPECT_GT(s.checks().penetration, seen);
  Solved middle;
  middle.u.edge[facet.edge][1] -= 1;
  EXPECT_GT(middle.checks().penetration, seen);
}

TEST(Checks, see_penetration_of_a_body_that_flies_off) {
  // Sideways the bodies are held by nothing; a motion without end along the contact must not make penetration look
  // small.
  const auto problem = tests::problem(tests::linear_pressure({}, 4, 2));
  auto u = primal::solve(problem, 2).displacement;
  const auto stress = dual::solve(problem, 1).stress;
  for (std::size_t c = 0; c < problem.mesh.cells.size(); ++c) {
    if (problem.mesh.cell_body[c] != 1) continue;
    for (const int v : problem.mesh.cells[c]) u.vertex[v][0] = 1e12;
    for (const int e : problem.mesh.cell_edges[c]) u.edge[e][0] = 1e12;
  }
  u.vertex[problem.mesh.boundary[problem.contact[0].first].vertices[0]][1] -= 0.1;
  EXPECT_GT(admissibility(problem, u, stress).penetration, 1e-3);
}

TEST(Checks, see_a_support_that_is_not_kept) {
  for (const char* part : {"lower.bottom", "upper.left"}) {
    Solved s;
    const auto& parts = s.problem.mesh.parts;
    const int index = static_cast<int>(std::find(parts.begin(), parts.end(), part) - parts.begin());
    for (const auto& facet : s.problem.mesh.boundary)
      if (facet.part == index) s.u.edge[facet.edge][0] += 1;
    EXPECT_GT(s.checks().penetration, seen) << part;
  }
}

TEST(Checks, see_stresses_out_of_equilibrium) {
  Solved s;
  s.stress.cell[3][2] += Voigt<2>(1, 0, 0);  // at the centroid in one part: a divergence and an inner jump
  EXPECT_GT(s.checks().equilibrium, 0.1);
  EXPECT_LT(s.checks().interface_jump, 1e-10);
}

TEST(Checks, see_jumps_between_cells_and_across_the_contact) {
  Solved s;
  for (auto& corner : s.stress.cell[20]) corner += Voigt<2>(1, 1, 0);  // a constant: in equilibrium by itself
  EXPECT_LT(s.checks().equilibrium, 1e-10);
  EXPECT_GT(s.checks().interface_jump, 0.1);

  Solved across;  // σ_yy in all of one body: continuous inside, not across the contact
  for (std::size_t c = 0; c < across.stress.cell.size(); ++c)
    if (across.problem.mesh.cell_body[c] == 1)
      for (auto& corner : across.stress.cell[c]) corner[1] -= 1;
  EXPECT_GT(across.checks().interface_jump, 0.1);
}

TEST(Checks, see_wrong_boundary_tractions_and_shear_on_smooth_parts) {
  Solved s;
  for (auto& cell : s.stress.cell)
    for (auto& corner : cell) corner[0] += 1;  // σ_xx everywhere: the free sides
  EXPECT_GT(s.checks().boundary_traction, 0.1);
  EXPECT_LT(s.checks().interface_jump, 1e-10);
  Solved shear;
  for (auto& cell : shear.stress.cell)
    for (auto& corner : cell) corner[2] += 1;
  EXPECT_GT(shear.checks().boundary_traction, 0.1);
}

TEST(Checks, see_tension) {
  Solved s;
  for (auto& cell : s.stress.cell)
    for (auto& corner : cell) corner[1] += 1;
  EXPECT_GT(s.checks().tension, 0.1);
}

TEST(Checks, name_the_worst) {
  Checks checks;
  checks.tension = 0.5;
  checks.equilibrium = 0.25;
  EXPECT_EQ(checks.worst().name, "tension");
  EXPECT_EQ(checks.worst().value, 0.5);
  checks.interface_jump = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(checks.worst().name, "interface jump");
  EXPECT_FALSE(checks.passed());
}

TEST(Checks, each_may_be_the_worst) {
  std::set<std::string> names;
  for (double Checks::*check : {&Checks::penetration, &Checks::equilibrium, &Checks::interface_jump,
                                &Checks::boundary_traction, &Checks::tension, &Checks::gap_identity}) {
    Checks checks;
    checks.*check = 2 * Checks::tolerance;
    EXPECT_EQ(checks.worst().value, checks.*check);
    EXPECT_FALSE(checks.passed());
    EXPECT_TRUE(names.insert(checks.worst().name).second) << checks.worst().name;
  }
  EXPECT_EQ(names.size(), Checks().all().size());
}

TEST(Checks, do_not_pass_what_is_not_a_number) {
  Solved s;
  s.u.vertex[1][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(s.checks().passed());
  Solved t;
  t.stress.cell[0][0][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(t.checks().passed());
}

}  // namespace
}  // namespace bracket::bounds
