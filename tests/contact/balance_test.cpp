// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "contact/contact.h"
#include "tests/contact/truss.h"

namespace bracket::contact {
namespace {

using namespace test;

void expect_balanced(const MatrixXd& rows, const VectorXd& load, double scale) {
  const Balance found = balance(rows, load, 1e-10 * scale);
  ASSERT_TRUE(found.possible);
  EXPECT_TRUE((found.pressure.array() >= 0).all());
  EXPECT_LE((found.pressure.array() > 0).count(), rows.cols());
  EXPECT_LE((rows.transpose() * found.pressure - load).norm(), 1e-10 * scale);
}

/// y is a certificate: nothing ≥ 0 can do work against it, yet the load gains. [HH81, (1.16)]
void expect_pushed_off(const MatrixXd& rows, const VectorXd& load, double scale) {
  const Balance found = balance(rows, load, 1e-10 * scale);
  ASSERT_FALSE(found.possible);
  const VectorXd work = rows * found.motion;
  // The slope that counts as zero is 64 roundings of the load, per unit row.
  for (Index i = 0; i < rows.rows(); ++i)
    EXPECT_LE(work[i], 128 * std::numeric_limits<double>::epsilon() * scale * rows.row(i).norm());
  EXPECT_GT(load.dot(found.motion), 0);
}

TEST(Balance, FindsAPressureWhereOneIsKnown) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const Index k = 1 + static_cast<Index>(random() % 6), m = 1 + static_cast<Index>(random() % 30);
    const MatrixXd rows = MatrixXd::NullaryExpr(m, k, [&] { return random_vector(1, random)[0]; });
    const VectorXd load = rows.transpose() * random_vector(m, random).cwiseMax(0);
    expect_balanced(rows, load, load.norm());
  }
}

TEST(Balance, GivesTheMotionWhereNoneCanBe) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const Index k = 2 + static_cast<Index>(random() % 5), m = static_cast<Index>(random() % 30);
    VectorXd motion = random_vector(k, random).normalized();
    MatrixXd rows = MatrixXd::NullaryExpr(m, k, [&] { return random_vector(1, random)[0]; });
    for (Index i = 0; i < m; ++i)
      if (rows.row(i).dot(motion) > 0) rows.row(i) *= -1;  // now G y ≤ 0 …
    const VectorXd load = random_vector(k, random);
    expect_pushed_off(rows, load.dot(motion) > 0 ? load : VectorXd(-load), load.norm());  // … and eᵀy > 0
  }
}

TEST(Balance, OfRowsThatDependOnEachOther) {
  MatrixXd rows(5, 2);
  rows << 1, 0, 1, 0, 0, 1, 0, 1, 0.5, 0.5;
  expect_balanced(rows, Eigen::Vector2d(3, 0), 3);
  expect_balanced(rows, Eigen::Vector2d(0, 0), 0);
  expect_balanced(rows, Eigen::Vector2d(1, 1), 1);
  expect_pushed_off(rows, Eigen::Vector2d(3, -1), 3);
  expect_pushed_off(rows, Eigen::Vector2d(3, -1e-6), 3);
}

TEST(Balance, TakesWhatIsRoundingForRounding) {
  MatrixXd rows(2, 2);
  rows << 1, 0, 1, 0;
  expect_balanced(rows, Eigen::Vector2d(1, 1e-12), 1);
  expect_pushed_off(rows, Eigen::Vector2d(1, 1e-8), 1);
}

TEST(Balance, DoesNotDependOnUnits) {
  MatrixXd rows(3, 2);
  rows << 1, -1, 1, 1, 2, 0.1;
  for (double unit : {1e-12, 1.0, 1e12}) {
    expect_balanced(rows, Eigen::Vector2d(1, 0.3) * unit, unit);
    expect_pushed_off(rows, Eigen::Vector2d(1, 1.3) * unit, unit);
    expect_balanced(rows * unit, Eigen::Vector2d(1, 0.3), 1);
  }
}

