// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "scene/options.h"
#include "scene/types.h"

namespace bracket::scene {

/// Young's modulus (force by area), Poisson's ratio, and whether a plane problem is one of plane strain or stress; in
/// space it is strain.
struct IsotropicConstants {
  double young, poisson;
  Plane plane;
};

/// An elastic material, made by isotropic() or anisotropic(). Stiffness, compliance and constants belong together:
/// they are read, and replaced by another material as a whole.
template <int dim> class Material {
 public:
  /// C, symmetric and positive definite: stress (force by area) by strain, in the notation of `Voigt`.
  const Elasticity<dim>& stiffness() const { return stiffness_; }
  /// C⁻¹: strain by stress. Of isotropic materials both are closed forms, neither is computed as the inverse of the
  /// other, so that both stay accurate as ν → ½.
  const Elasticity<dim>& compliance() const { return compliance_; }
  /// What the matrices are made of; none of an anisotropic material.
  const std::optional<IsotropicConstants>& constants() const { return constants_; }

 private:
  Material(const Elasticity<dim>& stiffness, const Elasticity<dim>& compliance,
           std::optional<IsotropicConstants> constants = {})
      : stiffness_(stiffness), compliance_(compliance), constants_(constants) {}
  template <int d> friend Material<d> isotropic(double young, double poisson, Plane plane);
  template <int d> friend Material<d> anisotropic(const Elasticity<d>& stiffness);

  Elasticity<dim> stiffness_, compliance_;
  std::optional<IsotropicConstants> constants_;
};

/// \throw Error (input) unless E > 0 and −1 < ν < ½ (plane stress: −1 < ν ≤ ½), and all entries of both matrices are
///        within the range of a double
template <int dim> Material<dim> isotropic(double young, double poisson, Plane plane);
template <int dim>
requires(dim == 3) Material<dim> isotropic(double young, double poisson) {
  return isotropic<dim>(young, poisson, Plane::strain);
}

/// \param stiffness its upper triangle counts where it is symmetric but for rounding
/// \throw Error (input) unless it is finite, symmetric within 64 ε of its largest entry, and positive definite: the
///        least eigenvalue of it scaled to a unit diagonal is more than 64 ε, beyond what rounding can do to it
template <int dim> Material<dim> anisotropic(const Elasticity<dim>& stiffness);

/// A body's material and weight; none but given.
template <int dim> struct Body {
  Body(const Material<dim>& made_of) : material(made_of) {}

  Material<dim> material;
  Vector<dim> force = Vector<dim>::Zero();  ///< body force per volume, constant
  std::string where;                        ///< "file:line:column", for messages
};

}  // namespace bracket::scene
