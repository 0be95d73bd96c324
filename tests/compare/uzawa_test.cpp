// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/uzawa.h"

#include <gtest/gtest.h>

#include "bounds/bounds.h"
#include "bounds/particular.h"
#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/compare/scene_files.h"
#include "tests/compare/stress_norm.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

namespace bracket::tests {
namespace {

struct Case {
  std::string name;
  scene::Problem<2> problem;
};

scene::Problem<2> balanced(const scene::Scene<2>& scene) { return bounds::balanced(problem(scene), 2); }

Case case_of(const std::string& name) { return {name, balanced(from_file(name))}; }

/// Supports and loads of all kinds, floating bodies, walls, inclined contact, weight, unlike moduli.
std::vector<Case> cases() {
  scene::Scene<2> raised = two_blocks(2, 0.02);
  raised.contact[0].gap = scene::enclosed<2>([](const auto& x) { return 0.01 * x[0]; });
  LinearPressure unlike;
  unlike.young_upper = 20;
  return {{"patch", balanced(patch(1e6, 0.3, 0.01, 3))},
          {"linear pressure", balanced(linear_pressure({.c = 0.9}, 4, 2))},
          {"unlike moduli", balanced(linear_pressure(unlike, 2, 1))},
          {"lift-off", balanced(two_blocks(3))},
          {"gap", balanced(raised)},
          case_of("gravity"),
          case_of("example_1"),
          case_of("example_2"),
          case_of("example_3")};
}

TEST(Uzawa, particular_stress_balances_the_data) {
  for (const auto& [name, problem] : cases()) {
    const auto stress = bounds::particular_stress(problem);
    const scene::Displacement<2> rest{1, std::vector<Vector<2>>(problem.mesh.vertices.size(), Vector<2>::Zero()), {}};
    const auto checks = bounds::admissibility(problem, rest, stress);
    EXPECT_LT(checks.equilibrium, 1e-11) << name;
    EXPECT_LT(checks.interface_jump, 1e-11) << name;
    EXPECT_LT(checks.boundary_traction, 1e-11) << name;
  }
}

TEST(Uzawa, finds_the_stress_of_the_hybrid_method) {
  // Its iteration ends where the estimated error is 1e-9 of the stress; the estimate is given a factor of ten.
  for (const auto& [name, problem] : cases()) {
    if (sanitized && problem.mesh.cells.size() > 100) continue;
    const auto hybrid = dual::solve(problem, 1);
    const auto uzawa = dual::uzawa(problem, bounds::particular_stress(problem));
    ASSERT_EQ(uzawa.termination, contact::Termination::solved) << name << ": " << uzawa.reason;
    EXPECT_EQ(uzawa.statistics.unknowns, hybrid.statistics.unknowns) << name;
    EXPECT_GT(uzawa.statistics.iterations, hybrid.statistics.iterations) << name;
    EXPECT_LE(stress_distance(problem, uzawa.stress, hybrid.stress),
              1e-8 * stress_distance(problem, hybrid.stress, no_stress(problem)))
        << name << ", " << uzawa.statistics.iterations << " iterations";
    // λ_h is the minimum of S: no other stress, made admissible, bounds better.
    const auto displacement = primal::solve(problem, 2).displacement;
    const auto best = bounds::certify(problem, displacement, hybrid.stress);
    const auto ours = bounds::certify(problem, displacement, uzawa.stress);
    ASSERT_TRUE(ours.valid) << name << ": " << ours.reason;
    const double slack = 1e-12 * std::max(std::abs(best.lower), std::abs(best.upper));
    EXPECT_LE(ours.lower, best.lower + slack) << name;
    EXPECT_GE(ours.lower, best.lower - 1e-7 * std::max(std::abs(best.lower), std::abs(best.upper))) << name;
    EXPECT_EQ(ours.upper, best.upper) << name;
  }
}

dual::UzawaSystem system_of(const scene::Problem<2>& problem, const scene::Stress<2>& particular) {
  const dual::Layout layout = dual::lay_out(problem, 1);
  return dual::uzawa_system(problem, layout, dual::make_cells<1>(problem, layout), particular);
}

TEST(Uzawa, constraints_are_scaled_and_the_step_lies_below_two_by_the_largest_eigenvalue) {
  int small = 0;
  for (const auto& [name, problem] : cases()) {
    const auto system = system_of(problem, no_stress(problem));
    const auto n = system.scale.size();
    if (n > 300) continue;  // dense
    ++small;
    // One step from z, of size 1, with an opening so large that no projection acts, is affine in z: z + G − B A⁻¹ Bᵀ z.
    const auto step_from = [&](Eigen::VectorXd z) {
      for (const auto& o : system.openings) z[o.first] += 1e3;
      return Eigen::VectorXd(dual::next_multipliers(system, z, dual::parameters(system, z), 1) - z);
    };
    const Eigen::VectorXd origin = step_from(Eigen::VectorXd::Zero(n));
    Eigen::MatrixXd matrix(n, n);
    for (Eigen::Index i = 0; i < n; ++i) matrix.col(i) = origin - step_from(Eigen::VectorXd::Unit(n, i));
    const double rounding = 1e-12 * (1e3 + origin.cwiseAbs().maxCoeff());
    EXPECT_LT((matrix - matrix.transpose()).cwiseAbs().maxCoeff(), rounding) << name;
    EXPECT_LT((matrix.diagonal().array() - 1).abs().maxCoeff(), rounding) << name;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix, Eigen::EigenvaluesOnly);
    const double product = dual::uzawa_step(system) * eigen.eigenvalues()[n - 1];
    EXPECT_GE(product, 1.8 - 1e-9) << name;  // Rayleigh quotients are below the largest eigenvalue
    EXPECT_LT(product, 2) << name;
  }
  EXPECT_GT(small, 0);
}

TEST(Uzawa, changes_never_grow) {  // a projected gradient step below 2 / λ does not expand distances
  for (const auto& [name, problem] : cases()) {
    const auto system = system_of(problem, bounds::particular_stress(problem));
    const double step = dual::uzawa_step(system);
    Eigen::VectorXd z = Eigen::VectorXd::Zero(system.scale.size());
    double first = 0, last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 300; ++i) {
      const Eigen::VectorXd next = dual::next_multipliers(system, z, dual::parameters(system, z), step);
      const double change = (next - z).norm();
      if (i == 0) first = change;
      ASSERT_LE(change, last + 1e-12 * first) << name << ", step " << i;
      last = change;
      z = next;
    }
    EXPECT_LT(last, first) << name;
    for (const auto& o : system.openings) EXPECT_GE(z[o.first], 0) << name;
  }
}

