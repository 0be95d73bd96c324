// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/stresses.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace bracket::apps {

std::optional<double> stress_across(const scene::Material<2>& material, scene::Plane plane,
                                    const scene::Voigt<2>& stress) {
  if (plane == scene::Plane::stress) return 0;
  if (!material.constants()) return {};
  return material.constants()->poisson * (stress[0] + stress[1]);
}

bool knows_stress_across(const scene::Problem<2>& problem, scene::Plane plane) {
  return std::ranges::all_of(problem.bodies, [plane](const scene::Body<2>& body) {
    return stress_across(body.material, plane, scene::Voigt<2>::Zero()).has_value();
  });
}

double von_mises(const scene::Voigt<2>& stress, double across) {
  const double a = stress[0] - stress[1], b = stress[1] - across, c = across - stress[0];
  return std::sqrt((a * a + b * b + c * c) / 2 + 3 * stress[2] * stress[2]);
}

double von_mises(const scene::Voigt<3>& stress) {
  const double a = stress[0] - stress[1], b = stress[1] - stress[2], c = stress[2] - stress[0];
  return std::sqrt((a * a + b * b + c * c) / 2 + 3 * stress.tail<3>().squaredNorm());
}

double largest_shear(const scene::Voigt<2>& stress) { return std::hypot((stress[0] - stress[1]) / 2, stress[2]); }

std::array<double, 2> principal_stresses(const scene::Voigt<2>& stress) {
  const double mean = (stress[0] + stress[1]) / 2, shear = largest_shear(stress);
  return {mean + shear, mean - shear};
}

std::array<double, 3> principal_stresses(const scene::Voigt<3>& stress) {
  Eigen::Matrix3d matrix;
  for (int k = 0; k < 6; ++k) {
    const auto& [i, j] = scene::Simplex<3>::voigt[k];
    matrix(i, j) = matrix(j, i) = stress[k];
  }
  const Eigen::Vector3d values =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
  return {values[2], values[1], values[0]};
}

}  // namespace bracket::apps