/// Within limits: p, independent rows of G where it is neither at a limit nor at zero; or the certificate.
/// \return whether it is possible
bool expect_decided(const MatrixXd& rows, const VectorXd& load, const Limits& limits, double scale) {
  const Balance found = balance(rows, load, 1e-10 * scale, limits);
  if (found.possible) {
    const VectorXd& p = found.pressure;
    EXPECT_TRUE((p.array() >= limits.lower.array() && p.array() <= limits.upper.array()).all());
    EXPECT_LE((rows.transpose() * p - load).norm(), 1e-10 * scale);
    std::vector<Index> between;
    for (Index i = 0; i < p.size(); ++i)
      if (p[i] != 0 && p[i] > limits.lower[i] && p[i] < limits.upper[i]) between.push_back(i);
    const MatrixXd chosen = rows(between, Eigen::all);
    if (!between.empty()) {
      EXPECT_EQ(chosen.fullPivLu().rank(), static_cast<Index>(between.size()));
    }
    return true;
  }
  const VectorXd work = rows * found.motion;
  double most = 0;  // that p can do against the motion, but for rounding
  for (Index i = 0; i < rows.rows(); ++i) {
    const double limit = work[i] > 0 ? limits.upper[i] : limits.lower[i];
    if (std::isfinite(limit))
      most += limit * work[i];
    else
      EXPECT_LE(std::abs(work[i]), 128 * eps * scale * rows.row(i).norm());
  }
  EXPECT_LT(most, load.dot(found.motion));
  return false;
}

TEST(Balance, WithinLimits) {
  std::mt19937 random(4);
  constexpr double none = std::numeric_limits<double>::infinity();
  int possible = 0, impossible = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const Index k = 1 + static_cast<Index>(random() % 6), m = 1 + static_cast<Index>(random() % 20);
    MatrixXd rows = MatrixXd::NullaryExpr(m, k, [&] { return random_vector(1, random)[0]; });
    if (trial % 3 == 0) rows = rows.array().round();  // ties, rows that are the same, zeros
    Limits limits{VectorXd(m), VectorXd(m)};
    for (Index i = 0; i < m; ++i) {
      const double b = std::abs(random_vector(1, random)[0]);
      const double kind[][2] = {{-b, b}, {-b, b}, {0, none}, {0, 0}, {-none, -b}, {b, 2 * b}, {-none, none}};
      const int which = static_cast<int>(random() % (trial % 2 ? 6 : 7));
      limits.lower[i] = kind[which][0];
      limits.upper[i] = kind[which][1];
    }
    const VectorXd within = random_vector(m, random).cwiseMax(limits.lower).cwiseMin(limits.upper);
    const double scale = 10 * (1 + rows.norm() * within.norm());
    EXPECT_TRUE(expect_decided(rows, rows.transpose() * within, limits, scale));
    (expect_decided(rows, 3 * random_vector(k, random), limits, scale) ? possible : impossible)++;
    // Exactly at the limit of what holds against a motion that no row without limit meets, and beyond.
    const VectorXd motion = random_vector(k, random).normalized();
    VectorXd p(m);
    for (Index i = 0; i < m; ++i) {
      const double limit = rows.row(i).dot(motion) > 0 ? limits.upper[i] : limits.lower[i];
      p[i] = std::isfinite(limit) ? limit : within[i];
      if (!std::isfinite(limit)) rows.row(i) -= rows.row(i).dot(motion) * motion.transpose();
    }
    const VectorXd most = rows.transpose() * p;
    EXPECT_TRUE(expect_decided(rows, most, limits, scale));
    EXPECT_FALSE(expect_decided(rows, most + 1e-6 * scale * motion, limits, scale));
  }
  EXPECT_GE(possible, 100);
  EXPECT_GE(impossible, 100);
}

TEST(Balance, WithoutRowsOrWithoutMotions) {
  expect_balanced(MatrixXd(4, 0), VectorXd(0), 1);
  expect_pushed_off(MatrixXd(0, 2), Eigen::Vector2d(0, 1), 1);
  expect_balanced(MatrixXd(0, 2), Eigen::Vector2d(0, 0), 1);
  expect_pushed_off(MatrixXd::Zero(3, 1), VectorXd::Ones(1), 1);
}

}  // namespace
}  // namespace bracket::contact
