// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "scene/fields.h"
#include "scene/problem/problem.h"

namespace bracket::bounds {

/// What the energies of cells are enclosed in.
enum class Digits {
  extended,  ///< precision, for as narrow bounds as there are
  enough,    ///< doubles, several times as quick, where they widen the interval by less than a hundredth and tell each
             ///< energy from zero; else extended precision
};

/// Bounds that hold in floating point, whatever the solvers did [HH81 §3]. Displacements are moved into K exactly, edge
/// loads into exact balance with the data, and both energies are enclosed with every rounding error accounted for.
struct Certificate {
  bool valid = false;
  std::string reason;        ///< if not: one line
  double lower = 0;          ///< ≤ L(u)
  double upper = 0;          ///< ≥ L(u)
  double strain_energy = 0;  ///< ≤ ½ A(u_h,u_h)
  double contact = 0;        ///< ≥ κ = ∫ p (g − r(u_h)), a part of the width
};
/// \param displacement, stress need not solve anything; the closer they do, the closer the bounds
template <int dim>
Certificate certify(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                    const scene::Stress<dim>& stress, Digits digits = Digits::extended);
/// In space displacements have degree 1 or 2, stresses degree 1, and contacts no law but that sides keep together;
/// digits are extended.
template <>
Certificate certify(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
                    const scene::Stress<3>& stress, Digits);

/// A bound of the functional J of a perturbation (scene/problem/perturbation.h) at the solution of the problem that it
/// was added to, f times: by docs/theory.md §10, for every v in K and every λ in K⁺ of the perturbed problem,
///     f J ≤ f Q(v) + f R(λ) + ½ (L_f(v) + S_f(λ) + κ_f),     κ_f = ∫ p (g + f ψ − r(v)).
/// With f > 0 it bounds J from above, with f < 0 from below.
struct FunctionalBound {
  bool valid = false;
  std::string reason;  ///< if not: one line
  double above = 0;    ///< ≥ f J
};
/// Along motions that nothing holds the loads of the functional must be in balance; what they lack by rounding is taken
/// off them, and so from what J means.
/// \param problem perturbed, with one factor f for loads and kinematics
/// \param displacement, stress need not solve anything; they are moved into K and K⁺ as certify() does
template <int dim>
FunctionalBound certify_functional(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                                   const scene::Stress<dim>& stress);
template <>
FunctionalBound certify_functional(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
                                   const scene::Stress<3>& stress);

}  // namespace bracket::bounds
