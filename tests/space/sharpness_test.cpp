// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bounds/bounds.h"
#include "bounds/estimate/on_mesh.h"
#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/space/scenes.h"
#include "tests/support/hybrid.h"
#include "tests/support/sanitized.h"

namespace bracket {
namespace {

using namespace tests::space;

/// Local stresses beside the best that there are on the mesh.
struct Sharpness {
  std::vector<double> width;  ///< after 0, 1, … sweeps, by that of the global hybrid method
  double least_pressure = 0;
};
Sharpness sharpness(const scene::Scene<3>& scene, int sweeps) {
  const scene::Problem<3> problem = bounds::balanced(scene::fix_data(scene, scene::build_mesh(scene)), 2);
  const primal::Solver<3> solver(problem, 2);
  const auto displacement = solver.solve(problem).displacement;
  const double upper = bounds::potential_energy(problem, displacement).total;
  const auto best = tests::hybrid(problem);
  EXPECT_EQ(best.termination, contact::Termination::solved);
  const double least = upper + bounds::complementary_energy(problem, best.stress);
  const auto start = solver.solve_with_pressure(problem);
  Sharpness result;
  for (int i = 0; i <= sweeps; ++i) {
    const auto local = dual::local<3>(problem, start.pressure, start.displacement, i);
    result.width.push_back((upper + bounds::complementary_energy(problem, local.stress)) / least);
    for (const auto& pair : problem.contact)
      for (const double p : bounds::plain_pressure(problem, local.stress, pair))
        result.least_pressure = std::min(result.least_pressure, p);
  }
  return result;
}

using LocalInSpace = tests::Long;

TEST_F(LocalInSpace, is_little_wider_than_the_best_after_one_sweep) {
  struct Case {
    std::string name;
    scene::Scene<3> scene;
    double most;
  };
  for (const auto& [name, scene, most] :
       {Case{"lift-off", two_blocks(4), 1.10},
        Case{"lift-off, nearly incompressible", two_blocks(4, 0.09, 0.4999), 1.13},
        Case{"closed", two_blocks(4, 0.02), 1.10}, Case{"on a wall", on_a_wall(3, 0.3), 1.10},
        Case{"on a wall, nearly incompressible", on_a_wall(3, 0.4999), 1.13},
        Case{"everything", everything(2), 1.13}}) {
    const Sharpness found = sharpness(scene, 2);
    EXPECT_LE(found.width[0], 1.7) << name;
    EXPECT_LE(found.width[1], most) << name;
    for (std::size_t i = 0; i < found.width.size(); ++i) {
      EXPECT_GE(found.width[i], 1 - 1e-9) << name;
      if (i > 0) {
        EXPECT_LE(found.width[i], found.width[i - 1] * (1 + 1e-12)) << name;
      }
    }
    EXPECT_GE(found.least_pressure, -1e-13) << name;
  }
}

/// A block in a trough, pressed on its floor and its wall, from which a wedge of gap parts it.
scene::Scene<3> in_a_trough(double poisson) {
  scene::Scene<3> s;
  s.blocks = {block("block", {0, 1}, {0, 1}, {0, 1}, {3, 3, 3}), block("trough", {0, 1}, {-1, 0}, {0, 1}, {3, 3, 3}),
              block("trough", {-1, 0}, {-1, 0}, {0, 1}, {3, 3, 3}),
              block("trough", {-1, 0}, {0, 1}, {0, 1}, {3, 3, 3})};
  s.blocks[1].name = "floor";
  s.blocks[2].name = "corner";
  s.blocks[3].name = "wall";
  s.bodies = {{"block", isotropic(1, poisson)}, {"trough", isotropic(1, poisson)}};
  s.boundary = {{"trough.corner.bottom", fixed()},
                {"trough.floor.bottom", fixed()},
                {"block.back", sliding()},
                {"block.top", traction(-0.03, -0.1, 0.0)}};
  s.contact = {{"block.bottom", "trough.floor.top", 0.0, ""},
               {"block.left", "trough.wall.right", scene::enclosed<3>([](const auto& x) { return 0.01 * x[1]; }), ""}};
  return s;
}

/// Moduli 1 : 1000, sides that overlap, a clamped side beside the contact, weight.
scene::Scene<3> unlike_moduli(double poisson) {
  scene::Scene<3> s;
  s.blocks = {block("lower", {0, 1}, {0, 1}, {0, 1}, {3, 3, 3}), block("upper", {0, 1}, {1, 2}, {0, 1}, {3, 3, 3})};
  s.bodies = {{"lower", isotropic(1, poisson)}, {"upper", isotropic(1000, poisson)}};
  s.bodies.at("lower").force = {0, -0.05, 0.02};
  s.boundary = {{"lower.left", fixed()},
                {"lower.bottom", sliding()},
                {"upper.right", sliding()},
                {"upper.back", sliding()},
                {"upper.top", traction(0.0, scene::enclosed<3>([](const auto& x) { return 0.2 * x[0] - 0.2; }), 0.0)}};
  s.contact = {{"upper.bottom", "lower.top", -0.001, ""}};
  return s;
}

/// Cells 5 : 1, in two layers; clamped at a side and bent.
scene::Scene<3> bent_plate(double poisson) {
  scene::Scene<3> s;
  s.blocks = {block("b", {0, 1}, {0, 1}, {0, 0.08}, {5, 5, 2})};
  s.bodies = {{"b", isotropic(1, poisson)}};
  s.boundary = {{"b.left", fixed()}, {"b.front", traction(0.0, 0.0, -0.1)}};
  return s;
}
scene::Scene<3> plate_on_a_wall(double poisson) {
  scene::Scene<3> s = on_a_wall(5, poisson);
  s.blocks = {block("b", {0, 1}, {0, 1}, {0, 0.04}, {5, 5, 1})};
  return s;
}

TEST_F(LocalInSpace, ridges_unlike_moduli_and_flat_cells_cost_little_more) {
  struct Case {
    std::string name;
    scene::Scene<3> (*scene)(double poisson);
    int sweeps;
    double most;
  };
  for (const double poisson : {0.3, 0.4999})
    for (const auto& [name, scene, sweeps, most] :
         {Case{"ridge", in_a_trough, 1, 1.18}, Case{"moduli 1 : 1000", unlike_moduli, 1, 1.28},
          Case{"bent plate", bent_plate, 2, 1.4}, Case{"plate on a wall", plate_on_a_wall, 2, 1.4}}) {
      const scene::Scene<3> made = scene(poisson);
      EXPECT_EQ(scene::sweeps_for(scene::common_flatness(scene::flatness(scene::build_mesh(made)))), sweeps) << name;
      const Sharpness found = sharpness(made, sweeps);
      EXPECT_LE(found.width.back(), most) << name << ", " << poisson;
      for (std::size_t i = 1; i < found.width.size(); ++i)
        EXPECT_LE(found.width[i], found.width[i - 1] * (1 + 1e-12)) << name;
      EXPECT_GE(found.least_pressure, -1e-13) << name;
    }
}

}  // namespace
}  // namespace bracket
