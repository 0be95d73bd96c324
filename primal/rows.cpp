// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "primal/rows.h"

#include <fmt/format.h>

#include "scene/problem/law.h"

namespace bracket::primal {

namespace {

using scene::ContactFacet;
using scene::Problem;
using scene::Vector;

constexpr double unlimited = std::numeric_limits<double>::infinity();
/// scene::fix_data() has made room where rounding alone closed a gap; here the sum of three products is rounded.
constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();

/// One coefficient of (u' − u'')·d at a pair of nodes, as a row. A rigid wall has no second node.
template <int dim> struct Approach {
  const Nodes<dim>& nodes;
  const Problem<dim>& problem;

  void add(Row& row, int node, int body, const Vector<dim>& d, double weight) const {
    const Node<dim>& at = nodes.node[node];
    row.bound -= weight * at.prescribed.dot(d);
    row.size += std::abs(weight) * at.prescribed.norm();
    for (int k = 0; k < at.free; ++k) {
      const Vector<dim>& other = at.directions.col(1 - k);
      if (other == d || other == -d) continue;  // this one is at right angles to d
      row.entries.push_back({body, at.unknown + k, weight * at.directions.col(k).dot(d)});
    }
  }

  int body_of(int facet) const { return problem.mesh.cell_component[problem.mesh.boundary[facet].cell]; }

  /// At vertex `end` of the first facet.
  void add_end(Row& row, const ContactFacet& pair, int end, const Vector<dim>& d, double weight = 1) const {
    const auto& boundary = problem.mesh.boundary;
    add(row, nodes.at_vertex(boundary[pair.first].vertices[end]), body_of(pair.first), d, weight);
    if (pair.second >= 0)
      add(row, nodes.at_vertex(boundary[pair.second].vertices[1 - end]), body_of(pair.second), d, -weight);
  }

  /// Coefficient k of degree spring_degree(), from the first facet's vertex 0.
  void add_coefficient(Row& row, const ContactFacet& pair, int k, const Vector<dim>& d) const {
    const int last = spring_degree(nodes.degree);
    if (k == 0 || k == last) return add_end(row, pair, k / last, d);
    if (nodes.degree == 1) {
      add_end(row, pair, 0, d, 0.5);
      return add_end(row, pair, 1, d, 0.5);
    }
    for (const int side : {pair.first, pair.second}) {
      if (side < 0) continue;
      const auto& facet = problem.mesh.boundary[side];
      const int begin = facet.vertices[side == pair.first ? 0 : 1];
      add(row, nodes.on_edge(problem.mesh, facet.edge, begin, k), body_of(side), d, side == pair.first ? 1 : -1);
    }
  }
};

/// A row at a pair of vertices.
struct EndRow {
  int first, second;  ///< vertices
  Vector<2> normal;
  int facet, end;
  double gap;
  double lower, upper;  ///< limits
};

/// The vertices of a facet's end; the second −1: a wall.
template <int dim> std::pair<int, int> vertices(const scene::Mesh<dim>& mesh, const ContactFacet& pair, int end) {
  return {mesh.boundary[pair.first].vertices[end], pair.second < 0 ? -1 : mesh.boundary[pair.second].vertices[1 - end]};
}

/// One row for each vertex pair and distinct normal. \param merge makes one row of two
template <class Merge> std::vector<EndRow> distinct(std::vector<EndRow> rows, const Merge& merge) {
  std::stable_sort(rows.begin(), rows.end(), [](const EndRow& a, const EndRow& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  });
  std::vector<EndRow> result;
  for (const EndRow& row : rows) {
    bool merged = false;
    for (auto it = result.rbegin();
         it != result.rend() && it->first == row.first && it->second == row.second && !merged; ++it) {
      merged = it->normal == row.normal;
      if (merged) merge(*it, row);
    }
    if (!merged) result.push_back(row);
  }
  return result;
}

double gap_coefficient(const ContactFacet& pair, int k) {
  return pair.law.two_sided ? 0.5 * pair.lower[k] + 0.5 * pair.upper[k] : pair.lower[k];
}
double least_pressure(const ContactFacet& pair) { return pair.law.two_sided ? -unlimited : 0; }

/// The end rows of facets without springs, with the smaller gap where two facets share one; sides that keep together at
/// one of them do so.
template <int dim> std::vector<EndRow> end_rows(const Problem<dim>& problem) {
  std::vector<EndRow> rows;
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const ContactFacet& pair = problem.contact[j];
    for (int i = 0; i < dim && !has_springs(pair.law); ++i) {
      const auto [first, second] = vertices(problem.mesh, pair, i);
      if (first == second) continue;  // the tip of a crack, which does not open
      rows.push_back({first, second, problem.facets[pair.first].normal, static_cast<int>(j), i,
                      gap_coefficient(pair, 2 * i), least_pressure(pair), unlimited});
    }
  }
  return distinct(std::move(rows), [](EndRow& row, const EndRow& other) {
    if (other.lower < row.lower)
      row = other;
    else if (other.lower == row.lower)
      row.gap = std::min(row.gap, other.gap);
  });
}

/// ∫ g_T B_k over a facet, for the displacements' degree.
template <int dim> double shear_limit(const Problem<dim>& problem, const ContactFacet& pair, int degree, int k) {
  double mean = 0;
  for (int a = 0; a < 2; ++a)
    mean += scene::number<double>(scene::bernstein_mass(degree, k, 1, a)) * pair.law.friction[a];
  return scene::length(problem.mesh, pair.first) * mean;
}

/// The end rows of slip; what facets that share one can bear adds up.
template <int dim> std::vector<EndRow> slip_end_rows(const Problem<dim>& problem, int degree) {
  std::vector<EndRow> rows;
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const ContactFacet& pair = problem.contact[j];
    for (int i = 0; i < dim && has_friction(pair.law); ++i) {
      const auto [first, second] = vertices(problem.mesh, pair, i);
      if (first == second) continue;
      const double limit = shear_limit(problem, pair, degree, i * degree);
      rows.push_back({first, second, problem.facets[pair.first].normal, static_cast<int>(j), i, 0, -limit, limit});
    }
  }
  return distinct(std::move(rows), [](EndRow& row, const EndRow& other) {
    row.lower += other.lower;
    row.upper += other.upper;
  });
}

