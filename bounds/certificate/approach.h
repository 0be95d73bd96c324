// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/kept_gap.h"
#include "bounds/certificate/linear_system.h"
#include "scene/offsets.h"
#include "scene/problem/law.h"

/// How the sides of contacts move against each other.
namespace bracket::bounds {

/// Displacements as plain numbers: a linear field and what is added to its Bernstein coefficients (scene/offsets.h).
/// The field they stand for is moved onto the supports and ties exactly by shift(), and offsets on Γ_0 by onto(), those
/// of sides that keep together by tied_offsets(), which are of the size of rounding.
struct PlainField {
  int degree = 1;
  std::vector<scene::Vector<2>> vertex = {};
  scene::Offsets<scene::Vector<2>> offset = {};
};

/// Vertices that keep together, r = g along each of some directions, and what the supports leave of their motions.
struct Tie {
  struct Row {
    Facing facing;
    int contact;  ///< of the first mesh, whose gap at …
    double t;     ///< … this point of its facet it keeps
  };
  std::vector<Row> rows = {};
};

/// All that moves plain displacements onto what is prescribed.
struct Supports {
  std::vector<VertexSupport> vertex;  ///< of each vertex
  FirstContacts contacts = {};
  std::vector<Tie> ties = {};
  std::vector<int> tie_of = {};  ///< of each vertex, −1: none; empty: no sides keep together
  std::string fault = {};        ///< why r = g cannot be: one line
};
Supports supports_of(const scene::Problem<2>& problem);

/// d as far as a support lets a vertex move, by a factor.
template <class Number> Vector2<Number> free_part(const VertexSupport& support, const std::array<double, 2>& d) {
  const Vector2<Number> all = {Number(d[0]), Number(d[1])};
  if (holds(support)) return {};
  if (support.slides == 0) return all;
  const Vector2<Number> along = turned(vector2<Number>(support.slide[0].normal));
  return dot(along, all) * along;
}

/// (u′ − u″)·d of vertices that face each other, but for ties.
template <class Number>
Number untied_approach(const Supports& supports, const PlainField& field, int first, int second,
                       const scene::Vector<2>& d) {
  const auto along = [&](int vertex) { return component<Number>(supports.vertex[vertex], field.vertex[vertex], d); };
  if (second < 0) return along(first);
  if (supports.vertex[first].slides > 0 || supports.vertex[second].slides > 0) return along(first) - along(second);
  const Vector2<Number> moved = shift<Number>(supports.vertex[first], field.vertex[first]) -
                                shift<Number>(supports.vertex[second], field.vertex[second]);
  return dot(between<Number>(field.vertex[second], field.vertex[first]) + moved, vector2<Number>(d));
}

/// The multipliers of a tie's rows: the shortest move that the supports leave makes r = g. \return nothing where none
/// may
template <class Number>
std::optional<std::vector<Number>> tie_forces(const Supports& supports, const Tie& tie, const PlainField& field) {
  const std::size_t n = tie.rows.size();
  std::vector<std::vector<Number>> matrix(n, std::vector<Number>(n, Number(0)));
  std::vector<Number> missing;
  for (std::size_t i = 0; i < n; ++i) {
    const auto& [at, contact, t] = tie.rows[i];
    const Number gap = scene::on_stretch(kept_gap<Number>(supports.contacts.kept[contact]), t, t)[0];
    missing.push_back(
        gap - untied_approach<Number>(supports, field, at.first, at.second, scene::Vector<2>(at.d[0], at.d[1])));
    for (std::size_t j = 0; j < n; ++j) {
      const Facing& other = tie.rows[j].facing;
      const Vector2<Number> d = {Number(other.d[0]), Number(other.d[1])};
      const auto add = [&](int vertex, int of_other, int sign) {
        if (vertex < 0 || vertex != of_other) return;
        matrix[i][j] += Number(sign) * dot(free_part<Number>(supports.vertex[vertex], at.d), d);
      };
      add(at.first, other.first, 1);
      add(at.second, other.second, 1);
      add(at.first, other.second, -1);
      add(at.second, other.first, -1);
    }
  }
  return solution(std::move(matrix), std::move(missing));
}

/// What its tie adds to a vertex.   \pre supports_of() found no fault
template <class Number> Vector2<Number> tied(const Supports& supports, const PlainField& field, int vertex) {
  if (supports.tie_of.empty() || supports.tie_of[vertex] < 0) return {};
  const Tie& tie = supports.ties[supports.tie_of[vertex]];
  const std::vector<Number> force = tie_forces<Number>(supports, tie, field).value();
  Vector2<Number> sum;
  for (std::size_t i = 0; i < force.size(); ++i) {
    const Facing& at = tie.rows[i].facing;
    if (at.first == vertex) sum = sum + force[i] * free_part<Number>(supports.vertex[vertex], at.d);
    if (at.second == vertex) sum = sum - force[i] * free_part<Number>(supports.vertex[vertex], at.d);
  }
  return sum;
}

/// What is to be added to a vertex's plain displacement.
template <class Number> Vector2<Number> shift(const Supports& supports, const PlainField& field, int vertex) {
  const Vector2<Number> own = shift<Number>(supports.vertex[vertex], field.vertex[vertex]);
  return supports.tie_of.empty() || supports.tie_of[vertex] < 0 ? own : own + tied<Number>(supports, field, vertex);
}

/// (u′ − u″)·d at a vertex of a contact's first side and that of the second on it (−1: a wall): what moves both alike
/// leaves it zero to the last bit.
template <class Number>
Number approach(const Supports& supports, const PlainField& field, int first, int second, const scene::Vector<2>& d) {
  Number result = untied_approach<Number>(supports, field, first, second, d);
  if (supports.tie_of.empty()) return result;
  const auto by_tie = [&](int vertex) {
    if (vertex < 0 || supports.tie_of[vertex] < 0 || holds(supports.vertex[vertex], d)) return Number(0);
    return dot(tied<Number>(supports, field, vertex), vector2<Number>(d));
  };
  result += by_tie(first);
  result -= by_tie(second);
  return result;
}

/// The plain offset k of a boundary facet, seen along it.
inline const scene::Vector<2>& offset_on(const scene::Mesh<2>& mesh, const PlainField& field, int facet, int k) {
  const auto& at = mesh.boundary[facet];
  return field.offset.edge[scene::place_inside_edge(mesh, field.degree, at.edge, at.vertices[0], k)];
}

/// (u′ − u″)·d of one contact facet along some direction, ties left out of what is inside, as Bernstein coefficients of
/// degree 2 or more from its vertex 0 to its vertex 1. \param end what it is at both
template <class Number>
std::vector<Number> plain_approach_on(const scene::Mesh<2>& mesh, const PlainField& field,
                                      const scene::ContactFacet& pair, const scene::Vector<2>& d,
                                      const std::array<Number, 2>& end) {
  std::vector<Number> r;
  for (int k = 0; k <= field.degree; ++k) {
    r.push_back(scene::linear_coefficient<Number>(end[0], end[1], field.degree, k));
    if (k == 0 || k == field.degree) continue;
    r[k] += dot(vector2<Number>(offset_on(mesh, field, pair.first, k)), vector2<Number>(d));
    if (pair.second >= 0)
      r[k] -= dot(vector2<Number>(offset_on(mesh, field, pair.second, field.degree - k)), vector2<Number>(d));
  }
  return scene::raised_to<Number>(2, std::move(r));
}

template <class Number>
std::array<Number, 2> approach_at_ends(const scene::Mesh<2>& mesh, const Supports& supports, const PlainField& field,
                                       const scene::ContactFacet& pair, const scene::Vector<2>& d) {
  std::array<Number, 2> end;
  for (int i = 0; i < 2; ++i) {
    const int across = pair.second < 0 ? -1 : mesh.boundary[pair.second].vertices[1 - i];
    end[i] = approach<Number>(supports, field, mesh.boundary[pair.first].vertices[i], across, d);
  }
  return end;
}

/// r of one contact facet, as such coefficients: that of sides that keep together is their gap.
template <class Number>
std::vector<Number> approach_on(const scene::Problem<2>& problem, const Supports& supports, const PlainField& field,
                                const scene::ContactFacet& pair) {
  if (keeps_together(pair.law)) {
    const auto gap = kept_gap<Number>(problem, supports.contacts, pair);
    return scene::raised_to<Number>(field.degree, std::vector<Number>(gap.begin(), gap.end()));
  }
  const scene::Vector<2>& d = problem.facets[pair.first].normal;
  return plain_approach_on(problem.mesh, field, pair, d,
                           approach_at_ends<Number>(problem.mesh, supports, field, pair, d));
}

/// v_t = (u′ − u″)·t likewise. Ties move what is inside along d, which is at right angles to t.
template <class Number>
std::vector<Number> slip_on(const scene::Problem<2>& problem, const Supports& supports, const PlainField& field,
                            const scene::ContactFacet& pair) {
  const scene::Vector<2> t = scene::tangent(problem.facets[pair.first].normal);
  return plain_approach_on(problem.mesh, field, pair, t,
                           approach_at_ends<Number>(problem.mesh, supports, field, pair, t));
}

/// What friction sees of it: all but unseen_slip().
template <class Number>
std::vector<Number> rubbing_on(const scene::Problem<2>& problem, const Supports& supports, const PlainField& field,
                               const scene::ContactFacet& pair) {
  std::vector<Number> slip = slip_on<Number>(problem, supports, field, pair);
  std::vector<Number> unseen = unseen_slip<Number>(problem, supports.contacts, pair);
  if (unseen.empty()) return slip;
  unseen = scene::raised_to<Number>(static_cast<int>(slip.size()) - 1, std::move(unseen));
  for (std::size_t k = 0; k < slip.size(); ++k) slip[k] -= unseen[k];
  return slip;
}

/// What pairs of forces of a perturbation do on a contact facet, as they are, without their factor.
template <class Number>
Number contact_load_work(const scene::Problem<2>& problem, const Supports& supports, const PlainField& field,
                         const scene::ContactFacet& pair) {
  const auto [open0, open1] = opening_load<Number>(problem, pair);
  Number work =
      scene::bernstein_product(std::vector<Number>{open0, open1}, approach_on<Number>(problem, supports, field, pair));
  if (!scene::has_friction(pair.law)) return work;
  const auto [shear0, shear1] = shear_load<Number>(problem, pair);
  work +=
      scene::bernstein_product(std::vector<Number>{shear0, shear1}, slip_on<Number>(problem, supports, field, pair));
  return work;
}

/// What is to be added, along d, to offset k of the first side of sides that keep together, and taken off that of the
/// second: as a factor of d.
template <class Number>
std::vector<Number> tied_offsets(const scene::Problem<2>& problem, const Supports& supports, const PlainField& field,
                                 const scene::ContactFacet& pair) {
  const scene::Vector<2>& d = problem.facets[pair.first].normal;
  const std::vector<Number> meant = approach_on<Number>(problem, supports, field, pair);
  const std::vector<Number> plain =
      plain_approach_on<Number>(problem.mesh, field, pair, d, {meant.front(), meant.back()});
  const Number weight = Number(pair.second < 0 ? 1 : 2) * dot(vector2<Number>(d), vector2<Number>(d));
  std::vector<Number> factors;
  for (std::size_t k = 0; k < meant.size(); ++k) factors.push_back((meant[k] - plain[k]) / weight);
  return factors;
}

}  // namespace bracket::bounds
