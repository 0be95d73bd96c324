// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bounds/certificate/judge.h"

/// The judge of displacements from anywhere (docs/theory.md §10.6): their errors and distances as rational numbers,
/// from nodal values by Lagrange's polynomials.
namespace bracket::bounds {

/// The field of these values at vertices and midpoints. \pre degree 1 or 2
ExactDisplacement from_nodes(const scene::Mesh<2>& mesh, const scene::Displacement<2>& displacement);
/// A field on a mesh that refinement made, found by the coordinates of its vertices. \pre those are exact midpoints
ExactDisplacement on_finer(const scene::Mesh<2>& mesh, const ExactDisplacement& displacement,
                           const scene::Mesh<2>& finer);
/// a u + b v
ExactDisplacement combination(const Exact& a, const ExactDisplacement& u, const Exact& b, const ExactDisplacement& v);

/// u_s, which the certificate's numbers stand for: the field moved onto the supports, not out of contact.
ExactDisplacement on_supports(const scene::Problem<2>& first, const scene::Displacement<2>& given);

/// ‖σ(u_x) − ½ (σ(u_h) + λ_h)‖²_{C⁻¹} = ¼ ‖σ(2 u_x − u_h) − λ_h‖² on each cell. \param given u_x on this mesh
std::vector<Exact> squared_distances(const scene::Problem<2>& problem, const Judged& own,
                                     const ExactDisplacement& given);
/// Their sum without any difference of stresses, by the gap identity, which needs no displacements in K:
///     ½ ‖σ(w) − λ‖² = L(w) + S(λ) − ∫ p (g − r(w)), the reactions' work in S that on w itself.
Exact squared_distance_by_energies(const scene::Problem<2>& problem, const Judged& own, const ExactDisplacement& given);

/// Expects lower ≤ √square ≤ upper.
void expect_root_inside(double lower, double upper, const Exact& square);

}  // namespace bracket::bounds
