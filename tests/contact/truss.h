// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <random>

#include "contact/contact.h"

/// Small plane bodies with known rigid motions: pin-jointed trusses with a bar between any two joints. Joints in
/// general position make such a truss rigid, so that its kernel is exactly the three rigid motions.
namespace bracket::contact::test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

inline constexpr double eps = std::numeric_limits<double>::epsilon();
/// A backward stable solve of n ≤ 60 unknowns leaves n eps; trusses in random position have factors up to 1e2 more.
inline constexpr double truss_rounding = 60 * eps * 1e2;

struct Truss {
  MatrixXd joints;     ///< n × 2
  MatrixXd stiffness;  ///< 2n × 2n, unknowns (x, y) joint by joint
};

inline void add_bar(MatrixXd& stiffness, Index i, Index j, const Eigen::Matrix2d& bar) {
  stiffness.block<2, 2>(2 * i, 2 * i) += bar;
  stiffness.block<2, 2>(2 * j, 2 * j) += bar;
  stiffness.block<2, 2>(2 * i, 2 * j) -= bar;
  stiffness.block<2, 2>(2 * j, 2 * i) -= bar;
}

inline Truss random_truss(int n_joints, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  Truss truss{MatrixXd(n_joints, 2), MatrixXd::Zero(2 * n_joints, 2 * n_joints)};
  for (Index i = 0; i < n_joints; ++i) truss.joints.row(i) << unit(random), unit(random);
  for (Index i = 0; i < n_joints; ++i)
    for (Index j = 0; j < i; ++j) {
      const Eigen::Vector2d along = (truss.joints.row(i) - truss.joints.row(j)).transpose().normalized();
      add_bar(truss.stiffness, i, j, (0.5 + unit(random)) * along * along.transpose());
    }
  return truss;
}

/// Columns: the translations and the rotation about the origin.
inline MatrixXd rigid_motions(const MatrixXd& joints) {
  MatrixXd rigid = MatrixXd::Zero(2 * joints.rows(), 3);
  for (Index i = 0; i < joints.rows(); ++i) {
    rigid(2 * i, 0) = rigid(2 * i + 1, 1) = 1;
    rigid(2 * i, 2) = -joints(i, 1);
    rigid(2 * i + 1, 2) = joints(i, 0);
  }
  return rigid;
}

inline Eigen::SparseMatrix<double> lower(const MatrixXd& matrix) {
  const MatrixXd triangle = matrix.triangularView<Eigen::Lower>();
  Eigen::SparseMatrix<double> result = triangle.sparseView();
  result.makeCompressed();
  return result;
}

inline MatrixXd symmetric(const Eigen::SparseMatrix<double>& lower_triangle) {
  return MatrixXd(lower_triangle).selfadjointView<Eigen::Lower>();
}

inline std::vector<int> pairs(Index n_unknowns) {
  std::vector<int> nodes;
  for (int i = 0; i <= n_unknowns; i += 2) nodes.push_back(i);
  return nodes;
}

/// A body with its load.
struct Loaded : System {
  VectorXd load;
};

inline std::vector<System> systems_of(const std::vector<Loaded>& bodies) { return {bodies.begin(), bodies.end()}; }

inline std::vector<VectorXd> loads_of(const std::vector<Loaded>& bodies) {
  std::vector<VectorXd> loads;
  for (const Loaded& body : bodies) loads.push_back(body.load);
  return loads;
}

inline Solution solve(const std::vector<Loaded>& bodies, const VectorXd& gap, const std::vector<char>& guess = {},
                      const Limits& limits = {}) {
  return Bodies(systems_of(bodies)).solve(loads_of(bodies), gap, guess, limits);
}

/// \param rows B, dense
inline Loaded floating(const Truss& truss, const VectorXd& load, const MatrixXd& rows) {
  return {{lower(truss.stiffness), pairs(load.size()), rows.sparseView(), rigid_motions(truss.joints)}, load};
}

