// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/cells.h"

#include <algorithm>

namespace bracket::dual {

using scene::Problem;
using scene::Support;
using scene::Vector;

template <int dim> int end_of(const scene::Mesh<dim>& mesh, int edge, int vertex) {
  return mesh.edges[edge][0] == vertex ? 0 : 1;
}

namespace {

template <int dim> void set_supports(const Problem<dim>& problem, std::vector<Edge>& edges) {
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support == Support::traction) continue;
    Edge& edge = edges[problem.mesh.boundary[f].edge];
    edge.normal_held = data.support != Support::contact;
    edge.tangent_held = data.support == Support::fixed;
    if (data.support == Support::fixed) continue;
    const Vector<dim>& n = data.normal;
    edge.frame << n[0], n[1], -n[1], n[0];
  }
}

template <int dim> Cell make_cell(const Problem<dim>& problem, const Layout& layout, int c) {
  const auto& mesh = problem.mesh;
  const BlockElement block = block_element(corners(mesh, c), body_of(problem, c).material.compliance());
  Cell cell{block.piola, block.compliance.llt(), block.loads, {}};
  for (int e = 0; e < 3; ++e) {
    const int mesh_edge = mesh.cell_edges[c][e];
    const Edge& edge = layout.edges[mesh_edge];
    for (int i = 0; i < 2; ++i) {
      const int row = 4 * e + 2 * i;
      const int place = 2 * end_of(mesh, mesh_edge, scene::facet_vertices(mesh, c, e)[i]);
      cell.loads.middleRows<2>(row) = (edge.frame * cell.loads.middleRows<2>(row)).eval();
      for (int k = 0; k < 2; ++k) cell.unknowns[row + k] = edge.unknown[place + k];
    }
  }
  return cell;
}

/// A cell's edge displacements that this boundary facet, one of its edges, prescribes. A facet runs along its cell's
/// edge: its vertex i is the end i.
template <int dim> void add_prescribed(const scene::FacetData<dim>& data, int edge_of_cell, LoadVector& displacements) {
  for (int i = 0; i < 2; ++i) {
    const int row = 4 * edge_of_cell + 2 * i;
    if (data.support == Support::fixed) displacements.segment<2>(row) = data.displacement[i];
    if (data.support == Support::sliding) displacements[row] = data.normal_displacement[i];
  }
}

template <int dim> Particular weight(const Problem<dim>& problem, const Layout& layout, const Cell& cell, int c) {
  const auto& mesh = problem.mesh;
  const auto& body = body_of(problem, c);
  Particular result = particular(corners(mesh, c), cell.piola, body.material.compliance(), body.force);
  for (int e = 0; e < 3; ++e)
    for (int i = 0; i < 2; ++i) {
      auto own = result.loads.segment<2>(4 * e + 2 * i);
      own = (layout.edges[mesh.cell_edges[c][e]].frame * own).eval();
    }
  return result;
}

}  // namespace

template <int dim> Layout lay_out(const Problem<dim>& problem) {
  const auto& mesh = problem.mesh;
  Layout layout;
  layout.edges.resize(mesh.edges.size());
  layout.body_cells.resize(mesh.components.size());
  layout.body_nodes.assign(mesh.components.size(), {0});
  set_supports(problem, layout.edges);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int body = mesh.cell_component[c];
    layout.body_cells[body].push_back(static_cast<int>(c));
    auto& nodes = layout.body_nodes[body];
    for (const int e : mesh.cell_edges[c]) {
      Edge& edge = layout.edges[e];
      if (edge.node >= 0) continue;
      edge.node = static_cast<int>(nodes.size()) - 1;
      int next = nodes.back();
      for (int end = 0; end < 2; ++end) {
        if (!edge.normal_held) edge.unknown[2 * end] = next++;
        if (!edge.tangent_held) edge.unknown[2 * end + 1] = next++;
      }
      nodes.push_back(next);
    }
  }
  return layout;
}

template <int dim> Triangle corners(const scene::Mesh<dim>& mesh, int cell) {
  const auto& v = mesh.cells[cell];
  return {Vector<dim>::Zero(), mesh.vertices[v[1]] - mesh.vertices[v[0]], mesh.vertices[v[2]] - mesh.vertices[v[0]]};
}

template <int dim> std::vector<Cell> make_cells(const Problem<dim>& problem, const Layout& layout) {
  std::vector<Cell> cells;
  cells.reserve(problem.mesh.cells.size());
  for (std::size_t c = 0; c < problem.mesh.cells.size(); ++c)
    cells.push_back(make_cell(problem, layout, static_cast<int>(c)));
  return cells;
}

template <int dim> std::vector<LoadVector> prescribed_displacements(const Problem<dim>& problem) {
  std::vector<LoadVector> result(problem.mesh.cells.size(), LoadVector::Zero());
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& facet = problem.mesh.boundary[f];
    add_prescribed(problem.facets[f], facet.local, result[facet.cell]);
  }
  const bool none = std::all_of(result.begin(), result.end(), [](const LoadVector& own) { return own.isZero(0); });
  return none ? std::vector<LoadVector>{} : result;
}

template <int dim>
std::vector<Particular> weights(const Problem<dim>& problem, const Layout& layout, const std::vector<Cell>& cells) {
  std::vector<Particular> result;
  const bool none =
      std::all_of(problem.bodies.begin(), problem.bodies.end(), [](const auto& body) { return body.force.isZero(0); });
  for (std::size_t c = 0; !none && c < cells.size(); ++c)
    result.push_back(weight(problem, layout, cells[c], static_cast<int>(c)));
  return result;
}

LoadVector edge_displacements(const Cell& cell, const Eigen::VectorXd& unknowns, const LoadVector& otherwise) {
  LoadVector edges = otherwise;
  for (int i = 0; i < n_loads; ++i)
    if (cell.unknowns[i] >= 0) edges[i] = unknowns[cell.unknowns[i]];
  return edges;
}

template <int dim> Eigen::VectorXd gap_moments(const Problem<dim>& problem) {
  Eigen::VectorXd moments(2 * problem.contact.size());
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const auto& g = problem.contact[j].upper;
    const double length = scene::length(problem.mesh, problem.contact[j].first);
    for (int i = 0; i < 2; ++i) moments[2 * j + i] = length / 12 * (3 * g[2 * i] + 2 * g[1] + g[2 - 2 * i]);
  }
  return moments;
}

template int end_of(const scene::Mesh<2>&, int, int);
template Layout lay_out(const Problem<2>&);
template Triangle corners(const scene::Mesh<2>&, int);
template std::vector<Cell> make_cells(const Problem<2>&, const Layout&);
template std::vector<LoadVector> prescribed_displacements(const Problem<2>&);
template std::vector<Particular> weights(const Problem<2>&, const Layout&, const std::vector<Cell>&);
template Eigen::VectorXd gap_moments(const Problem<2>&);

}  // namespace bracket::dual
