// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/fields.h"

/// Displacements given at points as Bernstein coefficients: a linear field and what is added to its coefficients, so
/// that a motion of the whole, however large, is none of it.
namespace bracket::scene {

/// By which the Bernstein coefficients differ from those of the linear field with the same values at the vertices:
/// inside of edges and cells, as in Displacement.
template <class Value> struct Offsets {
  std::vector<Value> edge = {}, cell = {};
};

/// Inside of a segment: coefficients of what is zero at its ends, by its values at equally spaced points.
template <class Number, class Value> std::vector<Value> coefficients_inside(const std::vector<Value>& at_points) {
  constexpr std::array<Fraction, 1> of2 = {{{2, 1}}};
  constexpr std::array<Fraction, 4> of3 = {{{3, 1}, {-3, 2}, {-3, 2}, {3, 1}}};
  constexpr std::array<Fraction, 9> of4 = {
      {{4, 1}, {-3, 1}, {4, 3}, {-32, 9}, {20, 3}, {-32, 9}, {4, 3}, {-3, 1}, {4, 1}}};
  const std::size_t n = at_points.size();
  const std::span<const Fraction> inverse = n == 1   ? std::span<const Fraction>(of2)
                                            : n == 2 ? std::span<const Fraction>(of3)
                                                     : std::span<const Fraction>(of4);
  std::vector<Value> coefficients;
  for (std::size_t i = 0; i < n; ++i) {
    Value sum = number<Number>(inverse[n * i]) * at_points[0];
    for (std::size_t k = 1; k < n; ++k) sum = sum + number<Number>(inverse[n * i + k]) * at_points[k];
    coefficients.push_back(sum);
  }
  return coefficients;
}

/// Inside of a triangle, given all coefficients of what is zero at its corners but those inside, which are passed over,
/// and its values at the points inside.
template <class Number, class Value>
std::vector<Value> coefficients_inside(int degree, const std::vector<Value>& coefficients,
                                       std::vector<Value> at_points) {
  const auto& indices = bernstein_indices(degree);
  const auto& points = control_points(degree);
  int whole = 1;
  for (int k = 0; k < degree; ++k) whole *= degree;
  std::size_t inside = 0;
  for (std::size_t node = 0; node < indices.size(); ++node) {
    if (points[node].on != ControlPoint::On::cell) continue;
    Value& value = at_points[inside++];
    for (std::size_t c = 0; c < indices.size(); ++c) {
      if (points[c].on != ControlPoint::On::edge) continue;
      const auto& i = indices[c];
      int part = trinomial(i);  // of the Bernstein polynomial there
      for (int corner = 0; corner < 3; ++corner)
        for (int k = 0; k < i[corner]; ++k) part *= indices[node][corner];
      value = value - number<Number>(Fraction{part, whole}) * coefficients[c];
    }
  }
  if (degree == 3) return {number<Number>(Fraction{9, 2}) * at_points[0]};
  std::vector<Value> result;  // degree 4
  const Value sum = number<Number>(Fraction{8, 3}) * (at_points[0] + at_points[1] + at_points[2]);
  for (int k = 0; k < 3; ++k) result.push_back(number<Number>(Fraction{32, 3}) * at_points[k] - sum);
  return result;
}

/// The coefficients on a cell of what offsets stand for, in the order of control_points(): zero at the vertices, and
/// inside where those are not given.
template <class Value, int dim>
std::vector<Value> on_cell(const Mesh<dim>& mesh, int degree, const std::vector<Value>& inside_edges,
                           const std::vector<Value>& inside_cells, int cell) {
  std::vector<Value> coefficients;
  for (const ControlPoint& point : control_points<dim>(degree)) {
    Value value = zero_value<Value>();
    if (point.on == ControlPoint::On::edge)
      value = inside_edges[place_inside_edge(mesh, degree, mesh.cell_edges[cell][point.which],
                                             mesh.cells[cell][Simplex<dim>::edges[point.which][0]], point.k)];
    if (point.on == ControlPoint::On::cell && !inside_cells.empty())
      value = inside_cells[n_inside_cell(degree) * cell + point.k];
    coefficients.push_back(value);
  }
  return coefficients;
}

/// Of a displacement field those inside of an edge, from its lower vertex to its higher.
/// \param vertex what the field has at the vertices   \param between (a, b): the vector from a to b
template <class Number, class Value, class Between, int dim>
std::vector<Value> offsets_inside_edge(const Mesh<dim>& mesh, const Displacement<dim>& u,
                                       const std::vector<Vector<dim>>& vertex, const Between& between, int edge) {
  std::vector<Value> beside;  // the linear field
  const auto& [a, b] = mesh.edges[edge];
  for (int k = 1; k < u.degree; ++k) {
    const Vector<dim>& at = u.edge[n_inside_edge(u.degree) * edge + k - 1];
    beside.push_back(share<Number, Value>(between(vertex[a], at), u.degree - k, u.degree) +
                     share<Number, Value>(between(vertex[b], at), k, u.degree));
  }
  return beside.empty() ? beside : coefficients_inside<Number>(beside);
}

/// Planar: those inside of a cell. \param coefficients of the cell, which those inside are not read of
template <class Number, class Value, class Between>
std::vector<Value> offsets_inside_cell(const Mesh<2>& mesh, const Displacement<2>& u,
                                       const std::vector<Vector<2>>& vertex, const Between& between, int cell,
                                       const std::vector<Value>& coefficients) {
  const auto& indices = bernstein_indices(u.degree);
  const auto& points = control_points(u.degree);
  std::vector<Value> beside;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (points[p].on != ControlPoint::On::cell) continue;
    const Vector<2>& at = u.cell[n_inside_cell(u.degree) * cell + points[p].k];
    Value sum = zero_value<Value>();
    for (int corner = 0; corner < 3; ++corner)
      sum = sum + share<Number, Value>(between(vertex[mesh.cells[cell][corner]], at), indices[p][corner], u.degree);
    beside.push_back(sum);
  }
  return beside.empty() ? beside : coefficients_inside<Number>(u.degree, coefficients, beside);
}

