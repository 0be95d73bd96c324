// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "primal/nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

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

/// One approach r = (u' − u'')·d at a pair of nodes, as a row. A rigid wall has no second node.
template <int dim> struct Approach {
  const Nodes<dim>& nodes;
  const Problem<dim>& problem;

  void add(Row& row, int node, int body, const Vector<dim>& d, double weight) const {
    const Node<dim>& at = nodes.node[node];
    row.bound -= weight * at.prescribed.dot(d);
    row.size += std::abs(weight) * at.prescribed.norm();
    for (int k = 0; k < at.free; ++k) {
      if (parallel<dim>(at.directions.col(1 - k), d)) continue;  // this one is at right angles to d
      row.entries.push_back({body, at.unknown + k, weight * at.directions.col(k).dot(d)});
    }
  }
};

struct EndRow {
  int first, second;  ///< vertices
  Vector<2> normal;
  double gap;
  int facet;
};

/// The end rows, one for each vertex pair and distinct normal, with the smaller gap where two facets share it.
template <int dim> std::vector<EndRow> end_rows(const Problem<dim>& problem) {
  const auto& mesh = problem.mesh;
  std::vector<EndRow> rows;
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const auto& pair = problem.contact[j];
    for (int i = 0; i < dim; ++i) {
      const int first = mesh.boundary[pair.first].vertices[i];
      const int second = pair.second < 0 ? -1 : mesh.boundary[pair.second].vertices[1 - i];
      if (first == second) continue;  // the tip of a crack, which does not open
      rows.push_back({first, second, problem.facets[pair.first].normal, pair.lower[2 * i], static_cast<int>(j)});
    }
  }
  std::stable_sort(rows.begin(), rows.end(), [](const EndRow& a, const EndRow& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  });
  std::vector<EndRow> distinct;
  for (const EndRow& row : rows) {
    bool merged = false;
    for (auto it = distinct.rbegin(); it != distinct.rend() && it->first == row.first && it->second == row.second; ++it)
      if (it->normal == row.normal) {
        it->gap = std::min(it->gap, row.gap);
        merged = true;
        break;
      }
    if (!merged) distinct.push_back(row);
  }
  return distinct;
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

template <int dim> std::vector<Row> contact_rows(const Problem<dim>& problem, const Nodes<dim>& nodes, bool any_gap) {
  const auto& mesh = problem.mesh;
  const Approach<dim> approach{nodes, problem};
  std::vector<Row> rows;
  // scene::fix_data() has made room where rounding alone closed a gap; here the sum of three products is rounded.
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  const auto keep = [&](Row row, const Vector<dim>& x) {
    if (!row.entries.empty()) {
      rows.push_back(std::move(row));
    } else if (row.bound < -rounding * (row.size + problem.length_scale)) {
      const int part = mesh.boundary[problem.contact[row.facet].first].part;
      throw scene::Error(
          scene::Status::ill_posed,
          fmt::format("the displacements prescribed at the contact of '{}' close its gap by up to {:.3g} "
                      "more than it has at ({:.7g}, {:.7g}): no displacement of degree {} is admissible",
                      mesh.parts[part], -row.bound, x[0], x[1], nodes.degree));
    }
  };
  const auto body_of = [&](int facet) { return mesh.cell_component[mesh.boundary[facet].cell]; };

  // The inner rows come first: where rows depend on each other, the earlier ones are kept active.
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const auto& pair = problem.contact[j];
    const auto& [ga, middle, gb] = pair.lower;
    // A linear r meets a middle coefficient no smaller than the mean of its neighbours by itself; that of a linear gap
    // is their mean but for rounding.
    const bool met = middle >= (ga + gb) / 2 - rounding * std::max(std::abs(ga), std::abs(gb));
    if (nodes.degree == 1 && met && !any_gap) continue;
    const Vector<dim>& d = problem.facets[pair.first].normal;
    const std::vector<double> gap = scene::raised_to<double>(nodes.degree, std::vector<double>{ga, middle, gb});
    for (std::size_t k = 1; k + 1 < gap.size(); ++k) {
      Row row{{}, gap[k], std::abs(gap[k]), static_cast<int>(j)};
      for (const int side : {pair.first, pair.second}) {
        if (side < 0) continue;
        const auto& facet = mesh.boundary[side];
        const double sign = side == pair.first ? 1 : -1;
        if (nodes.degree == 1)
          for (const int v : facet.vertices) approach.add(row, nodes.at_vertex(v), body_of(side), d, sign * 0.5);
        else
          approach.add(row,
                       nodes.on_edge(mesh, facet.edge, facet.vertices[side == pair.first ? 0 : 1], static_cast<int>(k)),
                       body_of(side), d, sign);
      }
      const auto& [a, b] = mesh.boundary[pair.first].vertices;
      keep(std::move(row), (mesh.vertices[a] + mesh.vertices[b]) / 2);
    }
  }
  for (const EndRow& end : end_rows(problem)) {
    const auto& pair = problem.contact[end.facet];
    Row row{{}, end.gap, std::abs(end.gap), end.facet};
    approach.add(row, nodes.at_vertex(end.first), body_of(pair.first), end.normal, 1);
    if (end.second >= 0) approach.add(row, nodes.at_vertex(end.second), body_of(pair.second), end.normal, -1);
    keep(std::move(row), mesh.vertices[end.first]);
  }
  return rows;
}

template struct Node<2>;
template struct Nodes<2>;
template Nodes<2> make_nodes(const Problem<2>&, int);
template std::vector<int> cell_nodes(const scene::Mesh<2>&, const Nodes<2>&, int);
template std::vector<Row> contact_rows(const Problem<2>&, const Nodes<2>&, bool);

}  // namespace bracket::primal
