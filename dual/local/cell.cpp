// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/local/cell.h"

#include <limits>
#include <optional>

#include "scene/parallel.h"

namespace bracket::dual {

namespace {

template <int dim> inline constexpr int n_motions = scene::Simplex<dim>::n_rigid_motions;

/// −H⁻¹, facet by facet; nothing: H is not definite in floating point.
template <int dim, int lanes> std::optional<CellForm<dim>> negative_inverse(CellForm<dim> form) {
  using Block = FacetBlock<dim>;
  for (int p = 0; p <= dim; ++p) {
    Block pivot = form.at(p, p);
    if (!factorise(pivot)) return {};
    Block root = Block::Identity();  // L⁻ᵀ
    divide<lanes>(root, pivot);
    std::array<Block, dim + 1> column, solved;
    form.at(p, p).setZero();
    subtract_product<lanes>(form.at(p, p), root, root);
    for (int i = 0; i <= dim; ++i) {
      if (i == p) continue;
      column[i] = form.rows_of(i, p);
      solved[i].setZero();
      subtract_product<lanes>(solved[i], column[i], form.at(p, p));
    }
    for (int i = 0; i <= dim; ++i)
      for (int k = 0; k <= i && i != p; ++k)
        if (k != p) subtract_product<lanes>(form.at(i, k), solved[i], column[k]);
    for (int i = 0; i <= dim; ++i) {
      if (i > p) form.at(i, p) = solved[i];
      if (i < p) form.at(p, i) = solved[i].transpose();
    }
  }
  return form;
}

/// k = H⁻¹ − H⁻¹ Rᵀ (R H⁻¹ Rᵀ)⁻¹ R H⁻¹, R the resultants of the loads.
template <int dim, int lanes>
CellForm<dim> stiffness_of(const scene::Mesh<dim>& mesh, int cell, const CellForm<dim>& energy) {
  constexpr int one = n_facet_loads<dim>, m = n_motions<dim>, n = n_cell_loads<dim>;
  CellForm<dim> result;
  const std::optional<CellForm<dim>> negative = negative_inverse<dim, lanes>(energy);
  if (!negative) {
    for (auto& block : result.block) block.setConstant(std::numeric_limits<double>::quiet_NaN());
    return result;
  }
  const auto& vertices = mesh.cells[cell];
  Eigen::Matrix<double, m, n> balance;
  for (int i = 0; i <= dim; ++i) {
    std::array<scene::Vector<dim>, dim> x;
    const auto corners = sorted_corners<dim>(vertices, i);
    for (int k = 0; k < dim; ++k) x[k] = mesh.vertices[vertices[corners[k]]] - mesh.vertices[vertices[0]];
    balance.template middleCols<one>(one * i) = resultants<dim>(x);
  }
  Eigen::Matrix<double, n, m> lifted = Eigen::Matrix<double, n, m>::Zero();  // H⁻¹ Rᵀ, then by the root of R H⁻¹ Rᵀ
  for (int i = 0; i <= dim; ++i)
    for (int k = 0; k <= dim; ++k)
      lifted.template middleRows<one>(one * i) -=
          negative->rows_of(i, k).lazyProduct(balance.template middleCols<one>(one * k).transpose());
  Eigen::Matrix<double, m, m> root = balance.lazyProduct(lifted);
  if (!factorise(root)) root.setConstant(std::numeric_limits<double>::quiet_NaN());
  for (int j = 0; j < m; ++j) {
    for (int k = 0; k < j; ++k) lifted.col(j) -= root(j, k) * lifted.col(k);
    lifted.col(j) *= root(j, j);
  }
  for (int i = 0; i <= dim; ++i)
    for (int k = 0; k <= i; ++k) {
      result.at(i, k) = -negative->at(i, k);
      subtract_product<lanes>(result.at(i, k), &lifted(one * i, 0), &lifted(one * k, 0), m, n);
    }
  return result;
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

/// With U the root of the compliance, twice the energy are the squares of U t, t the stress of each part at each
/// vertex, of U times the sum of these and of that at the centroid, and once for all parts of that at the centroid
/// [docs/theory.md §12.1]. A load acts on the parts at its own vertex, and on the centroid.
template <int dim> Energy<dim> energy_of(const scene::Problem<dim>& problem, int cell) {
  constexpr int n = n_cell_loads<dim>, one = n_facet_loads<dim>, m = scene::n_voigt<dim>, rows = (dim + 2) * m;
  using Tensor = scene::Voigt<dim>;
  const auto& vertices = problem.mesh.cells[cell];
  const auto geometry = geometry_of(problem.mesh, cell);
  const double volume = geometry.scaled_volume / (dim == 2 ? 2 : 6);
  const Eigen::LLT<scene::Elasticity<dim>> llt(volume / ((dim + 1) * (dim + 1) * (dim + 2)) *
                                               body_of(problem, cell).material.compliance());
  const scene::Elasticity<dim> root = llt.matrixU();
  const auto by_root = [&](const scene::TensorOf<dim, double>& tensor) {
    return Tensor(root.lazyProduct(Eigen::Map<const Tensor>(tensor.data())));
  };

  // Of unit loads: of the parts, [a] at facet Simplex::facets[j][a], at the load's vertex j.
  std::array<std::array<Tensor, dim>, n> at_vertex;
  std::array<int, n> vertex_of;
  // Of unit loads and body forces: of the parts, then at the centroid.
  Eigen::Matrix<double, n + dim, rows> sums;
  const auto set_centre = [&](int q, const std::array<scene::VectorOf<dim, double>, dim + 1>& w) {
    const Tensor centre = by_root(scene::centre_stress<dim, double>(geometry, w));
    for (int part = 0; part <= dim; ++part) sums.row(q).template segment<m>(m * part) = centre;
    sums.row(q).template segment<m>(m * (dim + 1)) = std::sqrt(dim + 1.0) * centre;
  };
  for (int i = 0; i <= dim; ++i) {
    const auto corners = sorted_corners<dim>(vertices, i);
    for (int slot = 0; slot < dim; ++slot) {
      const int j = corners[slot];
      const auto& others = scene::Simplex<dim>::facets[j];
      const int place = scene::block::place_on_facet<dim>(j, i);
      for (int c = 0; c < dim; ++c) {
        const int q = one * i + dim * slot + c;
        vertex_of[q] = j;
        scene::CornerLoads<dim, double> load = {};
        load[place][c] = 1;
        const auto parts = scene::corner_stress<dim, double>(geometry, j, load);
        std::array<scene::VectorOf<dim, double>, dim + 1> w = {};
        for (int a = 0; a < dim; ++a)
          w[others[a]] = scene::share_in_centre<dim, double>(geometry, others[a], j, parts[a]);
        set_centre(q, w);
        for (int a = 0; a < dim; ++a) {
          at_vertex[q][a] = by_root(parts[a]);
          sums.row(q).template segment<m>(m * others[a]) += at_vertex[q][a];
        }
      }
    }
  }
  for (int c = 0; c < dim; ++c) {
    std::array<scene::VectorOf<dim, double>, dim + 1> w = {};
    for (auto& of_part : w) of_part[c] = -1;
    set_centre(n + c, w);
  }

  Energy<dim> energy;
  in_lanes([&](auto lanes) {
    for (int i = 0; i <= dim; ++i)
      for (int k = 0; k <= i; ++k) {
        FacetBlock<dim>& block = energy.loads.at(i, k);
        block.setZero();
        subtract_product<lanes>(block, &sums(one * i, 0), &sums(one * k, 0), rows, n + dim);
        block = -block;
      }
  });
  for (int i = 0; i <= dim; ++i)
    for (int k = 0; k <= i; ++k) {
      FacetBlock<dim>& block = energy.loads.at(i, k);
      for (int a = 0; a < one; ++a)
        for (int b = 0; b < one; ++b) {
          const int q = one * i + a, r = one * k + b;
          for (int part = 0; part < dim && vertex_of[q] == vertex_of[r]; ++part)
            block(a, b) += at_vertex[q][part].dot(at_vertex[r][part]);
        }
    }
  energy.by_body_force = sums.template topRows<n>().lazyProduct(sums.template bottomRows<dim>().transpose());
  energy.stiffness = in_lanes([&](auto lanes) { return stiffness_of<dim, lanes>(problem.mesh, cell, energy.loads); });
  return energy;
}

template <int dim> Energies<dim> energies_of(const scene::Problem<dim>& problem) {
  Energies<dim> energies(problem.mesh.cells.size());
  scene::for_each_index(static_cast<int>(energies.size()), [&](int c) { energies[c] = energy_of(problem, c); });
  return energies;
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
  template Energies<dim> energies_of(const scene::Problem<dim>&);                                                \
  template Eigen::Matrix<double, dim, dim> hat_masses<dim>();                                                    \
  template Eigen::Matrix<double, scene::Simplex<dim>::n_rigid_motions, n_facet_loads<dim>> resultants<dim>(      \
      const std::array<scene::Vector<dim>, dim>&);                                                               \
  template const std::array<Eigen::Matrix<double, dim, dim>, std::size_t{dim}>& share_of_vertex<dim>();
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::dual
