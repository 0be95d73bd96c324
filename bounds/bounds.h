// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <stop_token>

#include "dual/dual.h"
#include "primal/primal.h"
#include "scene/scene.h"

/// The bracket −S(λ_h) ≤ L(u) ≤ L(u_h) and what follows from it (design §1.1). Everything here is computed from plain
/// field values by code of its own: what certifies shares nothing with what solves.
namespace bracket::bounds {

// ---- fields ---------------------------------------------------------------------------------------------------------

/// σ(u_h) at the vertices of a cell, between which it is linear.
template <int dim>
std::array<scene::Voigt<dim>, 3> displacement_stress(const scene::Problem<dim>& problem,
                                                     const primal::Displacement<dim>& displacement, int cell);

// ---- energies -------------------------------------------------------------------------------------------------------

/// L(v) = ½ A(v,v) − ℓ(v) [HH81 §1], and its strain part ½ A(v,v).
struct PotentialEnergy {
  double strain = 0;
  double total = 0;
};
template <int dim>
PotentialEnergy potential_energy(const scene::Problem<dim>& problem, const primal::Displacement<dim>& displacement);

/// S(λ) = ½ ∫ λ : C⁻¹ λ − ∫_Γu λn·u0 − ∫_Γ0 (λn)_n u0n + ∫_ΓK p g
template <int dim>
double complementary_energy(const scene::Problem<dim>& problem, const dual::Stress<dim>& stress);

// ---- checks ---------------------------------------------------------------------------------------------------------

struct Check {
  std::string name;
  double value;
};

/// How far the two computed fields are from being admissible, each by the scene's largest displacement or stress. Above
/// `tolerance` the certificate has much to make good, and the bracket becomes wide.
struct Checks {
  static constexpr double tolerance = 1e-8;
  double penetration = 0;        ///< largest r − g on Γ_K (Bernstein coefficients), misfit of prescribed displacements
  double equilibrium = 0;        ///< largest |div λ + F| · cell diameter, and traction jumps between a cell's parts
  double interface_jump = 0;     ///< largest jump of λn between cells, and of the pressure across the contact
  double boundary_traction = 0;  ///< largest |λn − P| on Γ_τ and shear on Γ_0, Γ_K
  double tension = 0;            ///< largest −p on Γ_K
  double gap_identity = 0;       ///< |sum of indicators − width| by the energy
  Check worst() const;           ///< the largest, or one that is not a number
  bool passed() const;           ///< all of them finite and at most `tolerance`
};
/// All but the gap identity, which needs the bracket.
template <int dim>
Checks admissibility(const scene::Problem<dim>& problem, const primal::Displacement<dim>& displacement,
                     const dual::Stress<dim>& stress);

// ---- bracket --------------------------------------------------------------------------------------------------------

/// The terms of the gap identity; they are ≥ 0 and add up to the width of the bracket.
struct Indicator {
  std::vector<double> cell;     ///< ½ ‖σ(u_h) − λ_h‖²_{C⁻¹} on each cell
  std::vector<double> contact;  ///< ∫ p_h (g − r(u_h)) on each contact facet
  double sum = 0;
};
template <int dim>
Indicator indicator(const scene::Problem<dim>& problem, const primal::Displacement<dim>& displacement,
                    const dual::Stress<dim>& stress);

/// The two energies as the computed fields give them, rounding included.
struct PlainEnergies {
  double lower = 0;         ///< −S(λ_h)
  double upper = 0;         ///< L(u_h)
  double strain = 0;        ///< ½ A(u_h,u_h)
  double gap_identity = 0;  ///< |sum of indicators − (upper − lower)| by the largest of the three
};
template <int dim>
PlainEnergies plain_energies(const scene::Problem<dim>& problem, const primal::Displacement<dim>& displacement,
                             const dual::Stress<dim>& stress, const Indicator& indicator);

/// Bounds that hold in floating point, whatever the solvers did [HH81 §3]. Displacements are moved into K exactly, edge
/// loads into exact balance with the data, and both energies are enclosed with every rounding error accounted for.
struct Certificate {
  bool valid = false;
  std::string reason;        ///< if not: one line
  double lower = 0;          ///< ≤ L(u)
  double upper = 0;          ///< ≥ L(u)
  double strain_energy = 0;  ///< ≤ ½ A(u_h,u_h)
  /// Rounding of the data along rigid motions that nothing holds, removed from them: largest load added, by the
  /// largest. The bounds are as far apart as its work could be.
  double added_load = 0;
};
/// \param displacement, stress need not solve anything; the closer they do, the closer the bounds
template <int dim>
Certificate certify(const scene::Problem<dim>& problem, const primal::Displacement<dim>& displacement,
                    const dual::Stress<dim>& stress);

/// An interval for L(u), and the errors that it bounds.
struct Bracket {
  double lower = 0;
  double upper = 0;
  double relative_width = 0;           ///< width by the larger of |lower|, |upper|
  double error_bound = 0;              ///< √(2 width) ≥ ‖u − u_h‖_A and ≥ ‖σ − λ_h‖_{C⁻¹}
  double mean_stress_error_bound = 0;  ///< √(½ width + ½ ∫ p (g − r)) ≥ ‖σ − ½(σ(u_h) + λ_h)‖_{C⁻¹}
  double relative_error_bound = 0;     ///< error_bound / ‖u_h‖_A; infinite where u_h does not deform
};
/// \param strain_energy ½ A(u_h,u_h)
Bracket bracket(double lower, double upper, double strain_energy, const Indicator& indicator);

/// An estimate of what fixing the data edgewise did to the energy, to first order and in absolute value:
///     ∫ |P − P_h| |u_h − I u_h| + ∫ |λ_h n·(u0 − u0_h)| + ∫ p_h |g − g_h|
/// where I u_h is linear on each facet (degree 1: its mean), to which P − P_h is orthogonal.
/// \pre `problem` is fix_data() of `scene`, on its own mesh
template <int dim>
double oscillation_energy(const scene::Scene<dim>& scene, const scene::Problem<dim>& problem,
                          const primal::Displacement<dim>& displacement, const dual::Stress<dim>& stress);

// ---- contact, as both formulations see it ---------------------------------------------------------------------------

/// On one contact facet, at the first facet's vertices 0 and 1 (and its midpoint: gap only).
struct ContactState {
  std::array<double, 2> pressure;       ///< of λ_h
  std::array<double, 3> gap_left;       ///< g − r(u_h)
};
template <int dim>
std::vector<ContactState> contact_state(const scene::Problem<dim>& problem,
                                        const primal::Displacement<dim>& displacement, const dual::Stress<dim>& stress);

// ---- the driver -----------------------------------------------------------------------------------------------------

struct Seconds {
  double mesh = 0;  ///< reading, meshing and fixing the data; later marking and refining
  double primal = 0;
  double dual = 0;
  double estimate = 0;  ///< indicators and checks
  double certify = 0;
  double total = 0;  ///< wall clock; the two formulations run side by side
};

/// What one mesh gave.
struct Level {
  int cells = 0;
  int primal_dofs = 0;
  int dual_dofs = 0;
  Bracket bracket;  ///< from the certificate; without one, from the plain energies
  PlainEnergies plain;
  Certificate certificate;
  Checks checks;
  double oscillation_energy = 0;  ///< of the data, which the first mesh fixes: see oscillation_energy()
  Seconds seconds;
  int contact_rows = 0, contact_active = 0, contact_iterations = 0;  ///< of the displacements
  int dual_contact_rows = 0, dual_contact_active = 0, dual_contact_iterations = 0;
  double primal_imbalance = 0, dual_imbalance = 0;
  double primal_assemble = 0, dual_assemble = 0;
  contact::Seconds primal_phases, dual_phases;
};

/// What a run has found; the fields are those of the last level.
template <int dim> struct Outcome {
  scene::Status status = scene::Status::done;
  std::string guarantee = "none";  ///< "rounding-safe" or "none"
  std::string reason;              ///< if there is no guarantee or the budget was spent: one line
  /// The bracket of the run: its levels' brackets of one fixed problem, intersected. The displacement spaces are
  /// nested, so the last upper bound is the least; the stress spaces are not.
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double relative_error_bound = std::numeric_limits<double>::infinity();  ///< √(2 (upper − lower)) / ‖u_h‖_A
  scene::Problem<dim> problem;
  primal::Displacement<dim> displacement;
  dual::Stress<dim> stress;
  Indicator indicator;
  std::vector<Level> levels;
  std::vector<std::string> skipped;  ///< stages that the scene did not need
};

/// Who follows a run, and may end it.
template <int dim> struct Observer {
  std::function<void(const std::string& stage)> stage;  ///< told as each stage of a level begins
  std::function<void(const Outcome<dim>& so_far)> level;  ///< told as each level is done
  std::stop_token stop;                                   ///< asked after each level
};

/// Solvability: prescribed displacements that keep the contact, and pressures that can balance the loads (HH81 (1.16)).
/// \param degree of the displacements, 1 or 2
/// \return the largest relative imbalance that was at rounding level and is removed
/// \throw scene::Error (ill_posed), with the place on the contact or with the body and the motion
template <int dim> double check_solvability(const scene::Problem<dim>& problem, int degree);

/// Bulk marking (Dörfler): as few cells as carry `bulk` of the sum of the indicators, a contact facet's share split
/// between the cells at it. \return 1 per marked cell   \pre 0 < bulk ≤ 1
template <int dim>
std::vector<char> mark(const scene::Problem<dim>& problem, const Indicator& indicator, double bulk);

/// The whole main job: mesh, fixed data, solvability; then level by level both formulations, checks, bracket, marking
/// and refinement, until the target or the budget of scene.refine. Where the bodies do but follow the prescribed
/// displacements and gaps, rigidly and without loads, the bracket is [0, 0] and the first mesh is the last.
/// \throw scene::Error for all that the user can mend
template <int dim> Outcome<dim> run(const scene::Scene<dim>& scene, const Observer<dim>& observer = {});

/// The same from data that are fixed already and may have been changed since: of `scene` only the settings count, and
/// nothing is known of what fixing the data did (Level::oscillation_energy is 0).
template <int dim>
Outcome<dim> run(const scene::Scene<dim>& scene, scene::Problem<dim> problem, const Observer<dim>& observer = {});

}  // namespace bracket::bounds
