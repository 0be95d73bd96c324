// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "scene/fields.h"
#include "scene/problem/problem.h"

namespace bracket::bounds {

/// Bounds that hold in floating point, whatever the solvers did [HH81 §3]. Displacements are moved into K exactly, edge
/// loads into exact balance with the data, and both energies are enclosed with every rounding error accounted for.
struct Certificate {
  bool valid = false;
  std::string reason;        ///< if not: one line
  double lower = 0;          ///< ≤ L(u)
  double upper = 0;          ///< ≥ L(u)
  double strain_energy = 0;  ///< ≤ ½ A(u_h,u_h)
};
/// \param displacement, stress need not solve anything; the closer they do, the closer the bounds
template <int dim>
Certificate certify(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                    const scene::Stress<dim>& stress);

}  // namespace bracket::bounds
