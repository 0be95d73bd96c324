// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/large_array.h"
#include "dual/local/small_blocks.h"
#include "scene/balanced_block.h"
#include "scene/scene.h"

/// Cells by the loads on their facets, and what a load on one of them does, over any dimension.
namespace bracket::dual {

/// Loads linear on a facet: load density times length or area at its vertices, which are counted from the lowest number
/// to the highest, component by component. So both cells at a facet have one order.
template <int dim> inline constexpr int n_facet_loads = dim* dim;
template <int dim> inline constexpr int n_cell_loads = (dim + 1) * n_facet_loads<dim>;
/// Those of the facets at one vertex of the cell, its spokes.
template <int dim> inline constexpr int n_spoke_loads = dim* n_facet_loads<dim>;

template <int dim> using FacetVector = Eigen::Matrix<double, n_facet_loads<dim>, 1>;
template <int dim> using CellVector = Eigen::Matrix<double, n_cell_loads<dim>, 1>;
template <int dim> using FacetBlock = Eigen::Matrix<double, n_facet_loads<dim>, n_facet_loads<dim>>;

/// A symmetric form of the loads on n facets, facet by facet.
template <int dim, int n> struct FacetForm {
  std::array<FacetBlock<dim>, std::size_t{n * (n + 1) / 2}> block;  ///< see at()

  /// Rows of facet i, columns of facet k. \pre k ≤ i
  FacetBlock<dim>& at(int i, int k) { return block[i * (i + 1) / 2 + k]; }
  const FacetBlock<dim>& at(int i, int k) const { return block[i * (i + 1) / 2 + k]; }
  /// The same for any two of them.
  FacetBlock<dim> rows_of(int i, int k) const { return k <= i ? at(i, k) : FacetBlock<dim>(at(k, i).transpose()); }
};
template <int dim> using CellForm = FacetForm<dim, dim + 1>;

template <int dim> using SpokeVector = Eigen::Matrix<double, n_spoke_loads<dim>, 1>;
/// The loads on all facets but that opposite to a vertex; and the other way round, with none on that.
template <int dim> SpokeVector<dim> on_spokes(int corner, const CellVector<dim>& loads) {
  constexpr int one = n_facet_loads<dim>;
  SpokeVector<dim> result;
  result.head(one * corner) = loads.head(one * corner);
  result.tail(one * (dim - corner)) = loads.tail(one * (dim - corner));
  return result;
}
template <int dim> CellVector<dim> on_cell(int corner, const SpokeVector<dim>& loads) {
  constexpr int one = n_facet_loads<dim>;
  CellVector<dim> result;
  result.head(one * corner) = loads.head(one * corner);
  result.template segment<one>(one * corner).setZero();
  result.tail(one * (dim - corner)) = loads.tail(one * (dim - corner));
  return result;
}

/// The facets of a cell but that opposite to a vertex, in their order.
constexpr int facet_at(int corner, int i) { return i < corner ? i : i + 1; }
/// Of a form of a cell's loads the rows of the facets at a vertex, by loads on these alone.
template <int dim> SpokeVector<dim> times(const CellForm<dim>& form, int corner, const SpokeVector<dim>& x) {
  constexpr int one = n_facet_loads<dim>;
  SpokeVector<dim> result = SpokeVector<dim>::Zero();
  for (int i = 0; i < dim; ++i)
    for (int k = 0; k <= i; ++k) {
      const FacetBlock<dim>& block = form.at(facet_at(corner, i), facet_at(corner, k));
      const FacetVector<dim> own = x.template segment<one>(one * i), other = x.template segment<one>(one * k);
      result.template segment<one>(one * i) += times(block, other);
      if (k < i) result.template segment<one>(one * k) += transposed_times(block, own);
    }
  return result;
}
/// Of these rows what loads on the facet opposite add.
template <int dim>
void add_by_opposite(const CellForm<dim>& form, int corner, const FacetVector<dim>& opposite, SpokeVector<dim>& to) {
  constexpr int one = n_facet_loads<dim>;
  for (int i = 0; i < dim; ++i) {
    const int facet = facet_at(corner, i);
    to.template segment<one>(one * i) +=
        facet > corner ? times(form.at(facet, corner), opposite) : transposed_times(form.at(corner, facet), opposite);
  }
}
/// The rows of the facet opposite, by loads on the others.
template <int dim> FacetVector<dim> opposite_times(const CellForm<dim>& form, int corner, const SpokeVector<dim>& x) {
  constexpr int one = n_facet_loads<dim>;
  FacetVector<dim> result = FacetVector<dim>::Zero();
  for (int i = 0; i < dim; ++i) {
    const int facet = facet_at(corner, i);
    const FacetVector<dim> own = x.template segment<one>(one * i);
    result += facet > corner ? transposed_times(form.at(facet, corner), own) : times(form.at(corner, facet), own);
  }
  return result;
}
/// The rows of the facets at a vertex, by loads on all.
template <int dim> SpokeVector<dim> times(const CellForm<dim>& form, int corner, const CellVector<dim>& x) {
  constexpr int one = n_facet_loads<dim>;
  SpokeVector<dim> result = times(form, corner, on_spokes<dim>(corner, x));
  add_by_opposite<dim>(form, corner, x.template segment<one>(one * corner), result);
  return result;
}

/// A stress or the like, linear on a cell: at its vertices.
template <int dim> using LinearStress = std::array<scene::Voigt<dim>, dim + 1>;

/// The vertices of facet i of a cell, as places in the cell, by increasing number.
template <int dim>
std::array<int, std::size_t{dim}> sorted_corners(const std::array<int, dim + 1>& vertices, int facet) {
  std::array<int, dim> corners = scene::Simplex<dim>::facets[facet];
  std::sort(corners.begin(), corners.end(), [&](int a, int b) { return vertices[a] < vertices[b]; });
  return corners;
}

template <int dim> scene::BlockGeometry<dim, double> geometry_of(const scene::Mesh<dim>& mesh, int cell) {
  std::array<scene::VectorOf<dim, double>, dim + 1> x;
  const scene::Vector<dim>& origin = mesh.vertices[mesh.cells[cell][0]];
  for (int i = 0; i <= dim; ++i) {
    const scene::Vector<dim> arm = mesh.vertices[mesh.cells[cell][i]] - origin;
    for (int c = 0; c < dim; ++c) x[i][c] = arm[c];
  }
  return scene::block_geometry<dim, double>(x);
}

/// The stress of a block element by its loads and a body force.
template <int dim>
scene::BalancedStress<dim, double> stress_of(const std::array<int, dim + 1>& vertices,
                                             const scene::BlockGeometry<dim, double>& geometry,
                                             const CellVector<dim>& loads, const scene::Vector<dim>& force);

/// The energy of stresses in terms of the loads: ½ ∫ λ : C⁻¹ λ = ½ Lᵀ H L + Lᵀ B F + …
template <int dim> struct Energy {
  CellForm<dim> loads;      ///< H, positive definite
  CellForm<dim> stiffness;  ///< k: L = k μ has the least ½ Lᵀ H L − μᵀ L that loads
                            ///< in balance have; not numbers where H is singular
  Eigen::Matrix<double, n_cell_loads<dim>, dim> by_body_force;  ///< B
};
template <int dim> using Energies = contact::LargeArray<Energy<dim>>;
template <int dim> Energy<dim> energy_of(const scene::Problem<dim>& problem, int cell);
template <int dim> Energies<dim> energies_of(const scene::Problem<dim>& problem);  ///< of all cells

/// Facet loads by the force and the moments about the origin in the planes of Simplex::rotations that they are.
/// \param x the vertices of the facet
template <int dim>
Eigen::Matrix<double, scene::Simplex<dim>::n_rigid_motions, n_facet_loads<dim>> resultants(
    const std::array<scene::Vector<dim>, dim>& x);

/// ∫ ψ_k t over a facet: the moments of a linear load f = t · area are moments · f; of scalars.
template <int dim> Eigen::Matrix<double, dim, dim> hat_masses();

/// The L2 projection of ψ_a t on linear functions, by that of t: for vertex a of the facet.
template <int dim> const std::array<Eigen::Matrix<double, dim, dim>, std::size_t{dim}>& share_of_vertex();

/// f at the vertices by what `share` says of scalars.
template <int dim> FacetVector<dim> applied(const Eigen::Matrix<double, dim, dim>& share, const FacetVector<dim>& f) {
  FacetVector<dim> result;
  using Table = Eigen::Matrix<double, dim, dim>;  // columns: vertices
  Eigen::Map<Table>(result.data()) = Eigen::Map<const Table>(f.data()) * share.transpose();
  return result;
}

}  // namespace bracket::dual
