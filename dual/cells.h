// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dual/block_element.h"

/// The multipliers of the block elements' side loads, which are edge displacements, and the cells as these see them:
/// what the hybrid method and Uzawa's share.
namespace bracket::dual {

/// The multipliers of one edge: the Bernstein coefficients of its displacement (degree 1: at its two ends), in the
/// directions of the rows of `frame`. Place 2 k + direction; k counts from the lower vertex. The frame is (normal,
/// tangent) where a support or the contact needs it.
struct Edge {
  Eigen::Matrix2d frame = Eigen::Matrix2d::Identity();
  std::array<int, 8> unknown = {-1, -1, -1, -1, -1, -1, -1, -1};  ///< number in its body; −1: prescribed, or none
  int node = -1;                                                  ///< number of the edge in its body
  bool normal_held = false, tangent_held = false;
};

struct Layout {
  int degree;  ///< of the block elements
  std::vector<Edge> edges;
  std::vector<std::vector<int>> body_cells;
  std::vector<std::vector<int>> body_nodes;  ///< offsets of each edge's unknowns, as contact::System::nodes
};
template <int dim> Layout lay_out(const scene::Problem<dim>& problem, int degree);

/// The coefficient k of a displacement of an edge, seen along a side or facet that begins at `first_vertex`, as counted
/// from the edge's lower vertex.
template <int dim> int along_edge(const scene::Mesh<dim>& mesh, int degree, int edge, int first_vertex, int k) {
  return mesh.edges[edge][0] == first_vertex ? k : degree - k;
}

/// A cell's vertices relative to the first of them: far from the origin a centroid would be rounded otherwise.
template <int dim> Triangle corners(const scene::Mesh<dim>& mesh, int cell);

/// One cell's block element, with its loads in the frames of its edges.
template <int degree> struct Cell {
  Eigen::Matrix3d piola;                      ///< as BlockElement::piola
  Eigen::LLT<ModeMatrix<degree>> compliance;  ///< A = L Lᵀ
  LoadMatrix<degree> loads;                   ///< G
  std::array<int, n_loads(degree)> unknowns;  ///< −1: prescribed
};
template <int degree, int dim>
std::vector<Cell<degree>> make_cells(const scene::Problem<dim>& problem, const Layout& layout);

/// The displacements that are prescribed on the edges of each cell, others zero; empty where all are.
template <int degree, int dim>
std::vector<LoadVector<degree>> prescribed_displacements(const scene::Problem<dim>& problem);
/// Of the body forces in each cell, the loads in the frames of the edges; empty where there are none.
template <int degree, int dim>
std::vector<Particular<degree>> weights(const scene::Problem<dim>& problem, const Layout& layout,
                                        const std::vector<Cell<degree>>& cells);

/// The edge displacements of a cell, a share of its body's unknowns; prescribed ones are `otherwise`.
template <int degree>
LoadVector<degree> edge_displacements(const Cell<degree>& cell, const Eigen::VectorXd& unknowns,
                                      const LoadVector<degree>& otherwise);

/// ∫ B_i q over each contact facet, for the Bernstein polynomials of the first facet: entry (degree + 1) facet + i.
/// \param which the quadratic q: a gap, or what friction does not see of the slip
template <int dim>
Eigen::VectorXd moments(const scene::Problem<dim>& problem, int degree,
                        std::array<double, 3> scene::ContactFacet::*which);

}  // namespace bracket::dual
