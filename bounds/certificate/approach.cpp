// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/approach.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <map>
#include <numeric>

namespace bracket::bounds {

namespace {

/// The rows of all ties, but those of which neither side can move.
std::vector<Tie::Row> rows(const scene::Problem<2>& problem, const Supports& supports) {
  std::map<Facing, Tie::Row> found;
  for (const auto& pair : problem.contact) {
    if (!keeps_together(pair.law)) continue;
    const auto [of, corner] = scene::piece_of_facet(problem, pair.first);
    for (int end = 0; end < 2; ++end) {
      const Facing at = facing(problem, pair, end);
      const scene::Vector<2> d(at.d[0], at.d[1]);
      if (holds(supports.vertex[at.first], d) && (at.second < 0 || holds(supports.vertex[at.second], d))) continue;
      found.insert({at, {at, supports.contacts.of_facet[of], corner[end][0]}});
    }
  }
  std::vector<Tie::Row> result;
  for (const auto& [at, row] : found) result.push_back(row);
  return result;
}

}  // namespace

Supports supports_of(const scene::Problem<2>& problem) {
  Supports result{.vertex = vertex_supports(problem)};
  result.contacts = first_contacts(problem, result.vertex);
  result.fault = result.contacts.fault;
  if (std::ranges::none_of(problem.contact, [](const auto& pair) { return keeps_together(pair.law); }) ||
      !result.fault.empty())
    return result;
  const auto n = static_cast<int>(result.vertex.size());
  std::vector<int> ranks(n), parents(n);
  std::iota(parents.begin(), parents.end(), 0);
  boost::disjoint_sets<int*, int*> joined(ranks.data(), parents.data());
  const std::vector<Tie::Row> all = rows(problem, result);
  for (const auto& row : all)
    if (row.facing.second >= 0) joined.union_set(row.facing.first, row.facing.second);
  result.tie_of.assign(n, -1);
  std::map<int, int> tie_of_set;
  for (const auto& row : all) {
    const auto [known, is_new] =
        tie_of_set.insert({joined.find_set(row.facing.first), static_cast<int>(result.ties.size())});
    if (is_new) result.ties.emplace_back();
    Tie& tie = result.ties[known->second];
    tie.rows.push_back(row);
    for (const int vertex : {row.facing.first, row.facing.second})
      if (vertex >= 0) result.tie_of[vertex] = known->second;
  }
  const PlainField none{1, std::vector<scene::Vector<2>>(n, scene::Vector<2>(scene::Vector<2>::Zero())), {}};
  for (const Tie& tie : result.ties)
    if (!tie_forces<Enclosure>(result, tie, none)) {
      const scene::Vector<2>& at = problem.mesh.vertices[tie.rows[0].facing.first];
      result.fault =
          fmt::format("the supports at ({:.6g}, {:.6g}) leave sides that keep together no room", at[0], at[1]);
    }
  return result;
}

}  // namespace bracket::bounds
