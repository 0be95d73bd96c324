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

template <int dim> std::string describe(const RigidMotion<dim>& motion) {
  static_assert(dim == 2);
  const double angle = motion.rotation[0];
  const auto rounded = [](const Vector<dim>& x, double size) {
    return fmt::format("({:.3g}, {:.3g})", std::abs(x[0]) < 1e-12 * size ? 0 : x[0],
                       std::abs(x[1]) < 1e-12 * size ? 0 : x[1]);
  };
  if (angle == 0) return "moving it by " + rounded(motion.translation, motion.translation.norm());
  // A translation with a rotation is a rotation about another point.
  const Vector<dim> pole = motion.centre + Vector<dim>(-motion.translation[1], motion.translation[0]) / angle;
  return fmt::format("turning it {} about {}", angle > 0 ? "counter-clockwise" : "clockwise",
                     rounded(pole, motion.centre.norm() + 1 / std::abs(angle)));
}

template struct RigidMotion<2>;
template std::vector<RigidMotion<2>> free_motions(const Problem<2>&, int);
template std::string describe(const RigidMotion<2>&);

}  // namespace bracket::scene
