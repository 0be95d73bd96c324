// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "primal/rows.h"

#include "primal/approach.h"
#include "scene/problem/law.h"

/// Planar, with springs and friction; rows_in_space.cpp has those of space.
namespace bracket::primal {

namespace {

using scene::ContactFacet;
using scene::Problem;
using scene::Vector;

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// A row at a pair of vertices.
struct EndRow {
  int first, second;  ///< vertices
  Vector<2> normal;
  int facet, end;
  double gap;
  double lower, upper;  ///< limits
};

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

/// The end rows of facets without springs, with the smaller gap where two facets share one; sides that keep together at
/// one of them do so.
std::vector<EndRow> end_rows(const Problem<2>& problem, const Approach<2>& approach) {
  std::vector<EndRow> rows;
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const ContactFacet& pair = problem.contact[j];
    for (int i = 0; i < 2 && !has_springs(pair.law); ++i) {
      const auto [first, second] = approach.vertices(pair, i);
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
double shear_limit(const Problem<2>& problem, const ContactFacet& pair, int degree, int k) {
  double mean = 0;
  for (int a = 0; a < 2; ++a)
    mean += scene::number<double>(scene::bernstein_mass(degree, k, 1, a)) * pair.law.friction[a];
  return scene::length(problem.mesh, pair.first) * mean;
}

/// The end rows of slip; what facets that share one can bear adds up. What they do not see of it is one number but for
/// rounding, where it does not jump.
std::vector<EndRow> slip_end_rows(const Problem<2>& problem, const Approach<2>& approach, int degree) {
  std::vector<EndRow> rows;
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const ContactFacet& pair = problem.contact[j];
    for (int i = 0; i < 2 && has_friction(pair.law); ++i) {
      const auto [first, second] = approach.vertices(pair, i);
      if (first == second) continue;
      const double limit = shear_limit(problem, pair, degree, i * degree);
      rows.push_back(
          {first, second, problem.facets[pair.first].normal, static_cast<int>(j), i, pair.slip[2 * i], -limit, limit});
    }
  }
  return distinct(std::move(rows), [](EndRow& row, const EndRow& other) {
    if (other.gap != row.gap) row.gap = (row.gap + other.gap) / 2;
    row.lower += other.lower;
    row.upper += other.upper;
  });
}

}  // namespace

template <> std::vector<Row> contact_rows(const Problem<2>& problem, const Nodes<2>& nodes, bool any_gap) {
  const auto& mesh = problem.mesh;
  const Approach<2> approach{nodes, problem};
  const int degree = nodes.degree, last = spring_degree(degree);
  Rows<2> rows{problem, degree};
  // The inner rows come first: where rows depend on each other, the earlier ones are kept active.
  int springs = 0;
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const ContactFacet& pair = problem.contact[j];
    const auto& [a, b] = mesh.boundary[pair.first].vertices;
    const Vector<2> x = (mesh.vertices[a] + mesh.vertices[b]) / 2;
    const Vector<2>& d = problem.facets[pair.first].normal;
    const double ga = gap_coefficient(pair, 0), middle = gap_coefficient(pair, 1), gb = gap_coefficient(pair, 2);
    const bool sprung = has_springs(pair.law);
    // A linear r meets a middle coefficient no smaller than the mean of its neighbours by itself; that of a linear gap
    // is their mean but for rounding.
    const double above = middle - (ga + gb) / 2, noise = rounding_of_rows * std::max(std::abs(ga), std::abs(gb));
    if (degree == 1 && !sprung && rows.met_by_linear(pair, above, noise, any_gap, x)) continue;
    const std::vector<double> gap = scene::raised_to<double>(degree, std::vector<double>{ga, middle, gb});
    for (int k = sprung ? 0 : 1; k < last + sprung; ++k) {
      Row row{{}, gap[k], std::abs(gap[k]), static_cast<int>(j), least_pressure(pair)};
      if (sprung) row.spring = springs++;
      approach.add_coefficient(row, pair, k, d);
      rows.keep(std::move(row), x);
    }
  }
  for (const EndRow& end : end_rows(problem, approach)) {
    Row row{{}, end.gap, std::abs(end.gap), end.facet, end.lower, end.upper};
    approach.add_end(row, problem.contact[end.facet], end.end, end.normal);
    rows.keep(std::move(row), mesh.vertices[end.first]);
  }
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const ContactFacet& pair = problem.contact[j];
    if (!has_friction(pair.law)) continue;
    const auto unseen = scene::raised_to<double>(degree, std::vector<double>(pair.slip.begin(), pair.slip.end()));
    for (int k = 1; k < degree; ++k) {
      const double limit = shear_limit(problem, pair, degree, k);
      Row row{{}, unseen[k], std::abs(unseen[k]), static_cast<int>(j), -limit, limit, -1, true};
      approach.add_coefficient(row, pair, k, scene::tangent(problem.facets[pair.first].normal));
      rows.keep(std::move(row), mesh.vertices[mesh.boundary[pair.first].vertices[0]]);
    }
  }
  for (const EndRow& end : slip_end_rows(problem, approach, degree)) {
    Row row{{}, end.gap, std::abs(end.gap), end.facet, end.lower, end.upper, -1, true};
    approach.add_end(row, problem.contact[end.facet], end.end, scene::tangent(end.normal));
    rows.keep(std::move(row), mesh.vertices[end.first]);
  }
  return std::move(rows.kept);
}

}  // namespace bracket::primal
