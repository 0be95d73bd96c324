// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bounds/bounds.h"

/// Example 1 of [HH81, §2] with solutions of different smoothness: a slider (0,1) × (0,1) on a lubricated base y = 0
/// leans on a stop (1,2) × (0,1) at x = 1.
namespace bracket::apps {

/// A solution in closed form, on one body.
struct ExactField {
  std::function<scene::Voigt<2>(const scene::Vector<2>&)> stress;
  std::function<scene::Vector<2>(const scene::Vector<2>&)> displacement;
};

/// Entire functions, the contact closed, the stop clamped. In each body σ comes from the Airy function
///     φ = f(x) cos ky − ½ p₀ y² + ½ s x²,   f'''' − 2k²f'' + k⁴f = 0,
/// with one pressure p₀ + p₁ cos ky > 0 and one normal displacement at x = 1, no shear there and at y = 0.
struct SmoothSolution {
  ExactField slider, stop;
};
SmoothSolution smooth_solution();

/// Example 1 on two blocks of n × n squares, each cut in two: "smooth", "contact end" (curved stop, partly open, stress
/// like r^½) or "clamped corners" (stress like r^-0.29).
struct Example {
  std::string name;
  std::function<scene::Scene<2>(int n)> scene;
};
std::vector<Example> examples();

/// What one mesh of an example gave; fields relative to the exact ones' norm, or to that of the finest displacements.
struct Measured {
  std::string example;
  int n;
  double h;                 ///< largest diameter of a cell
  double lower, upper;      ///< of the energy
  double stress_error = 0;  ///< ‖σ − λ_h‖_{C⁻¹} in closed form, else at most this: √(2 (S(λ_h) + L_ref))
  double stress_difference = 0;    ///< ‖σ(u_h) − λ_h‖_{C⁻¹}
  double pressure_difference = 0;  ///< of both formulations, in L²(Γ_K)
  double pressed = 0;              ///< length of the contact where the stresses press
  double closed = 0;               ///< length of the contact that the displacements close
};

/// Solves an example on each mesh.
/// \param stage told what begins
std::vector<Measured> measure(const Example& example, const std::vector<int>& meshes,
                              const std::function<void(const std::string&)>& stage);

}  // namespace bracket::apps
