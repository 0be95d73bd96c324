// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "scene/scene.h"

/// What is told of a stress at a point.
namespace bracket::apps {

/// Whether the stress across the plane is known of all bodies: in plane stress it is zero, in plane strain
/// ν (σ_xx + σ_yy) of isotropic ones; a stiffness of the plane does not tell it.
bool knows_stress_across(const scene::Problem<2>& problem, scene::Plane plane);

/// σ_zz of a body, if it is known.
std::optional<double> stress_across(const scene::Material<2>& material, scene::Plane plane,
                                    const scene::Voigt<2>& stress);

/// √(½ ((σ₁ − σ₂)² + (σ₂ − σ₃)² + (σ₃ − σ₁)²))
double von_mises(const scene::Voigt<2>& stress, double across);
double von_mises(const scene::Voigt<3>& stress);

/// Half the difference of the principal stresses in the plane.
double largest_shear(const scene::Voigt<2>& stress);

/// The principal stresses in the plane, the larger one first.
std::array<double, 2> principal_stresses(const scene::Voigt<2>& stress);
/// In space all three, the largest first.
std::array<double, 3> principal_stresses(const scene::Voigt<3>& stress);

}  // namespace bracket::apps
