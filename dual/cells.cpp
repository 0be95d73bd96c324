// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/cells.h"

#include <algorithm>

#include "contact/large_pages.h"
#include "scene/parallel.h"

namespace bracket::dual {

using scene::Problem;
using scene::Support;
using scene::Vector;

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

template <int degree, int dim> Cell<degree> make_cell(const Problem<dim>& problem, const Layout& layout, int c) {
  const auto& mesh = problem.mesh;
  const BlockElement<degree> block = block_element<degree>(corners(mesh, c), body_of(problem, c).material.compliance());
  Cell<degree> cell{block.piola, block.compliance.llt(), block.loads, {}};
  for (int e = 0; e < 3; ++e) {
    const int mesh_edge = mesh.cell_edges[c][e];
    const Edge& edge = layout.edges[mesh_edge];
    for (int i = 0; i <= degree; ++i) {
      const int row = 2 * (degree + 1) * e + 2 * i;
      const int place = 2 * along_edge(mesh, degree, mesh_edge, scene::facet_vertices(mesh, c, e)[0], i);
      auto own = cell.loads.template middleRows<2>(row);
      own = (edge.frame * own).eval();
      for (int k = 0; k < 2; ++k) cell.unknowns[row + k] = edge.unknown[place + k];
    }
  }
  return cell;
}

/// A cell's edge displacements that this boundary facet, one of its edges, prescribes. A facet runs along its cell's
/// edge, in the same sense.
template <int degree, int dim>
void add_prescribed(const scene::FacetData<dim>& data, int edge_of_cell, LoadVector<degree>& displacements) {
  for (int i = 0; i <= degree; ++i) {
    const int row = 2 * (degree + 1) * edge_of_cell + 2 * i;
    if (data.support == Support::fixed)
      displacements.template segment<2>(row) =
          scene::linear_coefficient<double>(data.displacement[0], data.displacement[1], degree, i);
    if (data.support == Support::sliding)
      displacements[row] =
          scene::linear_coefficient<double>(data.normal_displacement[0], data.normal_displacement[1], degree, i);
  }
}

template <int degree, int dim>
Particular<degree> weight(const Problem<dim>& problem, const Layout& layout, const Cell<degree>& cell, int c) {
  const auto& mesh = problem.mesh;
  const auto& body = body_of(problem, c);
  Particular<degree> result = particular<degree>(corners(mesh, c), cell.piola, body.material.compliance(), body.force);
  for (int e = 0; e < 3; ++e)
    for (int i = 0; i <= degree; ++i) {
      auto own = result.loads.template segment<2>(2 * (degree + 1) * e + 2 * i);
      own = (layout.edges[mesh.cell_edges[c][e]].frame * own).eval();
    }
  return result;
}

}  // namespace

template <int dim> Layout lay_out(const Problem<dim>& problem, int degree) {
  const auto& mesh = problem.mesh;
  Layout layout{degree, {}, {}, {}};
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
      for (int k = 0; k <= degree; ++k) {
        if (!edge.normal_held) edge.unknown[2 * k] = next++;
        if (!edge.tangent_held) edge.unknown[2 * k + 1] = next++;
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

template <int degree, int dim> std::vector<Cell<degree>> make_cells(const Problem<dim>& problem, const Layout& layout) {
  std::vector<Cell<degree>> cells;
  cells.reserve(problem.mesh.cells.size());
  contact::use_large_pages(cells.data(), cells.capacity());
  cells.resize(problem.mesh.cells.size());
  scene::for_each_index(static_cast<int>(cells.size()),
                        [&](int c) { cells[c] = make_cell<degree>(problem, layout, c); });
  return cells;
}

template <int degree, int dim> std::vector<LoadVector<degree>> prescribed_displacements(const Problem<dim>& problem) {
  std::vector<LoadVector<degree>> result(problem.mesh.cells.size(), LoadVector<degree>::Zero());
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& facet = problem.mesh.boundary[f];
    add_prescribed<degree>(problem.facets[f], facet.local, result[facet.cell]);
  }
  const bool none = std::all_of(result.begin(), result.end(), [](const auto& own) { return own.isZero(0); });
  return none ? std::vector<LoadVector<degree>>{} : result;
}

template <int degree, int dim>
std::vector<Particular<degree>> weights(const Problem<dim>& problem, const Layout& layout,
                                        const std::vector<Cell<degree>>& cells) {
  std::vector<Particular<degree>> result;
  const bool none =
      std::all_of(problem.bodies.begin(), problem.bodies.end(), [](const auto& body) { return body.force.isZero(0); });
  for (std::size_t c = 0; !none && c < cells.size(); ++c)
    result.push_back(weight<degree>(problem, layout, cells[c], static_cast<int>(c)));
  return result;
}

template <int degree>
LoadVector<degree> edge_displacements(const Cell<degree>& cell, const Eigen::VectorXd& unknowns,
                                      const LoadVector<degree>& otherwise) {
  LoadVector<degree> edges = otherwise;
  for (int i = 0; i < n_loads(degree); ++i)
    if (cell.unknowns[i] >= 0) edges[i] = unknowns[cell.unknowns[i]];
  return edges;
}

template <int dim>
Eigen::VectorXd moments(const Problem<dim>& problem, int degree, std::array<double, 3> scene::ContactFacet::*which) {
  Eigen::VectorXd moments((degree + 1) * problem.contact.size());
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const auto& given = problem.contact[j].*which;
    const double length = scene::length(problem.mesh, problem.contact[j].first);
    for (int i = 0; i <= degree; ++i) {
      double mean = 0;
      for (int k = 0; k < 3; ++k) mean += scene::number<double>(scene::bernstein_mass(degree, i, 2, k)) * given[k];
      moments[(degree + 1) * j + i] = length * mean;
    }
  }
  return moments;
}

template Layout lay_out(const Problem<2>&, int);
template Triangle corners(const scene::Mesh<2>&, int);
template Eigen::VectorXd moments(const Problem<2>&, int, std::array<double, 3> scene::ContactFacet::*);
#define BRACKET_CELLS(degree)                                                                   \
  template std::vector<Cell<degree>> make_cells<degree>(const Problem<2>&, const Layout&);      \
  template std::vector<LoadVector<degree>> prescribed_displacements<degree>(const Problem<2>&); \
  template std::vector<Particular<degree>> weights(const Problem<2>&, const Layout&,            \
                                                   const std::vector<Cell<degree>>&);           \
  template LoadVector<degree> edge_displacements(const Cell<degree>&, const Eigen::VectorXd&,   \
                                                 const LoadVector<degree>&);
BRACKET_CELLS(1)
BRACKET_CELLS(2)
BRACKET_CELLS(3)
#undef BRACKET_CELLS

}  // namespace bracket::dual
