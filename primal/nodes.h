// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/fields.h"
#include "scene/scene.h"

namespace bracket::primal {

/// A control point of the displacements, whose Bernstein coefficient there is prescribed + directions · q, with `free`
/// unknowns q.
template <int dim> struct Node {
  scene::Vector<dim> prescribed = scene::Vector<dim>::Zero();
  Eigen::Matrix<double, dim, dim> directions = Eigen::Matrix<double, dim, dim>::Identity();  ///< first `free` columns
  int free = dim;
  int unknown = -1;  ///< number of its first unknown in its body
  int number = -1;   ///< of its vertex, edge or cell in its body, which have neighbours in common
};

/// All nodes: those at Mesh::vertices, those inside of Mesh::edges (from the lower vertex to the higher) and those
/// inside of Mesh::cells. The supports are built into them exactly; where a node is free but in contact, its first
/// direction is the contact normal, in space also what is left of that where the node slides.
template <int dim> struct Nodes {
  int degree;
  std::vector<Node<dim>> node;
  std::vector<std::vector<int>> body_nodes;  ///< offsets of the unknowns, as contact::System::nodes
  int at_vertex(int vertex) const { return vertex; }
  /// The k-th inside of an edge, seen from one of its vertices.
  int on_edge(const scene::Mesh<dim>& mesh, int edge, int first_vertex, int k) const {
    return static_cast<int>(mesh.vertices.size()) + scene::place_inside_edge(mesh, degree, edge, first_vertex, k);
  }
  int in_cell(const scene::Mesh<dim>& mesh, int cell, int k) const {
    return static_cast<int>(mesh.vertices.size() + scene::n_inside_edge(degree) * mesh.edges.size()) +
           scene::n_inside_cell(degree) * cell + k;
  }
};
/// Indices into Nodes::node of a cell's, in the order of scene::control_points().
template <int dim> std::vector<int> cell_nodes(const scene::Mesh<dim>& mesh, const Nodes<dim>& nodes, int cell);
/// Those of a boundary facet, in the order of scene/on_facet.h.
template <int dim> std::vector<int> facet_nodes(const scene::Mesh<dim>& mesh, const Nodes<dim>& nodes, int facet);
/// \throw scene::Error (input) unless the degree is one from 1 to 4, in space 1 or 2
template <int dim> Nodes<dim> make_nodes(const scene::Problem<dim>& problem, int degree);

}  // namespace bracket::primal
