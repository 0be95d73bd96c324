// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "scene/bernstein.h"
#include "scene/mesh/mesh.h"

/// The two fields, as plain values: whoever has them, from whatever solver, can have them certified.
namespace bracket::scene {

/// The highest degree of displacements in the plane; in space it is 2.
inline constexpr int largest_degree = 4;
template <int dim> constexpr int largest_degree_in() { return dim == 2 ? largest_degree : 2; }
/// The degree of the stresses beside displacements of a degree.
constexpr int stress_degree(int degree) { return degree > 1 ? degree - 1 : 1; }

/// How many values of a field of displacements lie inside of an edge and inside of a cell; in space none inside of
/// cells.
constexpr int n_inside_edge(int degree) { return degree - 1; }
constexpr int n_inside_cell(int degree) { return (degree - 1) * (degree - 2) / 2; }

/// A continuous displacement field, on each cell a polynomial of a degree from 1 to 4, in space to 2, by its values at
/// equally spaced points.
template <int dim> struct Displacement {
  int degree = 2;
  std::vector<Vector<dim>> vertex;  ///< at Mesh::vertices
  /// Inside of Mesh::edges, degree − 1 each, from its lower vertex to its higher; degree 2: at its midpoint.
  std::vector<Vector<dim>> edge;
  /// Inside of Mesh::cells, (degree − 1)(degree − 2)/2 each: degree 3: at the centroid; degree 4: those next to the
  /// vertices 0, 1, 2.
  std::vector<Vector<dim>> cell = {};
};

/// A stress field, on the parts of each cell, which meet at its centroid, a polynomial of a degree from 1 to 3, in
/// space of degree 1. Part k holds the facet opposite to vertex k; its corners are the vertices of that, in the order
/// of Simplex::facets, and the centroid.
template <int dim> struct Stress {
  int degree = 1;
  /// Of each cell the Bernstein coefficients, part by part; degree 1: [(dim + 1) part + corner]. Those of a part begin
  /// with those on its facet.
  std::vector<std::vector<Voigt<dim>>> cell;
};

/// The coefficients on one part of a cell.
template <int dim> std::span<const Voigt<dim>> stress_of_part(const Stress<dim>& stress, int cell, int part) {
  const auto n = static_cast<std::size_t>(n_bernstein<dim>(stress.degree));
  return std::span(stress.cell[cell]).subspan(n * part, n);
}

/// The value inside of an edge that, seen along a cell's side or a facet, is the k-th from its first vertex: its place
/// in Displacement::edge.
template <int dim> int place_inside_edge(const Mesh<dim>& mesh, int degree, int edge, int first_vertex, int k) {
  const bool forward = mesh.edges[edge][0] == first_vertex;
  return n_inside_edge(degree) * edge + (forward ? k : degree - k) - 1;
}

/// The place of a vertex among the coefficients of a cell.
constexpr int vertex_place(int degree, int vertex) {
  return vertex == 0 ? 0
                     : (vertex == 1   ? n_bernstein<1>(degree)
                        : vertex == 2 ? n_bernstein(degree)
                                      : n_bernstein<3>(degree)) -
                           1;
}

/// Where a Bernstein coefficient of a cell belongs to.
struct ControlPoint {
  enum class On { vertex, edge, cell };
  On on;
  int which;  ///< vertex or edge of the cell
  int k;      ///< edge: the k-th from its first vertex, as in Simplex::edges; cell: the k-th from 0 on
};
/// Of all coefficients of a cell's polynomials of a degree up to the largest, in their order.
template <int dim = 2> const std::vector<ControlPoint>& control_points(int degree);

}  // namespace bracket::scene
