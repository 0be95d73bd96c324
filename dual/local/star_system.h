// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dual/local/block_cholesky.h"
#include "dual/local/star.h"

/// The least energy of loads in balance on the spokes of a star (docs/theory.md §12.2).
namespace bracket::dual {

/// What the loads on the spokes of a star's cells are to be.
template <int dim> struct StarData {
  using Spokes = SpokeVector<dim>;
  std::vector<Spokes> gradient;  ///< of the energy by the loads, as they are
  /// Force and moments about the vertex that the loads of each cell have.
  std::vector<Eigen::Matrix<double, scene::Simplex<dim>::n_rigid_motions, 1>> resultant;
  /// Of the loads on each spoke: of both cells inside, of one on Γ_τ and Γ_K, without what is along the normal on Γ_0.
  std::vector<FacetVector<dim>> sum;
  /// Displacements of spokes on Γ_u and, along the normal, Γ_0, by moments: dual to loads.
  std::vector<FacetVector<dim>> prescribed;

  explicit StarData(const Star<dim>& star);  ///< all zero
};

/// A star whose system is not definite in floating point.
struct NotDefinite {
  int vertex;
};

/// The least energy Σ ½ DᵀH D + gradientᵀ D − D · prescribed of loads D on a star's spokes that do what is given.
template <int dim> class StarSystem {
 public:
  using Spokes = typename StarData<dim>::Spokes;
  struct Solution {
    std::vector<Spokes> loads;                   ///< D of each cell
    std::vector<FacetVector<dim>> displacement;  ///< of each spoke: the derivative of the energy by `sum`
  };

  /// \param energy of all cells of the mesh; kept by reference, as the star is
  /// \throw NotDefinite
  StarSystem(const Star<dim>& star, const Energies<dim>& energy);
  const Star<dim>& star() const { return star_; }
  const Energy<dim>& energy(std::size_t cell) const { return energy_[star_.cells()[cell]]; }

  /// Balanced to the last digits of the loads, however stiff the cells are. What `sum` lacks of balance along
  /// Star::motions() is left on one spoke.
  Solution solve(const StarData<dim>& data) const;
  /// Solution::displacement of all else zero but `sum` of one spoke, which nothing holds.
  std::vector<FacetVector<dim>> moved_by(int spoke, const FacetVector<dim>& sum) const;

 private:
  /// D = response (μ − gradient) of the loads on a cell's spokes, balanced; those on the facet opposite are zero. Of
  /// the blocks on the diagonal the lower halves count.
  using Response = FacetForm<dim, dim>;
  using Resultant = Eigen::Matrix<double, scene::Simplex<dim>::n_rigid_motions, 1>;
  using Balance = Eigen::Matrix<double, scene::Simplex<dim>::n_rigid_motions, n_spoke_loads<dim>>;
  using Block = FacetBlock<dim>;
  template <int lanes> Response set_form(std::size_t cell);
  void add(std::size_t cell, const Response& response);
  void hold_what_slides();
  Spokes respond(std::size_t cell, const Spokes& slope) const;
  Balance balance(std::size_t cell) const;
  double handed_out(const StarData<dim>& data, Solution& found) const;
  void add_shortest(std::size_t cell, const Balance& of_cell, const Resultant& resultant, Spokes& loads) const;
  template <class Rows> void make_tangential(int spoke, Rows&& rows) const;

  const Star<dim>& star_;
  const Energies<dim>& energy_;
  std::vector<int> unknown_;                       ///< of each spoke; −1: on Γ_u
  std::vector<const scene::Vector<dim>*> normal_;  ///< of spokes on Γ_0
  std::vector<Block> opposite_;                    ///< of each cell: the root of its stiffness at the facet opposite
  std::vector<Eigen::Matrix<double, scene::Simplex<dim>::n_rigid_motions, scene::Simplex<dim>::n_rigid_motions>>
      balance_root_;  ///< of each cell: L, L Lᵀ = balance balanceᵀ
  BlockCholesky<Block> matrix_;
};

}  // namespace bracket::dual
