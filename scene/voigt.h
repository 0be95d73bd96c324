// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/mesh/simplex.h"

/// Stresses and strains as tensors.
namespace bracket::scene {

/// σ n
template <int dim> Vector<dim> traction(const Voigt<dim>& stress, const Vector<dim>& n) {
  Vector<dim> result = Vector<dim>::Zero();
  for (int k = 0; k < n_voigt<dim>; ++k) {
    const auto [i, j] = Simplex<dim>::voigt[k];
    result[i] += stress[k] * n[j];
    if (i != j) result[j] += stress[k] * n[i];
  }
  return result;
}

/// ε of a displacement gradient, ∂u_i/∂x_j in row i and column j: shear twice, as in `Voigt`.
template <int dim> Voigt<dim> strain(const Eigen::Matrix<double, dim, dim>& gradient) {
  Voigt<dim> result;
  for (int k = 0; k < n_voigt<dim>; ++k) {
    const auto [i, j] = Simplex<dim>::voigt[k];
    result[k] = i == j ? gradient(i, i) : gradient(i, j) + gradient(j, i);
  }
  return result;
}

}  // namespace bracket::scene
