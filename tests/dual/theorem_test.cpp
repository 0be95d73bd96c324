// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "dual/block_theory.h"

/// Theorems 2.1 and 2.2 of HH81, block by block.
namespace bracket::dual {
namespace {

using scene::Vector;
using scene::Voigt;

constexpr double eps = std::numeric_limits<double>::epsilon();

/// The triangle with these angles (degrees) at the ends of a side of length one that points along 0.4 rad.
Triangle triangle(double first, double second) {
  const double a = first * std::numbers::pi / 180, b = second * std::numbers::pi / 180;
  const double side = std::sin(b) / std::sin(a + b);
  const Eigen::Rotation2Dd turn(0.4);
  return {Vector<2>(0, 0), turn * Vector<2>(1, 0), turn * Vector<2>(side * std::cos(a), side * std::sin(a))};
}

std::vector<Triangle> triangles() {
  return {{Vector<2>(0, 0), Vector<2>(1, 0), Vector<2>(0, 1)},
          triangle(60, 60),
          triangle(37, 81),
          triangle(5, 5),
          triangle(5, 87.5),
          triangle(1, 178)};
}

double tangent_of_smallest_angle(const Triangle& t) {
  double smallest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const Vector<2> u = t[(k + 1) % 3] - t[k], v = t[(k + 2) % 3] - t[k];
    const double sine = u[0] * v[1] - u[1] * v[0], cosine = u.dot(v);
    if (cosine > 0) smallest = std::min(smallest, sine / cosine);
  }
  return smallest;
}

Vector<2> outward(const Triangle& t, int edge) {
  const Vector<2> along = t[(edge + 2) % 3] - t[(edge + 1) % 3];
  return Vector<2>(along[1], -along[0]).normalized();
}

Vector<2> traction(const Voigt<2>& s, const Vector<2>& n) {
  return {s[0] * n[0] + s[2] * n[1], s[2] * n[0] + s[1] * n[1]};
}

/// Forces along x and y and the moment about vertex 0 of side tractions, by Simpson's rule.
Eigen::Vector3d resultants(const Triangle& t, const SideTractions& tractions) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int e = 0; e < 3; ++e) {
    const Vector<2> a = t[(e + 1) % 3] - t[0], b = t[(e + 2) % 3] - t[0];
    for (const auto& [s, weight] : {std::pair(0.0, 1.0), std::pair(0.5, 4.0), std::pair(1.0, 1.0)}) {
      const Vector<2> x = (1 - s) * a + s * b;
      const Vector<2> load = (1 - s) * tractions.segment<2>(4 * e) + s * tractions.segment<2>(4 * e + 2);
      sum += (b - a).norm() * weight / 6 * Eigen::Vector3d(load[0], load[1], x[0] * load[1] - x[1] * load[0]);
    }
  }
  return sum;
}

/// 3 × 12, by columns.
Eigen::Matrix<double, 3, 12> equilibrium(const Triangle& t) {
  Eigen::Matrix<double, 3, 12> rows;
  for (int i = 0; i < 12; ++i) rows.col(i) = resultants(t, SideTractions::Unit(i));
  return rows;
}

double largest(const Corners& stress) {
  double size = 0;
  for (const auto& s : stress) size = std::max(size, s.cwiseAbs().maxCoeff());
  return size;
}

/// The largest |τ| of the block over all vertices of { T in equilibrium, |T| ≤ 1 }: nine components at ±1, three free.
double largest_over_vertices(const Triangle& t) {
  const auto rows = equilibrium(t);
  std::array<Corners, 12> unit;
  for (int i = 0; i < 12; ++i) unit[i] = stress_by_tractions(t, SideTractions::Unit(i));
  double most = 0;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < i; ++j)
      for (int k = 0; k < j; ++k) {
        Eigen::Matrix3d free;
        free << rows.col(i), rows.col(j), rows.col(k);
        const double size = free.col(0).norm() * free.col(1).norm() * free.col(2).norm();
        if (std::abs(free.determinant()) < 1e-12 * size) continue;
        const Eigen::Matrix3d inverse = free.inverse();
        for (int signs = 0; signs < 512; ++signs) {
          SideTractions load;
          int bit = 0;
          for (int r = 0; r < 12; ++r) load[r] = r == i || r == j || r == k ? 0 : (signs >> bit++) & 1 ? 1 : -1;
          const Eigen::Vector3d rest = inverse * -(rows * load);
          if (rest.cwiseAbs().maxCoeff() > 1) continue;
          load[i] = rest[0], load[j] = rest[1], load[k] = rest[2];
          for (int c = 0; c < 9; ++c) {
            Voigt<2> stress = Voigt<2>::Zero();
            for (int r = 0; r < 12; ++r) stress += load[r] * unit[r][c];
            most = std::max(most, stress.cwiseAbs().maxCoeff());
          }
        }
      }
  return most;
}

TEST(StressByLoads, HasTheLoadsAsItsTractions) {  // Theorem 2.1
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const Triangle& t : triangles()) {
    const auto rows = equilibrium(t);
    SideTractions load;
    for (double& value : load) value = uniform(random);
    load -= rows.transpose() * (rows * rows.transpose()).ldlt().solve(rows * load);
    const Corners stress = stress_by_tractions(t, load);
    for (int e = 0; e < 3; ++e)
      for (int end = 0; end < 2; ++end)
        EXPECT_LT((traction(stress[3 * e + end], outward(t, e)) - load.segment<2>(4 * e + 2 * end)).norm(),
                  100 * eps * largest(stress));
  }
}

