// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/links.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/pending/disjoint_sets.hpp>
#include <numeric>
#include <set>

#include "scene/problem/law.h"

namespace bracket::bounds {

namespace {

using Rational = boost::multiprecision::cpp_rational;
using Row = std::vector<Rational>;

/// Two bodies, or a body and the ground, that cannot move against each other along a direction.
struct Link {
  int one, other;
  std::array<double, 2> direction;  // of a pair of opposite ones, that with the first component not zero positive
  auto operator<=>(const Link&) const = default;
};

Link link(int one, int other, const scene::Vector<2>& d) {
  const double sign = d[0] < 0 || (d[0] == 0 && d[1] < 0) ? -1 : 1;
  return {std::min(one, other), std::max(one, other), {sign * d[0], sign * d[1]}};
}

int component(const scene::Problem<2>& problem, int facet) {
  return problem.mesh.cell_component[problem.mesh.boundary[facet].cell];
}

/// \param ground the number of what does not move: that of the bodies
std::set<Link> links_of(const scene::Problem<2>& problem, const std::vector<char>& carrying, int ground) {
  std::set<Link> links;
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const int body = component(problem, static_cast<int>(f));
    if (problem.facets[f].support == scene::Support::sliding)
      links.insert(link(body, ground, problem.facets[f].normal));
    if (problem.facets[f].support != scene::Support::fixed) continue;
    for (int c = 0; c < 2; ++c) links.insert(link(body, ground, scene::Vector<2>::Unit(c)));
  }
  for (const auto& pair : problem.contact) {
    if (!carrying[pair.pair] && !pair.law.two_sided) continue;
    const int other = pair.second < 0 ? ground : component(problem, pair.second);
    if (other == component(problem, pair.first)) continue;
    const scene::Vector<2>& d = problem.facets[pair.first].normal;
    links.insert(link(component(problem, pair.first), other, d));
    if (scene::has_friction(pair.law)) links.insert(link(component(problem, pair.first), other, scene::tangent(d)));
  }
  return links;
}

/// Whether the two sides of a contact facet coincide to the last bit.
bool touch(const scene::Problem<2>& problem, const scene::ContactFacet& pair) {
  const auto one = positions(problem.mesh, problem.mesh.boundary[pair.first].vertices);
  const auto other = positions(problem.mesh, problem.mesh.boundary[pair.second].vertices);
  return one[0] == other[1] && one[1] == other[0];
}

int rank(std::vector<Row> rows) {
  int found = 0;
  const std::size_t columns = rows.empty() ? 0 : rows[0].size();
  for (std::size_t column = 0; column < columns; ++column) {
    const auto begin = rows.begin() + found;
    const auto pivot = std::find_if(begin, rows.end(), [&](const Row& row) { return !row[column].is_zero(); });
    if (pivot == rows.end()) continue;
    std::iter_swap(begin, pivot);
    for (auto row = begin + 1; row != rows.end(); ++row) {
      if ((*row)[column].is_zero()) continue;
      const Rational factor = (*row)[column] / (*begin)[column];
      for (std::size_t k = column; k < columns; ++k) (*row)[k] -= factor * (*begin)[k];
    }
    ++found;
  }
  return found;
}

}  // namespace

int unheld_motions(const scene::Problem<2>& problem, const std::vector<char>& carrying) {
  const int bodies = static_cast<int>(problem.mesh.components.size());
  const std::set<Link> links = links_of(problem, carrying, bodies);
  std::vector<int> ranks(bodies + 1), parents(bodies + 1);
  std::iota(parents.begin(), parents.end(), 0);
  boost::disjoint_sets<int*, int*> joined(ranks.data(), parents.data());
  std::vector<Row> rows;
  for (const auto& [one, other, direction] : links) {
    joined.union_set(one, other);
    Row row(2 * bodies);
    for (int c = 0; c < 2; ++c) {
      row[2 * one + c] = Rational(direction[c]);
      if (other < bodies) row[2 * other + c] = -Rational(direction[c]);
    }
    rows.push_back(std::move(row));
  }
  std::set<int> turning;  // those that hang together and not on the ground
  for (int body = 0; body < bodies; ++body)
    if (joined.find_set(body) != joined.find_set(bodies)) turning.insert(joined.find_set(body));
  // Sides at a distance lie along their direction but for rounding: a turn of both meets that rounding.
  for (const auto& pair : problem.contact)
    if ((carrying[pair.pair] || pair.law.two_sided) && pair.second >= 0 && !touch(problem, pair))
      turning.erase(joined.find_set(component(problem, pair.first)));
  return static_cast<int>(turning.size()) + 2 * bodies - rank(std::move(rows));
}

}  // namespace bracket::bounds
