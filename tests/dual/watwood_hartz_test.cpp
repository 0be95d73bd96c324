// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "dual/block_element.h"

/// The block element in the parameters of Watwood and Hartz, by the closed forms of HH81 §3, beside ours.
namespace bracket::dual {
namespace {

using Seven = Eigen::Matrix<double, 7, 1>;

constexpr double eps = std::numeric_limits<double>::epsilon();

struct Material {
  double young, poisson;
  bool plane_stress;
  double reference;  ///< E0
};

/// A subtriangle a1 a2 a3, counter-clockwise, its origin at its centre of gravity.
struct Subtriangle {
  Triangle a;
  double area;
};
Subtriangle subtriangle(const Triangle& a) {
  const scene::Vector<2> centre = (a[0] + a[1] + a[2]) / 3, u = a[1] - a[0], v = a[2] - a[0];
  return {{a[0] - centre, a[1] - centre, a[2] - centre}, (u[0] * v[1] - u[1] * v[0]) / 2};
}

/// M of (3.1).
Eigen::Matrix<double, 3, 7> stress_matrix(const Subtriangle& k, const Material& material, const scene::Vector<2>& x) {
  const double r = std::sqrt(k.area);
  Eigen::Matrix<double, 3, 7> m;
  m << r, 0, 0, 0, x[0], 0, x[1],  //
      0, r, 0, x[0], 0, x[1], 0,   //
      0, 0, r, 0, -x[1], -x[0], 0;
  return std::sqrt(material.young / (k.area * material.reference)) * m;
}

/// F of (3.2), ∫ λ : C⁻¹ λ = SᵀFS, for thickness 1.
Eigen::Matrix<double, 7, 7> compliance_matrix(const Subtriangle& k, const Material& material) {
  const double nu = material.poisson, area = k.area;
  const double alpha = material.plane_stress ? 1 : 1 - nu * nu;
  const double beta = material.plane_stress ? -nu : -nu * (1 + nu);
  const double gamma = 2 * (1 + nu);
  double s1 = 0, s2 = 0, s12 = 0;  // means of x1², x2², x1 x2: a twelfth of the sums over the corners
  for (const scene::Vector<2>& a : k.a) {
    s1 += a[0] * a[0] / 12;
    s2 += a[1] * a[1] / 12;
    s12 += a[0] * a[1] / 12;
  }
  Eigen::Matrix<double, 7, 7> lower;
  lower << alpha * area, 0, 0, 0, 0, 0, 0,                                     //
      beta * area, alpha * area, 0, 0, 0, 0, 0,                                //
      0, 0, gamma * area, 0, 0, 0, 0,                                          //
      0, 0, 0, alpha * s1, 0, 0, 0,                                            //
      0, 0, 0, beta * s1, alpha * s1 + gamma * s2, 0, 0,                       //
      0, 0, 0, alpha * s12, (beta + gamma) * s12, alpha * s2 + gamma * s1, 0,  //
      0, 0, 0, beta * s12, alpha * s12, beta * s2, alpha * s2;
  return Eigen::Matrix<double, 7, 7>(lower.selfadjointView<Eigen::Lower>()) / material.reference;
}

/// C of (3.4) for the side from corner i to i + 1 (from 0): T1 = S1* + S2* p, T2 = S3* + S4* p, p from −1 to 1. In the
/// scanned text the fifth entry of the second row has the opposite sign; T1 = x1 n1 − x2 n2 there has this one.
Eigen::Matrix<double, 4, 7> side_matrix(const Subtriangle& k, const Material& material, int i) {
  const scene::Vector<2> from = k.a[i], to = k.a[(i + 1) % 3];
  const double x2 = from[0], y2 = from[1], x3 = to[0], y3 = to[1], dx = x2 - x3, dy = y2 - y3;
  const double r = 2 * std::sqrt(k.area);
  Eigen::Matrix<double, 4, 7> c;
  c << -r * dy, 0, r * dx, 0, -2 * (x2 * y2 - x3 * y3), -(x2 * x2 - x3 * x3), -(y2 * y2 - y3 * y3),  //
      0, 0, 0, 0, 2 * dx * dy, dx * dx, dy * dy,                                                     //
      0, r * dx, -r * dy, x2 * x2 - x3 * x3, y2 * y2 - y3 * y3, 2 * (x2 * y2 - x3 * y3), 0,          //
      0, 0, 0, -dx * dx, -dy * dy, -2 * dx * dy, 0;
  return std::sqrt(material.young / material.reference) / (r * (to - from).norm()) * c;
}

/// The parts of a block; a1 is the block's centroid, the side a2 a3 that of the block.
std::array<Subtriangle, 3> parts(const Triangle& t) {
  const scene::Vector<2> centroid = (t[0] + t[1] + t[2]) / 3;
  std::array<Subtriangle, 3> result;
  for (int k = 0; k < 3; ++k) result[k] = subtriangle({centroid, t[(k + 1) % 3], t[(k + 2) % 3]});
  return result;
}

struct Case {
  Triangle t;
  Material material;
};
std::vector<Case> cases() {
  return {{{scene::Vector<2>(0, 0), scene::Vector<2>(1, 0), scene::Vector<2>(0, 1)}, {1, 0.3, true, 1}},
          {{scene::Vector<2>(2, 1), scene::Vector<2>(5, 1.5), scene::Vector<2>(3, 4)}, {2.1e5, 0.3, false, 1e5}},
          {{scene::Vector<2>(0, 0), scene::Vector<2>(1, 0), scene::Vector<2>(0.5, 0.02)}, {3, 0.499, false, 2}},
          {{scene::Vector<2>(0, 0), scene::Vector<2>(1e-6, 0), scene::Vector<2>(3e-7, 2e-6)}, {1e-3, -0.5, true, 7}}};
}

/// A mode of ours in the parameters of the three parts, and the largest misfit of its nine corners, by its largest.
struct Parameters {
  std::array<Seven, 3> part;
  double misfit = 0;
};
Parameters parameters_of(const Case& c, const Corners& mode) {
  Parameters result;
  double largest = 0;
  for (int k = 0; k < 3; ++k) {
    const Subtriangle sub = parts(c.t)[k];
    Eigen::Matrix<double, 9, 7> values;
    Eigen::Matrix<double, 9, 1> ours;
    for (int corner = 0; corner < 3; ++corner) {  // ours are numbered a2, a3, a1
      values.middleRows<3>(3 * corner) = stress_matrix(sub, c.material, sub.a[(corner + 1) % 3]);
      ours.segment<3>(3 * corner) = mode[3 * k + corner];
    }
    const Seven scale = values.colwise().norm();  // a thin triangle's parameters differ in size
    const Eigen::MatrixXd scaled = values * scale.cwiseInverse().asDiagonal();
    const Seven fit = scaled.colPivHouseholderQr().solve(Eigen::VectorXd(ours));
    result.part[k] = fit.cwiseQuotient(scale);
    result.misfit = std::max(result.misfit, (values * result.part[k] - ours).cwiseAbs().maxCoeff());
    largest = std::max(largest, ours.cwiseAbs().maxCoeff());
  }
  result.misfit /= largest;
  return result;
}

std::array<Parameters, n_modes(1)> all_modes(const Case& c, const BlockElement<1>& block) {
  std::array<Parameters, n_modes(1)> result;
  for (int m = 0; m < n_modes(1); ++m)
    result[m] = parameters_of(c, block_stress<1>(block.piola, ModeVector<1>::Unit(m)));
  return result;
}

BlockElement<1> our_block(const Case& c) {
  const auto& [young, poisson, plane_stress, reference] = c.material;
  return block_element<1>(
      c.t,
      scene::isotropic<2>(young, poisson, plane_stress ? scene::Plane::stress : scene::Plane::strain).compliance());
}

/// Rounding of the parameters of thin triangles: longest side squared by twice the area.
double aspect(const Triangle& t) {
  double longest = 0;
  for (int e = 0; e < 3; ++e) longest = std::max(longest, (t[(e + 1) % 3] - t[e]).squaredNorm());
  return longest / (2 * subtriangle(t).area);
}

TEST(WatwoodHartz, modes_are_of_the_papers_form) {  // (3.1)
  for (const Case& c : cases())
    for (const Parameters& mode : all_modes(c, our_block(c))) EXPECT_LT(mode.misfit, 1e2 * eps * aspect(c.t));
}

TEST(WatwoodHartz, compliance_agrees_entry_by_entry) {  // (3.2), (3.12)
  for (const Case& c : cases()) {
    const BlockElement<1> block = our_block(c);
    const auto modes = all_modes(c, block);
    const auto sub = parts(c.t);
    for (int m = 0; m < n_modes(1); ++m)
      for (int n = 0; n < n_modes(1); ++n) {
        double sum = 0;
        for (int k = 0; k < 3; ++k)
          sum += modes[m].part[k].dot(compliance_matrix(sub[k], c.material) * modes[n].part[k]);
        const double size = std::sqrt(block.compliance(m, m) * block.compliance(n, n));
        EXPECT_NEAR(block.compliance(m, n), sum, 1e3 * eps * aspect(c.t) * aspect(c.t) * size) << m << ", " << n;
      }
  }
}

TEST(WatwoodHartz, side_loads_agree_entry_by_entry) {  // (3.4)
  for (const Case& c : cases()) {
    const BlockElement<1> block = our_block(c);
    const auto modes = all_modes(c, block);
    const auto sub = parts(c.t);
    for (int m = 0; m < n_modes(1); ++m)
      for (int e = 0; e < 3; ++e) {
        const double length = (c.t[(e + 2) % 3] - c.t[(e + 1) % 3]).norm();
        const Eigen::Vector4d s = length * side_matrix(sub[e], c.material, 1) * modes[m].part[e];
        LoadVector<1> loads = LoadVector<1>::Zero();  // ∫ φ (a + b p) = length (a ∓ b/3) / 2
        loads.segment<4>(4 * e) << s[0] / 2 - s[1] / 6, s[2] / 2 - s[3] / 6, s[0] / 2 + s[1] / 6, s[2] / 2 + s[3] / 6;
        const double size = block.loads.col(m).norm();
        for (int row = 4 * e; row < 4 * e + 4; ++row)
          EXPECT_NEAR(block.loads(row, m), loads[row], 1e3 * eps * aspect(c.t) * aspect(c.t) * size)
              << row << ", " << m;
      }
  }
}

TEST(WatwoodHartz, our_nine_modes_are_all_that_internal_continuity_leaves) {  // (3.5), (3.9), (3.12)
  for (const Case& c : cases()) {
    const auto sub = parts(c.t);
    Eigen::Matrix<double, 12, 21> internal = Eigen::Matrix<double, 12, 21>::Zero();
    const Eigen::Vector4d flip(1, -1, 1, -1);
    for (int k = 0; k < 3; ++k) {  // the side a3 a1 of part k is a1 a2 of part k + 1, run the other way: p = −p'
      const int next = (k + 1) % 3;
      internal.block<4, 7>(4 * k, 7 * k) = side_matrix(sub[k], c.material, 2);
      internal.block<4, 7>(4 * k, 7 * next) = flip.asDiagonal() * side_matrix(sub[next], c.material, 0);
    }
    const auto modes = all_modes(c, our_block(c));
    Eigen::Matrix<double, 21, n_modes(1)> ours;
    for (int m = 0; m < n_modes(1); ++m) ours.col(m) << modes[m].part[0], modes[m].part[1], modes[m].part[2];
    const double size = internal.norm() * ours.norm();
    EXPECT_LT((internal * ours).norm(), 1e2 * eps * aspect(c.t) * size);
    for (const Eigen::MatrixXd& products : {Eigen::MatrixXd(internal * internal.transpose()),  // 21 − 12 = 9
                                            Eigen::MatrixXd(ours.transpose() * ours)}) {
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(products, Eigen::EigenvaluesOnly);
      EXPECT_GT(eigen.eigenvalues().minCoeff(), 1e-12 * eigen.eigenvalues().maxCoeff());
    }
  }
}

}  // namespace
}  // namespace bracket::dual