TEST(StressByLoads, ConstantIsThatOfTheExtremeLoads) {  // duality of linear programs
  for (const Triangle& t : triangles()) {
    const double constant = stress_by_load_constant(t);
    // Rounding of vertices at the edge of the cube: they are left out, or are a little beyond.
    EXPECT_NEAR(constant, largest_over_vertices(t), 1e-9 * constant);
  }
}

TEST(StressByLoads, ConstantDependsOnShapeAlone) {
  for (const Triangle& t : triangles()) {
    const double constant = stress_by_load_constant(t);
    for (const double scale : {1e-6, 3.0, 1e6}) {
      Triangle other;
      for (int v = 0; v < 3; ++v) other[v] = scale * t[v];
      EXPECT_NEAR(stress_by_load_constant(other), constant, 1e-9 * constant);
      std::rotate(other.begin(), other.begin() + 1, other.end());  // its vertices' numbers do not matter
      EXPECT_NEAR(stress_by_load_constant(other), constant, 1e-9 * constant);
    }
  }
}

/// On the reference triangle the constant is ĉ. With τ = B τ̂ Bᵀ / det B, T̂ = B⁻¹ T |e| / |ê|, sides of at most h, the
/// longest one, |B| ≤ √2 h, |B⁻¹| ≤ √2 h / det B, det B ≥ ½ h² tan α:
///     max |τ| ≤ 2 √2 ĉ |B|² |B⁻¹| h / det B max |T| ≤ 32 ĉ / tan² α max |T|.
TEST(StressByLoads, ConstantIsBoundedByTheSmallestAngle) {
  const double reference = stress_by_load_constant(triangles()[0]);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 200; ++i) {
    const double smallest = 60 * std::pow(uniform(random), 3) + 0.5;
    const Triangle t = triangle(smallest, smallest + uniform(random) * (180 - 3 * smallest));
    const double tangent = tangent_of_smallest_angle(t);
    EXPECT_LE(stress_by_load_constant(t), 32 * reference / (tangent * tangent));
  }
}

TEST(Interpolation, KeepsStressesOfTheBlock) {
  // Linear, without divergence.
  const StressField stress = [](const Vector<2>& x) {
    return Voigt<2>(1 + 2 * x[0] - 3 * x[1], -2 + 5 * x[0] + 4 * x[1], 0.5 - 4 * x[0] - 2 * x[1]);
  };
  for (const Triangle& t : triangles()) {
    const Corners corners = interpolate(t, stress);
    // The loads, of size 10, are rounded; the stress by them is up to the constant larger.
    const double rounding = 1000 * eps * stress_by_load_constant(t);
    const Vector<2> centroid = (t[0] + t[1] + t[2]) / 3;
    for (int k = 0; k < 3; ++k) {
      const std::array<Vector<2>, 3> at = {t[(k + 1) % 3], t[(k + 2) % 3], centroid};
      for (int c = 0; c < 3; ++c) EXPECT_LT((corners[3 * k + c] - stress(at[c])).norm(), rounding);
    }
    EXPECT_LT(squared_distance(t, stress, corners, scene::Elasticity<2>::Identity()), rounding * rounding);
  }
}

TEST(Interpolation, KeepsTheMomentsOfTheTractions) {
  // Cubic, from the Airy function x⁵ − 3x²y³ + xy⁴.
  const StressField stress = [](const Vector<2>& x) {
    return Voigt<2>(-18 * x[0] * x[0] * x[1] + 12 * x[0] * x[1] * x[1], 20 * std::pow(x[0], 3) - 6 * std::pow(x[1], 3),
                    18 * x[0] * x[1] * x[1] - 4 * std::pow(x[1], 3));
  };
  for (const Triangle& t : triangles()) {
    const Corners corners = interpolate(t, stress);
    const double rounding = 1000 * eps * stress_by_load_constant(t);
    for (int e = 0; e < 3; ++e) {
      const Vector<2> a = t[(e + 1) % 3], b = t[(e + 2) % 3], n = outward(t, e);
      const auto misfit = [&](double s) {
        const Voigt<2> linear = (1 - s) * corners[3 * e] + s * corners[3 * e + 1];
        return Vector<2>(traction(stress(a + s * (b - a)) - linear, n));
      };
      for (int c = 0; c < 2; ++c) {
        EXPECT_NEAR(integrate([&](double s) { return misfit(s)[c]; }), 0, rounding);
        EXPECT_NEAR(integrate([&](double s) { return s * misfit(s)[c]; }), 0, rounding);
      }
    }
  }
}

TEST(Interpolation, DistanceIsThatOfTheCorners) {
  // A block's own stress against zero: ∫ |τ|² by its corners; the squares' distance takes it by Gauss points.
  for (const Triangle& t : triangles()) {
    const Voigt<2> stress(1, -2, 0.5);
    Corners zero;
    zero.fill(Voigt<2>::Zero());
    const Vector<2> u = t[1] - t[0], v = t[2] - t[0];
    const double area = (u[0] * v[1] - u[1] * v[0]) / 2;
    EXPECT_NEAR(squared_distance(
                    t, [&](const Vector<2>&) { return stress; }, zero, scene::Elasticity<2>::Identity()),
                5.25 * area, 1e-13 * area);
  }
}

}  // namespace
}  // namespace bracket::dual
