// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>
#include <random>

#include "dual/uzawa.h"
#include "scene/voigt.h"

namespace bracket::dual {

namespace {

using scene::Problem;
using scene::Vector;

/// The number of each body's first multiplier, and of all.
std::vector<int> first_multipliers(const Layout& layout) {
  std::vector<int> first = {0};
  for (const auto& nodes : layout.body_nodes) first.push_back(first.back() + nodes.back());
  return first;
}

/// The normal traction is constrained by its values at the ends, not by its moments, so that p ≥ 0 can be projected on:
/// M⁻¹ for M = ∫ φ_i φ_j = l/6 (2 1; 1 2).
Eigen::Matrix2d ends_from_moments(double length) {
  Eigen::Matrix2d inverse;
  inverse << 2, -1, -1, 2;
  return 2 / length * inverse;
}

/// λ̄ takes the place of the cell's weight. \param prescribed displacements of its edges
template <int dim>
UzawaCell uzawa_cell(const Problem<dim>& problem, const Cell<1>& cell, int c, const LoadVector<1>& prescribed,
                     int first_multiplier, const scene::Stress<dim>& particular) {
  Corners linear;
  std::copy(particular.cell[c].begin(), particular.cell[c].end(), linear.begin());
  UzawaCell result{half_stiffness<1>(cell.compliance, cell.loads), cell.unknowns, prescribed, {}};
  result.linear = cell.compliance.matrixL().solve(
      coupling<1>(corners(problem.mesh, c), cell.piola, body_of(problem, c).material.compliance(), linear));
  for (int& multiplier : result.multipliers)
    if (multiplier >= 0) multiplier += first_multiplier;
  return result;
}

template <int dim> void take_ends_on_contact(const Problem<dim>& problem, std::vector<UzawaCell>& cells) {
  for (const auto& pair : problem.contact)
    for (const int side : {pair.first, pair.second}) {
      if (side < 0) continue;
      const auto& facet = problem.mesh.boundary[side];
      auto& loads = cells[facet.cell].loads;
      Eigen::Matrix<double, n_modes(1), 2> normal;
      for (int i = 0; i < 2; ++i) normal.col(i) = loads.col(4 * facet.local + 2 * i);
      normal *= ends_from_moments(scene::length(problem.mesh, pair.first));
      for (int i = 0; i < 2; ++i) loads.col(4 * facet.local + 2 * i) = normal.col(i);
    }
}

template <int dim>
std::vector<Opening> openings(const Problem<dim>& problem, const std::vector<UzawaCell>& cells,
                              const scene::Stress<dim>& particular) {
  const auto& mesh = problem.mesh;
  const Eigen::VectorXd gaps = moments(problem, 1, &scene::ContactFacet::upper);
  // A facet runs along its cell's edge: its vertex i is the end i.
  const auto multiplier = [&](const auto& facet, int end) {
    return cells[facet.cell].multipliers[4 * facet.local + 2 * end];
  };
  std::vector<Opening> result;
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const auto& pair = problem.contact[j];
    const auto& facet = mesh.boundary[pair.first];
    const Vector<dim>& n = problem.facets[pair.first].normal;
    for (int i = 0; i < 2; ++i) {
      const auto& stress = particular.cell[facet.cell][3 * facet.local + i];
      result.push_back({multiplier(facet, i), pair.second < 0 ? -1 : multiplier(mesh.boundary[pair.second], 1 - i),
                        gaps[2 * j + i], -n.dot(scene::traction<dim>(stress, n))});
    }
  }
  return result;
}

/// The edge displacements that belong to multipliers.
Eigen::VectorXd displacements(const UzawaSystem& system, const Eigen::VectorXd& multipliers) {
  Eigen::VectorXd u = system.scale.cwiseProduct(multipliers);
  for (const Opening& o : system.openings) u[o.first] = o.gap - u[o.first] - (o.second < 0 ? 0 : u[o.second]);
  return u;
}

/// What tractions do on displacements: jumps (D S) and, for openings, −p.
Eigen::VectorXd violation(const UzawaSystem& system, const Parameters& parameters) {
  Eigen::VectorXd jump = Eigen::VectorXd::Zero(system.scale.size());
  for (std::size_t c = 0; c < parameters.size(); ++c) {
    const UzawaCell& cell = system.cells[c];
    const LoadVector<1> loads = cell.loads.transpose() * parameters[c];
    for (int i = 0; i < n_loads(1); ++i)
      if (cell.multipliers[i] >= 0) jump[cell.multipliers[i]] -= loads[i];
  }
  for (const Opening& o : system.openings) {  // here `jump` is the pressure of τ
    if (o.second >= 0) jump[o.second] -= jump[o.first];
    jump[o.first] = -jump[o.first] - o.pressure;
  }
  return system.scale.cwiseProduct(jump);
}

/// The diagonal of B A⁻¹ Bᵀ before it is scaled.
Eigen::VectorXd diagonal(const UzawaSystem& system) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(system.scale.size());
  for (const UzawaCell& cell : system.cells)
    for (int i = 0; i < n_loads(1); ++i)
      if (cell.multipliers[i] >= 0) sum[cell.multipliers[i]] += cell.loads.col(i).squaredNorm();
  for (const Opening& o : system.openings)
    if (o.second >= 0) sum[o.second] += sum[o.first];
  return sum;
}

}  // namespace

