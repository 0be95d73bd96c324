// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scene/enclosure.h"
#include "scene/fields.h"
#include "scene/problem/problem.h"

/// What holds of a displacement u_x from anywhere, in floating point (docs/other-programs.md). It lives on the first
/// mesh of a problem; supports and contact it may violate.
namespace bracket::bounds {

/// Of u_s, which is u_x moved onto the supports, and sides that keep together onto each other, exactly.
template <int dim> struct GivenEnergyOf {
  bool valid = false;
  std::string reason;  ///< if not: one line
  /// L(u_s) is between; what springs and friction add to it is known from above only: then `lower` is −∞.
  double lower = 0, upper = 0;
  double moved = 0;   ///< ≥ ‖u_s − u_x‖_A
  double misfit = 0;  ///< the largest distance by which a node was moved, rounded
  /// Quadratics around g − r(u_s), below and above, on each contact facet of the first mesh: Bernstein coefficients as
  /// ContactFacetOf has the gap's. Negative: it penetrates. Zero where sides keep together or springs give way.
  std::vector<scene::FacetQuadratic<dim>> below = {}, above = {};
};
using GivenEnergy = GivenEnergyOf<2>;
/// \param first on its first mesh, with its loads in balance
/// \param given u_x, of degree 1 or 2; need not solve anything
template <int dim>
GivenEnergyOf<dim> certify_given(const scene::Problem<dim>& first, const scene::Displacement<dim>& given);
template <> GivenEnergyOf<2> certify_given(const scene::Problem<2>& first, const scene::Displacement<2>& given);
template <> GivenEnergyOf<3> certify_given(const scene::Problem<3>& first, const scene::Displacement<3>& given);

/// By the equality in docs/other-programs.md, with m = ½ (σ(u_h) + λ_h) and T = ½ (w + κ) = ¼ ‖σ(u_h) − λ_h‖² + κ of
/// fields that are admissible:
///     | ‖σ(u_x) − m‖ − ‖u_x − u‖_A | ≤ √T
struct GivenDistance {
  bool valid = false;
  std::string reason;                     ///< if not: one line
  double lower = 0, upper = 0;            ///< ‖σ(u_x) − m‖ is between
  double stress_error = 0;                ///< ≥ √T
  double norm_lower = 0, norm_upper = 0;  ///< ‖u_h‖_A is between
  std::vector<double> cell = {};          ///< ‖σ(u_x) − m‖² on each cell of the first mesh, not below
};
/// \param problem on any mesh   \param displacement, stress u_h and λ_h, moved as by certify()
/// \param given u_x, on the first mesh
template <int dim>
GivenDistance certify_distance(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                               const scene::Stress<dim>& stress, const scene::Displacement<dim>& given);
template <>
GivenDistance certify_distance(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                               const scene::Stress<2>& stress, const scene::Displacement<2>& given);
template <>
GivenDistance certify_distance(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
                               const scene::Stress<3>& stress, const scene::Displacement<3>& given);

/// √x, below and above, also where x may be zero; not a number where it is below.
double root_below(const scene::Enclosure& x);
double root_above(const scene::Enclosure& x);

}  // namespace bracket::bounds
