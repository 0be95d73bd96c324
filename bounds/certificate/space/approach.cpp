// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/space/approach.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <map>
#include <numeric>

#include "bounds/certificate/space/exact_rank.h"

namespace bracket::bounds::space {

namespace {

using scene::Vector;

/// The rows of all ties, each once.
std::vector<Tie::Row> all_rows(const scene::Problem<3>& problem, const Supports& supports, int degree) {
  std::map<std::pair<std::array<int, 2>, std::array<double, 3>>, Tie::Row> found;
  for (const auto& pair : problem.contact) {
    if (!pair.law.two_sided) continue;
    const scene::Piece<2> piece = scene::piece_of_facet(problem, pair.first);
    const auto nodes = nodes_of_facet(problem.mesh, pair.first);
    for (int k = 0; k < (degree == 1 ? 3 : 6); ++k) {
      const int one = nodes[k], other = node_across(problem.mesh, pair, k);
      const auto [a, b] = k < 3 ? std::array<int, 2>{k, k} : scene::Simplex<2>::edges[k - 3];
      const double sign = other >= 0 && other < one ? -1 : 1;
      const Vector<3>& normal = problem.facets[pair.first].normal;
      const Vector<3> d = sign * normal;
      const std::array<int, 2> both = sign < 0 ? std::array<int, 2>{other, one} : std::array<int, 2>{one, other};
      found.insert({{both, {d[0], d[1], d[2]}},
                    {one, other, normal, supports.gaps.of_facet[piece.of], piece.corner[a], piece.corner[b]}});
    }
  }
  std::vector<Tie::Row> rows;
  for (const auto& [at, row] : found) rows.push_back(row);
  return rows;
}

/// Leaves out the rows that say nothing more. \return whether those agree with the others, exactly
bool leave_independent(const Supports& supports, std::vector<Tie::Row>& rows, const PlainField& none) {
  std::vector<Tie::Row> chosen;
  for (const auto& row : rows) {
    std::vector<Tie::Row> with = chosen;
    with.push_back(row);
    const auto matrix = tie_matrix<Rational>(supports, with);
    if (rank(matrix) == static_cast<int>(with.size())) {
      chosen = std::move(with);
      continue;
    }
    // The last row is a combination of the others as far as their nodes may move: then it has to be one of theirs in
    // what is missing, too.
    auto extended = matrix;
    const auto missing = missing_of<Rational>(supports, with, none);
    for (std::size_t i = 0; i < with.size(); ++i) extended[i].push_back(missing[i]);
    if (rank(extended) != static_cast<int>(chosen.size())) return false;
  }
  rows = std::move(chosen);
  return true;
}

}  // namespace

Supports supports_of(const scene::Problem<3>& problem, int degree) {
  const scene::Problem<3>& first = scene::first_of(problem);
  Supports result{fixed_vertices(first), {}};
  result.node = node_supports(problem, result.fixed);
  result.gaps = kept_gaps(problem);
  result.fault = result.gaps.fault;
  if (result.gaps.kept.empty() || !result.fault.empty()) return result;
  const auto is_linear = [](const KeptGap& gap) { return gap.is_linear && (gap.factor == 0 || gap.is_psi_linear); };
  if (degree == 1 && !std::ranges::all_of(result.gaps.kept, is_linear)) {
    result.fault = "the gap of sides that keep together is not linear, as displacements of degree 1 are";
    return result;
  }
  const auto n = static_cast<int>(result.node.of_node.size());
  std::vector<int> ranks(n), parents(n);
  std::iota(parents.begin(), parents.end(), 0);
  boost::disjoint_sets<int*, int*> joined(ranks.data(), parents.data());
  const std::vector<Tie::Row> all = all_rows(problem, result, degree);
  for (const auto& row : all)
    if (row.second >= 0) joined.union_set(row.first, row.second);
  std::map<int, std::vector<Tie::Row>> sets;
  for (const auto& row : all) sets[joined.find_set(row.first)].push_back(row);
  const PlainField none{degree, std::vector<Vector<3>>(n, Vector<3>(Vector<3>::Zero()))};
  std::vector<int> tie_of(n, -1);
  for (auto& [_, rows] : sets) {
    const auto regular = [&] {
      return solution(tie_matrix<Enclosure>(result, rows), missing_of<Enclosure>(result, rows, none)).has_value();
    };
    const int node = rows[0].first;
    if (!regular() && (!leave_independent(result, rows, none) || !regular())) {
      const auto& mesh = problem.mesh;
      const auto vertices = static_cast<int>(mesh.vertices.size());
      const Vector<3>& at = mesh.vertices[node < vertices ? node : mesh.edges[node - vertices][0]];
      result.fault = fmt::format("the supports at ({:.6g}, {:.6g}, {:.6g}) leave sides that keep together no room",
                                 at[0], at[1], at[2]);
      return result;
    }
    for (const auto& row : rows)
      for (const int one : {row.first, row.second})
        if (one >= 0) tie_of[one] = static_cast<int>(result.ties.size());
    result.ties.push_back({std::move(rows)});
  }
  result.tie_of = std::move(tie_of);
  return result;
}

}  // namespace bracket::bounds::space