template <int dim>
UzawaSystem uzawa_system(const Problem<dim>& problem, const Layout& layout, const std::vector<Cell<1>>& cells,
                         const scene::Stress<dim>& particular) {
  const std::vector<int> first = first_multipliers(layout);
  const std::vector<LoadVector<1>> prescribed = prescribed_displacements<1>(problem);
  UzawaSystem system;
  for (std::size_t c = 0; c < cells.size(); ++c)
    system.cells.push_back(uzawa_cell(problem, cells[c], static_cast<int>(c),
                                      prescribed.empty() ? LoadVector<1>::Zero() : prescribed[c],
                                      first[problem.mesh.cell_component[c]], particular));
  take_ends_on_contact(problem, system.cells);
  system.openings = openings(problem, system.cells, particular);
  system.scale = Eigen::VectorXd::Ones(first.back());
  system.scale = diagonal(system).cwiseSqrt().cwiseInverse();
  return system;
}

double uzawa_step(const UzawaSystem& system) {
  UzawaSystem homogeneous = system;
  for (UzawaCell& cell : homogeneous.cells) {
    cell.prescribed.setZero();
    cell.linear.setZero();
  }
  for (Opening& opening : homogeneous.openings) opening.gap = opening.pressure = 0;
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  Eigen::VectorXd z = Eigen::VectorXd::NullaryExpr(system.scale.size(), [&] { return normal(generator); });
  double eigenvalue = 0;
  for (int k = 0; k < 100; ++k) {
    z.normalize();
    const Eigen::VectorXd image = -violation(homogeneous, parameters(homogeneous, z));
    eigenvalue = z.dot(image);
    z = image;
  }
  return 1.8 / eigenvalue;
}

Parameters parameters(const UzawaSystem& system, const Eigen::VectorXd& multipliers) {
  const Eigen::VectorXd u = displacements(system, multipliers);
  Parameters result;
  result.reserve(system.cells.size());
  for (const UzawaCell& cell : system.cells) {
    LoadVector<1> own = cell.prescribed;
    for (int i = 0; i < n_loads(1); ++i)
      if (cell.multipliers[i] >= 0) own[i] = u[cell.multipliers[i]];
    result.push_back(cell.loads * own - cell.linear);
  }
  return result;
}

Eigen::VectorXd next_multipliers(const UzawaSystem& system, const Eigen::VectorXd& multipliers,
                                 const Parameters& parameters, double step) {
  Eigen::VectorXd next = multipliers + step * violation(system, parameters);
  for (const Opening& o : system.openings) next[o.first] = std::max(0.0, next[o.first]);
  return next;
}

template UzawaSystem uzawa_system(const Problem<2>&, const Layout&, const std::vector<Cell<1>>&,
                                  const scene::Stress<2>&);

}  // namespace bracket::dual
