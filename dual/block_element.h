// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/fields.h"
#include "scene/scene.h"

/// The self-equilibrated triangular block element [HH81, §2.1], [WH68]: a triangle cut into three at its centroid, on
/// each part a polynomial stress without divergence, tractions continuous inside. Degree 1 is that of the paper; 2 and
/// 3 are its like (docs/theory.md §4).
namespace bracket::dual {

/// Degree 1: 3 · 7 parameters − 12 continuity conditions.
constexpr int n_modes(int degree) { return degree == 1 ? 9 : degree == 2 ? 18 : 30; }
/// 3 edges × (degree + 1) coefficients × 2 components
constexpr int n_loads(int degree) { return 6 * (degree + 1); }
/// Of a stress on all parts.
constexpr int n_coefficients(int degree) { return 3 * scene::n_bernstein(degree); }

template <int degree> using ModeMatrix = Eigen::Matrix<double, n_modes(degree), n_modes(degree)>;
template <int degree> using ModeVector = Eigen::Matrix<double, n_modes(degree), 1>;
template <int degree> using LoadMatrix = Eigen::Matrix<double, n_loads(degree), n_modes(degree)>;
template <int degree> using LoadVector = Eigen::Matrix<double, n_loads(degree), 1>;
template <int degree> using CellMatrix = Eigen::Matrix<double, n_loads(degree), n_loads(degree)>;
/// A cell's stress by its Bernstein coefficients, numbered as in scene::Stress.
template <int degree> using BlockStress = std::array<scene::Voigt<2>, n_coefficients(degree)>;
/// Degree 1: by its values at the corners of the parts.
using Corners = BlockStress<1>;
using Triangle = std::array<scene::Vector<2>, 3>;

/// The modes on the triangle (0,0), (1,0), (0,1), which every cell shares: divergence-free fields and their tractions
/// are preserved by the double contravariant Piola map τ = B τ̂ Bᵀ / det B.
template <int degree> struct ReferenceBlock {
  /// Their coefficients are integers, so that they are held exactly: rounded modes would act as a body force, the same
  /// in all cells of one shape.
  std::array<BlockStress<degree>, n_modes(degree)> modes;
  /// ∫ τ̂_k,a τ̂_l,b, made symmetric, for the pairs (a,b) = 11, 22, 33, 12, 13, 23 of Voigt components.
  std::array<ModeMatrix<degree>, 6> mass;
  /// ∫ B_i (τ̂ n̂)_c over edge e by row 2 (degree + 1) e + 2 i + c, for the Bernstein polynomials B_i of the edge, which
  /// runs from vertex e+1 to e+2.
  LoadMatrix<degree> loads;
};
template <int degree> const ReferenceBlock<degree>& reference_block();

/// A cell's block element.
template <int degree> struct BlockElement {
  Eigen::Matrix3d piola;          ///< τ = piola τ̂ in Voigt components
  ModeMatrix<degree> compliance;  ///< A = ∫ τ_k : C⁻¹ τ_l; symmetric, positive definite
  LoadMatrix<degree> loads;       ///< G, in x and y components, rows as in ReferenceBlock
};
/// \pre the vertices run counter-clockwise
template <int degree>
BlockElement<degree> block_element(const Triangle& vertices, const scene::Elasticity<2>& compliance);

/// W = L⁻¹ Gᵀ, where A = L Lᵀ: the stiffness for edge displacements is k = WᵀW = G A⁻¹ Gᵀ, all motions but the rigid
/// ones being strained.
/// \param loads G, in whatever frames
template <int degree>
Eigen::Matrix<double, n_modes(degree), n_loads(degree)> half_stiffness(const Eigen::LLT<ModeMatrix<degree>>& compliance,
                                                                       const LoadMatrix<degree>& loads) {
  return compliance.matrixL().solve(loads.transpose());
}

/// The stress Σ s_k τ_k. \param piola as in BlockElement; so below
template <int degree>
BlockStress<degree> block_stress(const Eigen::Matrix3d& piola, const ModeVector<degree>& amplitudes);

/// ∫ τ_k : C⁻¹ λ over the cell.
template <int degree>
ModeVector<degree> coupling(const Triangle& vertices, const Eigen::Matrix3d& piola,
                            const scene::Elasticity<2>& compliance, const BlockStress<degree>& stress);

/// A linear field with div λ̄ = −F on one cell, zero at its centroid [HH81, §3: "simple integration"], and what it adds
/// to the cell's system.
template <int degree> struct Particular {
  BlockStress<degree> stress;   ///< λ̄
  ModeVector<degree> coupling;  ///< ∫ τ_k : C⁻¹ λ̄
  LoadVector<degree> loads;     ///< ∫ B_i λ̄n by edges, as ReferenceBlock::loads
};
template <int degree>
Particular<degree> particular(const Triangle& vertices, const Eigen::Matrix3d& piola,
                              const scene::Elasticity<2>& compliance, const scene::Vector<2>& force);

}  // namespace bracket::dual
