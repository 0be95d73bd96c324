// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/bounds.h"
#include "bounds/certificate/equilibrate.h"
#include "tests/bounds/certificate/rational.h"

/// The judge of the certificate: fields as rational numbers, whether they are admissible, and their energies, from the
/// definitions [HH81 (1.2), (1.11), (1.13)] by quadrature that is exact for them. It shares vectors of the plane with
/// the certificate, and no formula.
namespace bracket::bounds {

/// A field that is quadratic on each cell.
struct ExactDisplacement {
  std::vector<Vector2<Exact>> vertex;  ///< at Mesh::vertices
  std::vector<Vector2<Exact>> edge;    ///< at the midpoints of Mesh::edges
};
/// The field that the certificate's numbers stand for.
ExactDisplacement exact_displacement(const scene::Problem<2>& problem, const PlainField& field);

using ExactVoigt = std::array<Exact, 3>;  ///< xx, yy, xy; strains: twice xy
struct ExactStress {
  /// As BlockStress: at the corners i, i + 1 and the centroid of the part at the side i → i + 1 of each cell.
  std::vector<std::array<std::array<ExactVoigt, 3>, 3>> cell;
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
/// ½ ‖σ(u) − λ‖²_{C⁻¹} + ∫ p (g − r(u)) over Γ_K: by the gap identity L + S, if both fields are admissible.
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

/// Expects the fields to be admissible, the certificate to contain their energies, and the gap identity.
void expect_holds_exactly(const scene::Problem<2>& problem, const Certificate& certificate, const Judged& exact);

}  // namespace bracket::bounds
