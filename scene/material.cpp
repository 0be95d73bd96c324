// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/material.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "scene/fault.h"

namespace bracket::scene {

namespace {

constexpr double tolerance = 64 * std::numeric_limits<double>::epsilon();

/// Scaled to a unit diagonal: the shear and the normal entries may differ by orders of magnitude.
Voigt<2> unit_scale(const Elasticity<2>& stiffness) { return stiffness.diagonal().cwiseSqrt().cwiseInverse(); }

Elasticity<2> symmetric(const Elasticity<2>& stiffness) {
  return Elasticity<2>(stiffness.selfadjointView<Eigen::Upper>());
}

Elasticity<2> inverse(const Elasticity<2>& stiffness) {
  const Voigt<2> scale = unit_scale(stiffness);
  const Elasticity<2> unit = scale.asDiagonal() * stiffness * scale.asDiagonal();
  const Elasticity<2> unit_inverse = unit.ldlt().solve(Elasticity<2>::Identity());
  const Elasticity<2> result = scale.asDiagonal() * unit_inverse * scale.asDiagonal();
  return 0.5 * (result + result.transpose());
}

struct Matrices {
  Elasticity<2> stiffness, compliance;
  bool finite() const { return stiffness.allFinite() && compliance.allFinite(); }
};

Matrices isotropic_matrices(double young, double poisson, Plane plane) {
  const bool plane_stress = plane == Plane::stress;
  Matrices result;
  const double shear = young / (2 * (1 + poisson));
  const double normal = plane_stress ? young / ((1 - poisson) * (1 + poisson))
                                     : young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson));
  const double cross = plane_stress ? young * poisson / ((1 - poisson) * (1 + poisson))
                                    : young * poisson / ((1 + poisson) * (1 - 2 * poisson));
  result.stiffness << normal, cross, 0, cross, normal, 0, 0, 0, shear;
  const double own = plane_stress ? 1 / young : (1 + poisson) * (1 - poisson) / young;
  const double other = plane_stress ? -poisson / young : -(1 + poisson) * poisson / young;
  result.compliance << own, other, 0, other, own, 0, 0, 0, 2 * (1 + poisson) / young;
  return result;
}

}  // namespace

std::optional<Fault> isotropic_fault(double young, double poisson, Plane plane) {
  if (!std::isfinite(young)) return Fault{{"E"}, fmt::format("E must be finite, is {}", young)};
  if (young <= 0) return Fault{{"E"}, fmt::format("E must be > 0, is {}", young)};
  const bool closed = plane == Plane::stress;
  if (!(poisson > -1 && (poisson < 0.5 || (closed && poisson == 0.5)))) {
    return Fault{{"nu"},
                 fmt::format("nu must lie in (-1, 0.5{} in plane {}, is {}", closed ? "]" : ")", name(plane), poisson)};
  }
  if (!isotropic_matrices(young, poisson, plane).finite())
    return Fault{{"E"}, fmt::format("E = {} is out of range", young)};
  return {};
}

std::optional<Fault> anisotropic_fault(const Elasticity<2>& stiffness) {
  if (!stiffness.allFinite()) return Fault{{}, "must be finite"};
  if ((stiffness - stiffness.transpose()).cwiseAbs().maxCoeff() > tolerance * stiffness.cwiseAbs().maxCoeff())
    return Fault{{}, "is not symmetric"};
  const Elasticity<2> upper = symmetric(stiffness);
  bool definite = (upper.diagonal().array() > 0).all();
  if (definite) {
    const Voigt<2> scale = unit_scale(upper);
    const Elasticity<2> unit = scale.asDiagonal() * upper * scale.asDiagonal();
    definite = Eigen::SelfAdjointEigenSolver<Elasticity<2>>(unit).eigenvalues()[0] > tolerance;
  }
  if (!definite) return Fault{{}, "is not positive definite"};
  if (!inverse(upper).allFinite()) return Fault{{}, "is out of range"};
  return {};
}

template <int dim> Material<dim> isotropic(double young, double poisson, Plane plane) {
  static_assert(dim == 2);
  throw_if(isotropic_fault(young, poisson, plane));
  const auto [stiffness, compliance] = isotropic_matrices(young, poisson, plane);
  return {stiffness, compliance, IsotropicConstants{young, poisson, plane}};
}

template <int dim> Material<dim> anisotropic(const Elasticity<dim>& stiffness) {
  if (auto fault = anisotropic_fault(stiffness)) {
    fault->message = "the stiffness " + fault->message;
    throw_if(fault);
  }
  const Elasticity<dim> upper = symmetric(stiffness);
  return {upper, inverse(upper)};
}

template Material<2> isotropic<2>(double, double, Plane);
template Material<2> anisotropic<2>(const Elasticity<2>&);

}  // namespace bracket::scene
