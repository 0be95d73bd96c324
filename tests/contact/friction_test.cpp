// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/contact/truss.h"

namespace bracket::contact {
namespace {

using namespace test;

constexpr double unbounded = std::numeric_limits<double>::infinity();

void expect_within_limits(const std::vector<Loaded>& bodies, const VectorXd& gap, const Limits& limits,
                          const Solution& solution) {
  ASSERT_EQ(solution.termination, Termination::solved);
  const Kkt found = kkt(bodies, gap, solution, limits);
  EXPECT_LE(found.equilibrium, truss_rounding);
  EXPECT_LE(found.rigid, truss_rounding);
  EXPECT_LE(found.penetration, truss_rounding);
  EXPECT_TRUE(found.within);
}

/// The motion that solve() gives must gain more than any p within the limits takes of it.
void expect_slides(const std::vector<Loaded>& bodies, const Limits& limits, const Solution& solution) {
  ASSERT_EQ(solution.termination, Termination::no_equilibrium);
  double gain = 0, moved = 0;
  VectorXd work = VectorXd::Zero(limits.lower.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const VectorXd motion = bodies[b].rigid * solution.motion[b];
    if (motion.size() > 0) moved = std::max(moved, motion.lpNorm<Eigen::Infinity>());
    gain += motion.dot(bodies[b].load);
    work += bodies[b].rows * motion;
  }
  double taken = 0;
  for (Index i = 0; i < work.size(); ++i) {
    if (std::abs(work[i]) < 1e-10) work[i] = 0;
    if (work[i] != 0) taken += std::max(limits.lower[i] * work[i], limits.upper[i] * work[i]);
  }
  EXPECT_LT(taken, gain);
  EXPECT_NEAR(moved, 1, 1e-12);  // to what is left out of it as rounding
}

/// A square of side one on a floor: rows 0, 1 normal and 2, 3 tangential at its lower corners.
Loaded block_on_floor(const VectorXd& load) {
  Truss truss{MatrixXd(4, 2), MatrixXd::Zero(8, 8)};
  truss.joints << 0, 0, 1, 0, 1, 1, 0, 1;
  for (Index i = 0; i < 4; ++i)
    for (Index j = 0; j < i; ++j) {
      const Eigen::Vector2d along = (truss.joints.row(i) - truss.joints.row(j)).transpose().normalized();
      add_bar(truss.stiffness, i, j, along * along.transpose());
    }
  MatrixXd rows = MatrixXd::Zero(4, 8);
  for (Index i = 0; i < 2; ++i) {
    bind(rows, i, i, {0, -1});
    bind(rows, 2 + i, i, {1, 0});
  }
  return floating(truss, load, rows);
}

/// Pressed down by 2 from above and pushed to the right by `push`, at half its height.
Loaded pushed(double push) {
  VectorXd load = VectorXd::Constant(8, 0.25 * push);
  load[1] = load[3] = 0;
  load[5] = load[7] = -1;
  return block_on_floor(load);
}

Limits with_friction(const VectorXd& bound) {
  const Index n = bound.size();
  Limits limits{VectorXd::Zero(2 * n), VectorXd::Constant(2 * n, unbounded)};
  limits.lower.tail(n) = -bound;
  limits.upper.tail(n) = bound;
  return limits;
}

TEST(Friction, HoldsABlockUpToItsBoundAndNamesTheMotionBeyond) {
  const VectorXd gap = VectorXd::Zero(4);
  for (double unit : {1e-12, 1.0, 1e12})
    for (double side : {-1.0, 1.0})
      for (double bound : {1e-3, 0.5, 1.0}) {
        const Limits limits = with_friction(Eigen::Vector2d(bound, 0.5 * bound) * unit);
        const auto body = [&](double of_bound) {
          Loaded result = pushed(side * 1.5 * bound * of_bound);
          result.load *= unit;
          return std::vector<Loaded>{result};
        };
        for (double held : {0.0, 0.3, 0.9, 1 - 1e-9, 1.0})
          for (const std::vector<char>& guess : {std::vector<char>{}, {1, 1, 0, 0}, {0, 0, 0, 0}})
            expect_within_limits(body(held), gap, limits, solve(body(held), gap, guess, limits));
        const VectorXd p = solve(body(1), gap, {}, limits).pressure;
        EXPECT_NEAR(p[2], side * bound * unit, 1e-10 * unit);
        EXPECT_NEAR(p[3], side * 0.5 * bound * unit, 1e-10 * unit);
        for (double lost : {1 + 1e-6, 2.0, 1e6}) expect_slides(body(lost), limits, solve(body(lost), gap, {}, limits));
      }
}

// Hung up by friction alone: no row presses.
TEST(Friction, HoldsWithoutPressure) {
  std::mt19937 random(70);
  for (int trial = 0; trial < 60; ++trial) {
    const Truss truss = random_truss(9, random);
    MatrixXd rows = MatrixXd::Zero(6, 18);
    for (Index i = 0; i < 6; ++i) bind(rows, i, i, Eigen::Vector2d(random_vector(2, random)).normalized());
    const VectorXd bound = random_vector(6, random).cwiseAbs(), gap = 0.1 * random_vector(6, random);
    const Limits limits{-bound, bound};
    // The rigid motion along which they are to be at their bounds takes all of them.
    const MatrixXd rigid = rigid_motions(truss.joints);
    const VectorXd approach = rows * (rigid * random_vector(3, random));
    const VectorXd all = bound.cwiseProduct(approach.cwiseSign());
    const auto body = [&](double of_bound) {
      return std::vector<Loaded>{floating(truss, of_bound * rows.transpose() * all, rows)};
    };
    for (double held : {0.5, 1.0}) {
      const Solution solution = solve(body(held), gap, {}, limits);
      expect_within_limits(body(held), gap, limits, solution);
      if (held == 1) {
        EXPECT_NEAR((solution.pressure - all).norm(), 0, 1e-7 * all.norm());
      }
    }
    expect_slides(body(1.001), limits, solve(body(1.001), gap, {}, limits));
  }
}

/// Two trusses joint against joint, the second on springs; rows 0 … m−1 normal, m … 2m−1 tangential.
struct Rough {
  std::vector<Loaded> bodies;
  VectorXd gap;
};
Rough rough_pair(Index m, bool first_floats, std::mt19937& random) {
  const Truss upper = random_truss(9, random), under = random_truss(9, random);
  MatrixXd first = MatrixXd::Zero(2 * m, 18), second = MatrixXd::Zero(2 * m, 18);
  for (Index i = 0; i < m; ++i) {
    const Eigen::Vector2d normal = Eigen::Vector2d(random_vector(2, random)).normalized(),
                          along(-normal.y(), normal.x());
    bind(first, i, i, normal);
    bind(second, i, i, -normal);
    bind(first, m + i, i, along);
    bind(second, m + i, i, -along);
  }
  Rough result;
  result.gap = 0.1 * random_vector(2 * m, random);
  VectorXd held = 0.3 * random_vector(2 * m, random);
  held.head(m) = held.head(m).cwiseAbs();
  const VectorXd load = first.transpose() * held + upper.stiffness * random_vector(18, random);
  result.bodies = {first_floats ? floating(upper, load, first) : supported(upper, load, first),
                   supported(under, random_vector(18, random), second)};
  return result;
}

TEST(Friction, KktOfTwoBodies) {
  std::mt19937 random(71);
  for (int trial = 0; trial < 60; ++trial) {
    const Index m = 1 + trial % 9;
    const Rough pair = rough_pair(m, trial % 2 == 0, random);
    const Limits limits = with_friction(VectorXd(0.3 * random_vector(m, random).cwiseAbs()).array() + 1.0);
    const Bodies bodies(systems_of(pair.bodies));
    const Solution all = bodies.solve(loads_of(pair.bodies), pair.gap, {}, limits);
    if (all.termination == Termination::no_equilibrium) {
      expect_slides(pair.bodies, limits, all);
      continue;
    }
    expect_within_limits(pair.bodies, pair.gap, limits, all);
    for (Index i = 0; i < 2 * m; ++i)
      EXPECT_TRUE(all.active[static_cast<std::size_t>(i)] || all.pressure[i] == limits.lower[i] ||
                  all.pressure[i] == limits.upper[i]);
    for (const std::vector<char>& guess : {all.active, std::vector<char>(2 * static_cast<std::size_t>(m), 0)}) {
      const Solution other = bodies.solve(loads_of(pair.bodies), pair.gap, guess, limits);
      expect_within_limits(pair.bodies, pair.gap, limits, other);
      EXPECT_NEAR((other.pressure - all.pressure).norm(), 0, 1e4 * truss_rounding * all.pressure.norm());
    }
  }
}

// Whether [0, ∞) is told or not makes no difference at all.
TEST(Friction, UnilateralLimitsAreTheDefault) {
  std::mt19937 random(72);
  for (int trial = 0; trial < 10; ++trial) {
    const Rough pair = rough_pair(6, false, random);
    const Limits limits{VectorXd::Zero(12), VectorXd::Constant(12, unbounded)};
    const Solution told = solve(pair.bodies, pair.gap, {}, limits), plain = solve(pair.bodies, pair.gap);
    EXPECT_EQ(told.pressure, plain.pressure);
    EXPECT_EQ(told.displacement, plain.displacement);
    EXPECT_EQ(told.active, plain.active);
    EXPECT_EQ(told.iterations, plain.iterations);
  }
}

// Also where these rows are all that resists a motion: then it is free.
TEST(Friction, ABoundOfZeroLeavesTheRowOut) {
  std::mt19937 random(73);
  const auto expect_same = [](std::vector<Loaded> bodies, const VectorXd& gap) {
    const Index m = gap.size() / 2;
    const Solution with = solve(bodies, gap, {}, with_friction(VectorXd::Zero(m)));
    for (Loaded& body : bodies) body.rows = MatrixXd(MatrixXd(body.rows).topRows(m)).sparseView();
    const Solution without = solve(bodies, gap.head(m));
    ASSERT_EQ(with.termination, without.termination);
    if (without.termination != Termination::solved) return;
    EXPECT_NEAR((with.pressure.head(m) - without.pressure).norm(), 0, truss_rounding * without.pressure.norm());
    EXPECT_EQ(with.pressure.tail(m).norm(), 0);
    for (std::size_t b = 0; b < bodies.size(); ++b) {  // up to a free motion: what strains it
      const MatrixXd stiffness = symmetric(bodies[b].stiffness);
      EXPECT_NEAR((stiffness * (with.displacement[b] - without.displacement[b])).norm(), 0,
                  10 * truss_rounding * stiffness.norm() * (1 + without.displacement[b].norm()));
    }
  };
  expect_same({pushed(0)}, VectorXd::Zero(4));
  expect_same({pushed(1e-3)}, VectorXd::Zero(4));
  for (int trial = 0; trial < 20; ++trial) {
    const Rough pair = rough_pair(5, trial % 2 == 0, random);
    expect_same(pair.bodies, pair.gap);
  }
}

// A row whose limits are equal is a load.
TEST(Friction, EqualLimitsAreALoad) {
  std::mt19937 random(74);
  for (int trial = 0; trial < 20; ++trial) {
    Rough pair = rough_pair(5, trial % 2 == 0, random);
    Limits limits{VectorXd::Zero(10), VectorXd::Constant(10, unbounded)};
    limits.lower.tail(5) = limits.upper.tail(5) = random_vector(5, random);
    if (trial % 2 == 0)  // what then floats is held by the first rows
      pair.bodies[0].load += pair.bodies[0].rows.transpose() * limits.lower;
    const Solution given = solve(pair.bodies, pair.gap, {}, limits);
    for (Loaded& body : pair.bodies) {
      body.load -= body.rows.transpose() * limits.lower;
      body.rows = MatrixXd(MatrixXd(body.rows).topRows(5)).sparseView();
    }
    const Solution loaded = solve(pair.bodies, pair.gap.head(5));
    ASSERT_EQ(given.termination, loaded.termination);
    if (loaded.termination != Termination::solved) continue;
    EXPECT_NEAR((given.pressure.head(5) - loaded.pressure).norm(), 0, 1e3 * truss_rounding * given.pressure.norm());
    EXPECT_EQ(given.pressure.tail(5), limits.lower.tail(5));
  }
}

// Pressed together beyond what the rows may carry, without any load: forces in themselves, balanced or not.
TEST(Friction, LimitsBeyondZeroAreLoads) {
  const Loaded body = block_on_floor(VectorXd::Zero(8));
  Limits limits{VectorXd::Constant(4, -unbounded), VectorXd::Constant(4, unbounded)};
  limits.lower[2] = 1.0 / 3;
  const VectorXd gap = VectorXd::Zero(4);
  const Solution solution = solve({body}, gap, {}, limits);
  expect_within_limits({body}, gap, limits, solution);
  EXPECT_EQ(solution.pressure[2], 1.0 / 3);
  EXPECT_NEAR(solution.pressure[3], -1.0 / 3, truss_rounding);
  limits.lower[3] = 0;
  const Solution lost = solve({body}, gap, {}, limits);
  ASSERT_EQ(lost.termination, Termination::no_equilibrium);
  EXPECT_LT((body.rigid * lost.motion[0])[0], 0);  // to the left: p of rows is what they take, and they take too much
}

TEST(Friction, BilateralRowsStayClosed) {
  std::mt19937 random(75);
  for (int trial = 0; trial < 30; ++trial) {
    const Index m = 2 + trial % 8;
    Rough pair = rough_pair(m, trial % 2 == 0, random);
    const Limits limits{VectorXd::Constant(2 * m, -unbounded), VectorXd::Constant(2 * m, unbounded)};
    const Solution tied = solve(pair.bodies, pair.gap, std::vector<char>(2 * static_cast<std::size_t>(m), 0), limits);
    expect_within_limits(pair.bodies, pair.gap, limits, tied);
    EXPECT_EQ(tied.iterations, 1);
    // The same rows twice, and means of neighbours: dependent, but consistent; then not.
    MatrixXd more(5 * m, 2 * m);
    more << MatrixXd::Identity(2 * m, 2 * m), MatrixXd::Identity(2 * m, 2 * m), 0.5 * MatrixXd::Identity(m, 2 * m);
    more.bottomRightCorner(m, m) += 0.5 * MatrixXd::Identity(m, m);
    const VectorXd gap = more * pair.gap;
    std::vector<Loaded> again = pair.bodies;
    for (Loaded& body : again) body.rows = MatrixXd(more * MatrixXd(body.rows)).sparseView();
    Limits of_all{VectorXd::Constant(5 * m, -unbounded), VectorXd::Constant(5 * m, unbounded)};
    const Solution dependent = solve(again, gap, {}, of_all);
    expect_within_limits(again, gap, of_all, dependent);
    EXPECT_NEAR((dependent.elastic[1] - tied.elastic[1]).norm(), 0, 1e3 * truss_rounding * tied.elastic[1].norm());
    VectorXd other = gap;
    other[5 * m - 1] += 1e-3;
    EXPECT_EQ(solve(again, other, {}, of_all).termination, Termination::contradiction);
    of_all.lower[5 * m - 1] = -1e-6;  // a bound gives way
    of_all.upper[5 * m - 1] = 1e-6;
    expect_within_limits(again, other, of_all, solve(again, other, {}, of_all));
  }
}

// In other units of force and length, with one body stiffer than the other or softer, the same holds.
TEST(Friction, UnitsAndModuli) {
  std::mt19937 random(76);
  for (bool floats : {false, true}) {
    const Rough pair = rough_pair(6, floats, random);
    const VectorXd bound = VectorXd::Constant(6, 1.2);
    for (double ratio : {1e-12, 1e-6, 1.0, 1e6, 1e12})
      for (double force : {1e-12, 1.0, 1e12})
        for (double length : {1e-12, 1.0, 1e12}) {
          std::vector<Loaded> bodies = pair.bodies;
          for (Loaded& body : bodies) {
            body.load *= force;
            body.stiffness *= force / length;
          }
          bodies[0].stiffness *= ratio;
          const Limits limits = with_friction(bound * force);
          expect_within_limits(bodies, pair.gap * length, limits, solve(bodies, pair.gap * length, {}, limits));
        }
  }
}

}  // namespace
}  // namespace bracket::contact
