// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/local/smoothed.h"

#include <map>
#include <optional>

#include "scene/parallel.h"
#include "scene/voigt.h"

namespace bracket::dual {

namespace {

using scene::Problem;
using scene::Vector;
using scene::Voigt;

/// σ of a displacement at the vertices of a cell.
template <int dim>
LinearStress<dim> stress_at_vertices(const Problem<dim>& problem, const scene::Displacement<dim>& u, int cell) {
  const auto& mesh = problem.mesh;
  const auto G = scene::hat_gradients<dim>(scene::positions(mesh, mesh.cells[cell]));
  LinearStress<dim> result;
  for (int k = 0; k <= dim; ++k) {
    Eigen::Matrix<double, dim, dim> slope = Eigen::Matrix<double, dim, dim>::Zero();
    const bool quadratic = u.degree == 2;
    for (int a = 0; a <= dim; ++a)
      slope += (quadratic ? (a == k ? 3.0 : -1.0) : 1.0) * u.vertex[mesh.cells[cell][a]] * G[a].transpose();
    for (int e = 0; quadratic && e < scene::Simplex<dim>::n_edges; ++e) {
      const auto [a, b] = scene::Simplex<dim>::edges[e];
      if (a != k && b != k) continue;
      slope += 4 * u.edge[mesh.cell_edges[cell][e]] * G[a == k ? b : a].transpose();
    }
    result[k] = body_of(problem, cell).material.stiffness() * scene::strain<dim>(slope);
  }
  return result;
}

template <int dim> double mean_of_diagonal(const Voigt<dim>& s) { return s.template head<dim>().sum() / dim; }

/// The value at a vertex of the affine function that is closest to the mean pressures of cells; none: they do not
/// determine one.
template <int dim>
std::optional<double> fitted(const Problem<dim>& problem, const std::vector<int>& cells, int vertex, double size,
                             const std::vector<double>& pressure) {
  if (cells.size() <= dim) return {};
  Eigen::Matrix<double, Eigen::Dynamic, dim + 1> rows(cells.size(), dim + 1);
  Eigen::VectorXd values(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Vector<dim> arm = Vector<dim>::Zero();
    for (const int v : problem.mesh.cells[cells[i]]) arm += problem.mesh.vertices[v] - problem.mesh.vertices[vertex];
    rows.row(i) << 1, arm.transpose() / ((dim + 1) * size);
    values[i] = pressure[cells[i]];
  }
  Eigen::ColPivHouseholderQR<Eigen::Matrix<double, Eigen::Dynamic, dim + 1>> qr(rows);
  qr.setThreshold(1e-6);  // centroids that nearly lie in one plane tell nothing of the slope across it
  if (qr.rank() <= dim) return {};
  return qr.solve(values)[0];
}

/// The cells of a star's body, and those next to them where they are few.
template <int dim>
std::vector<int> cells_around(const Problem<dim>& problem, const std::vector<Star<dim>>& stars,
                              const std::vector<int>& own, int body) {
  constexpr std::size_t few = dim == 2 ? 6 : 12;
  if (own.size() >= few) return own;
  std::vector<int> wider;
  for (const int c : own)
    for (const int v : problem.mesh.cells[c])
      for (const int other : stars[v].cells())
        if (problem.mesh.cell_body[other] == body) wider.push_back(other);
  std::sort(wider.begin(), wider.end());
  wider.erase(std::unique(wider.begin(), wider.end()), wider.end());
  return wider;
}

}  // namespace

template <int dim>
std::vector<LinearStress<dim>> smoothed(const Problem<dim>& problem, const std::vector<Star<dim>>& stars,
                                        const scene::Displacement<dim>& displacement) {
  const auto& mesh = problem.mesh;
  const int n = static_cast<int>(mesh.cells.size());
  std::vector<LinearStress<dim>> own(n), result(n);
  std::vector<double> pressure(n);
  scene::for_each_index(n, [&](int c) {
    own[c] = stress_at_vertices(problem, displacement, c);
    pressure[c] = 0;
    for (const auto& s : own[c]) pressure[c] += mean_of_diagonal<dim>(s) / (dim + 1);
  });
  scene::for_each_index(static_cast<int>(stars.size()), [&](int v) {
    std::map<int, std::vector<int>> of_body;
    for (const int c : stars[v].cells()) of_body[mesh.cell_body[c]].push_back(c);
    for (const auto& [body, cells] : of_body) {
      Voigt<dim> sum = Voigt<dim>::Zero();
      double volume = 0;
      const auto corner = [&](int c) {
        return std::find(mesh.cells[c].begin(), mesh.cells[c].end(), v) - mesh.cells[c].begin();
      };
      for (const int c : cells) {
        sum += scene::volume(mesh, c) * own[c][corner(c)];
        volume += scene::volume(mesh, c);
      }
      Voigt<dim> value = sum / volume;
      const auto fit = fitted(problem, cells_around(problem, stars, cells, body), v, stars[v].size(), pressure);
      if (fit) value.template head<dim>().array() += *fit - mean_of_diagonal<dim>(value);
      for (const int c : cells) result[c][corner(c)] = value;
    }
  });
  return result;
}

#define INSTANTIATE(dim)                                                                               \
  template std::vector<LinearStress<dim>> smoothed(const Problem<dim>&, const std::vector<Star<dim>>&, \
                                                   const scene::Displacement<dim>&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::dual
