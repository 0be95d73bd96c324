// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/material.h"

namespace bracket::scene {

template <> Material<3> isotropic<3>(double young, double poisson, Plane plane) {
  Elasticity<3> c = Elasticity<3>::Zero();
  const double lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson)), mu = young / (2 * (1 + poisson));
  c.topLeftCorner<3, 3>().setConstant(lambda);
  for (int k = 0; k < 6; ++k) c(k, k) += k < 3 ? 2 * mu : mu;
  return {c, c.inverse(), IsotropicConstants{young, poisson, plane}};
}
template <> Material<3> anisotropic<3>(const Elasticity<3>& stiffness) { return {stiffness, stiffness.inverse()}; }

}  // namespace bracket::scene