/// The same on springs: no rigid motion is left.
inline Loaded supported(const Truss& truss, const VectorXd& load, const MatrixXd& rows) {
  const MatrixXd stiffness = truss.stiffness + MatrixXd::Identity(load.size(), load.size());
  return {{lower(stiffness), pairs(load.size()), rows.sparseView(), MatrixXd(load.size(), 0)}, load};
}

inline VectorXd random_vector(Index n, std::mt19937& random) {
  std::normal_distribution<double> normal;
  return VectorXd::NullaryExpr(n, [&] { return normal(random); });
}

/// A row that bounds the displacement of one joint along `normal`.
inline void bind(MatrixXd& rows, Index row, Index joint, const Eigen::Vector2d& normal) {
  rows.block<1, 2>(row, 2 * joint) += normal.transpose();
}

/// What the solution of a problem must satisfy, each by the size of the terms that it is a sum of.
struct Kkt {
  double equilibrium = 0;  ///< K u + Bᵀp − f, of the strain-producing part of u
  double rigid = 0;        ///< Rᵀ(f − Bᵀp)
  double penetration = 0;  ///< max(r − g), by the largest part of an r or g; with limits: g − r of the wrong sign
  double complementarity = 0;  ///< p (g − r)
  double least_pressure = 0;
  bool within = true;  ///< the limits
};

inline Kkt kkt(const std::vector<Loaded>& bodies, const VectorXd& gap, const Solution& solution,
               const Limits& limits = {}) {
  Kkt result;
  VectorXd approach = VectorXd::Zero(gap.size());
  VectorXd size = gap.cwiseAbs();
  const auto largest = [](const auto& values) { return values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0.0; };
  double forces = 0;
  for (const Loaded& body : bodies) forces = std::max(forces, largest(body.load));
  forces = std::max(forces, largest(solution.pressure));
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Loaded& body = bodies[b];
    const VectorXd acting = body.load - body.rows.transpose() * solution.pressure;
    const VectorXd residual = body.stiffness.selfadjointView<Eigen::Lower>() * solution.elastic[b] - acting;
    const VectorXd terms = symmetric(body.stiffness).cwiseAbs() * solution.elastic[b].cwiseAbs();
    if (forces > 0) {
      result.equilibrium = std::max(result.equilibrium, largest(residual) / std::max(forces, largest(terms)));
      const VectorXd moved = body.rigid.transpose() * acting;
      for (Index j = 0; j < moved.size(); ++j)
        result.rigid = std::max(result.rigid, std::abs(moved[j]) / (forces * largest(body.rigid.col(j))));
    }
    approach += body.rows * solution.displacement[b];
    size += MatrixXd(body.rows).cwiseAbs() * solution.displacement[b].cwiseAbs();
  }
  const double size_of_approach = largest(size), size_of_pressure = largest(solution.pressure);
  if (gap.size() == 0) return result;
  result.least_pressure = solution.pressure.minCoeff();
  if (limits.lower.size() > 0) {
    const auto p = solution.pressure.array();
    result.within = (p >= limits.lower.array() && p <= limits.upper.array()).all();
    double moved = size_of_approach;  // rows that stick do not move, but what they hold does
    for (const VectorXd& displacement : solution.displacement) moved = std::max(moved, largest(displacement));
    for (Index i = 0; i < gap.size() && moved > 0; ++i) {
      const double slack = (gap[i] - approach[i]) / moved;
      if (p[i] > limits.lower[i]) result.penetration = std::max(result.penetration, slack);
      if (p[i] < limits.upper[i]) result.penetration = std::max(result.penetration, -slack);
    }
    return result;
  }
  if (size_of_approach > 0) result.penetration = (approach - gap).maxCoeff() / size_of_approach;
  if (size_of_approach * size_of_pressure > 0)
    result.complementarity =
        largest(solution.pressure.cwiseProduct(gap - approach)) / (size_of_approach * size_of_pressure);
  return result;
}

}  // namespace bracket::contact::test
