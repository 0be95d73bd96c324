// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/space/tree.h"

#include <cmath>
#include <limits>
#include <queue>

namespace bracket::bounds::space {

namespace {

using scene::Support;
using scene::Vector;

template <std::size_t n> Vector<3> centroid(const std::array<Vector<3>, n>& x) {
  Vector<3> sum = Vector<3>::Zero();
  for (const auto& one : x) sum += one;
  return sum / n;
}
Vector<3> centroid(const scene::Mesh<3>& mesh, int cell) { return centroid(positions(mesh, mesh.cells[cell])); }
double area(const scene::Mesh<3>& mesh, int cell, int local) {
  return scene::area_vector<3>(positions(mesh, scene::facet_vertices(mesh, cell, local))).norm();
}

/// A cell that can be reached, and how far it would be from its root.
struct Reach {
  double distance;
  std::size_t order;  ///< of finding: of the same distance the first comes first
  Branch branch;
  bool operator<(const Reach& other) const {  // the nearest is on top
    return std::pair(distance, order) > std::pair(other.distance, other.order);
  }
};

/// Of each body without Γ_u its root, −1 of the others.
std::vector<int> single_roots(const scene::Problem<3>& problem, const std::vector<char>& is_held) {
  const auto& mesh = problem.mesh;
  std::vector<int> root(mesh.components.size(), -1);
  std::vector<double> largest(mesh.components.size(), 0);
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& facet = mesh.boundary[f];
    const Support support = problem.facets[f].support;
    if (support != Support::sliding && support != Support::contact) continue;
    const double own = area(mesh, facet.cell, facet.local);
    double& of_body = largest[mesh.cell_component[facet.cell]];
    if (own <= of_body) continue;
    of_body = own;
    root[mesh.cell_component[facet.cell]] = facet.cell;
  }
  const std::vector<int> found = root;
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    const int body = mesh.cell_component[cell];
    if (found[body] >= 0) continue;
    const double own = scene::volume<3>(positions(mesh, mesh.cells[cell]));
    if (own <= largest[body]) continue;
    largest[body] = own;
    root[body] = cell;
  }
  for (std::size_t body = 0; body < root.size(); ++body)
    if (is_held[body]) root[body] = -1;
  return root;
}

}  // namespace

// What is handed on through a face strains the cells at it the more the smaller it is: a force F gives F² by the length
// √A. So steps are as long as the distance of centroids by √A, and paths keep to large cells.
std::vector<Branch> trees(const scene::Problem<3>& problem, const std::vector<Face>& faces) {
  const auto& mesh = problem.mesh;
  std::priority_queue<Reach> reachable;
  std::size_t found = 0;
  std::vector<char> is_held(mesh.components.size(), 0);
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (problem.facets[f].support != Support::fixed) continue;
    const auto& facet = mesh.boundary[f];
    const double away = (centroid(mesh, facet.cell) - centroid(positions(mesh, facet.vertices))).norm();
    reachable.push({away / std::sqrt(area(mesh, facet.cell, facet.local)), found++, {facet.cell, -1, facet.local}});
    is_held[mesh.cell_component[facet.cell]] = 1;
  }
  for (const int cell : single_roots(problem, is_held))
    if (cell >= 0) reachable.push({0, found++, {cell, -1, -1}});
  std::vector<Branch> order;
  std::vector<char> reached(mesh.cells.size(), 0);
  while (!reachable.empty()) {
    const auto [distance, _, branch] = reachable.top();
    reachable.pop();
    if (reached[branch.cell]) continue;
    reached[branch.cell] = 1;
    order.push_back(branch);
    for (int k = 0; k < 4; ++k) {
      const Face& face = faces[scene::cell_facets(mesh, branch.cell)[k]];
      const int other = face.cell[0] == branch.cell ? 1 : 0;
      if (face.cell[other] < 0 || reached[face.cell[other]]) continue;
      const double step = (centroid(mesh, branch.cell) - centroid(mesh, face.cell[other])).norm();
      reachable.push({distance + step / std::sqrt(area(mesh, branch.cell, k)),
                      found++,
                      {face.cell[other], branch.cell, face.local[other]}});
    }
  }
  return order;
}

}  // namespace bracket::bounds::space
