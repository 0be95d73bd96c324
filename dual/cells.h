// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dual/block_element.h"

/// The multipliers of the block elements' side loads, which are edge displacements, and the cells as these see them:
/// what the hybrid method and Uzawa's share.
namespace bracket::dual {

/// The multipliers of one edge: the displacement of its two ends, in the directions of the rows of `frame`. Place
/// 2 end + direction; the lower vertex is end 0. The frame is (normal, tangent) where a support or the contact needs
/// it.
struct Edge {
  Eigen::Matrix2d frame = Eigen::Matrix2d::Identity();
  std::array<int, 4> unknown = {-1, -1, -1, -1};  ///< number in its body; −1: prescribed
  int node = -1;                                  ///< number of the edge in its body
  bool normal_held = false, tangent_held = false;
};

struct Layout {
  std::vector<Edge> edges;
  std::vector<std::vector<int>> body_cells;
  std::vector<std::vector<int>> body_nodes;  ///< offsets of each edge's unknowns, as contact::System::nodes
};
template <int dim> Layout lay_out(const scene::Problem<dim>& problem);

/// Which end of its mesh edge a vertex of a boundary facet is.
template <int dim> int end_of(const scene::Mesh<dim>& mesh, int edge, int vertex);

/// A cell's vertices relative to the first of them: far from the origin a centroid would be rounded otherwise.
template <int dim> Triangle corners(const scene::Mesh<dim>& mesh, int cell);

/// One cell's block element, with its loads in the frames of its edges.
struct Cell {
  Eigen::Matrix3d piola;              ///< as BlockElement::piola
  Eigen::LLT<ModeMatrix> compliance;  ///< A = L Lᵀ
  LoadMatrix loads;                   ///< G
  std::array<int, n_loads> unknowns;  ///< −1: prescribed
};
template <int dim> std::vector<Cell> make_cells(const scene::Problem<dim>& problem, const Layout& layout);

/// The displacements that are prescribed on the edges of each cell, others zero; empty where all are.
template <int dim> std::vector<LoadVector> prescribed_displacements(const scene::Problem<dim>& problem);
/// Of the body forces in each cell, the loads in the frames of the edges; empty where there are none.
template <int dim>
std::vector<Particular> weights(const scene::Problem<dim>& problem, const Layout& layout,
                                const std::vector<Cell>& cells);

/// The edge displacements of a cell, a share of its body's unknowns; prescribed ones are `otherwise`.
LoadVector edge_displacements(const Cell& cell, const Eigen::VectorXd& unknowns, const LoadVector& otherwise);

/// ∫ φ_i g over each contact facet, for the hat functions of the first facet's vertices i = 0, 1: entry 2 facet + i.
template <int dim> Eigen::VectorXd gap_moments(const scene::Problem<dim>& problem);

}  // namespace bracket::dual
