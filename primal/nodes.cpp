// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "primal/nodes.h"

namespace bracket::primal {

namespace {

using scene::Problem;
using scene::Support;
using scene::Vector;

template <int dim> Vector<dim> tangent(const Vector<dim>& normal) { return {-normal[1], normal[0]}; }

/// The directions of the data are the same to the last bit (scene::FacetData::normal) or those of a corner.
template <int dim> bool parallel(const Vector<dim>& a, const Vector<dim>& b) { return a == b || a == -b; }

template <int dim> void fix(Node<dim>& node, const Vector<dim>& displacement) {
  node.prescribed = displacement;
  node.free = 0;
}

/// Adds u·n = value. Two such conditions with different normals determine the node.
template <int dim> void slide(Node<dim>& node, const Vector<dim>& n, double value) {
  if (node.free == 0) return;  // scene::fix_data has checked that the values agree
  if (node.free == dim) {
    node.prescribed = value * n;
    node.directions.col(0) = tangent<dim>(n);
    node.directions.col(1) = n;
    node.free = 1;
    return;
  }
  if (parallel<dim>(node.directions.col(1), n)) return;
  const Vector<dim> t = node.directions.col(0);
  fix<dim>(node, node.prescribed + t * ((value - node.prescribed.dot(n)) / t.dot(n)));
}

/// Builds the facets with this support into the nodes on them.
template <int dim> void set_supports(const Problem<dim>& problem, Nodes<dim>& nodes, Support support) {
  const auto& mesh = problem.mesh;
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support != support) continue;
    const auto& facet = mesh.boundary[f];
    const Vector<dim>& n = data.normal;
    const auto apply = [&](Node<dim>& node, const Vector<dim>& displacement, double normal_displacement) {
      if (support == Support::fixed) fix(node, displacement);
      if (support == Support::sliding) slide(node, n, normal_displacement);
      if (support == Support::contact && node.free == dim) {
        node.directions.col(0) = n;
        node.directions.col(1) = tangent<dim>(n);
      }
    };
    for (int i = 0; i < dim; ++i)
      apply(nodes.node[nodes.at_vertex(facet.vertices[i])], data.displacement[i], data.normal_displacement[i]);
    const auto& [u0, u1] = data.displacement;
    const auto& [s0, s1] = data.normal_displacement;
    for (int k = 1; k < nodes.degree; ++k)
      apply(nodes.node[nodes.on_edge(mesh, facet.edge, facet.vertices[0], k)],
            scene::linear_coefficient<double>(u0, u1, nodes.degree, k),
            scene::linear_coefficient<double>(s0, s1, nodes.degree, k));
  }
}

}  // namespace

template <int dim> Nodes<dim> make_nodes(const Problem<dim>& problem, int degree) {
  scene::check_degree(degree);
  const auto& mesh = problem.mesh;
  Nodes<dim> nodes{degree, {}, {}};
  nodes.node.resize(mesh.vertices.size() + scene::n_inside_edge(degree) * mesh.edges.size() +
                    scene::n_inside_cell(degree) * mesh.cells.size());
  set_supports(problem, nodes, Support::fixed);
  set_supports(problem, nodes, Support::sliding);
  set_supports(problem, nodes, Support::contact);

  nodes.body_nodes.assign(mesh.components.size(), {0});
  const auto number = [&](int first, int count, std::vector<int>& offsets) {  // those of a vertex, edge or cell
    if (count == 0 || nodes.node[first].number >= 0) return;
    int unknown = offsets.back();
    for (int i = first; i < first + count; ++i) {
      nodes.node[i].number = static_cast<int>(offsets.size()) - 1;
      nodes.node[i].unknown = unknown;
      unknown += nodes.node[i].free;
    }
    offsets.push_back(unknown);
  };
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    auto& offsets = nodes.body_nodes[mesh.cell_component[c]];
    for (const int v : mesh.cells[c]) number(nodes.at_vertex(v), 1, offsets);
    for (const int e : mesh.cell_edges[c])
      number(nodes.on_edge(mesh, e, mesh.edges[e][0], 1), scene::n_inside_edge(degree), offsets);
    number(nodes.in_cell(mesh, static_cast<int>(c), 0), scene::n_inside_cell(degree), offsets);
  }
  return nodes;
}

template <int dim> std::vector<int> cell_nodes(const scene::Mesh<dim>& mesh, const Nodes<dim>& nodes, int cell) {
  std::vector<int> list;
  for (const auto& [on, which, k] : scene::control_points(nodes.degree)) switch (on) {
      case scene::ControlPoint::On::vertex: list.push_back(nodes.at_vertex(mesh.cells[cell][which])); break;
      case scene::ControlPoint::On::edge:
        list.push_back(nodes.on_edge(mesh, mesh.cell_edges[cell][which],
                                     mesh.cells[cell][scene::Simplex<dim>::edges[which][0]], k));
        break;
      case scene::ControlPoint::On::cell: list.push_back(nodes.in_cell(mesh, cell, k)); break;
    }
  return list;
}

template struct Node<2>;
template struct Nodes<2>;
template Nodes<2> make_nodes(const Problem<2>&, int);
template std::vector<int> cell_nodes(const scene::Mesh<2>&, const Nodes<2>&, int);

}  // namespace bracket::primal
