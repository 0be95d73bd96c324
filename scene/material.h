// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "scene/types.h"

namespace bracket::scene {

/// An elastic material and its weight. Isotropic materials keep stiffness and compliance in closed form, neither is
/// computed as the inverse of the other, so that both stay accurate as ν → ½.
struct Isotropic {
  double young, poisson;
  bool plane_stress;
};
template <int dim> struct Body {
  std::optional<Isotropic> isotropic;  ///< what the matrices are made of
  Elasticity<dim> stiffness = Elasticity<dim>::Zero();
  Elasticity<dim> compliance = Elasticity<dim>::Zero();
  Vector<dim> force = Vector<dim>::Zero();  ///< body force per volume, constant
  std::string where;
};

/// Isotropic stiffness and compliance, plane strain unless `plane_stress`.
/// \pre E > 0, −1 < ν < ½ (plane stress: −1 < ν ≤ ½)
template <int dim> Body<dim> isotropic(double young, double poisson, bool plane_stress);

/// Anisotropic: compliance is the inverse of `stiffness`.
/// \pre symmetric, positive definite
template <int dim> Body<dim> anisotropic(const Elasticity<dim>& stiffness);

}  // namespace bracket::scene
