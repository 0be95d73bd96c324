// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

/// The self-equilibrated triangular block element [HH81, §2.1], [WH68]: a triangle cut into three at its centroid, on
/// each part a linear stress without divergence, tractions continuous inside.
namespace bracket::dual {

inline constexpr int n_modes = 9;   ///< 3 · 7 parameters − 12 continuity conditions
inline constexpr int n_loads = 12;  ///< 3 edges × 2 ends × 2 components

using ModeMatrix = Eigen::Matrix<double, n_modes, n_modes>;
using ModeVector = Eigen::Matrix<double, n_modes, 1>;
using LoadMatrix = Eigen::Matrix<double, n_loads, n_modes>;
using LoadVector = Eigen::Matrix<double, n_loads, 1>;
using CellMatrix = Eigen::Matrix<double, n_loads, n_loads>;
/// Stress at the corners of the three parts, numbered as in scene::Stress.
using Corners = std::array<scene::Voigt<2>, 9>;
using Triangle = std::array<scene::Vector<2>, 3>;

/// The nine modes on the triangle (0,0), (1,0), (0,1), which every cell shares: divergence-free fields and their linear
/// tractions are preserved by the double contravariant Piola map τ = B τ̂ Bᵀ / det B.
struct ReferenceBlock {
  std::array<Corners, n_modes> modes;
  /// ∫ τ̂_k,a τ̂_l,b, made symmetric, for the pairs (a,b) = 11, 22, 33, 12, 13, 23 of Voigt components.
  std::array<ModeMatrix, 6> mass;
  /// ∫ φ_i (τ̂ n̂)_c over edge e by row 4 e + 2 i + c; edge e runs from vertex e+1 (i = 0) to e+2 (i = 1).
  LoadMatrix loads;
};
const ReferenceBlock& reference_block();

/// A cell's block element.
struct BlockElement {
  Eigen::Matrix3d piola;  ///< τ = piola τ̂ in Voigt components
  ModeMatrix compliance;  ///< A = ∫ τ_k : C⁻¹ τ_l; symmetric, positive definite
  LoadMatrix loads;       ///< G, in x and y components, rows as in ReferenceBlock
};
/// \pre the vertices run counter-clockwise
BlockElement block_element(const Triangle& vertices, const scene::Elasticity<2>& compliance);

/// W = L⁻¹ Gᵀ (9 × 12), where A = L Lᵀ: the stiffness for edge displacements is k = WᵀW = G A⁻¹ Gᵀ, of rank 9.
/// \param loads G, in whatever frames
Eigen::Matrix<double, n_modes, n_loads> half_stiffness(const Eigen::LLT<ModeMatrix>& compliance,
                                                       const LoadMatrix& loads);

/// The stress Σ s_k τ_k at the corners. \param piola as in BlockElement; so below
Corners stress_at_corners(const Eigen::Matrix3d& piola, const ModeVector& amplitudes);

/// ∫ τ_k : C⁻¹ λ over the cell, for a stress λ that is linear on the parts, given at their corners.
ModeVector coupling(const Triangle& vertices, const Eigen::Matrix3d& piola, const scene::Elasticity<2>& compliance,
                    const Corners& stress);

/// A linear field with div λ̄ = −F on one cell, zero at its centroid [HH81, §3: "simple integration"], and what it adds
/// to the cell's system.
struct Particular {
  Corners stress;       ///< λ̄
  ModeVector coupling;  ///< ∫ τ_k : C⁻¹ λ̄
  LoadVector loads;     ///< ∫ φ_i λ̄n by edges, as ReferenceBlock::loads
};
Particular particular(const Triangle& vertices, const Eigen::Matrix3d& piola, const scene::Elasticity<2>& compliance,
                      const scene::Vector<2>& force);

}  // namespace bracket::dual
