// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "scene/scene.h"

namespace bracket::scene {

template <int dim> Vector<dim> displacement(const RigidMotion<dim>& motion, const Vector<dim>& x) {
  const Vector<dim> arm = x - motion.centre;
  return motion.translation + motion.rotation * Vector<dim>(-arm[1], arm[0]);
}

template <int dim> std::vector<RigidMotion<dim>> free_motions(const Problem<dim>& problem, int body) {
  const Mesh<dim>& mesh = problem.mesh;
  Vector<dim> low = Vector<dim>::Constant(std::numeric_limits<double>::infinity()), high = -low;
  std::vector<std::pair<Vector<dim>, Vector<dim>>> held;  // direction and place of each prescribed displacement
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    const auto& facet = mesh.boundary[f];
    if (mesh.cell_body[facet.cell] != body) continue;
    for (const int v : facet.vertices) {
      const Vector<dim>& x = mesh.vertices[v];
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
      if (problem.facets[f].support == Support::sliding) held.emplace_back(problem.facets[f].normal, x);
      if (problem.facets[f].support == Support::fixed)
        for (int c = 0; c < dim; ++c) held.emplace_back(Vector<dim>::Unit(c), x);
    }
  }
  const Vector<dim> centre = (low + high) / 2;
  const double radius = (high - low).norm() / 2;
  std::array<RigidMotion<dim>, 3> all = {RigidMotion<dim>{Vector<dim>::Unit(0), 0, centre},
                                         RigidMotion<dim>{Vector<dim>::Unit(1), 0, centre},
                                         RigidMotion<dim>{Vector<dim>::Zero(), 1 / radius, centre}};
  if (held.empty()) return {all.begin(), all.end()};

  Eigen::MatrixXd supports = Eigen::MatrixXd::Zero(std::max<Eigen::Index>(3, held.size()), 3);
  for (std::size_t i = 0; i < held.size(); ++i)
    for (int m = 0; m < 3; ++m) supports(i, m) = held[i].first.dot(displacement(all[m], held[i].second));
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(supports);
  const Eigen::Matrix3d upper = qr.matrixQR().topRows<3>().template triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(upper * qr.colsPermutation().transpose(), Eigen::ComputeFullV);
  std::vector<RigidMotion<dim>> free;
  constexpr double negligible = 1e-9;  // rounding: normals that are not equal differ by far more
  for (int m = 0; m < 3; ++m) {
    if (svd.singularValues()[m] > negligible * svd.singularValues()[0]) continue;
    const Eigen::Vector3d column = svd.matrixV().col(m);
    const Eigen::Vector3d y = (column.array().abs() < negligible).select(0, column);  // a pure translation stays pure
    free.push_back({Vector<dim>(y[0], y[1]), y[2] / radius, centre});
  }
  return free;
}

template <int dim> std::string describe(const RigidMotion<dim>& motion) {
  const auto rounded = [](const Vector<dim>& x, double size) {
    return fmt::format("({:.3g}, {:.3g})", std::abs(x[0]) < 1e-12 * size ? 0 : x[0],
                       std::abs(x[1]) < 1e-12 * size ? 0 : x[1]);
  };
  if (motion.rotation == 0) return "moving it by " + rounded(motion.translation, motion.translation.norm());
  // A translation with a rotation is a rotation about another point.
  const Vector<dim> pole = motion.centre + Vector<dim>(-motion.translation[1], motion.translation[0]) / motion.rotation;
  return fmt::format("turning it {} about {}", motion.rotation > 0 ? "counter-clockwise" : "clockwise",
                     rounded(pole, motion.centre.norm() + 1 / std::abs(motion.rotation)));
}

template struct RigidMotion<2>;
template Vector<2> displacement(const RigidMotion<2>&, const Vector<2>&);
template std::vector<RigidMotion<2>> free_motions(const Problem<2>&, int);
template std::string describe(const RigidMotion<2>&);

}  // namespace bracket::scene
