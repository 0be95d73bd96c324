// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "scene/scene.h"

namespace bracket::scene {

template <int dim> std::vector<RigidMotion<dim>> free_motions(const Problem<dim>& problem, int component) {
  constexpr int n = Simplex<dim>::n_rigid_motions;
  using Motions = Eigen::Matrix<double, n, 1>;  // amounts of all of them
  const Mesh<dim>& mesh = problem.mesh;
  Eigen::AlignedBox<double, dim> box;
  std::vector<std::pair<Vector<dim>, Vector<dim>>> held;  // direction and place of each prescribed displacement
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    const auto& facet = mesh.boundary[f];
    if (mesh.cell_component[facet.cell] != component) continue;
    for (const int v : facet.vertices) {
      const Vector<dim>& x = mesh.vertices[v];
      box.extend(x);
      if (problem.facets[f].support == Support::sliding) held.emplace_back(problem.facets[f].normal, x);
      if (problem.facets[f].support == Support::fixed)
        for (int c = 0; c < dim; ++c) held.emplace_back(Vector<dim>::Unit(c), x);
    }
  }
  const double radius = box.diagonal().norm() / 2;
  const auto motion = [&](const Motions& y) {
    RigidMotion<dim> result{y.template head<dim>(), {}, box.center()};
    for (int r = dim; r < n; ++r) result.rotation[r - dim] = y[r] / radius;
    return result;
  };
  std::vector<RigidMotion<dim>> all;
  for (int m = 0; m < n; ++m) all.push_back(motion(Motions::Unit(m)));
  if (held.empty()) return all;

  Eigen::MatrixXd supports = Eigen::MatrixXd::Zero(std::max<Eigen::Index>(n, held.size()), n);
  for (std::size_t i = 0; i < held.size(); ++i)
    for (int m = 0; m < n; ++m) supports(i, m) = held[i].first.dot(displacement(all[m], held[i].second));
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(supports);
  using Square = Eigen::Matrix<double, n, n>;
  const Square upper = qr.matrixQR().template topRows<n>().template triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<Square> svd(upper * qr.colsPermutation().transpose(), Eigen::ComputeFullV);
  std::vector<RigidMotion<dim>> free;
  constexpr double negligible = 1e-9;  // rounding: normals that are not equal differ by far more
  for (int m = 0; m < n; ++m) {
    if (svd.singularValues()[m] > negligible * svd.singularValues()[0]) continue;
    const Motions column = svd.matrixV().col(m);
    free.push_back(motion((column.array().abs() < negligible).select(0, column)));  // a pure translation stays pure
  }
  return free;
}

namespace {

template <int dim> std::string rounded(Vector<dim> x, double size) {
  x = (x.array().abs() < 1e-12 * size).select(0, x);
  if constexpr (dim == 2)
    return fmt::format("({:.3g}, {:.3g})", x[0], x[1]);
  else
    return fmt::format("({:.3g}, {:.3g}, {:.3g})", x[0], x[1], x[2]);
}

}  // namespace

template <> std::string describe(const RigidMotion<2>& motion) {
  const double angle = motion.rotation[0];
  if (angle == 0) return "moving it by " + rounded<2>(motion.translation, motion.translation.norm());
  // A translation with a rotation is a rotation about another point.
  const Vector<2> pole = motion.centre + Vector<2>(-motion.translation[1], motion.translation[0]) / angle;
  return fmt::format("turning it {} about {}", angle > 0 ? "counter-clockwise" : "clockwise",
                     rounded<2>(pole, motion.centre.norm() + 1 / std::abs(angle)));
}

template <> std::string describe(const RigidMotion<3>& motion) {
  const Vector<3> turn(motion.rotation.data()), &along = motion.translation;
  const double angle = turn.norm();
  if (angle == 0) return "moving it by " + rounded<3>(along, along.norm());
  // A translation across the axis moves the axis.
  const Vector<3> axis = turn / angle, pole = motion.centre + axis.cross(along) / angle;
  const double pitch = axis.dot(along) / angle;
  const double size = motion.centre.norm() + 1 / angle;
  const std::string turning =
      fmt::format("turning it about the axis through {} along {}", rounded<3>(pole, size), rounded<3>(axis, 1));
  if (std::abs(pitch) < 1e-9 * size) return turning;
  return fmt::format("{}, moving it along by {:.3g} a radian", turning, pitch);
}

template struct RigidMotion<2>;
template std::vector<RigidMotion<2>> free_motions(const Problem<2>&, int);
template struct RigidMotion<3>;
template std::vector<RigidMotion<3>> free_motions(const Problem<3>&, int);

}  // namespace bracket::scene