/// Collects the rows that have unknowns.
template <int dim> struct Rows {
  const Problem<dim>& problem;
  int degree;
  std::vector<Row> kept = {};

  /// \param x where it is, for messages
  void keep(Row row, const Vector<dim>& x) {
    if (!row.entries.empty() || row.spring >= 0) {
      kept.push_back(std::move(row));
      return;
    }
    const double tolerance = rounding * (row.size + problem.length_scale);
    const bool two_sided = row.lower < 0;
    if (row.is_slip || (row.bound >= -tolerance && (!two_sided || row.bound <= tolerance))) return;
    const int part = problem.mesh.boundary[problem.contact[row.facet].first].part;
    throw scene::Error(
        scene::Status::ill_posed,
        fmt::format("the displacements prescribed at the contact of '{}' {} at ({:.7g}, {:.7g}): no displacement of "
                    "degree {} is admissible",
                    problem.mesh.parts[part],
                    two_sided ? fmt::format("part its sides, which keep together, by {:.3g}", std::abs(row.bound))
                              : fmt::format("close its gap by up to {:.3g} more than it has", -row.bound),
                    x[0], x[1], degree));
  }
};

}  // namespace

template <int dim> std::vector<Row> contact_rows(const Problem<dim>& problem, const Nodes<dim>& nodes, bool any_gap) {
  const auto& mesh = problem.mesh;
  const Approach<dim> approach{nodes, problem};
  const int degree = nodes.degree, last = spring_degree(degree);
  Rows<dim> rows{problem, degree};
  // The inner rows come first: where rows depend on each other, the earlier ones are kept active.
  int springs = 0;
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const ContactFacet& pair = problem.contact[j];
    const auto& [a, b] = mesh.boundary[pair.first].vertices;
    const Vector<dim> x = (mesh.vertices[a] + mesh.vertices[b]) / 2;
    const Vector<dim>& d = problem.facets[pair.first].normal;
    const double ga = gap_coefficient(pair, 0), middle = gap_coefficient(pair, 1), gb = gap_coefficient(pair, 2);
    const bool sprung = has_springs(pair.law);
    // A linear r meets a middle coefficient no smaller than the mean of its neighbours by itself; that of a linear gap
    // is their mean but for rounding.
    const double above = middle - (ga + gb) / 2, noise = rounding * std::max(std::abs(ga), std::abs(gb));
    if (degree == 1 && !sprung && pair.law.two_sided && std::abs(above) > noise)
      throw scene::Error(scene::Status::input,
                         fmt::format("linear displacements cannot keep the sides of '{}' together along a gap that is "
                                     "curved at ({:.7g}, {:.7g}); write solve.degree = 2",
                                     mesh.parts[mesh.boundary[pair.first].part], x[0], x[1]));
    if (degree == 1 && !sprung && (pair.law.two_sided || (above >= -noise && !any_gap))) continue;
    const std::vector<double> gap = scene::raised_to<double>(degree, std::vector<double>{ga, middle, gb});
    for (int k = sprung ? 0 : 1; k < last + sprung; ++k) {
      Row row{{}, gap[k], std::abs(gap[k]), static_cast<int>(j), least_pressure(pair)};
      if (sprung) row.spring = springs++;
      approach.add_coefficient(row, pair, k, d);
      rows.keep(std::move(row), x);
    }
  }
  for (const EndRow& end : end_rows(problem)) {
    Row row{{}, end.gap, std::abs(end.gap), end.facet, end.lower, end.upper};
    approach.add_end(row, problem.contact[end.facet], end.end, end.normal);
    rows.keep(std::move(row), mesh.vertices[end.first]);
  }
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const ContactFacet& pair = problem.contact[j];
    for (int k = 1; k < degree && has_friction(pair.law); ++k) {
      const double limit = shear_limit(problem, pair, degree, k);
      Row row{{}, 0, 0, static_cast<int>(j), -limit, limit, -1, true};
      approach.add_coefficient(row, pair, k, scene::tangent(problem.facets[pair.first].normal));
      rows.keep(std::move(row), mesh.vertices[mesh.boundary[pair.first].vertices[0]]);
    }
  }
  for (const EndRow& end : slip_end_rows(problem, degree)) {
    Row row{{}, 0, 0, end.facet, end.lower, end.upper, -1, true};
    approach.add_end(row, problem.contact[end.facet], end.end, scene::tangent(end.normal));
    rows.keep(std::move(row), mesh.vertices[end.first]);
  }
  return std::move(rows.kept);
}

template std::vector<Row> contact_rows(const Problem<2>&, const Nodes<2>&, bool);

}  // namespace bracket::primal
