// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/certificate.h"
#include "bounds/certificate/space/sides.h"
#include "bounds/certificate/space/stress_energy.h"
#include "tests/bounds/certificate/rational.h"

/// The judge of the certificate in space: fields as rational numbers, whether they are admissible, and their energies,
/// from the definitions [HH81 (1.2), (1.11), (1.13)]. It asks the certificate what its numbers stand for; what these
/// fields are it finds by itself, from their values at points.
namespace bracket::bounds::space {

using Point = Vector3<Exact>;
using Tensor = std::array<Exact, 6>;

/// What certify() made of two fields.
struct Judged {
  std::vector<std::array<Point, 10>> displacement;      ///< of each cell: at its vertices and middles of edges
  std::vector<scene::BalancedStress<3, Exact>> stress;  ///< of each cell
  std::vector<std::array<Point, 4>> x;                  ///< the corners of each cell, as they are meant
  std::vector<Corrected<Exact>> corrections;
  PlainField field;
  Supports supports;
  Loads<Exact> loads;
  std::string reason;  ///< if there is none
};
Judged judged(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
              const scene::Stress<3>& stress);

/// What is wrong, one line each: of displacements that are not in K, stresses that are not in K⁺.
std::vector<std::string> displacement_faults(const scene::Problem<3>& problem, const Judged& exact);
std::vector<std::string> stress_faults(const scene::Problem<3>& problem, const Judged& exact);

Exact potential_energy(const scene::Problem<3>& problem, const Judged& exact);
Exact complementary_energy(const scene::Problem<3>& problem, const Judged& exact);
Exact strain_energy(const scene::Problem<3>& problem, const Judged& exact);
/// ∫ p (g − r(u)) over Γ_K, g the upper gap, or that of sides that keep together.
Exact contact_term(const scene::Problem<3>& problem, const Judged& exact);
/// ½ ‖σ(u) − λ‖²_{C⁻¹} + ∫ p (g − r(u)): by the gap identity L + S, if both fields are admissible.
Exact distance(const scene::Problem<3>& problem, const Judged& exact);

/// Expects the fields to be admissible, the certificate to contain their energies, and the gap identity.
void expect_holds_exactly(const scene::Problem<3>& problem, const Certificate& certificate, const Judged& exact);

}  // namespace bracket::bounds::space
