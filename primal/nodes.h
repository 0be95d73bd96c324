// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace bracket::primal {

/// A node of the displacements: u = prescribed + directions · q, with `free` unknowns q.
template <int dim> struct Node {
  scene::Vector<dim> prescribed = scene::Vector<dim>::Zero();
  Eigen::Matrix<double, dim, dim> directions = Eigen::Matrix<double, dim, dim>::Identity();  ///< first `free` columns
  int free = dim;
  int unknown = -1;  ///< number of its first unknown in its body
  int number = -1;   ///< its own number in its body
};

/// All nodes: those at Mesh::vertices, then (degree 2) those at the midpoints of Mesh::edges. The supports are built
/// into them exactly; where a node is free but in contact, its first direction is the contact normal.
template <int dim> struct Nodes {
  int degree;
  std::vector<Node<dim>> node;
  std::vector<std::vector<int>> body_nodes;  ///< offsets of the unknowns, as contact::System::nodes
  int at_vertex(int vertex) const { return vertex; }
  int at_edge(const scene::Mesh<dim>& mesh, int edge) const { return static_cast<int>(mesh.vertices.size()) + edge; }
};
template <int dim> Nodes<dim> make_nodes(const scene::Problem<dim>& problem, int degree);

/// A contact row Σ coefficient · q ≤ bound, one Bernstein coefficient of r and g.
struct Row {
  struct Entry {
    int body, unknown;
    double coefficient;
    bool operator==(const Entry&) const = default;
  };
  std::vector<Entry> entries;
  double bound;
  double size;  ///< of what `bound` is a difference of, absolute
  int facet;    ///< a contact facet that it belongs to, index into Problem::contact
};

/// Rows that make r ≤ g on all of Γ_K: the Bernstein coefficients of r on each facet are bounded by those of g, at the
/// ends once for each distinct normal that meets there. Rows without unknowns are checked and dropped.
/// \param any_gap the rows that some gap needs, whatever that of the problem is: linear displacements meet the middle
///     coefficients of most gaps by themselves
/// \throw scene::Error (ill_posed) if such a row is violated
template <int dim>
std::vector<Row> contact_rows(const scene::Problem<dim>& problem, const Nodes<dim>& nodes, bool any_gap = false);

}  // namespace bracket::primal