TEST(Uzawa, ends_with_a_reason_where_no_pressure_of_the_mesh_balances_the_loads) {
  // Forces at the ends of the single contact edge could hold this load, at 1/6 of its length from the end; a linear
  // pressure p ≥ 0 reaches from 1/3 to 2/3 only.
  scene::Scene<2> s;
  s.blocks = {block("b", 0, 1, 0, 1, 1, 1)};
  s.bodies = {{"b", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
  s.boundary = {{"b.top", traction(constant(0), scene::enclosed<2>([](const auto& x) { return x[0] - 0.75; }))}};
  s.contact = {{"b.bottom", "rigid", constant(0), ""}};
  s.solve.dual = scene::Dual::uzawa;
  const auto outcome = bounds::run(s);
  EXPECT_EQ(outcome.status, scene::Status::not_guaranteed);
  EXPECT_NE(outcome.reason.find("iterations of Uzawa's method"), std::string::npos) << outcome.reason;
  EXPECT_NE(outcome.reason.find("\"hybrid\""), std::string::npos) << outcome.reason;
}

TEST(Uzawa, a_run_gives_the_same_interval) {
  scene::Scene<2> s = two_blocks(2);
  const auto hybrid = bounds::run(s);
  s.solve.dual = scene::Dual::uzawa;
  const auto uzawa = bounds::run(s);
  EXPECT_EQ(uzawa.guarantee, "rounding-safe") << uzawa.reason;
  EXPECT_TRUE(uzawa.levels.at(0).checks.passed());
  EXPECT_EQ(uzawa.upper, hybrid.upper);
  EXPECT_NEAR(uzawa.lower, hybrid.lower, 1e-7 * std::abs(hybrid.lower));
}

}  // namespace
}  // namespace bracket::tests
