// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/local/cell.h"

namespace bracket::dual {

namespace {

/// All coefficients of a block stress, weighted such that the squares of U times them add up to twice the energy
/// [docs/theory.md §12], U the root of the compliance: of each part those at the facet's vertices and the sum of all,
/// and once for all parts that at the centroid.
template <int dim> inline constexpr int n_energy_rows = ((dim + 1) * (dim + 1) + 1) * scene::n_voigt<dim>;
template <int dim>
Eigen::Matrix<double, n_energy_rows<dim>, 1> energy_rows(const scene::BalancedStress<dim, double>& stress) {
  constexpr int n = scene::n_voigt<dim>;
  using Tensor = Eigen::Map<const scene::Voigt<dim>>;
  Eigen::Matrix<double, n_energy_rows<dim>, 1> rows;
  int row = 0;
  for (const auto& part : stress) {
    scene::Voigt<dim> sum = Tensor(part[dim].data());
    for (int k = 0; k < dim; ++k, row += n) {
      rows.template segment<n>(row) = Tensor(part[k].data());
      sum += Tensor(part[k].data());
    }
    rows.template segment<n>(row) = sum;
    row += n;
  }
  rows.template segment<n>(row) = std::sqrt(dim + 1.0) * Tensor(stress[0][dim].data());
  return rows;
}

}  // namespace

template <int dim>
scene::BalancedStress<dim, double> stress_of(const std::array<int, dim + 1>& vertices,
                                             const scene::BlockGeometry<dim, double>& geometry,
                                             const CellVector<dim>& loads, const scene::Vector<dim>& force) {
  scene::FacetLoads<dim, double> f;
  for (int i = 0; i <= dim; ++i) {
    const auto corners = sorted_corners<dim>(vertices, i);
    for (int slot = 0; slot < dim; ++slot)
      for (int c = 0; c < dim; ++c)
        f[i][scene::block::place_on_facet<dim>(i, corners[slot])][c] = loads[n_facet_loads<dim> * i + dim * slot + c];
  }
  scene::VectorOf<dim, double> F;
  for (int c = 0; c < dim; ++c) F[c] = force[c];
  return scene::balanced_stress<dim, double>(geometry, f, F);
}

template <int dim> Energy<dim> energy_of(const scene::Problem<dim>& problem, int cell) {
  constexpr int n = n_cell_loads<dim>, m = scene::n_voigt<dim>, rows = n_energy_rows<dim>;
  const auto& vertices = problem.mesh.cells[cell];
  const auto geometry = geometry_of(problem.mesh, cell);
  Eigen::Matrix<double, rows, n + dim> of_unit;
  for (int i = 0; i < n; ++i)
    of_unit.col(i) =
        energy_rows<dim>(stress_of<dim>(vertices, geometry, CellVector<dim>::Unit(i), scene::Vector<dim>::Zero()));
  for (int c = 0; c < dim; ++c)
    of_unit.col(n + c) =
        energy_rows<dim>(stress_of<dim>(vertices, geometry, CellVector<dim>::Zero(), scene::Vector<dim>::Unit(c)));
  const double volume = geometry.scaled_volume / (dim == 2 ? 2 : 6);
  const Eigen::LLT<scene::Elasticity<dim>> root(volume / ((dim + 1) * (dim + 1) * (dim + 2)) *
                                                body_of(problem, cell).material.compliance());
  const scene::Elasticity<dim> upper = root.matrixU();
  for (int row = 0; row < rows; row += m)
    of_unit.template middleRows<m>(row) =
        (upper.template triangularView<Eigen::Upper>() * of_unit.template middleRows<m>(row)).eval();
  Energy<dim> energy;
  energy.loads.noalias() = of_unit.template leftCols<n>().transpose() * of_unit.template leftCols<n>();
  energy.by_body_force.noalias() = of_unit.template leftCols<n>().transpose() * of_unit.template rightCols<dim>();
  return energy;
}

template <int dim> Eigen::Matrix<double, dim, dim> hat_masses() {
  Eigen::Matrix<double, dim, dim> masses;
  for (int i = 0; i < dim; ++i)
    for (int k = 0; k < dim; ++k) masses(i, k) = (i == k ? 2.0 : 1.0) / (dim * (dim + 1));
  return masses;
}

template <int dim>
Eigen::Matrix<double, scene::Simplex<dim>::n_rigid_motions, n_facet_loads<dim>> resultants(
    const std::array<scene::Vector<dim>, dim>& x) {
  using Table = scene::Simplex<dim>;
  Eigen::Matrix<double, Table::n_rigid_motions, n_facet_loads<dim>> result;
  result.setZero();
  const Eigen::Matrix<double, dim, dim> masses = hat_masses<dim>();
  for (int j = 0; j < dim; ++j) {
    scene::Vector<dim> arm = scene::Vector<dim>::Zero();  // ∫ ψ_j x
    for (int k = 0; k < dim; ++k) arm += masses(j, k) * x[k];
    for (int c = 0; c < dim; ++c) result(c, dim * j + c) = 1.0 / dim;
    for (int r = 0; r < Table::n_rotations; ++r) {
      const auto [a, b] = Table::rotations[r];
      result(dim + r, dim * j + a) = -arm[b];
      result(dim + r, dim * j + b) = arm[a];
    }
  }
  return result;
}

template <int dim> const std::array<Eigen::Matrix<double, dim, dim>, std::size_t{dim}>& share_of_vertex() {
  static const auto shares = [] {
    std::array<Eigen::Matrix<double, dim, dim>, dim> result;
    const Eigen::Matrix<double, dim, dim> inverse = hat_masses<dim>().inverse();
    for (int a = 0; a < dim; ++a) {
      Eigen::Matrix<double, dim, dim> moments;  // ∫ ψ_a ψ_j ψ_k by the area: n! Π α! / (n + 3)!, n = dim − 1
      for (int j = 0; j < dim; ++j)
        for (int k = 0; k < dim; ++k) {
          const int equal = (a == j) + (a == k) + (j == k);
          moments(j, k) = (equal == 3 ? 6.0 : equal == 1 ? 2.0 : 1.0) / (dim * (dim + 1) * (dim + 2));
        }
      result[a] = inverse * moments;
    }
    return result;
  }();
  return shares;
}

#define INSTANTIATE(dim)                                                                                         \
  template scene::BalancedStress<dim, double> stress_of<dim>(const std::array<int, dim + 1>&,                    \
                                                             const scene::BlockGeometry<dim, double>&,           \
                                                             const CellVector<dim>&, const scene::Vector<dim>&); \
  template Energy<dim> energy_of(const scene::Problem<dim>&, int);                                               \
  template Eigen::Matrix<double, dim, dim> hat_masses<dim>();                                                    \
  template Eigen::Matrix<double, scene::Simplex<dim>::n_rigid_motions, n_facet_loads<dim>> resultants<dim>(      \
      const std::array<scene::Vector<dim>, dim>&);                                                               \
  template const std::array<Eigen::Matrix<double, dim, dim>, std::size_t{dim}>& share_of_vertex<dim>();
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::dual
