// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/block_theory.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>

#include "scene/voigt.h"

namespace bracket::dual {
namespace {

using scene::Vector;
using Gauss = boost::math::quadrature::gauss<double, 10>;

/// The vertices where edge e begins and ends.
Vector<2> from(const Triangle& t, int e) { return t[scene::Simplex<2>::edges[e][0]]; }
Vector<2> to(const Triangle& t, int e) { return t[scene::Simplex<2>::edges[e][1]]; }

/// The block and the amplitudes of its stress with these ∫ φ_i T over the sides, which are B times the reference's.
Corners stress_by_moments(const Triangle& t, const LoadVector<1>& moments) {
  static const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> loads(reference_block<1>().loads);
  Eigen::Matrix2d b;
  b << t[1] - t[0], t[2] - t[0];
  Eigen::VectorXd pulled_back(n_loads(1));
  for (int i = 0; i < n_loads(1); i += 2) pulled_back.segment<2>(i) = b.inverse() * moments.segment<2>(i);
  const ModeVector<1> amplitudes = loads.solve(pulled_back);
  return block_stress<1>(block_element<1>(t, scene::Elasticity<2>::Identity()).piola, amplitudes);
}

/// Resultants and moment of side tractions: 3 × 12.
Eigen::Matrix<double, 3, n_loads(1)> resultants(const Triangle& t) {
  Eigen::Matrix<double, 3, n_loads(1)> rows;
  const Vector<2> centroid = (t[0] + t[1] + t[2]) / 3;
  for (int e = 0; e < 3; ++e) {
    const Vector<2> a = from(t, e) - centroid, b = to(t, e) - centroid;
    const double length = (b - a).norm();
    for (int end = 0; end < 2; ++end) {
      const Vector<2> arm = scene::hat_moment(std::array{a, b}, end);  // ∫ φ x by the length
      rows.block<3, 2>(0, 4 * e + 2 * end) << length / 2, 0, 0, length / 2, -length * arm[1], length * arm[0];
    }
  }
  return rows;
}

/// min over λ of |c − Eᵀλ|₁, which is the largest cᵀT where ET = 0 and |T| ≤ 1 in all components (duality). It is
/// attained where three of the twelve residuals vanish.
class LargestValue {
 public:
  explicit LargestValue(const Eigen::Matrix<double, 3, n_loads(1)>& equations) : equations_(equations) {
    constexpr double degenerate = 1e-12;  // of a determinant by its rows
    for (int i = 0; i < n_loads(1); ++i)
      for (int j = 0; j < i; ++j)
        for (int k = 0; k < j; ++k) {
          Eigen::Matrix3d m;
          m << equations.col(i), equations.col(j), equations.col(k);
          const double size = m.col(0).norm() * m.col(1).norm() * m.col(2).norm();
          if (std::abs(m.determinant()) > degenerate * size) vertices_.push_back({{i, j, k}, m.transpose().inverse()});
        }
  }

  double operator()(const SideTractions& c) const {
    double least = c.lpNorm<1>();  // λ = 0
    for (const auto& [at, inverse] : vertices_) {
      const Eigen::Vector3d lambda = inverse * Eigen::Vector3d(c[at[0]], c[at[1]], c[at[2]]);
      least = std::min(least, (c - equations_.transpose() * lambda).lpNorm<1>());
    }
    return least;
  }

 private:
  struct Vertex {
    std::array<int, 3> at;
    Eigen::Matrix3d inverse;
  };
  Eigen::Matrix<double, 3, n_loads(1)> equations_;
  std::vector<Vertex> vertices_;
};

}  // namespace

Corners stress_by_tractions(const Triangle& t, const SideTractions& tractions) {
  LoadVector<1> moments;
  for (int e = 0; e < 3; ++e) {
    const double length = (to(t, e) - from(t, e)).norm();
    const std::array<Vector<2>, 2> at = {tractions.segment<2>(4 * e), tractions.segment<2>(4 * e + 2)};
    for (int i = 0; i < 2; ++i) moments.segment<2>(4 * e + 2 * i) = length * scene::hat_moment(at, i);
  }
  return stress_by_moments(t, moments);
}

double stress_by_load_constant(const Triangle& t) {
  Eigen::Matrix<double, 27, n_loads(1)> stresses;
  for (int i = 0; i < n_loads(1); ++i) {
    const Corners corners = stress_by_tractions(t, SideTractions::Unit(i));
    for (int c = 0; c < 9; ++c) stresses.block<3, 1>(3 * c, i) = corners[c];
  }
  const LargestValue largest(resultants(t));
  double constant = 0;
  for (int i = 0; i < stresses.rows(); ++i) constant = std::max(constant, largest(stresses.row(i).transpose()));
  return constant;
}

Corners interpolate(const Triangle& t, const StressField& stress) {
  LoadVector<1> moments;
  for (int e = 0; e < 3; ++e) {
    const Vector<2> a = from(t, e), b = to(t, e), normal = scene::area_vector<2>({a, b});
    for (int end = 0; end < 2; ++end)
      for (int c = 0; c < 2; ++c)
        moments[4 * e + 2 * end + c] = integrate(
            [&](double s) { return scene::traction<2>(stress(a + s * (b - a)), normal)[c] * (end == 0 ? 1 - s : s); });
  }
  return stress_by_moments(t, moments);
}

double integrate(const std::function<double(double)>& f) { return Gauss::integrate(f, 0.0, 1.0); }

double integrate(const Triangle& t, const std::function<double(const Vector<2>&)>& f) {
  const Vector<2> u = t[1] - t[0], v = t[2] - t[1];
  const auto across = [&](double r) { return r * integrate([&](double s) { return f(t[0] + r * (u + s * v)); }); };
  return (u[0] * v[1] - u[1] * v[0]) * integrate(across);
}

double squared_distance(const Triangle& t, const StressField& stress, std::span<const scene::Voigt<2>> corners,
                        const scene::Elasticity<2>& form) {
  const Vector<2> centroid = (t[0] + t[1] + t[2]) / 3;
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const Triangle part = {from(t, k), to(t, k), centroid};
    Eigen::Matrix2d sides;
    sides << part[1] - part[0], part[2] - part[0];
    const Eigen::Matrix2d coordinates = sides.inverse();
    sum += integrate(part, [&](const Vector<2>& x) {
      const Vector<2> s = coordinates * (x - part[0]);
      const scene::Voigt<2> difference =
          stress(x) - (1 - s[0] - s[1]) * corners[3 * k] - s[0] * corners[3 * k + 1] - s[1] * corners[3 * k + 2];
      return difference.dot(form * difference);
    });
  }
  return sum;
}

}  // namespace bracket::dual
