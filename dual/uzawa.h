// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dual/cells.h"
#include "dual/dual.h"

/// The pieces of Uzawa's iteration [HH81, §3]: the functional (3.15) in the block parameters S, and the constraints
/// DS = 0 (3.13), ES ≤ −g (3.14), whose multipliers are edge displacements and, on Γ_K, the opening.
namespace bracket::dual {

/// The nine parameters of one cell, made such that its share of ½ SᵀAS is ½ |S|²: S = Lᵀ s, A = L Lᵀ.
struct UzawaCell {
  Eigen::Matrix<double, n_modes(1), n_loads(1)>
      loads;  ///< its share of (D, E)ᵀ: L⁻¹ Gᵀ; on Γ_K λn by its values at the ends
  std::array<int, n_loads(1)> multipliers;  ///< −1: none, the displacement is prescribed
  LoadVector<1> prescribed;
  ModeVector<1> linear;  ///< b: L⁻¹ ∫ τ_k : C⁻¹ λ̄
};

/// At one end of a contact facet. Without friction the two sides see opposite normal displacements but for the opening:
/// `first` = gap − opening − `second`, as moments against the end's hat function.
struct Opening {
  int first;   ///< multiplier of p ≥ 0 at this end: the opening, ≥ 0
  int second;  ///< of the equality of both sides' pressures: the second side's displacement; −1: a wall
  double gap;
  double pressure;  ///< of λ̄, of either sign
};

struct UzawaSystem {
  std::vector<UzawaCell> cells;
  std::vector<Opening> openings;
  /// Of each constraint; it makes the diagonal of B A⁻¹ Bᵀ one, B = (D, E), so that the iteration does not depend on
  /// units and little on the sizes of cells and moduli.
  Eigen::VectorXd scale;
};
/// \param cells make_cells()   \param particular as for uzawa()
template <int dim>
UzawaSystem uzawa_system(const scene::Problem<dim>& problem, const Layout& layout, const std::vector<Cell<1>>& cells,
                         const scene::Stress<dim>& particular);

/// The step of the iteration, 1.8 by an estimate of the largest eigenvalue of B A⁻¹ Bᵀ. The iteration converges for
/// steps below 2 by the eigenvalue, of which 100 steps of the power method miss less than 0.88 ln n / 99 on average
/// over the start: a tenth for n = 70 000 multipliers [Kuczyński & Woźniakowski, SIAM J. Matrix Anal. Appl. 13 (1992)].
double uzawa_step(const UzawaSystem& system);

using Parameters = std::vector<ModeVector<1>>;
/// S of each cell: AS = −b − Bᵀz.
Parameters parameters(const UzawaSystem& system, const Eigen::VectorXd& multipliers);

/// One step: P[z + ρ (B S + G)], where the projection P keeps openings from being negative.
Eigen::VectorXd next_multipliers(const UzawaSystem& system, const Eigen::VectorXd& multipliers,
                                 const Parameters& parameters, double step);

}  // namespace bracket::dual
