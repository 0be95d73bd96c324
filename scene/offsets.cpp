// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/offsets.h"

#include <algorithm>

namespace bracket::scene {

namespace {

/// Those inside of an edge, from one of its vertices.
template <int dim>
std::vector<Vector<dim>> inside_edge(const Mesh<dim>& mesh, const Displacement<dim>& u, int edge, int first_vertex) {
  auto inside = offsets_inside_edge<double, Vector<dim>>(mesh, u, u.vertex, plain_difference<dim>, edge);
  if (mesh.edges[edge][0] != first_vertex) std::reverse(inside.begin(), inside.end());
  return inside;
}

}  // namespace

template <int dim>
std::vector<Vector<dim>> offsets_on_cell(const Mesh<dim>& mesh, const Displacement<dim>& u, int cell) {
  std::vector<Vector<dim>> coefficients(n_bernstein<dim>(u.degree), Vector<dim>::Zero());
  if (u.degree == 1) return coefficients;
  std::array<std::vector<Vector<dim>>, Simplex<dim>::n_edges> sides;
  for (int e = 0; e < Simplex<dim>::n_edges; ++e)
    sides[e] = inside_edge(mesh, u, mesh.cell_edges[cell][e], mesh.cells[cell][Simplex<dim>::edges[e][0]]);
  const auto& points = control_points<dim>(u.degree);
  for (std::size_t p = 0; p < points.size(); ++p)
    if (points[p].on == ControlPoint::On::edge) coefficients[p] = sides[points[p].which][points[p].k - 1];
  if constexpr (dim == 2) {
    const auto inside = offsets_inside_cell<double>(mesh, u, u.vertex, plain_difference<dim>, cell, coefficients);
    for (std::size_t p = 0; p < points.size(); ++p)
      if (points[p].on == ControlPoint::On::cell) coefficients[p] = inside[points[p].k];
  }
  return coefficients;
}

Vector<2> displacement_at(const Mesh<2>& mesh, const Displacement<2>& u, int cell, const std::array<double, 3>& point) {
  Vector<2> value = value_on_triangle(offsets_on_cell(mesh, u, cell), u.degree, point);
  for (int k = 0; k < 3; ++k) value += point[k] * u.vertex[mesh.cells[cell][k]];
  return value;
}

Vector<3> displacement_at(const Mesh<3>& mesh, const Displacement<3>& u, int cell, const std::array<double, 4>& point) {
  Vector<3> value = Vector<3>::Zero();
  for (int i = 0; i < 4; ++i)
    value += (u.degree == 2 ? point[i] * (2 * point[i] - 1) : point[i]) * u.vertex[mesh.cells[cell][i]];
  for (int e = 0; u.degree == 2 && e < 6; ++e) {
    const auto& [a, b] = Simplex<3>::edges[e];
    value += 4 * point[a] * point[b] * u.edge[mesh.cell_edges[cell][e]];
  }
  return value;
}

template <> std::vector<Vector<2>> offsets_on_facet(const Mesh<2>& mesh, const Displacement<2>& u, int facet) {
  const auto& at = mesh.boundary[facet];
  auto inside = inside_edge(mesh, u, at.edge, at.vertices[0]);
  inside.insert(inside.begin(), Vector<2>::Zero());
  inside.push_back(Vector<2>::Zero());
  return inside;
}

template <> std::vector<Vector<3>> offsets_on_facet(const Mesh<3>& mesh, const Displacement<3>& u, int facet) {
  std::vector<Vector<3>> result(3, Vector<3>::Zero());
  if (u.degree == 1) return result;
  for (const int edge : facet_edges(mesh, mesh.boundary[facet]))
    result.push_back(inside_edge(mesh, u, edge, mesh.edges[edge][0]).front());
  return result;
}

template std::vector<Vector<2>> offsets_on_cell(const Mesh<2>&, const Displacement<2>&, int);
template std::vector<Vector<3>> offsets_on_cell(const Mesh<3>&, const Displacement<3>&, int);

}  // namespace bracket::scene
