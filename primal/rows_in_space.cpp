// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <tuple>

#include "primal/approach.h"

/// In space: rows belong to vertices and to edges, which neighbouring facets share, too.
namespace bracket::primal {

namespace {

using scene::ContactFacetOf;
using scene::Problem;
using scene::Vector;

/// A coefficient of r on a contact facet, as a row.
struct Candidate {
  int first, second;  ///< vertices, or edges, that lie on each other; the second −1: a wall
  Vector<3> normal;
  int facet, coefficient;
  double gap;
  double lower;  ///< limit of the multiplier
};

/// Those of the facets' vertices or edges. \param wanted (contact facet, coefficient): whether a row is needed
template <class Wanted>
std::vector<Candidate> candidates(const Problem<3>& problem, const Approach<3>& approach, bool of_edges,
                                  const Wanted& wanted) {
  std::vector<Candidate> result;
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const ContactFacetOf<3>& pair = problem.contact[j];
    for (int k = of_edges ? 3 : 0; k < (of_edges ? 6 : 3); ++k) {
      const auto [first, second] = of_edges ? approach.edges(pair, k - 3) : approach.vertices(pair, k);
      if (first == second || !wanted(static_cast<int>(j), k)) continue;  // the rim of a crack does not open
      result.push_back({first, second, problem.facets[pair.first].normal, static_cast<int>(j), k,
                        gap_coefficient(pair, k), least_pressure(pair)});
    }
  }
  return result;
}

/// One for each pair of vertices or edges and distinct normal, with the smaller gap where several facets have it; sides
/// that keep together at one of them do so.
std::vector<Candidate> distinct(std::vector<Candidate> all) {
  const auto key = [](const Candidate& c) {
    return std::tuple(c.first, c.second, c.normal[0], c.normal[1], c.normal[2]);
  };
  std::stable_sort(all.begin(), all.end(), [&](const Candidate& a, const Candidate& b) { return key(a) < key(b); });
  std::vector<Candidate> result;
  for (const Candidate& row : all) {
    if (result.empty() || key(result.back()) != key(row))
      result.push_back(row);
    else if (row.lower < result.back().lower)
      result.back() = row;
    else if (row.lower == result.back().lower)
      result.back().gap = std::min(result.back().gap, row.gap);
  }
  return result;
}

Vector<3> middle(const Problem<3>& problem, const ContactFacetOf<3>& pair, int edge) {
  const auto& [a, b] = scene::Simplex<2>::edges[edge];
  const auto x = scene::positions(problem.mesh, problem.mesh.boundary[pair.first].vertices);
  return (x[a] + x[b]) / 2;
}

}  // namespace

template <> std::vector<Row> contact_rows(const Problem<3>& problem, const Nodes<3>& nodes, bool any_gap) {
  const Approach<3> approach{nodes, problem};
  Rows<3> rows{problem, nodes.degree};
  const auto edge_is_wanted = [&](int facet, int k) {
    if (nodes.degree > 1) return true;
    const ContactFacetOf<3>& pair = problem.contact[facet];
    const auto& [a, b] = scene::Simplex<2>::edges[k - 3];
    const double ga = gap_coefficient(pair, a), gb = gap_coefficient(pair, b);
    const double above = gap_coefficient(pair, k) - (ga + gb) / 2;
    const double noise = rounding_of_rows * std::max(std::abs(ga), std::abs(gb));
    return !rows.met_by_linear(pair, above, noise, any_gap, middle(problem, pair, k - 3));
  };
  // Where rows depend on each other, the earlier ones are kept active.
  for (const bool of_edges : {true, false}) {
    const auto wanted = [&](int facet, int k) { return !of_edges || edge_is_wanted(facet, k); };
    for (const Candidate& of : distinct(candidates(problem, approach, of_edges, wanted))) {
      const ContactFacetOf<3>& pair = problem.contact[of.facet];
      Row row{{}, of.gap, std::abs(of.gap), of.facet, of.lower};
      approach.add_coefficient(row, pair, of.coefficient, of.normal);
      rows.keep(std::move(row), of_edges ? middle(problem, pair, of.coefficient - 3) : problem.mesh.vertices[of.first]);
    }
  }
  return std::move(rows.kept);
}

}  // namespace bracket::primal
