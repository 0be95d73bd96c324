// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <numbers>

#include "scene/scene.h"

namespace bracket::scene {

namespace {

double cross(const Vector<2>& a, const Vector<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

}  // namespace

template <int dim> double volume(const Mesh<dim>& mesh, int cell) {
  static_assert(dim == 2);
  const auto& [a, b, c] = mesh.cells[cell];
  return 0.5 * cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
}

template <int dim> double length(const Mesh<dim>& mesh, int facet) {
  const auto& [a, b] = mesh.boundary[facet].vertices;
  return (mesh.vertices[b] - mesh.vertices[a]).norm();
}

template <int dim> Vector<dim> normal(const Mesh<dim>& mesh, int facet) {
  static_assert(dim == 2);
  const auto& [a, b] = mesh.boundary[facet].vertices;
  const Vector<dim> along = mesh.vertices[b] - mesh.vertices[a];
  return Vector<dim>(along[1], -along[0]) / along.norm();  // the body lies to the left
}

template <int dim> Quality quality(const Mesh<dim>& mesh) {
  Quality result;
  result.smallest_area = mesh.cells.empty() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const double area = volume(mesh, static_cast<int>(cell));
    result.smallest_area = std::min(result.smallest_area, area);
    result.largest_area = std::max(result.largest_area, area);
    for (int k = 0; k < 3; ++k) {
      const Vector<dim>& corner = mesh.vertices[mesh.cells[cell][k]];
      const Vector<dim> a = mesh.vertices[mesh.cells[cell][(k + 1) % 3]] - corner;
      const Vector<dim> b = mesh.vertices[mesh.cells[cell][(k + 2) % 3]] - corner;
      const double angle = std::atan2(cross(a, b), a.dot(b)) * 180 / std::numbers::pi;
      result.smallest_angle = std::min(result.smallest_angle, angle);
      result.largest_angle = std::max(result.largest_angle, angle);
    }
  }
  return result;
}

template double volume(const Mesh<2>&, int);
template double length(const Mesh<2>&, int);
template Vector<2> normal(const Mesh<2>&, int);
template Quality quality(const Mesh<2>&);

}  // namespace bracket::scene
