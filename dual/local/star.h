// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dual/local/cell.h"

/// The star of a vertex: the cells at it, held together by their common facets, its spokes (docs/theory.md §12.2).
namespace bracket::dual {

/// What the facets of a mesh are.
template <int dim> struct Facets {
  struct Facet {
    std::array<int, dim> vertices;  ///< by increasing number
    scene::Support support;         ///< of the boundary
    int boundary = -1;              ///< index into Mesh::boundary; −1: inside
    scene::Vector<dim> normal;      ///< of the boundary: FacetData::normal
  };
  std::vector<Facet> facet;
  std::vector<scene::Vector<dim>> position;  ///< of the mesh's vertices
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

/// The displacement of a facet's vertices by rigid motions about a point, rotations by `size`.
/// \param x the vertices about that point
template <int dim>
Eigen::Matrix<double, n_facet_loads<dim>, scene::Simplex<dim>::n_rigid_motions> motions_of(
    const std::array<scene::Vector<dim>, dim>& x, double size);

/// Rigid motions about a vertex: translation, then rotations in the planes of Simplex::rotations; columns.
template <int dim>
using Motions = Eigen::Matrix<double, scene::Simplex<dim>::n_rigid_motions, Eigen::Dynamic, 0,
                              scene::Simplex<dim>::n_rigid_motions, scene::Simplex<dim>::n_rigid_motions>;

/// One star and its facets, which are kept by reference.
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
  const typename Facets<dim>::Facet& spoke(std::size_t i) const { return facets_.facet[spokes_[i]]; }
  double size() const { return size_; }
  /// The position of a spoke's vertices about the star's.
  std::array<scene::Vector<dim>, dim> arms(int spoke) const;

 private:
  const Facets<dim>& facets_;
  int vertex_;
  double size_ = 0;
  std::vector<int> cells_, corner_, spokes_;
  std::vector<std::array<int, dim>> cell_spokes_;
  Motions<dim> motions_;
};

/// The stars of all vertices, as numbers of these: in each group those that have no cell in common.
template <int dim>
std::vector<std::vector<int>> groups_apart(const scene::Mesh<dim>& mesh, const std::vector<Star<dim>>& stars);

}  // namespace bracket::dual
