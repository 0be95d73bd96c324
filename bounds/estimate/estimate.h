// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scene/scene.h"

/// Energies, indicators, checks and marks of the fields as computed, rounding included.
namespace bracket::bounds {

/// σ(u_h) on a cell, by Bernstein coefficients of the degree stress_degree() of the stresses beside it; degree 1: at
/// the vertices.
template <int dim>
std::vector<scene::Voigt<dim>> displacement_stress(const scene::Problem<dim>& problem,
                                                   const scene::Displacement<dim>& displacement, int cell);

/// L(v) = ½ A(v,v) − ℓ(v) [HH81 §1], with what contact laws add (docs/theory.md §11), and its strain part ½ A(v,v).
struct PotentialEnergy {
  double strain = 0;
  double total = 0;
};
template <int dim>
PotentialEnergy potential_energy(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement);

/// S(λ) = ½ ∫ λ : C⁻¹ λ − ∫_Γu λn·u0 − ∫_Γ0 (λn)_n u0n + ∫_ΓK p g, with what contact laws add
template <int dim> double complementary_energy(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress);

struct Check {
  std::string name;
  double value;
  std::string meaning;  ///< what holds where the value is small
};

/// How far the two computed fields are from being admissible, each by the scene's largest displacement or stress. Above
/// `tolerance` the certificate has much to make good, and the bracket becomes wide.
struct Checks {
  static constexpr double tolerance = 1e-8;
  double penetration = 0;     ///< largest r − g on Γ_K (Bernstein coefficients), misfit of prescribed displacements
  double equilibrium = 0;     ///< largest |div λ + F| · cell diameter, and traction jumps between a cell's parts
  double interface_jump = 0;  ///< largest jump of λn between cells, and of the pressure across the contact
  double boundary_traction = 0;  ///< largest |λn − P| on Γ_τ and shear on Γ_0, Γ_K, there above what friction bears
  double tension = 0;            ///< largest −p on Γ_K, where its sides can part
  double gap_identity = 0;       ///< |sum of indicators − width| by the energy
  std::array<Check, 6> all() const;
  Check worst() const;  ///< the largest, or one that is not a number
  bool passed() const;  ///< all of them finite and at most `tolerance`
};
/// All but the gap identity, which needs the bracket.
template <int dim>
Checks admissibility(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                     const scene::Stress<dim>& stress);

/// The terms of the gap identity; they are ≥ 0 and add up to the width of the bracket.
struct Indicator {
  std::vector<double> cell;  ///< ½ ‖σ(u_h) − λ_h‖²_{C⁻¹} on each cell
  std::vector<double> contact;  ///< ∫ p_h (g − r(u_h)) on each contact facet, rounding of p_h included; with other laws
                                ///< ∫ φ + φ* − p_h r(u_h) − τ_h v_t(u_h)
  double sum = 0;
};
template <int dim>
Indicator indicator(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                    const scene::Stress<dim>& stress);

/// The two energies as the computed fields give them, rounding included.
struct PlainEnergies {
  double lower = 0;         ///< −S(λ_h)
  double upper = 0;         ///< L(u_h)
  double strain = 0;        ///< ½ A(u_h,u_h)
  double gap_identity = 0;  ///< |sum of indicators − (upper − lower)| by the largest of the three
};
template <int dim>
PlainEnergies plain_energies(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                             const scene::Stress<dim>& stress, const Indicator& indicator);

/// An interval for L(u), and the errors that it bounds.
struct Bracket {
  double lower = 0;
  double upper = 0;
  double relative_width = 0;  ///< width by the larger of |lower|, |upper|
  double error_bound = 0;     ///< √(2 width) ≥ ‖u − u_h‖_A and ≥ ‖σ − λ_h‖_{C⁻¹}
  double mean_stress_error_bound = 0;  ///< √T ≥ ‖σ − ½(σ(u_h) + λ_h)‖_{C⁻¹}, T = ½ width + ½ ∫ p (g − r(u_h))
  double relative_error_bound = 0;  ///< error_bound / ‖u_h‖_A; infinite where u_h does not deform
};
/// \param strain_energy ½ A(u_h,u_h), or less   \param contact κ = ∫ p (g − r(u_h)), or more
Bracket bracket(double lower, double upper, double strain_energy, double contact);

/// An estimate of what fixing the data facet by facet did to the energy, in absolute value: to first order
///     ∫ |P − P_h| |u_h − I u_h| + ∫ |λ_h n·(u0 − u0_h)| + ∫ p_h |g − g_h|
/// where I u_h has the degree of the stresses on each facet (degree 1: its mean), to which P − P_h is orthogonal, and,
/// as data of which nothing is left have no first order, the energy with which a half-plane or half-space answers to
/// what is left out. Differences are bounds, of functions that are but sampled their values at points; enclosed gaps
/// have none.
struct DataEffect {
  double energy = 0;          ///< infinite where data are unbounded, or jumps are prescribed as displacements
  std::vector<double> facet;  ///< the shares of Mesh::boundary
};
/// \pre `problem` is fix_data() of `scene`, on its own mesh, and the fields have its degree
template <int dim>
DataEffect data_effect(const scene::Scene<dim>& scene, const scene::Problem<dim>& problem,
                       const scene::Displacement<dim>& displacement, const scene::Stress<dim>& stress);

/// The pressure of λ_h on each contact facet, by Bernstein coefficients in the order of scene/on_facet.h on the first
/// facet, which are ≥ 0 (degree 1: its values at the vertices); exactly 0 where one is not more than rounding of λ_h.
/// That is seen where λ_h n has to be something known: by the most that, on the bodies of the pair, it misses the loads
/// of Γ_τ and has of shear on Γ_0 and Γ_K (up to Checks::tolerance of their largest stress; what is more is not
/// rounding), and by 1e-11 of that stress, below which the certificate has no pressure either.
template <int dim>
std::vector<std::vector<double>> contact_pressure(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress);

/// On one contact facet, by Bernstein coefficients in the order of scene/on_facet.h on the first facet.
struct ContactState {
  std::vector<double> pressure;  ///< of λ_h, see contact_pressure()
  std::vector<double> gap_left;  ///< g − r(u_h)
};
template <int dim>
std::vector<ContactState> contact_state(const scene::Problem<dim>& problem,
                                        const scene::Displacement<dim>& displacement, const scene::Stress<dim>& stress);

/// Planar: the shear τ of λ_h and the slip v_t of u_h on a contact facet, likewise (scene/problem/law.h).
struct ShearAndSlip {
  std::vector<double> shear, slip;
};
template <int dim>
ShearAndSlip shear_and_slip(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                            const scene::Stress<dim>& stress, const scene::ContactFacetOf<dim>& pair);

/// Bulk marking (Dörfler): as few cells as carry `bulk` of the sum of the indicators, a contact facet's share split
/// between the cells at it. \return 1 per marked cell   \pre 0 < bulk ≤ 1
template <int dim> std::vector<char> mark(const scene::Problem<dim>& problem, const Indicator& indicator, double bulk);

}  // namespace bracket::bounds
