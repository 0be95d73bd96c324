// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include "primal/rows.h"
#include "scene/on_facet.h"

/// What rows of the contact are made of.
namespace bracket::primal {

/// Coefficients of (u' − u'')·d at pairs of nodes, as rows. A rigid wall has no second node.
template <int dim> struct Approach {
  const Nodes<dim>& nodes;
  const scene::Problem<dim>& problem;

  void add(Row& row, int node, int body, const scene::Vector<dim>& d, double weight) const {
    const Node<dim>& at = nodes.node[node];
    row.bound -= weight * at.prescribed.dot(d);
    row.size += std::abs(weight) * at.prescribed.norm();
    for (int k = 0; k < at.free; ++k) {
      const double along = at.directions.col(k).dot(d);
      if (at_right_angles(at, k, d, along)) continue;
      row.entries.push_back({body, at.unknown + k, weight * along});
    }
  }

  int body_of(int facet) const { return problem.mesh.cell_component[problem.mesh.boundary[facet].cell]; }

  /// At vertex `end` of the first facet.
  void add_end(Row& row, const scene::ContactFacetOf<dim>& pair, int end, const scene::Vector<dim>& d,
               double weight = 1) const {
    const auto& boundary = problem.mesh.boundary;
    add(row, nodes.at_vertex(boundary[pair.first].vertices[end]), body_of(pair.first), d, weight);
    if (pair.second >= 0)
      add(row, nodes.at_vertex(boundary[pair.second].vertices[pair.meets[end]]), body_of(pair.second), d, -weight);
  }

  /// Coefficient k of degree spring_degree() on the first facet, in the order of scene/on_facet.h.
  void add_coefficient(Row& row, const scene::ContactFacetOf<dim>& pair, int k, const scene::Vector<dim>& d,
                       double weight = 1) const {
    const int end = scene::vertex_of_coefficient<dim>(spring_degree(nodes.degree), k);
    if (end >= 0) return add_end(row, pair, end, d, weight);
    const auto& [a, b] = scene::Simplex<dim - 1>::edges[dim == 2 ? 0 : k - 3];
    if (nodes.degree == 1) {
      add_end(row, pair, a, d, 0.5 * weight);
      return add_end(row, pair, b, d, 0.5 * weight);
    }
    const auto& [first, second] = edges(pair, dim == 2 ? 0 : k - 3);
    const auto& boundary = problem.mesh.boundary;
    const int inside = dim == 2 ? k : 1;
    add(row, nodes.on_edge(problem.mesh, first, boundary[pair.first].vertices[a], inside), body_of(pair.first), d,
        weight);
    if (pair.second >= 0)
      add(row, nodes.on_edge(problem.mesh, second, boundary[pair.second].vertices[pair.meets[a]], inside),
          body_of(pair.second), d, -weight);
  }

  /// Edge e of the first facet and the one that it lies on, −1: a wall.
  std::pair<int, int> edges(const scene::ContactFacetOf<dim>& pair, int e) const {
    const auto& mesh = problem.mesh;
    const auto& [a, b] = scene::Simplex<dim - 1>::edges[e];
    const int first = scene::facet_edges(mesh, mesh.boundary[pair.first])[e];
    if (pair.second < 0) return {first, -1};
    const int over = scene::Simplex<dim - 1>::edge_between(pair.meets[a], pair.meets[b]);
    return {first, scene::facet_edges(mesh, mesh.boundary[pair.second])[over]};
  }
  /// Vertex `end` of the first facet and the one that it lies on, −1: a wall.
  std::pair<int, int> vertices(const scene::ContactFacetOf<dim>& pair, int end) const {
    const auto& boundary = problem.mesh.boundary;
    return {boundary[pair.first].vertices[end], pair.second < 0 ? -1 : boundary[pair.second].vertices[pair.meets[end]]};
  }

 private:
  static bool at_right_angles(const Node<dim>& node, int k, const scene::Vector<dim>& d, double along) {
    if constexpr (dim == 2) {
      const scene::Vector<dim>& other = node.directions.col(1 - k);
      return other == d || other == -d;
    } else {  // normals that are not equal differ by far more than their rounding
      return std::abs(along) < 16 * std::numeric_limits<double>::epsilon();
    }
  }
};

/// The gap's coefficient that a row has: where sides keep together the middle of what encloses it.
template <int dim> double gap_coefficient(const scene::ContactFacetOf<dim>& pair, int k) {
  return pair.law.two_sided ? 0.5 * pair.lower[k] + 0.5 * pair.upper[k] : pair.lower[k];
}
template <int dim> double least_pressure(const scene::ContactFacetOf<dim>& pair) {
  return pair.law.two_sided ? -std::numeric_limits<double>::infinity() : 0;
}

/// scene::fix_data() has made room where rounding alone closed a gap; here the sum of a few products is rounded.
inline constexpr double rounding_of_rows = 4 * std::numeric_limits<double>::epsilon();

/// "(1, 2)"
template <int dim> std::string place(const scene::Vector<dim>& x) {
  std::string result = fmt::format("({:.7g}", x[0]);
  for (int k = 1; k < dim; ++k) result += fmt::format(", {:.7g}", x[k]);
  return result + ")";
}

/// Collects the rows that have unknowns.
template <int dim> struct Rows {
  const scene::Problem<dim>& problem;
  int degree;
  std::vector<Row> kept = {};

  /// \param x where it is, for messages
  void keep(Row row, const scene::Vector<dim>& x) {
    if (!row.entries.empty() || row.spring >= 0) {
      kept.push_back(std::move(row));
      return;
    }
    const double tolerance = rounding_of_rows * (row.size + problem.length_scale);
    const bool two_sided = row.lower < 0;
    if (row.is_slip || (row.bound >= -tolerance && (!two_sided || row.bound <= tolerance))) return;
    const int part = problem.mesh.boundary[problem.contact[row.facet].first].part;
    throw scene::Error(
        scene::Status::ill_posed,
        fmt::format("the displacements prescribed at the contact of '{}' {} at {}: no displacement of degree {} is "
                    "admissible",
                    problem.mesh.parts[part],
                    two_sided ? fmt::format("part its sides, which keep together, by {:.3g}", std::abs(row.bound))
                              : fmt::format("close its gap by up to {:.3g} more than it has", -row.bound),
                    place<dim>(x), degree));
  }

  /// Linear displacements meet the inner coefficients of a linear gap by themselves. \throw scene::Error (input) where
  /// they would have to keep sides together that no linear ones do
  /// \param above by how much the coefficient is above that of the linear gap with its ends   \param noise rounding
  bool met_by_linear(const scene::ContactFacetOf<dim>& pair, double above, double noise, bool any_gap,
                     const scene::Vector<dim>& x) const {
    if (pair.law.two_sided && std::abs(above) > noise)
      throw scene::Error(scene::Status::input,
                         fmt::format("linear displacements cannot keep the sides of '{}' together along a gap that is "
                                     "curved at {}; write solve.degree = 2",
                                     problem.mesh.parts[problem.mesh.boundary[pair.first].part], place<dim>(x)));
    return pair.law.two_sided || (above >= -noise && !any_gap);
  }
};

}  // namespace bracket::primal
