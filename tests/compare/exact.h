// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

/// Exact energies L(u) of the scenes that have one (docs/theory.md §9; apps/scenes), as functions of the scenes'
/// parameters. All are per unit thickness, in the units of the parameters. The bounds are −S(λ_h) ≤ L(u) ≤ L(u_h).
namespace bracket::tests {

/// E' = E / (1 − ν²) in plane strain, E in plane stress.
inline double plane_modulus(double young, double poisson, bool plane_stress = false) {
  return plane_stress ? young : young / (1 - poisson * poisson);
}

/// docs/theory.md §9.1, patch.toml: bodies of one material, `width` wide and `height` high together, on a sliding base,
/// their sliding top lowered by `lowering`: p = E' lowering / height, L(u) = ½ p lowering width.
/// \param modulus E'
inline double patch_energy(double modulus, double lowering, double width, double height) {
  return 0.5 * modulus * lowering * lowering * width / height;
}

/// One block of the scene of docs/theory.md §9.3.
struct Layer {
  double thickness;
  double modulus;  ///< E'
};

/// docs/theory.md §9.3, linear_pressure.toml: the pressure p0 (1 − c x) on −1 < x < 1 passes unchanged through both
/// blocks: L(u) = −p0² (1 + c²/3) (t₁/E₁' + t₂/E₂').
/// \pre |c| ≤ 1
inline double linear_pressure_energy(double p0, double c, const Layer& lower, const Layer& upper) {
  return -p0 * p0 * (1 + c * c / 3) * (lower.thickness / lower.modulus + upper.thickness / upper.modulus);
}

/// docs/theory.md §9.4, westergaard.toml: half a period (0, ½) × (0, height), plane strain, over a wall with the gap
/// amplitude (1 − cos 2πx).
struct Westergaard {
  double young;
  double poisson;
  double amplitude;  ///< Δ
  double height;     ///< H
  double fraction;   ///< s² = p̄/p* in (0, 1), p* = π E* Δ being the mean pressure that closes the contact
};

/// The mean pressure p̄ = s² π E* Δ on the top.
inline double westergaard_pressure(const Westergaard& scene) {
  return scene.fraction * std::numbers::pi * plane_modulus(scene.young, scene.poisson) * scene.amplitude;
}

/// The end of the contact, a = asin(s)/π.
inline double westergaard_half_width(const Westergaard& scene) {
  return std::asin(std::sqrt(scene.fraction)) / std::numbers::pi;
}

/// L(u) = −(p̄/4) (p̄ H/M + Δ s² (3/2 − ln s²)), M = E (1 − ν) / ((1 + ν)(1 − 2ν)); it leaves out terms of the relative
/// size exp(−4πH), and holds for the smooth gap: that of the scene is quadratic on each edge.
inline double westergaard_energy(const Westergaard& scene) {
  const double mean = westergaard_pressure(scene);
  const double confined = scene.young * (1 - scene.poisson) / ((1 + scene.poisson) * (1 - 2 * scene.poisson));
  const double wave = scene.amplitude * scene.fraction * (1.5 - std::log(scene.fraction));
  return -0.25 * mean * (mean * scene.height / confined + wave);
}

/// docs/theory.md §9.5, three_halves.toml: (−1, 1) × (0, 1) on a rigid wall, plane strain, with the contact pressure
/// √|x| where x < 0. The energy density is (1 + ν)/(2E) ((1 − 2ν)(r − x) + y²/(2r)); on each half of the domain
/// ∫ y²/r = ½ ∫ r: L(u) = −(1 + ν)(5 − 8ν)(√2 + arsinh 1)/(12 E). It holds for the given tractions: those of
/// the scene are linear on each edge.
inline double three_halves_energy(double young, double poisson) {
  return -(1 + poisson) * (5 - 8 * poisson) * (std::numbers::sqrt2 + std::asinh(1.0)) / (12 * young);
}

/// gravity.toml: a block with ν = 0, `along` × `across` the slope, under its weight per volume on a wall inclined by
/// `angle` (radians) with a stop at right angles to it. In axes along and across the slope, (s, t),
/// σ_ss = −w sin(angle) (along − s), σ_tt = −w cos(angle) (across − t), σ_st = 0.
inline double gravity_energy(double young, double weight, double along, double across, double angle) {
  const double down = weight * std::sin(angle) * along;     // pressure on the stop
  const double inward = weight * std::cos(angle) * across;  // pressure on the wall
  return -(down * down + inward * inward) * along * across / (6 * young);
}

/// shrink_fit.toml: a quarter of two smooth rings (polygons in the scene), plane stress. Lamé's pressure under the
/// interference `interference`, and L(u) = ¼ π b interference p.
struct ShrinkFit {
  double inner, contact, outer;  ///< radii a < b < c
  double bush_young, bush_poisson;
  double hub_young, hub_poisson;
  double interference;  ///< −gap > 0
};

inline double shrink_fit_pressure(const ShrinkFit& fit) {
  const double a2 = fit.inner * fit.inner;
  const double b2 = fit.contact * fit.contact;
  const double c2 = fit.outer * fit.outer;
  const double bush = ((b2 + a2) / (b2 - a2) - fit.bush_poisson) / fit.bush_young;
  const double hub = ((c2 + b2) / (c2 - b2) + fit.hub_poisson) / fit.hub_young;
  return fit.interference / (fit.contact * (bush + hub));
}

inline double shrink_fit_energy(const ShrinkFit& fit) {
  return 0.25 * std::numbers::pi * fit.contact * fit.interference * shrink_fit_pressure(fit);
}

}  // namespace bracket::tests
