// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/offsets.h"

#include <algorithm>

namespace bracket::scene {

std::vector<Vector<2>> offsets_on_cell(const Mesh<2>& mesh, const Displacement<2>& u, int cell) {
  std::vector<Vector<2>> coefficients(n_bernstein(u.degree), Vector<2>::Zero());
  if (u.degree == 1) return coefficients;
  std::array<std::vector<Vector<2>>, 3> sides;
  for (int e = 0; e < 3; ++e) {
    const int edge = mesh.cell_edges[cell][e];
    sides[e] = offsets_inside_edge<double, Vector<2>>(mesh, u, u.vertex, plain_difference, edge);
    if (mesh.edges[edge][0] != mesh.cells[cell][Simplex<2>::edges[e][0]])
      std::reverse(sides[e].begin(), sides[e].end());
  }
  const auto& points = control_points(u.degree);
  for (std::size_t p = 0; p < points.size(); ++p)
    if (points[p].on == ControlPoint::On::edge) coefficients[p] = sides[points[p].which][points[p].k - 1];
  const auto inside = offsets_inside_cell<double>(mesh, u, u.vertex, plain_difference, cell, coefficients);
  for (std::size_t p = 0; p < points.size(); ++p)
    if (points[p].on == ControlPoint::On::cell) coefficients[p] = inside[points[p].k];
  return coefficients;
}

Vector<2> displacement_at(const Mesh<2>& mesh, const Displacement<2>& u, int cell, const std::array<double, 3>& point) {
  Vector<2> value = value_on_triangle(offsets_on_cell(mesh, u, cell), u.degree, point);
  for (int k = 0; k < 3; ++k) value += point[k] * u.vertex[mesh.cells[cell][k]];
  return value;
}

std::vector<Vector<2>> offsets_on_facet(const Mesh<2>& mesh, const Displacement<2>& u, int facet) {
  const auto& at = mesh.boundary[facet];
  auto inside = offsets_inside_edge<double, Vector<2>>(mesh, u, u.vertex, plain_difference, at.edge);
  if (mesh.edges[at.edge][0] != at.vertices[0]) std::reverse(inside.begin(), inside.end());
  inside.insert(inside.begin(), Vector<2>::Zero());
  inside.push_back(Vector<2>::Zero());
  return inside;
}

}  // namespace bracket::scene
