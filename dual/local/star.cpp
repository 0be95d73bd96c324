// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/local/star.h"

#include <limits>

namespace bracket::dual {

namespace {

using scene::Support;
using scene::Vector;

}  // namespace

template <int dim>
Eigen::Matrix<double, n_facet_loads<dim>, scene::Simplex<dim>::n_rigid_motions> motions_of(
    const std::array<Vector<dim>, dim>& x, double size) {
  using Table = scene::Simplex<dim>;
  Eigen::Matrix<double, n_facet_loads<dim>, Table::n_rigid_motions> result;
  result.setZero();
  for (int j = 0; j < dim; ++j) {
    result.template block<dim, dim>(dim * j, 0).setIdentity();
    for (int r = 0; r < Table::n_rotations; ++r) {
      const auto [a, b] = Table::rotations[r];
      result(dim * j + a, dim + r) = -x[j][b] / size;
      result(dim * j + b, dim + r) = x[j][a] / size;
    }
  }
  return result;
}

template <int dim> Facets<dim> facets_of(const scene::Problem<dim>& problem) {
  const auto& mesh = problem.mesh;
  Facets<dim> facets;
  facets.facet.resize(n_facets(mesh));
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int i = 0; i <= dim; ++i) {
      auto& vertices = facets.facet[cell_facets(mesh, static_cast<int>(c))[i]].vertices;
      const auto corners = sorted_corners<dim>(mesh.cells[c], i);
      for (int k = 0; k < dim; ++k) vertices[k] = mesh.cells[c][corners[k]];
    }
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    auto& facet = facets.facet[cell_facets(mesh, mesh.boundary[f].cell)[mesh.boundary[f].local]];
    facet.boundary = static_cast<int>(f);
    facet.support = problem.facets[f].support;
    facet.normal = problem.facets[f].normal;
  }
  facets.position = mesh.vertices;
  return facets;
}

template <int dim> Stars stars_of(const scene::Mesh<dim>& mesh) {
  Stars stars;
  stars.first.assign(mesh.vertices.size() + 1, 0);
  for (const auto& cell : mesh.cells)
    for (const int v : cell) ++stars.first[v + 1];
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) stars.first[v + 1] += stars.first[v];
  stars.cell.resize(stars.first.back());
  std::vector<int> next(stars.first.begin(), stars.first.end() - 1);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const int v : mesh.cells[c]) stars.cell[next[v]++] = static_cast<int>(c);
  return stars;
}

template <int dim>
Star<dim>::Star(const scene::Problem<dim>& problem, const Facets<dim>& facets, const Stars& stars, int vertex)
    : facets_(facets), vertex_(vertex) {
  const auto& mesh = problem.mesh;
  const Vector<dim>& centre = mesh.vertices[vertex];
  cells_.assign(stars.cell.begin() + stars.first[vertex], stars.cell.begin() + stars.first[vertex + 1]);
  for (const int c : cells_) {
    const auto& vertices = mesh.cells[c];
    corner_.push_back(static_cast<int>(std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin()));
    for (const int v : vertices) size_ = std::max(size_, (mesh.vertices[v] - centre).norm());
    for (int i = 0; i <= dim; ++i)
      if (i != corner_.back()) spokes_.push_back(cell_facets(mesh, c)[i]);
  }
  std::sort(spokes_.begin(), spokes_.end());
  spokes_.erase(std::unique(spokes_.begin(), spokes_.end()), spokes_.end());
  bool held = false;
  std::vector<Eigen::Matrix<double, 1, scene::Simplex<dim>::n_rigid_motions>> slides;
  for (const int f : spokes_) {
    const auto& facet = facets.facet[f];
    if (facet.boundary < 0) continue;
    held = held || facet.support == Support::fixed;
    if (facet.support != Support::sliding) continue;
    std::array<Vector<dim>, dim> x;
    for (int k = 0; k < dim; ++k) x[k] = mesh.vertices[facet.vertices[k]] - centre;
    const auto moved = motions_of<dim>(x, size_);
    for (int k = 0; k < dim; ++k) slides.push_back(facet.normal.transpose() * moved.template middleRows<dim>(dim * k));
  }
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    std::array<int, dim> own;
    for (int k = 0, place = 0; k <= dim; ++k) {
      if (k == corner_[i]) continue;
      const int f = cell_facets(mesh, cells_[i])[k];
      own[place++] = static_cast<int>(std::lower_bound(spokes_.begin(), spokes_.end(), f) - spokes_.begin());
    }
    cell_spokes_.push_back(own);
  }
  constexpr int m = scene::Simplex<dim>::n_rigid_motions;
  if (held) {
    motions_.resize(m, 0);
  } else if (slides.empty()) {
    motions_ = Motions<dim>::Identity(m, m);
  } else {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(std::max<std::size_t>(m, slides.size()), m);
    for (std::size_t i = 0; i < slides.size(); ++i) rows.row(i) = slides[i];
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullV);
    int free = 0;
    constexpr double negligible = 1e-9;  // as scene::free_motions()
    for (int i = 0; i < m; ++i) free += svd.singularValues()[i] <= negligible * svd.singularValues()[0];
    motions_ = svd.matrixV().rightCols(free);
  }
}

template <int dim> std::array<Vector<dim>, dim> Star<dim>::arms(int spoke) const {
  std::array<Vector<dim>, dim> x;
  for (int k = 0; k < dim; ++k)
    x[k] = facets_.position[facets_.facet[spokes_[spoke]].vertices[k]] - facets_.position[vertex_];
  return x;
}

template <int dim>
std::vector<std::vector<int>> groups_apart(const scene::Mesh<dim>& mesh, const std::vector<Star<dim>>& stars) {
  std::vector<std::vector<int>> groups;
  std::vector<int> group(stars.size(), -1);
  std::vector<std::size_t> taken;  // by which vertex a group is last known to be
  for (std::size_t v = 0; v < stars.size(); ++v) {
    for (const int c : stars[v].cells())
      for (const int w : mesh.cells[c])
        if (group[w] >= 0) taken[group[w]] = v + 1;
    const auto free = std::find_if(taken.begin(), taken.end(), [&](std::size_t by) { return by != v + 1; });
    group[v] = static_cast<int>(free - taken.begin());
    if (free == taken.end()) {
      taken.push_back(0);
      groups.emplace_back();
    }
    groups[group[v]].push_back(static_cast<int>(v));
  }
  return groups;
}

#define INSTANTIATE(dim)                                                                                    \
  template Eigen::Matrix<double, n_facet_loads<dim>, scene::Simplex<dim>::n_rigid_motions> motions_of<dim>( \
      const std::array<Vector<dim>, dim>&, double);                                                         \
  template Facets<dim> facets_of(const scene::Problem<dim>&);                                               \
  template Stars stars_of(const scene::Mesh<dim>&);                                                         \
  template class Star<dim>;                                                                                 \
  template std::vector<std::vector<int>> groups_apart(const scene::Mesh<dim>&, const std::vector<Star<dim>>&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::dual
