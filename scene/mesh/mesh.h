// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <vector>

#include "scene/mesh/simplex.h"

namespace bracket::scene {

/// A conforming triangulation of all bodies. Components share no vertices, each hangs together through edges; a body
/// belongs to one component.
template <int dim> struct Mesh {
  std::vector<Vector<dim>> vertices;
  std::vector<std::array<int, dim + 1>> cells;  ///< vertices, in an order as Simplex has it
  std::vector<int> cell_body;                   ///< index into `bodies`
  std::vector<std::string> bodies;              ///< names
  /// What hangs together through edges moves as one, whatever it is made of: index into `components`. Supports and
  /// contact hold components; materials and weights are those of bodies.
  std::vector<int> cell_component;
  std::vector<std::string> components;                             ///< the names of their bodies
  std::vector<std::array<int, 2>> edges;                           ///< vertices, the lower index first
  std::vector<std::array<int, Simplex<dim>::n_edges>> cell_edges;  ///< in the order of Simplex::edges
  std::vector<char> refinement_edge;  ///< of each cell: which of its edges bisection cuts first
  /// In space, what bisection goes by besides: see scene/mesh/space/marks.h.
  struct Marks {
    std::array<char, dim + 1> facet;  ///< of each facet of a cell the edge at which it is cut first
    bool flagged = false;
  };
  std::vector<Marks> marks;  ///< of each cell; empty: they are yet to be chosen
  /// Of each cell the numbers of its facets; empty in the plane, where they are those of the edges. See cell_facets().
  std::vector<std::array<int, dim + 1>> facet_numbers;
  int facet_count = 0;  ///< in space: how many facets there are

  struct Facet {
    std::array<int, dim> vertices;  ///< in the order of Simplex::facets: in the plane the body is left
    int cell;
    int local;  ///< which facet of the cell
    int edge;   ///< in the plane, index into `edges`: the midpoint on the facet
    int part;   ///< index into `parts`, −1: none (such a facet is free)
  };
  std::vector<Facet> boundary;     ///< every facet that has a cell on one side only
  std::vector<std::string> parts;  ///< names of the boundary parts
  std::vector<std::string> notes;  ///< what was mended on reading, one line each
  /// By how much coordinates may be off what their author meant, by their size: the last place of a double, or of the
  /// digits of a file.
  double coordinate_rounding = std::numeric_limits<double>::epsilon() / 2;
};

/// The facets of a cell, in the order of Simplex::facets, as numbers below n_facets(). Two cells that lie on each other
/// share one. In the plane they have the numbers of the edges.
template <int dim> const std::array<int, dim + 1>& cell_facets(const Mesh<dim>& mesh, int cell) {
  if constexpr (dim == 2) return mesh.cell_edges[cell];
  if constexpr (dim == 3) return mesh.facet_numbers[cell];
}
template <int dim> std::size_t n_facets(const Mesh<dim>& mesh) {
  return dim == 2 ? mesh.edges.size() : static_cast<std::size_t>(mesh.facet_count);
}
/// The vertices of facet `local` of a cell, in the order of Simplex::facets.
template <int dim> std::array<int, std::size_t{dim}> facet_vertices(const Mesh<dim>& mesh, int cell, int local) {
  std::array<int, dim> vertices;
  for (int i = 0; i < dim; ++i) vertices[i] = mesh.cells[cell][Simplex<dim>::facets[local][i]];
  return vertices;
}
/// The edges of a boundary facet, as indices into Mesh::edges, in the order of Simplex<dim − 1>::edges for its
/// vertices.
template <int dim>
std::array<int, Simplex<dim - 1>::n_edges> facet_edges(const Mesh<dim>& mesh, const typename Mesh<dim>::Facet& facet) {
  std::array<int, Simplex<dim - 1>::n_edges> result;
  for (std::size_t e = 0; e < result.size(); ++e) {
    const auto& [i, k] = Simplex<dim - 1>::edges[e];
    const auto& corners = Simplex<dim>::facets[facet.local];
    result[e] = mesh.cell_edges[facet.cell][Simplex<dim>::edge_between(corners[i], corners[k])];
  }
  return result;
}
/// The positions of vertices.
template <int dim, std::size_t n>
std::array<Vector<dim>, n> positions(const Mesh<dim>& mesh, const std::array<int, n>& vertices) {
  std::array<Vector<dim>, n> x;
  for (std::size_t i = 0; i < n; ++i) x[i] = mesh.vertices[vertices[i]];
  return x;
}

/// Counts and shape of a mesh. Angles in degrees, in space those between facets.
struct Quality {
  double smallest_angle = 180;
  double largest_angle = 0;
  double smallest_area = 0;  ///< of cells; in space their volumes
  double largest_area = 0;
  double smallest_shape = 1;  ///< in space: 12 (3 |K|)^(2/3) / Σ |e|² over a cell's edges, 1 of a regular tetrahedron
};
template <int dim> Quality quality(const Mesh<dim>& mesh);

/// Longest edge by smallest height by √(dim − 1), of each cell: 2 and 1.7 of squares and cubes cut in two or six, a
/// little more than n of boxes n : 1.
template <int dim> std::vector<double> flatness(const Mesh<dim>& mesh);
/// Of these, that which a hundredth of the cells reaches; 0: there are no cells.
double common_flatness(std::vector<double> flatness);

template <int dim> double volume(const Mesh<dim>& mesh, int cell);        ///< of a cell: in the plane its area
template <int dim> double length(const Mesh<dim>& mesh, int facet);       ///< of a boundary facet: in space its area
template <int dim> Vector<dim> normal(const Mesh<dim>& mesh, int facet);  ///< unit outward normal of a boundary facet

}  // namespace bracket::scene
