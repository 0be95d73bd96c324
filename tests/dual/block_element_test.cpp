// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/block_element.h"

#include <gtest/gtest.h>

#include <random>

namespace bracket::dual {
namespace {

using scene::Vector;
using scene::Voigt;

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Isosceles with the given angle at vertex 0, turned by 1 rad.
Triangle isosceles(double degrees) {
  const double half = degrees * M_PI / 360;
  const Eigen::Rotation2Dd turn(1);
  return {Vector<2>(3, -2), Vector<2>(3, -2) + turn * Vector<2>(std::cos(half), -std::sin(half)),
          Vector<2>(3, -2) + turn * Vector<2>(std::cos(half), std::sin(half))};
}

std::vector<Triangle> triangles() {
  return {{Vector<2>(0, 0), Vector<2>(1, 0), Vector<2>(0, 1)},
          {Vector<2>(2, 1), Vector<2>(5, 1.5), Vector<2>(3, 4)},
          isosceles(1),
          isosceles(178),
          {Vector<2>(0, 0), Vector<2>(1e-9, 0), Vector<2>(2e-10, 1e-9)},
          {Vector<2>(0, 0), Vector<2>(1e9, 0), Vector<2>(1e8, 1e9)}};
}

scene::Elasticity<2> compliance() { return scene::isotropic<2>(2, 0.3, scene::Plane::strain).compliance(); }

Vector<2> traction(const Voigt<2>& s, const Vector<2>& n) {
  return {s[0] * n[0] + s[2] * n[1], s[2] * n[0] + s[1] * n[1]};
}

Vector<2> outward(const Triangle& t, int edge) {
  const Vector<2> along = t[(edge + 2) % 3] - t[(edge + 1) % 3];
  return {along[1], -along[0]};
}

/// Longest edge squared by twice the area: rounding grows with it.
double aspect(const Triangle& t) {
  double longest = 0;
  for (int e = 0; e < 3; ++e) longest = std::max(longest, outward(t, e).squaredNorm());
  return longest / std::abs(outward(t, 0).dot(t[1] - t[0]));
}

ModeVector<1> random_amplitudes(unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return ModeVector<1>::NullaryExpr([&] { return uniform(generator); });
}

/// The three rigid motions as edge displacements: linear, by Bernstein coefficients along the edges.
template <int degree> Eigen::Matrix<double, n_loads(degree), 3> rigid(const Triangle& t) {
  const Vector<2> centre = (t[0] + t[1] + t[2]) / 3;
  const double size = (t[1] - t[0]).norm() + (t[2] - t[0]).norm();
  Eigen::Matrix<double, n_loads(degree), 3> motions;
  for (int e = 0; e < 3; ++e)
    for (int i = 0; i <= degree; ++i) {
      const Vector<2> begin = t[(e + 1) % 3], end = t[(e + 2) % 3];
      const Vector<2> arm = (begin + i * (end - begin) / degree - centre) / size;
      motions.template middleRows<2>(2 * (degree + 1) * e + 2 * i) << 1, 0, -arm[1], 0, 1, arm[0];
    }
  return motions;
}

double largest(const Corners& stress) {
  double value = 0;
  for (const auto& s : stress) value = std::max(value, s.cwiseAbs().maxCoeff());
  return value;
}

TEST(BlockElement, reference_modes_are_exact) {
  // Integers: the tractions at the ends of the outer edges give the loads, and those of inner edges agree, to the last
  // bit.
  const ReferenceBlock<1>& reference = reference_block<1>();
  const Triangle t = {Vector<2>(0, 0), Vector<2>(1, 0), Vector<2>(0, 1)},
                 tripled = {Vector<2>(0, 0), Vector<2>(3, 0), Vector<2>(0, 3)};
  for (int m = 0; m < n_modes(1); ++m) {
    const Corners& s = reference.modes[m];
    for (int e = 0; e < 3; ++e) {
      const Vector<2> n = outward(t, e), a = traction(s[3 * e], n), b = traction(s[3 * e + 1], n);
      EXPECT_EQ(Vector<2>(2 * a + b), Vector<2>(6 * reference.loads.block<2, 1>(4 * e, m)));
      EXPECT_EQ(Vector<2>(a + 2 * b), Vector<2>(6 * reference.loads.block<2, 1>(4 * e + 2, m)));
      const Vector<2> inner = tripled[(e + 2) % 3] - Vector<2>(1, 1), across(inner[1], -inner[0]);
      const int next = 3 * ((e + 1) % 3);
      EXPECT_EQ(traction(s[3 * e + 1], across), traction(s[next], across));
      EXPECT_EQ(traction(s[3 * e + 2], across), traction(s[next + 2], across));
    }
  }
}

template <int degree> void expect_only_rigid_motions_in_kernel() {
  for (const Triangle& t : triangles()) {
    const BlockElement<degree> block = block_element<degree>(t, compliance());
    const auto half = half_stiffness<degree>(block.compliance.llt(), block.loads);
    const CellMatrix<degree> k = half.transpose() * half;
    EXPECT_LT((k * rigid<degree>(t)).norm(), 1e-10 * k.norm()) << degree;
    // Rows and columns scaled to a unit diagonal, so that the rank does not hide behind the shape of the cell.
    const LoadVector<degree> scale = k.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = scale.asDiagonal() * k * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled, Eigen::EigenvaluesOnly);
    const Eigen::VectorXd& values = eigen.eigenvalues();
    for (int i = 0; i < 3; ++i) EXPECT_LT(std::abs(values[i]), 1e3 * eps) << degree;
    EXPECT_GT(values[3], 1e-9) << degree;
  }
}
TEST(BlockElement, stiffness_has_only_rigid_motions_in_its_kernel) {  // no spurious modes, on slivers either
  expect_only_rigid_motions_in_kernel<1>();
  expect_only_rigid_motions_in_kernel<2>();
  expect_only_rigid_motions_in_kernel<3>();
}

TEST(BlockElement, each_equilibrated_linear_side_load_has_exactly_one_stress) {  // [HH81, Theorem 2.1]
  for (const Triangle& t : triangles()) {
    const BlockElement<1> block = block_element<1>(t, compliance());
    const Eigen::MatrixXd products = block.loads.transpose() * block.loads;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(products, Eigen::EigenvaluesOnly);
    EXPECT_GT(eigen.eigenvalues()[0], 1e-12 * eigen.eigenvalues()[8]);  // one at most
    // Loads of modes do no work in rigid motions, and 12 − 3 = 9: one at least.
    EXPECT_LT((rigid<1>(t).transpose() * block.loads).norm(), 1e2 * eps * block.loads.norm());
  }
}

TEST(BlockElement, modes_have_no_divergence_and_continuous_tractions) {
  for (const Triangle& t : triangles()) {
    const Corners s = block_stress<1>(block_element<1>(t, compliance()).piola, random_amplitudes(7));
    const Vector<2> centroid = (t[0] + t[1] + t[2]) / 3;
    for (int k = 0; k < 3; ++k) {
      // The tractions on a closed curve balance where the divergence vanishes: over each part, linear fields.
      const Triangle part = {t[(k + 1) % 3], t[(k + 2) % 3], centroid};
      Vector<2> force = Vector<2>::Zero();
      double size = 0;
      for (int c = 0; c < 3; ++c) {
        const Vector<2> n = outward(part, (c + 2) % 3);  // the edge from corner c to c+1
        const Vector<2> share = (traction(s[3 * k + c], n) + traction(s[3 * k + (c + 1) % 3], n)) / 2;
        force += share;
        size += share.norm();
      }
      EXPECT_LT(force.norm(), 1e3 * eps * aspect(t) * size);
      const Vector<2> inner = t[(k + 2) % 3] - centroid, n = Vector<2>(inner[1], -inner[0]).normalized();
      const int next = 3 * ((k + 1) % 3);
      EXPECT_LT(traction(s[3 * k + 1] - s[next], n).norm(), 1e3 * eps * aspect(t) * largest(s));
      EXPECT_LT(traction(s[3 * k + 2] - s[next + 2], n).norm(), 1e3 * eps * aspect(t) * largest(s));
    }
  }
}

TEST(BlockElement, contains_all_divergence_free_linear_stresses) {
  const auto field = [](const Vector<2>& x) {
    return Voigt<2>(1 + 2 * x[0] - x[1], -3 + x[0] + 4 * x[1], 2 - 4 * x[0] - 2 * x[1]);
  };
  for (const Triangle& t : {triangles()[0], triangles()[1], triangles()[2]}) {
    const BlockElement<1> block = block_element<1>(t, compliance());
    LoadVector<1> loads;
    for (int e = 0; e < 3; ++e) {
      const Vector<2> n = outward(t, e), a = traction(field(t[(e + 1) % 3]), n), b = traction(field(t[(e + 2) % 3]), n);
      loads.segment<4>(4 * e) << (2 * a + b) / 6, (a + 2 * b) / 6;
    }
    const ModeVector<1> amplitudes = Eigen::MatrixXd(block.loads).colPivHouseholderQr().solve(Eigen::VectorXd(loads));
    EXPECT_LT((block.loads * amplitudes - loads).norm(), 1e2 * eps * loads.norm());
    const Corners s = block_stress<1>(block.piola, amplitudes);
    const Vector<2> centroid = (t[0] + t[1] + t[2]) / 3;
    for (int k = 0; k < 3; ++k) {
      const Triangle part = {t[(k + 1) % 3], t[(k + 2) % 3], centroid};
      for (int c = 0; c < 3; ++c)
        EXPECT_LT((s[3 * k + c] - field(part[c])).norm(), 1e3 * eps * std::pow(aspect(t), 2) * largest(s));
    }
  }
}

TEST(BlockElement, affine_maps_carry_modes_loads_and_compliance) {
  Eigen::Matrix2d b;
  b << 3, 40, -0.5, 0.02;
  b *= b.determinant() > 0 ? 1 : -1;
  if (b.determinant() < 0) b.col(0) *= -1;
  const Triangle t = triangles()[1];
  const Triangle mapped = {b * t[0], b * t[1], b * t[2]};
  const BlockElement<1> from = block_element<1>(t, compliance()), to = block_element<1>(mapped, compliance());
  for (int r = 0; r < n_loads(1); r += 2)
    EXPECT_LT((to.loads.middleRows<2>(r) - b * from.loads.middleRows<2>(r)).norm(), 1e2 * eps * to.loads.norm());
  const Corners s = block_stress<1>(from.piola, random_amplitudes(3)),
                image = block_stress<1>(to.piola, random_amplitudes(3));
  for (int c = 0; c < 9; ++c) {
    Eigen::Matrix2d full;
    full << s[c][0], s[c][2], s[c][2], s[c][1];
    const Eigen::Matrix2d carried = b * full * b.transpose() / b.determinant();
    EXPECT_LT((Voigt<2>(carried(0, 0), carried(1, 1), carried(0, 1)) - image[c]).norm(), 1e3 * eps * largest(image));
  }
}

TEST(BlockElement, compliance_is_the_energy_of_its_stresses) {
  for (const Triangle& t : triangles()) {
    const BlockElement<1> block = block_element<1>(t, compliance());
    const ModeVector<1> amplitudes = random_amplitudes(11);
    const Corners s = block_stress<1>(block.piola, amplitudes);
    const double area = std::abs(outward(t, 0).dot(t[1] - t[0])) / 2;
    double energy = 0;
    for (int k = 0; k < 3; ++k)  // midpoints of the edges: exact for quadratics
      for (int c = 0; c < 3; ++c) {
        const Voigt<2> middle = (s[3 * k + c] + s[3 * k + (c + 1) % 3]) / 2;
        energy += area / 9 * middle.dot(compliance() * middle);
      }
    EXPECT_NEAR(amplitudes.dot(block.compliance * amplitudes), energy, 1e-11 * energy);
  }
}

TEST(BlockElement, particular_field_carries_the_body_force) {
  const Vector<2> force(0.7, -2);
  for (const Triangle& t : triangles()) {
    const BlockElement<1> block = block_element<1>(t, compliance());
    const Particular<1> field = particular<1>(t, block.piola, compliance(), force);
    const double area = std::abs(outward(t, 0).dot(t[1] - t[0])) / 2;
    Vector<2> resultant = Vector<2>::Zero();
    for (int r = 0; r < n_loads(1); r += 2) resultant += field.loads.segment<2>(r);
    EXPECT_LT((resultant + area * force).norm(), 1e2 * eps * field.loads.norm() + 1e2 * eps * area * force.norm());
    // Its coupling is the mixed term of the energy of both fields together: a quadratic form is exact at midpoints.
    const ModeVector<1> amplitudes = random_amplitudes(5);
    const Corners s = block_stress<1>(block.piola, amplitudes);
    double mixed = 0, size = 0;
    for (int k = 0; k < 3; ++k)
      for (int c = 0; c < 3; ++c) {
        const Voigt<2> a = (s[3 * k + c] + s[3 * k + (c + 1) % 3]) / 2;
        const Voigt<2> l = (field.stress[3 * k + c] + field.stress[3 * k + (c + 1) % 3]) / 2;
        mixed += area / 9 * a.dot(compliance() * l);
        size += area / 9 * std::abs(a.dot(compliance() * l));
      }
    EXPECT_NEAR(amplitudes.dot(field.coupling), mixed, 1e-11 * size);
  }
}

}  // namespace
}  // namespace bracket::dual
