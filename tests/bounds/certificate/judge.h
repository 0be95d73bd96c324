// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/bounds.h"
#include "bounds/certificate/equilibrate.h"
#include "tests/bounds/certificate/polynomial.h"

/// The judge of the certificate: fields as rational numbers, whether they are admissible, and their energies, from the
/// definitions [HH81 (1.2), (1.11), (1.13)] by products and integrals of polynomials. It shares vectors of the
/// plane with the certificate and asks it what its numbers stand for; what these fields are it finds by itself.
namespace bracket::bounds {

/// A vector or a stress whose components are polynomials.
using Field = std::array<Polynomial, 2>;
using StressField = std::array<Polynomial, 3>;  ///< xx, yy, xy; strains: twice xy

/// Of each cell, in its barycentric coordinates.
struct ExactDisplacement {
  std::vector<Field> cell;
};
/// The field that the certificate's numbers stand for.
ExactDisplacement exact_displacement(const scene::Problem<2>& problem, const PlainField& field);
ExactDisplacement exact_displacement(const scene::Problem<2>& problem, const PlainField& field,
                                     const Supports& supports);

struct ExactStress {
  /// On the part at the side i → i + 1 of each cell, in the part's barycentric coordinates: i, i + 1, centroid.
  std::vector<std::array<StressField, 3>> cell;
  std::vector<Corrected<Exact>> added;  ///< corrections of the loads
};
/// The block elements' stresses of balanced loads. What carries the body force differs from the certificate's choice by
/// a field without divergence that block elements have: the stress is the same.
ExactStress exact_stress(const scene::Problem<2>& problem, const EdgeLoads<Exact>& loads,
                         const std::vector<Corrected<Exact>>& added);

/// What keeps the field from being in K, one line each.
std::vector<std::string> faults(const scene::Problem<2>& problem, const ExactDisplacement& displacement);
/// What keeps it from being in K⁺ (for the data and the added loads), one line each.
std::vector<std::string> faults(const scene::Problem<2>& problem, const ExactStress& stress);

/// L, with the work of added loads.
Exact potential_energy(const scene::Problem<2>& problem, const ExactDisplacement& displacement,
                       const std::vector<Corrected<Exact>>& added);
/// S. \param displacement in K: what it is on Γ_u and Γ_0 is what is prescribed there
Exact complementary_energy(const scene::Problem<2>& problem, const ExactStress& stress,
                           const ExactDisplacement& displacement);
/// Rational numbers around one that may be irrational.
struct Around {
  Exact lower, upper;
};
/// What the laws add to L: ∫ φ(r, v_t), from the definitions, by halves of facets.
Around law_energy(const scene::Problem<2>& problem, const ExactDisplacement& displacement);
/// What they add to S: ½ ∫ p²/k, by tangents and chords of 1/k.
Around law_complementary_energy(const scene::Problem<2>& problem, const ExactStress& stress);
/// ½ ∫ (k s − p)²/k, s what springs are shortened by: their share of ½ ‖σ(u) − λ‖² as bodies, from above.
Exact springs_misfit(const scene::Problem<2>& problem, const ExactStress& stress, const ExactDisplacement& u);
/// ½ A(u, u)
Exact strain_energy(const scene::Problem<2>& problem, const ExactDisplacement& displacement);
/// ½ ‖σ(u) − λ‖²_{C⁻¹} on each cell.
std::vector<Exact> misfits(const scene::Problem<2>& problem, const ExactStress& stress,
                           const ExactDisplacement& displacement);
/// ∫ (p (g − r(u)) − τ v_t(u)) over Γ_K.
Exact contact_term(const scene::Problem<2>& problem, const ExactStress& stress, const ExactDisplacement& displacement);
/// ½ ‖σ(u) − λ‖²_{C⁻¹} + ∫ p (g − r(u)): by the gap identity L + S, if both fields are admissible.
Exact distance(const scene::Problem<2>& problem, const ExactStress& stress, const ExactDisplacement& displacement);

/// What certify() made of two fields, in rational numbers.
struct Judged {
  PlainField field;
  EdgeLoads<Exact> loads;
  ExactDisplacement displacement;
  ExactStress stress;
};
/// \pre its certificate is valid
Judged judged(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
              const scene::Stress<2>& stress);

/// What the certificate has wrong, one line each: of fields that are not admissible, energies that it does not contain.
std::vector<std::string> faults(const scene::Problem<2>& problem, const Certificate& certificate, const Judged& exact);

/// Expects the fields to be admissible, the certificate to contain their energies, and the gap identity.
void expect_holds_exactly(const scene::Problem<2>& problem, const Certificate& certificate, const Judged& exact);

}  // namespace bracket::bounds
