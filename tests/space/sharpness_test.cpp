// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bounds/bounds.h"
#include "bounds/estimate/on_mesh.h"
#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/space/scenes.h"
#include "tests/support/hybrid.h"

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

TEST(LocalInSpace, is_little_wider_than_the_best_after_one_sweep) {
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
      if (i > 0) EXPECT_LE(found.width[i], found.width[i - 1] * (1 + 1e-12)) << name;
    }
    EXPECT_GE(found.least_pressure, -1e-13) << name;
  }
}

}  // namespace
}  // namespace bracket
