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
template <int n> Eigen::Matrix<double, n, 1> unit_scale(const Eigen::Matrix<double, n, n>& stiffness) {
  return stiffness.diagonal().cwiseSqrt().cwiseInverse();
}

template <int n> Eigen::Matrix<double, n, n> symmetric(const Eigen::Matrix<double, n, n>& stiffness) {
  return Eigen::Matrix<double, n, n>(stiffness.template selfadjointView<Eigen::Upper>());
}

template <int n> Eigen::Matrix<double, n, n> inverse(const Eigen::Matrix<double, n, n>& stiffness) {
  using Square = Eigen::Matrix<double, n, n>;
  const Eigen::Matrix<double, n, 1> scale = unit_scale<n>(stiffness);
  const Square unit = scale.asDiagonal() * stiffness * scale.asDiagonal();
  const Square unit_inverse = unit.ldlt().solve(Square::Identity());
  const Square result = scale.asDiagonal() * unit_inverse * scale.asDiagonal();
  return 0.5 * (result + result.transpose());
}

template <int dim> struct Matrices {
  Elasticity<dim> stiffness, compliance;
  bool finite() const { return stiffness.allFinite() && compliance.allFinite(); }
};

template <int dim> Matrices<dim> isotropic_matrices(double young, double poisson, Plane plane);

template <> Matrices<2> isotropic_matrices<2>(double young, double poisson, Plane plane) {
  const bool plane_stress = plane == Plane::stress;
  Matrices<2> result;
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

template <> Matrices<3> isotropic_matrices<3>(double young, double poisson, Plane) {
  const double shear = young / (2 * (1 + poisson));
  const double cross = young * poisson / ((1 + poisson) * (1 - 2 * poisson));
  const double normal = young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson));
  Matrices<3> result{Elasticity<3>::Zero(), Elasticity<3>::Zero()};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      result.stiffness(i, j) = i == j ? normal : cross;
      result.compliance(i, j) = i == j ? 1 / young : -poisson / young;
    }
    result.stiffness(3 + i, 3 + i) = shear;
    result.compliance(3 + i, 3 + i) = 2 * (1 + poisson) / young;
  }
  return result;
}

}  // namespace

template <int dim> std::optional<Fault> isotropic_fault(double young, double poisson, Plane plane) {
  if (!std::isfinite(young)) return Fault{{"E"}, fmt::format("E must be finite, is {}", young)};
  if (young <= 0) return Fault{{"E"}, fmt::format("E must be > 0, is {}", young)};
  const bool closed = plane == Plane::stress;
  if (!(poisson > -1 && (poisson < 0.5 || (closed && poisson == 0.5)))) {
    return Fault{
        {"nu"},
        dim == 2 ? fmt::format("nu must lie in (-1, 0.5{} in plane {}, is {}", closed ? "]" : ")", name(plane), poisson)
                 : fmt::format("nu must lie in (-1, 0.5), is {}", poisson)};
  }
  if (!isotropic_matrices<dim>(young, poisson, plane).finite())
    return Fault{{"E"}, fmt::format("E = {} is out of range", young)};
  return {};
}

template <int dim> std::optional<Fault> anisotropic_fault(const Elasticity<dim>& stiffness) {
  constexpr int n = n_voigt<dim>;
  if (!stiffness.allFinite()) return Fault{{}, "must be finite"};
  if ((stiffness - stiffness.transpose()).cwiseAbs().maxCoeff() > tolerance * stiffness.cwiseAbs().maxCoeff())
    return Fault{{}, "is not symmetric"};
  const Elasticity<dim> upper = symmetric<n>(stiffness);
  bool definite = (upper.diagonal().array() > 0).all();
  if (definite) {
    const Voigt<dim> scale = unit_scale<n>(upper);
    const Elasticity<dim> unit = scale.asDiagonal() * upper * scale.asDiagonal();
    definite = Eigen::SelfAdjointEigenSolver<Elasticity<dim>>(unit).eigenvalues()[0] > tolerance;
  }
  if (!definite) return Fault{{}, "is not positive definite"};
  if (!inverse<n>(upper).allFinite()) return Fault{{}, "is out of range"};
  return {};
}

template <int dim> Material<dim> isotropic(double young, double poisson, Plane plane) {
  throw_if(isotropic_fault<dim>(young, poisson, plane));
  const auto [stiffness, compliance] = isotropic_matrices<dim>(young, poisson, plane);
  return {stiffness, compliance, IsotropicConstants{young, poisson, plane}};
}

template <int dim> Material<dim> anisotropic(const Elasticity<dim>& stiffness) {
  if (auto fault = anisotropic_fault<dim>(stiffness)) {
    fault->message = "the stiffness " + fault->message;
    throw_if(fault);
  }
  const Elasticity<dim> upper = symmetric<n_voigt<dim>>(stiffness);
  return {upper, inverse<n_voigt<dim>>(upper)};
}

template std::optional<Fault> isotropic_fault<2>(double, double, Plane);
template std::optional<Fault> isotropic_fault<3>(double, double, Plane);
template std::optional<Fault> anisotropic_fault<2>(const Elasticity<2>&);
template std::optional<Fault> anisotropic_fault<3>(const Elasticity<3>&);
template Material<2> isotropic<2>(double, double, Plane);
template Material<3> isotropic<3>(double, double, Plane);
template Material<2> anisotropic<2>(const Elasticity<2>&);
template Material<3> anisotropic<3>(const Elasticity<3>&);

}  // namespace bracket::scene