/// All of them.
template <class Number, class Value, class Between, int dim>
Offsets<Value> offsets(const Mesh<dim>& mesh, const Displacement<dim>& u, const std::vector<Vector<dim>>& vertex,
                       const Between& between) {
  Offsets<Value> result;
  for (std::size_t e = 0; e < mesh.edges.size() && u.degree > 1; ++e)
    for (const Value& value : offsets_inside_edge<Number, Value>(mesh, u, vertex, between, static_cast<int>(e)))
      result.edge.push_back(value);
  if constexpr (dim == 2)
    for (int cell = 0; cell < static_cast<int>(mesh.cells.size()) && u.degree > 2; ++cell) {
      const std::vector<Value> coefficients = on_cell(mesh, u.degree, result.edge, {}, cell);
      for (const Value& value : offsets_inside_cell<Number>(mesh, u, vertex, between, cell, coefficients))
        result.cell.push_back(value);
    }
  return result;
}

/// u_b − u_a in plain numbers.
template <int dim> Vector<dim> plain_difference(const Vector<dim>& a, const Vector<dim>& b) { return b - a; }

/// The coefficients of one cell's offsets, in plain numbers.
template <int dim>
std::vector<Vector<dim>> offsets_on_cell(const Mesh<dim>& mesh, const Displacement<dim>& u, int cell);
/// Those of a boundary facet, in the order of scene/on_facet.h: zero at its vertices.
template <int dim>
std::vector<Vector<dim>> offsets_on_facet(const Mesh<dim>& mesh, const Displacement<dim>& u, int facet);
template <> std::vector<Vector<2>> offsets_on_facet(const Mesh<2>& mesh, const Displacement<2>& u, int facet);
template <> std::vector<Vector<3>> offsets_on_facet(const Mesh<3>& mesh, const Displacement<3>& u, int facet);

/// u at a point of a cell, by its barycentric coordinates.
Vector<2> displacement_at(const Mesh<2>& mesh, const Displacement<2>& u, int cell, const std::array<double, 3>& point);
Vector<3> displacement_at(const Mesh<3>& mesh, const Displacement<3>& u, int cell, const std::array<double, 4>& point);

}  // namespace bracket::scene
