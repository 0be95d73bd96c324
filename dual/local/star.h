// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dual/local/block_cholesky.h"
#include "dual/local/cell.h"

/// The star of a vertex: the cells at it, held together by their common facets, its spokes; and the least energy of
/// loads on these in balance (docs/theory.md §12.2).
namespace bracket::dual {

/// What the facets of a mesh are.
template <int dim> struct Facets {
  struct Facet {
    std::array<int, dim> vertices;  ///< by increasing number
    scene::Support support;         ///< of the boundary
    int boundary = -1;              ///< index into Mesh::boundary; −1: inside
  };
  std::vector<Facet> facet;
};
template <int dim> Facets<dim> facets_of(const scene::Problem<dim>& problem);

/// Where a vertex is among those of a facet.
template <int dim> int slot(const Facets<dim>& facets, int facet, int vertex) {
  const auto& vertices = facets.facet[facet].vertices;
  return static_cast<int>(std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin());
}

/// The cells at each vertex.
struct Stars {
  std::vector<int> first;  ///< of the cells of vertex v: first[v] … first[v + 1] − 1
  std::vector<int> cell;
};
template <int dim> Stars stars_of(const scene::Mesh<dim>& mesh);

/// Rigid motions about a vertex: translation, then rotations in the planes of Simplex::rotations; columns.
template <int dim>
using Motions = Eigen::Matrix<double, scene::Simplex<dim>::n_rigid_motions, Eigen::Dynamic, 0,
                              scene::Simplex<dim>::n_rigid_motions, scene::Simplex<dim>::n_rigid_motions>;

/// One star and its facets.
template <int dim> class Star {
 public:
  Star(const scene::Problem<dim>& problem, const Facets<dim>& facets, const Stars& stars, int vertex);

  int vertex() const { return vertex_; }
  const std::vector<int>& cells() const { return cells_; }
  /// Which corner of cell i the vertex is.
  int corner(std::size_t i) const { return corner_[i]; }
  /// The facets at the vertex, as numbers of Facets.
  const std::vector<int>& spokes() const { return spokes_; }
  /// The places in `spokes` of cell i's: of the facets of the cell but that opposite to the vertex, in their order.
  const std::array<int, dim>& spokes_of(std::size_t i) const { return cell_spokes_[i]; }
  /// The motions about the vertex that the supports of its spokes leave, rotations by the star's size.
  const Motions<dim>& motions() const { return motions_; }
  /// The boundary data of a spoke; null: it lies inside.
  const scene::FacetData<dim>* data(int spoke) const;
  double size() const { return size_; }
  /// The position of a spoke's vertices about the star's.
  std::array<scene::Vector<dim>, dim> arms(int spoke) const;

 private:
  const scene::Problem<dim>& problem_;
  const Facets<dim>& facets_;
  int vertex_;
  double size_ = 0;
  std::vector<int> cells_, corner_, spokes_;
  std::vector<std::array<int, dim>> cell_spokes_;
  Motions<dim> motions_;
};

/// What the loads on the spokes of a star's cells are to be.
template <int dim> struct StarData {
  using Spokes = Eigen::Matrix<double, n_spoke_loads<dim>, 1>;
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

  /// \param energy H of all cells of the mesh
  /// \throw NotDefinite
  StarSystem(const Star<dim>& star, const std::vector<Energy<dim>>& energy);
  /// What `sum` lacks of balance along Star::motions() is left on one spoke.
  Solution solve(const StarData<dim>& data) const;

 private:
  using Response = Eigen::Matrix<double, n_spoke_loads<dim>, n_spoke_loads<dim>>;
  using Forced = Eigen::Matrix<double, n_spoke_loads<dim>, scene::Simplex<dim>::n_rigid_motions>;
  using Block = Eigen::Matrix<double, n_facet_loads<dim>, n_facet_loads<dim>>;
  void set_form(std::size_t cell, const CellForm<dim>& energy);
  void assemble();
  template <class Rows> void make_tangential(int spoke, Rows&& rows) const;

  const Star<dim>& star_;
  std::vector<int> unknown_;                       ///< of each spoke; −1: on Γ_u
  std::vector<const scene::Vector<dim>*> normal_;  ///< of spokes on Γ_0
  std::vector<Response> response_;                 ///< D = response (μ − gradient) + forced · resultant
  std::vector<Forced> forced_;
  BlockCholesky<Block> matrix_;
};

}  // namespace bracket::dual
