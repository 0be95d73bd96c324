// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene.h"

namespace bracket::scene {

template <int dim> Body<dim> isotropic(double young, double poisson, bool plane_stress) {
  static_assert(dim == 2);
  Body<dim> body;
  body.isotropic = {young, poisson, plane_stress};
  const double shear = young / (2 * (1 + poisson));
  const double normal = plane_stress ? young / ((1 - poisson) * (1 + poisson))
                                     : young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson));
  const double cross = plane_stress ? young * poisson / ((1 - poisson) * (1 + poisson))
                                    : young * poisson / ((1 + poisson) * (1 - 2 * poisson));
  body.stiffness << normal, cross, 0, cross, normal, 0, 0, 0, shear;
  const double own = plane_stress ? 1 / young : (1 + poisson) * (1 - poisson) / young;
  const double other = plane_stress ? -poisson / young : -(1 + poisson) * poisson / young;
  body.compliance << own, other, 0, other, own, 0, 0, 0, 2 * (1 + poisson) / young;
  return body;
}

template <int dim> Body<dim> anisotropic(const Elasticity<dim>& stiffness) {
  // Scaled to a unit diagonal: the shear and the normal entries may differ by orders of magnitude.
  const Voigt<dim> scale = stiffness.diagonal().cwiseSqrt().cwiseInverse();
  const Elasticity<dim> unit = scale.asDiagonal() * stiffness * scale.asDiagonal();
  const Elasticity<dim> unit_inverse = unit.ldlt().solve(Elasticity<dim>::Identity());
  const Elasticity<dim> inverse = scale.asDiagonal() * unit_inverse * scale.asDiagonal();
  Body<dim> body;
  body.stiffness = stiffness;
  body.compliance = 0.5 * (inverse + inverse.transpose());
  return body;
}

template Body<2> isotropic<2>(double, double, bool);
template Body<2> anisotropic<2>(const Elasticity<2>&);

}  // namespace bracket::scene
