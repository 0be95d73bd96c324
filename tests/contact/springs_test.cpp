// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "contact/condensed.h"
#include "tests/contact/truss.h"

/// Springs under the rows are one more body, all of whose unknowns are in contact and meet few others.
namespace bracket::contact {
namespace {

using namespace test;

/// The mass matrix of hats (`continuous`) or of linear functions on each edge, on edges of random lengths.
MatrixXd edge_mass(Index n, bool continuous, std::mt19937& random) {
  MatrixXd mass = MatrixXd::Zero(n, n);
  for (Index i = 0; i + 1 < n; i += continuous ? 1 : 2) {
    const double length = 0.1 + std::abs(random_vector(1, random)[0]);
    mass.block<2, 2>(i, i) += length / 6 * (Eigen::Matrix2d() << 2, 1, 1, 2).finished();
  }
  return mass;
}

/// \param first the row of its first unknown, of `m`
Loaded foundation(const MatrixXd& mass, double stiffness, Index first, Index m) {
  const Index n = mass.cols();
  MatrixXd rows = MatrixXd::Zero(m, n);
  rows.middleRows(first, n) = -MatrixXd::Identity(n, n);
  std::vector<int> nodes(static_cast<std::size_t>(n) + 1);
  for (Index i = 0; i <= n; ++i) nodes[static_cast<std::size_t>(i)] = static_cast<int>(i);
  return {{lower(stiffness * mass), nodes, rows.sparseView(), MatrixXd(n, 0)}, VectorXd::Zero(n)};
}

TEST(Springs, TheirComplianceIsTheInverse) {
  std::mt19937 random(80);
  for (Index n : {2, 6, 200})
    for (bool continuous : {false, true}) {
      const MatrixXd mass = edge_mass(n, continuous, random);
      const Loaded springs = foundation(mass, 3, 1, n + 2);
      Condensed condensed{{}, Factor(springs.stiffness, springs.nodes, {}, contact_unknowns(springs.rows))};
      ASSERT_TRUE(condensed.factor.factorise(springs.stiffness));
      MatrixXd compliance = MatrixXd::Zero(n + 2, n + 2);
      add_compliance(springs.rows, condensed, compliance);
      MatrixXd expected = MatrixXd::Zero(n + 2, n + 2);
      expected.block(1, 1, n, n) = mass.inverse() / 3;
      // The condition of a mass matrix is 3 times the ratio of two lengths, 100 here.
      EXPECT_LE((compliance - expected).norm(), 300 * eps * static_cast<double>(n) * expected.norm());
      EXPECT_EQ((compliance - compliance.transpose()).norm(), 0);
    }
}

// With p of either sign it is one linear problem: (B K⁻¹ Bᵀ + S⁻¹) p = B K⁻¹ f − g, S the springs' stiffness.
TEST(Springs, OfAnyStiffnessUnderASupportedBody) {
  std::mt19937 random(81);
  constexpr double none = std::numeric_limits<double>::infinity();
  const Index m = 9;
  const Truss truss = random_truss(m, random);
  MatrixXd rows = MatrixXd::Zero(m, 2 * m);
  for (Index i = 0; i < m; ++i) bind(rows, i, i, Eigen::Vector2d(random_vector(2, random)).normalized());
  const Loaded body = supported(truss, random_vector(2 * m, random), rows);
  const VectorXd gap = 0.1 * random_vector(m, random);
  const Eigen::LLT<MatrixXd> stiffness(symmetric(body.stiffness));
  for (double ratio : {1e-12, 1e-6, 1.0, 1e6, 1e12}) {
    const MatrixXd mass = edge_mass(m, true, random);
    const std::vector<Loaded> bodies{body, foundation(mass, ratio, 0, m)};
    const Solution solution = solve(bodies, gap, {}, {VectorXd::Constant(m, -none), VectorXd::Constant(m, none)});
    ASSERT_EQ(solution.termination, Termination::solved);
    const MatrixXd compliance = rows * stiffness.solve(MatrixXd(rows.transpose())) + mass.inverse() / ratio;
    const VectorXd p = compliance.llt().solve(rows * stiffness.solve(body.load) - gap);
    EXPECT_NEAR((solution.pressure - p).norm(), 0, 1e-10 * p.norm()) << ratio;
    const VectorXd pressed = mass * solution.displacement[1] * ratio;  // the springs carry it
    EXPECT_NEAR((pressed - p).norm(), 0, 1e-10 * p.norm()) << ratio;
  }
}

// A floating body on springs that do not pull.
TEST(Springs, UnderAFloatingBodyThatLiftsOff) {
  std::mt19937 random(82);
  for (int trial = 0; trial < 20; ++trial) {
    const Index m = 9;
    const Truss truss = random_truss(m, random);
    MatrixXd rows = MatrixXd::Zero(m, 2 * m);
    for (Index i = 0; i < m; ++i) bind(rows, i, i, Eigen::Vector2d(random_vector(2, random)).normalized());
    const VectorXd load =
        rows.transpose() * random_vector(m, random).cwiseMax(0) + truss.stiffness * random_vector(2 * m, random);
    const VectorXd gap = 0.1 * random_vector(m, random);
    for (double ratio : {1e-12, 1e-6, 1.0, 1e6, 1e12}) {
      const std::vector<Loaded> bodies{floating(truss, load, rows),
                                       foundation(edge_mass(m, true, random), ratio, 0, m)};
      const Solution solution = solve(bodies, gap);
      ASSERT_EQ(solution.termination, Termination::solved);
      const Kkt found = kkt(bodies, gap, solution);
      EXPECT_LE(found.equilibrium, truss_rounding);
      EXPECT_LE(found.rigid, truss_rounding);
      EXPECT_LE(found.penetration, truss_rounding);
      EXPECT_LE(found.complementarity, truss_rounding);
      EXPECT_GE(found.least_pressure, 0);
    }
  }
}

}  // namespace
}  // namespace bracket::contact
