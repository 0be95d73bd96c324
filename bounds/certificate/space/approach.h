// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "bounds/certificate/linear_system.h"
#include "bounds/certificate/space/kept_gap.h"
#include "scene/fields.h"

/// How the sides of contacts move against each other.
namespace bracket::bounds::space {

/// Displacements as plain numbers, at nodes. The field they stand for is moved onto the supports and ties exactly by
/// shift().
struct PlainField {
  int degree = 1;                           ///< 1 or 2
  std::vector<scene::Vector<3>> node = {};  ///< zero at edges in degree 1
};

/// Nodes that keep together, r = g along each of some directions, and what the supports leave of their motions.
struct Tie {
  struct Row {
    int first, second;  ///< nodes; −1: a wall
    scene::Vector<3> d;
    int contact;                     ///< of the first mesh, whose gap it keeps …
    std::array<double, 2> from, to;  ///< … at a point of its facet, or, of an edge, beside the mean of two
  };
  std::vector<Row> rows = {};  ///< independent of each other
};

/// All that moves plain displacements onto what is prescribed.
struct Supports {
  std::vector<FacetCorner> fixed;  ///< of the first mesh
  NodeSupports node;
  KeptGaps gaps = {};
  std::vector<Tie> ties = {};
  std::vector<int> tie_of = {};  ///< of each node, −1: none; empty: no sides keep together
  std::string fault = {};        ///< why r = g cannot be: one line
};
/// \pre problem_fault() finds none
Supports supports_of(const scene::Problem<3>& problem, int degree);

/// What r is to be.
template <class Number> Number kept_value(const Supports& supports, const Tie::Row& row) {
  const auto gap = kept_gap<Number>(supports.gaps.kept[row.contact]);
  const auto at = [&](const std::array<double, 2>& p, const std::array<double, 2>& q) {
    return scene::on_part(gap, {p, q, q});  // node 5 lies between the corners 0 and 1
  };
  const auto c = at(row.from, row.to);
  return row.from == row.to ? c[0] : Number(c[5] - (c[0] + c[1]) / Number(2));
}

/// (u′ − u″)·d of nodes that face each other, but for ties.
template <class Number>
Number untied_approach(const Supports& supports, const PlainField& field, int first, int second,
                       const scene::Vector<3>& d) {
  const NodeSupport& one = supports.node.of(first);
  if (second < 0) return component<Number>(one, field.node[first], d);
  const NodeSupport& other = supports.node.of(second);
  if (one.fixed || one.slides > 0 || other.fixed || other.slides > 0)
    return component<Number>(one, field.node[first], d) - component<Number>(other, field.node[second], d);
  return dot(between<Number>(field.node[second], field.node[first]), vector3<Number>(d));
}

/// d as far as a row's nodes may move: what multipliers of the rows of a tie do to them.
template <class Number>
std::vector<std::vector<Number>> tie_matrix(const Supports& supports, const std::vector<Tie::Row>& rows) {
  std::vector<std::vector<Number>> matrix(rows.size(), std::vector<Number>(rows.size(), Number(0)));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows.size(); ++j) {
      const Vector3<Number> d = vector3<Number>(rows[i].d), other = vector3<Number>(rows[j].d);
      const auto add = [&](int node, int of_other, int sign) {
        if (node >= 0 && node == of_other)
          matrix[i][j] += Number(sign) * dot(free_part(supports.node.of(node), d), other);
      };
      add(rows[i].first, rows[j].first, 1);
      add(rows[i].second, rows[j].second, 1);
      add(rows[i].first, rows[j].second, -1);
      add(rows[i].second, rows[j].first, -1);
    }
  return matrix;
}
template <class Number>
std::vector<Number> missing_of(const Supports& supports, const std::vector<Tie::Row>& rows, const PlainField& field) {
  std::vector<Number> missing;
  for (const auto& row : rows)
    missing.push_back(kept_value<Number>(supports, row) -
                      untied_approach<Number>(supports, field, row.first, row.second, row.d));
  return missing;
}

/// What its tie adds to a node: the shortest move that the supports leave makes r = g.
template <class Number> Vector3<Number> tied(const Supports& supports, const PlainField& field, int node) {
  if (supports.tie_of.empty() || supports.tie_of[node] < 0) return {};
  const auto& rows = supports.ties[supports.tie_of[node]].rows;
  const std::vector<Number> force =
      solution(tie_matrix<Number>(supports, rows), missing_of<Number>(supports, rows, field)).value();
  Vector3<Number> sum{};
  for (std::size_t i = 0; i < force.size(); ++i) {
    const Vector3<Number> d = force[i] * vector3<Number>(rows[i].d);
    if (rows[i].first == node) sum = sum + free_part(supports.node.of(node), d);
    if (rows[i].second == node) sum = sum - free_part(supports.node.of(node), d);
  }
  return sum;
}

/// What is to be added to a node's plain value.
template <class Number> Vector3<Number> shift(const Supports& supports, const PlainField& field, int node) {
  const Vector3<Number> own = shift<Number>(supports.node.of(node), field.node[node]);
  return supports.tie_of.empty() || supports.tie_of[node] < 0 ? own : own + tied<Number>(supports, field, node);
}

/// (u′ − u″)·d at a node of a contact's first side and that of the second on it (−1: a wall): what moves both alike
/// leaves it zero to the last bit.
template <class Number>
Number approach(const Supports& supports, const PlainField& field, int first, int second, const scene::Vector<3>& d) {
  Number result = untied_approach<Number>(supports, field, first, second, d);
  if (supports.tie_of.empty()) return result;
  const auto by_tie = [&](int node) {
    if (node < 0 || supports.tie_of[node] < 0 || holds(supports.node.of(node), d)) return Number(0);
    return dot(tied<Number>(supports, field, node), vector3<Number>(d));
  };
  result += by_tie(first);
  result -= by_tie(second);
  return result;
}

/// The gap that S pays for.
template <class Number>
std::array<Number, 6> gap_paid(const scene::Problem<3>& problem, const Supports& supports,
                               const scene::ContactFacetOf<3>& pair) {
  if (!pair.law.two_sided) return numbers<Number>(pair.upper);
  const scene::Piece<2> piece = scene::piece_of_facet(problem, pair.first);
  return scene::on_part(kept_gap<Number>(supports.gaps.kept[supports.gaps.of_facet[piece.of]]), piece.corner);
}

/// r of one contact facet by its Bernstein coefficients.
template <class Number>
std::array<Number, 6> approach_on(const scene::Problem<3>& problem, const Supports& supports, const PlainField& field,
                                  const scene::ContactFacetOf<3>& pair) {
  if (pair.law.two_sided) return gap_paid<Number>(problem, supports, pair);
  const scene::Vector<3>& d = problem.facets[pair.first].normal;
  const auto nodes = nodes_of_facet(problem.mesh, pair.first);
  std::array<Number, 6> r;
  for (int k = 0; k < 6; ++k) {
    if (k >= 3) {
      const auto& [a, b] = scene::Simplex<2>::edges[k - 3];
      r[k] = (r[a] + r[b]) / Number(2);
      if (field.degree == 1) continue;
    }
    const Number own = approach<Number>(supports, field, nodes[k], node_across(problem.mesh, pair, k), d);
    r[k] = k < 3 ? own : Number(r[k] + own);
  }
  return r;
}

}  // namespace bracket::bounds::space
