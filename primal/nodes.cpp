// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "primal/nodes.h"

#include <fmt/format.h>

#include "scene/on_facet.h"

namespace bracket::primal {

namespace {

using scene::Problem;
using scene::Support;
using scene::Vector;

Vector<2> tangent(const Vector<2>& normal) { return {-normal[1], normal[0]}; }

/// The directions of the data are the same to the last bit (scene::FacetData::normal) or those of a corner.
bool parallel(const Vector<2>& a, const Vector<2>& b) { return a == b || a == -b; }

template <int dim> void fix(Node<dim>& node, const Vector<dim>& displacement) {
  node.prescribed = displacement;
  node.free = 0;
}

/// Adds u·n = value. Two such conditions with different normals determine the node.
void slide(Node<2>& node, const Vector<2>& n, double value) {
  if (node.free == 0) return;  // scene::fix_data has checked that the values agree
  if (node.free == 2) {
    node.prescribed = value * n;
    node.directions.col(0) = tangent(n);
    node.directions.col(1) = n;
    node.free = 1;
    return;
  }
  if (parallel(node.directions.col(1), n)) return;
  const Vector<2> t = node.directions.col(0);
  fix<2>(node, node.prescribed + t * ((value - node.prescribed.dot(n)) / t.dot(n)));
}

/// A contact with this normal, of a node that no support holds.
void touch(Node<2>& node, const Vector<2>& n) {
  if (node.free < 2) return;
  node.directions.col(0) = n;
  node.directions.col(1) = tangent(n);
}

/// Two unit vectors at right angles to a third and to each other: axes where that is one.
std::array<Vector<3>, 2> tangents(const Vector<3>& n) {
  int least = 0;
  n.cwiseAbs().minCoeff(&least);
  const Vector<3> first = Vector<3>::Unit(least).cross(n).normalized();
  return {first, n.cross(first)};
}

/// What a direction has beyond those that are held, a unit vector; zero where they are all that it is made of: normals
/// that are not equal differ by far more than rounding.
Vector<3> beyond_held(const Node<3>& node, const Vector<3>& n) {
  constexpr double negligible = 1e-9;
  Vector<3> left = Vector<3>::Zero();
  for (int k = 0; k < node.free; ++k) left += node.directions.col(k).dot(n) * node.directions.col(k);
  const double size = left.norm();
  return size > negligible ? Vector<3>(left / size) : Vector<3>(Vector<3>::Zero());
}

/// Adds u·n = value: up to three such conditions with independent normals. The held directions come last.
void slide(Node<3>& node, const Vector<3>& n, double value) {
  const Vector<3> t = beyond_held(node, n);
  if (t.isZero(0)) return;  // scene::fix_data has checked that the values agree
  if (node.free == 3) {
    const auto [a, b] = tangents(n);
    node.prescribed = value * n;
    node.directions << a, b, n;
  } else {
    node.prescribed += t * ((value - node.prescribed.dot(n)) / t.dot(n));
    if (node.free == 2) node.directions << t.cross(node.directions.col(2)).eval(), t, node.directions.col(2).eval();
  }
  --node.free;
}

/// A contact with this normal.
void touch(Node<3>& node, const Vector<3>& n) {
  if (node.free == 3) {
    const auto [a, b] = tangents(n);
    node.directions << n, a, b;
  }
  if (node.free != 2) return;
  const Vector<3> t = beyond_held(node, n), held = node.directions.col(2);
  if (!t.isZero(0)) node.directions << t, held.cross(t), held;
}

/// Builds the facets with this support into the nodes on them.
template <int dim> void set_supports(const Problem<dim>& problem, Nodes<dim>& nodes, Support support) {
  const auto& mesh = problem.mesh;
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support != support) continue;
    const Vector<dim>& n = data.normal;
    const auto apply = [&](Node<dim>& node, const Vector<dim>& displacement, double normal_displacement) {
      if (support == Support::fixed) fix(node, displacement);
      if (support == Support::sliding) slide(node, n, normal_displacement);
      if (support == Support::contact) touch(node, n);
    };
    const std::vector<int> list = facet_nodes(mesh, nodes, static_cast<int>(f));
    const auto displacement = scene::linear_on_facet<double>(data.displacement, nodes.degree);
    const auto normal_displacement = scene::linear_on_facet<double>(data.normal_displacement, nodes.degree);
    for (std::size_t k = 0; k < list.size(); ++k) apply(nodes.node[list[k]], displacement[k], normal_displacement[k]);
  }
}

}  // namespace

template <int dim> Nodes<dim> make_nodes(const Problem<dim>& problem, int degree) {
  if (dim == 3 && (degree < 1 || degree > scene::largest_degree_in<dim>()))
    throw scene::Error(scene::Status::input, fmt::format("in space displacements have degree 1 or 2, not {}", degree));
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
  for (const auto& [on, which, k] : scene::control_points<dim>(nodes.degree)) switch (on) {
      case scene::ControlPoint::On::vertex: list.push_back(nodes.at_vertex(mesh.cells[cell][which])); break;
      case scene::ControlPoint::On::edge:
        list.push_back(nodes.on_edge(mesh, mesh.cell_edges[cell][which],
                                     mesh.cells[cell][scene::Simplex<dim>::edges[which][0]], k));
        break;
      case scene::ControlPoint::On::cell: list.push_back(nodes.in_cell(mesh, cell, k)); break;
    }
  return list;
}

template <int dim> std::vector<int> facet_nodes(const scene::Mesh<dim>& mesh, const Nodes<dim>& nodes, int facet) {
  const auto& of = mesh.boundary[facet];
  std::vector<int> list;
  if constexpr (dim == 2) {
    list.push_back(nodes.at_vertex(of.vertices[0]));
    for (int k = 1; k < nodes.degree; ++k) list.push_back(nodes.on_edge(mesh, of.edge, of.vertices[0], k));
    list.push_back(nodes.at_vertex(of.vertices[1]));
  } else {
    for (const int v : of.vertices) list.push_back(nodes.at_vertex(v));
    if (nodes.degree == 2)
      for (const int e : scene::facet_edges(mesh, of)) list.push_back(nodes.on_edge(mesh, e, mesh.edges[e][0], 1));
  }
  return list;
}

template struct Node<2>;
template struct Node<3>;
template struct Nodes<2>;
template struct Nodes<3>;
template Nodes<2> make_nodes(const Problem<2>&, int);
template Nodes<3> make_nodes(const Problem<3>&, int);
template std::vector<int> cell_nodes(const scene::Mesh<2>&, const Nodes<2>&, int);
template std::vector<int> cell_nodes(const scene::Mesh<3>&, const Nodes<3>&, int);
template std::vector<int> facet_nodes(const scene::Mesh<2>&, const Nodes<2>&, int);
template std::vector<int> facet_nodes(const scene::Mesh<3>&, const Nodes<3>&, int);

}  // namespace bracket::primal
