// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/contact/truss.h"

namespace bracket::contact {
namespace {

using namespace test;

void expect_solved(const std::vector<Loaded>& bodies, const VectorXd& gap, const Solution& solution) {
  ASSERT_EQ(solution.termination, Termination::solved);
  const Kkt found = kkt(bodies, gap, solution);
  EXPECT_LE(found.equilibrium, truss_rounding);
  EXPECT_LE(found.rigid, truss_rounding);
  EXPECT_LE(found.penetration, truss_rounding);
  EXPECT_LE(found.complementarity, truss_rounding);
  EXPECT_GE(found.least_pressure, 0);
  for (Index i = 0; i < gap.size(); ++i)
    EXPECT_TRUE(solution.active[static_cast<std::size_t>(i)] || solution.pressure[i] == 0);
}

/// Two trusses, the second on springs, joint against joint along random normals.
struct Pair {
  std::vector<Loaded> bodies;
  VectorXd gap;
};
Pair random_pair(Index m, bool first_floats, std::mt19937& random) {
  const Truss upper = random_truss(9, random), lower_truss = random_truss(9, random);
  MatrixXd first = MatrixXd::Zero(m, 18), second = MatrixXd::Zero(m, 18);
  for (Index i = 0; i < m; ++i) {
    const Eigen::Vector2d normal = Eigen::Vector2d(random_vector(2, random)).normalized();
    bind(first, i, i % 9, normal);
    bind(second, i, i % 9, -normal);
  }
  Pair result;
  result.gap = 0.1 * random_vector(m, random);
  // What some p ≥ 0 balances, plus what the truss carries in itself.
  const VectorXd carried =
      first.transpose() * random_vector(m, random).cwiseAbs() + upper.stiffness * random_vector(18, random);
  result.bodies = {first_floats ? floating(upper, carried, first) : supported(upper, random_vector(18, random), first),
                   supported(lower_truss, random_vector(18, random), second)};
  return result;
}

TEST(Solve, KktOfTwoBodies) {
  std::mt19937 random(20);
  for (int trial = 0; trial < 60; ++trial) {
    const Pair pair = random_pair(1 + trial % 14, trial % 2 == 0, random);
    expect_solved(pair.bodies, pair.gap, solve(pair.bodies, pair.gap));
  }
}

TEST(BlasThreads, AreAsBeforeInTheEnd) {
  const int before = BlasThreads::now();
  if (before == 0) GTEST_SKIP() << "BLAS is not OpenBLAS";
  {
    const BlasThreads two(2);
    const int in_two = BlasThreads::now();
    {
      const BlasThreads one(1);
      EXPECT_EQ(BlasThreads::now(), 1);
    }
    EXPECT_EQ(BlasThreads::now(), in_two);
  }
  EXPECT_EQ(BlasThreads::now(), before);
}

TEST(Solve, TheGuessDoesNotChangeTheSolution) {
  std::mt19937 random(21);
  for (int trial = 0; trial < 20; ++trial) {
    const Pair pair = random_pair(8, trial % 2 == 0, random);
    const Solution all = solve(pair.bodies, pair.gap);
    ASSERT_EQ(all.termination, Termination::solved);
    const std::vector<char> none(8, 0), every_other{1, 0, 1, 0, 1, 0, 1, 0};
    for (const std::vector<char>& guess : {none, all.active, every_other}) {
      const Solution other = solve(pair.bodies, pair.gap, guess);
      expect_solved(pair.bodies, pair.gap, other);
      EXPECT_NEAR((other.pressure - all.pressure).norm(), 0, 1e3 * truss_rounding * all.pressure.norm());
    }
    EXPECT_EQ(solve(pair.bodies, pair.gap, all.active).iterations, 1);
  }
}

// Factorised once, bodies are solved for whatever acts on them; one load without equilibrium leaves no trace.
TEST(Solve, OneFactorisationServesAllLoadsAndGaps) {
  std::mt19937 random(23);
  int pushed_off = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Index m = 1 + trial % 8;
    Pair pair = random_pair(m, trial % 2 == 0, random);
    const Bodies bodies(systems_of(pair.bodies));
    std::vector<VectorXd> lost = loads_of(pair.bodies);
    lost[0] -= 1e3 * (pair.bodies[0].rows.transpose() * VectorXd::Ones(m));  // off all rows
    if (bodies.solve(lost, pair.gap).termination == Termination::no_equilibrium) ++pushed_off;
    for (const double factor : {1.0, -0.3, 1e6}) {
      pair.gap *= factor;
      pair.bodies[1].load *= factor;
      if (factor > 0) pair.bodies[0].load *= factor;
      const Solution again = bodies.solve(loads_of(pair.bodies), pair.gap), anew = solve(pair.bodies, pair.gap);
      expect_solved(pair.bodies, pair.gap, again);
      EXPECT_EQ(again.pressure, anew.pressure);
      EXPECT_EQ(again.elastic, anew.elastic);
      EXPECT_EQ(again.displacement, anew.displacement);
    }
  }
  EXPECT_GE(pushed_off, 5);
}

// Without rows each body is solved for itself; the elastic part and the displacement are then the same.
TEST(Solve, WithoutRows) {
  std::mt19937 random(22);
  const Truss truss = random_truss(9, random);
  const VectorXd load = random_vector(18, random);
  const std::vector<Loaded> held{supported(truss, load, MatrixXd(0, 18))};
  const Solution solution = solve(held, VectorXd(0));
  expect_solved(held, VectorXd(0), solution);
  EXPECT_EQ(solution.displacement[0], solution.elastic[0]);
  EXPECT_EQ(solution.iterations, 0);

  const std::vector<Loaded> balanced{floating(truss, truss.stiffness * load, MatrixXd(0, 18))};
  const Solution afloat = solve(balanced, VectorXd(0));
  expect_solved(balanced, VectorXd(0), afloat);
  EXPECT_LE(afloat.imbalance, 18 * eps);

  const Solution lost = solve({floating(truss, load, MatrixXd(0, 18))}, VectorXd(0));
  ASSERT_EQ(lost.termination, Termination::no_equilibrium);
  EXPECT_GT((rigid_motions(truss.joints) * lost.motion[0]).dot(load), 0);
}

/// A square of four joints and its diagonals, from (x, y) with side one.
Truss square(double x, double y) {
  Truss truss{MatrixXd(4, 2), MatrixXd::Zero(8, 8)};
  truss.joints << x, y, x + 1, y, x + 1, y + 1, x, y + 1;
  for (Index i = 0; i < 4; ++i)
    for (Index j = 0; j < i; ++j) {
      const Eigen::Vector2d along = (truss.joints.row(i) - truss.joints.row(j)).transpose().normalized();
      add_bar(truss.stiffness, i, j, along * along.transpose());
    }
  return truss;
}

/// `levels` squares on each other and on a rigid floor, two rows on each level; all float. `stiffness` of each.
std::vector<Loaded> tower(const std::vector<double>& stiffness, const VectorXd& top_load) {
  std::vector<Loaded> bodies;
  const auto levels = static_cast<Index>(stiffness.size());
  for (Index level = 0; level < levels; ++level) {
    Truss truss = square(0, static_cast<double>(level));
    truss.stiffness *= stiffness[static_cast<std::size_t>(level)];
    MatrixXd rows = MatrixXd::Zero(2 * levels, 8);
    bind(rows, 2 * level, 0, {0, -1});
    bind(rows, 2 * level + 1, 1, {0, -1});
    if (level + 1 < levels) {
      bind(rows, 2 * level + 2, 3, {0, 1});
      bind(rows, 2 * level + 3, 2, {0, 1});
    }
    bodies.push_back(floating(truss, level + 1 == levels ? top_load : VectorXd::Zero(8), rows));
  }
  return bodies;
}

// Statics alone gives the pressures: the lever rule, the same on every level.
TEST(Solve, BodiesStackedOnEachOther) {
  VectorXd load = VectorXd::Zero(8);
  load[7] = -3;  // above the left row
  load[5] = -1;  // above the right
  for (double ratio : {1e-12, 1.0, 1e12})
    for (double unit : {1e-12, 1.0, 1e12}) {
      const auto bodies = tower({unit, unit * ratio, unit}, load);
      const VectorXd gap = VectorXd::Zero(6);
      const Solution solution = solve(bodies, gap);
      expect_solved(bodies, gap, solution);
      for (Index level = 0; level < 3; ++level) {
        EXPECT_NEAR(solution.pressure[2 * level], 3, 3 * truss_rounding);
        EXPECT_NEAR(solution.pressure[2 * level + 1], 1, 3 * truss_rounding);
      }
      EXPECT_LE(solution.imbalance, 1e-14);
    }
}

// Both loads above the left row: the right one carries nothing, yet is closed or open as the elastic squares decide.
TEST(Solve, RowWithoutPressureInAStack) {
  VectorXd load = VectorXd::Zero(8);
  load[7] = -1;
  const auto bodies = tower({1, 1, 1}, load);
  const VectorXd gap = VectorXd::Zero(6);
  const Solution solution = solve(bodies, gap);
  expect_solved(bodies, gap, solution);
  for (Index level = 0; level < 3; ++level) EXPECT_NEAR(solution.pressure[2 * level], 1, truss_rounding);
}

/// The motion that solve() gives must gain energy and meet no row.
void expect_pushed_off(const std::vector<Loaded>& bodies, const VectorXd& gap) {
  const Solution solution = solve(bodies, gap);
  ASSERT_EQ(solution.termination, Termination::no_equilibrium);
  double gain = 0, largest = 0;
  VectorXd work = VectorXd::Zero(gap.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const VectorXd moved = bodies[b].rigid * solution.motion[b];
    gain += moved.dot(bodies[b].load);
    work += bodies[b].rows * moved;
    if (moved.size() > 0) largest = std::max(largest, moved.cwiseAbs().maxCoeff());
  }
  EXPECT_GT(gain, 0);
  EXPECT_LE(work.maxCoeff(), 1e-10);
  EXPECT_NEAR(largest, 1, 4 * eps);
}

TEST(Solve, LoadsThatNoPressureBalances) {
  const VectorXd gap = VectorXd::Zero(6);
  VectorXd load = VectorXd::Zero(8);
  load[5] = load[7] = 1;  // lifted
  expect_pushed_off(tower({1, 1, 1}, load), gap);
  load << 0, 0, 0, 0, 0, -1, 0, 1e-3;  // tilted over its edge
  expect_pushed_off(tower({1, 1, 1}, load), gap);
  load << 0, 0, 0, 0, 0, -1, 1e-6, -1;  // pushed aside, where nothing is in the way
  expect_pushed_off(tower({1, 1, 1}, load), gap);
}

TEST(Solve, ImbalanceOfRoundingIsRemovedAndReported) {
  VectorXd load = VectorXd::Zero(8);
  load[5] = load[7] = -1;
  load[4] = 2e-13;
  const auto bodies = tower({1, 1, 1}, load);
  const Solution solution = solve(bodies, VectorXd::Zero(6));
  ASSERT_EQ(solution.termination, Termination::solved);
  EXPECT_GT(solution.imbalance, 1e-14);
  EXPECT_LT(solution.imbalance, 1e-12);
}

// What lifts the square is rounding beside the loads that it carries in itself: no p ≥ 0 balances it exactly.
TEST(Solve, LiftOfRoundingIsRemovedAndReported) {
  VectorXd load = VectorXd::Zero(8);
  load[4] = 1;
  load[6] = -1;
  load[5] = load[7] = 2e-11;
  const auto bodies = tower({1, 1, 1}, load);
  const Solution solution = solve(bodies, VectorXd::Zero(6));
  ASSERT_EQ(solution.termination, Termination::solved);
  EXPECT_GT(solution.imbalance, 1e-12);
  EXPECT_LT(solution.imbalance, 1e-10);
  EXPECT_LE(solution.pressure.maxCoeff(), 1e-10);
}

// A very stiff square on a soft one moves by the soft one's displacement; what strains it is 1e12 times less.
TEST(Solve, ElasticPartIsFreeOfTheRoundingOfALargeMotion) {
  VectorXd load = VectorXd::Zero(8);
  load[5] = load[7] = -1;
  const auto bodies = tower({1, 1e12}, load);
  const Solution solution = solve(bodies, VectorXd::Zero(4));
  ASSERT_EQ(solution.termination, Termination::solved);
  const VectorXd acting = bodies[1].load - bodies[1].rows.transpose() * solution.pressure;
  const MatrixXd stiffness = symmetric(bodies[1].stiffness);
  EXPECT_LE((stiffness * solution.elastic[1] - acting).norm(), truss_rounding);
  const VectorXd rigid = solution.displacement[1] - solution.elastic[1];
  EXPECT_GT(rigid.norm(), 1e6 * solution.elastic[1].norm());
  const VectorXd fitted = bodies[1].rigid * bodies[1].rigid.colPivHouseholderQr().solve(rigid);
  EXPECT_LE((rigid - fitted).norm(), 2 * 8 * eps * rigid.norm());
}

// The rounding of thousands of rows adds up along the rigid motions; the pinned unknowns must not bear the sum.
TEST(Solve, EquilibriumAtThePinsOfALargeBody) {
  constexpr int side = 80;
  std::vector<int> cells;
  for (int i = 0; i + 1 < side; ++i)
    for (int j = 0; j + 1 < side; ++j)
      for (int joint : {i * side + j, i * side + j + 1, (i + 1) * side + j + 1, (i + 1) * side + j})
        cells.push_back(joint);
  const std::vector<int> nodes = pairs(2 * side * side);
  Assembly assembly(nodes, cells, 4);
  const MatrixXd cell = square(0, 0).stiffness;
  for (std::size_t c = 0; c < cells.size(); c += 4) {
    std::vector<int> unknowns;
    for (std::size_t k = c; k < c + 4; ++k) unknowns.insert(unknowns.end(), {2 * cells[k], 2 * cells[k] + 1});
    assembly.add(unknowns, cell);
  }
  Loaded body{{assembly.take(), nodes, {side, nodes.back()}, {}}, VectorXd::Zero(nodes.back())};
  MatrixXd joints(side * side, 2);
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) joints.row(i * side + j) << j, i;
  body.rigid = rigid_motions(joints);
  for (int j = 0; j < side; ++j) {
    body.rows.insert(j, 2 * j + 1) = -1;
    body.load[2 * ((side - 1) * side + j) + 1] = j < side / 2 ? -1.0 : 0.1;
  }
  const Solution solution = solve({body}, VectorXd::Zero(side));
  ASSERT_EQ(solution.termination, Termination::solved);
  const auto stiffness = body.stiffness.selfadjointView<Eigen::Lower>();
  const VectorXd residual = body.load - body.rows.transpose() * solution.pressure - stiffness * solution.elastic[0];
  const Eigen::SparseMatrix<double> absolute = body.stiffness.cwiseAbs();
  const VectorXd terms = absolute.selfadjointView<Eigen::Lower>() * solution.elastic[0].cwiseAbs();
  EXPECT_LE(residual.cwiseAbs().maxCoeff(), 18 * eps * terms.maxCoeff());  // a row is a sum of 18 terms
}

}  // namespace
}  // namespace bracket::contact
