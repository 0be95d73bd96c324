// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>

#include "dual/block_element.h"

/// The block element as [HH81, §2.1] studies it: a stress by its side loads.
namespace bracket::dual {

using StressField = std::function<scene::Voigt<2>(const scene::Vector<2>&)>;

/// Linear tractions on the sides: place 4 e + 2 end + component, edge e from vertex e+1 (end 0) to e+2 (end 1).
using SideTractions = Eigen::Matrix<double, n_loads(1), 1>;

/// The stress of the block with these side tractions [HH81, Theorem 2.1].
/// \pre they are in equilibrium
Corners stress_by_tractions(const Triangle& vertices, const SideTractions& tractions);

/// The least c with max |τ| ≤ c max |T| for all side tractions T in equilibrium and the stress τ that they determine,
/// in components [HH81, (2.10)]. For each of the 27 corner values it is a linear program with three equations, solved
/// exactly.
/// \pre the vertices run counter-clockwise
double stress_by_load_constant(const Triangle& vertices);

/// r_h τ on one cell: the stress vector projected on linear functions of each side, in L² [HH81, §2.1].
/// \param stress symmetric, without divergence
Corners interpolate(const Triangle& vertices, const StressField& stress);

/// ∫ |τ − λ|² over a cell in the norm of `form` (identity: shear counts once; a compliance: energy).
/// \param corners λ, linear on the cell's parts
double squared_distance(const Triangle& vertices, const StressField& stress, std::span<const scene::Voigt<2>> corners,
                        const scene::Elasticity<2>& form);

/// Integrals over 0 < s < 1 and over a triangle, by Gauss points.
double integrate(const std::function<double(double)>& f);
double integrate(const Triangle& triangle, const std::function<double(const scene::Vector<2>&)>& f);

}  // namespace bracket::dual
