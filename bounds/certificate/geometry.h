// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "bounds/certificate/vector2.h"
#include "scene/problem/stretch.h"

/// The bodies and their data as they are meant: cells, facets and data of the first mesh, cut at dyadic points. No
/// coordinate of a vertex that refinement made is looked at.
namespace bracket::bounds {

using scene::between_ends;
template <class Number> Vector2<Number> between_ends(const Vector2<Number>& a, const Vector2<Number>& b, double t) {
  return {between_ends(a.x, b.x, t), between_ends(a.y, b.y, t)};
}

/// A cell's corners as seen from its first: differences of given coordinates, or dyadic combinations of them.
template <class Number> std::array<Vector2<Number>, 3> corners(const scene::Problem<2>& problem, int cell) {
  const scene::Problem<2>& first = scene::first_of(problem);
  const auto of = [&](int whole) -> std::array<Vector2<Number>, 2> {
    const auto& [a, b, c] = first.mesh.cells[whole];
    return {between<Number>(first.mesh.vertices[a], first.mesh.vertices[b]),
            between<Number>(first.mesh.vertices[a], first.mesh.vertices[c])};
  };
  std::array<Vector2<Number>, 3> x;
  if (!problem.origin.first) {
    const auto [to_second, to_third] = of(cell);
    x[1] = to_second;
    x[2] = to_third;
    return x;
  }
  const auto& [whole, corner] = problem.origin.cells[cell];
  const auto [e, f] = of(whole);
  for (int i = 1; i < 3; ++i) x[i] = Number(corner[i][0] - corner[0][0]) * e + Number(corner[i][1] - corner[0][1]) * f;
  return x;
}

/// Twice the area of a cell. \param x its corners
template <class Number> Number doubled_area(const std::array<Vector2<Number>, 3>& x) {
  return cross(x[1] - x[0], x[2] - x[0]);
}

/// A facet of the first mesh from its vertex 0 to its vertex 1.
template <class Number> Vector2<Number> whole_facet(const scene::Mesh<2>& first, int facet) {
  const auto& [a, b] = first.boundary[facet].vertices;
  return between<Number>(first.vertices[a], first.vertices[b]);
}

/// A facet from its vertex 0 to its vertex 1.
template <class Number> Vector2<Number> along(const scene::Problem<2>& problem, int facet) {
  const auto [of, corner] = scene::piece_of_facet(problem, facet);
  const Vector2<Number> whole = whole_facet<Number>(scene::first_of(problem).mesh, of);
  const double width = corner[1][0] - corner[0][0];
  return width == 1 ? whole : Number(width) * whole;
}

/// Vertex 0 of a facet as seen from a point.
template <class Number> Vector2<Number> arm(const scene::Problem<2>& problem, const scene::Vector<2>& from, int facet) {
  const auto [of, corner] = scene::piece_of_facet(problem, facet);
  const scene::Mesh<2>& first = scene::first_of(problem).mesh;
  const Vector2<Number> begin = between<Number>(from, first.vertices[first.boundary[of].vertices[0]]);
  const double t = corner[0][0];
  return t == 0 ? begin : begin + Number(t) * whole_facet<Number>(first, of);
}

/// Corner 0 of a cell as seen from a point.
template <class Number>
Vector2<Number> arm_of_cell(const scene::Problem<2>& problem, const scene::Vector<2>& from, int cell) {
  const auto [of, corner] = scene::piece_of_cell(problem, cell);
  const scene::Mesh<2>& first = scene::first_of(problem).mesh;
  const auto& v = first.cells[of];
  Vector2<Number> x = between<Number>(from, first.vertices[v[0]]);
  for (int k = 0; k < 2; ++k)
    if (corner[0][k] != 0)
      x = x + Number(corner[0][k]) * between<Number>(first.vertices[v[0]], first.vertices[v[k + 1]]);
  return x;
}

/// A load on a facet per unit of its parameter, at its two ends: what is linear of it.
template <class Number> using FacetLoad = std::array<Vector2<Number>, 2>;
/// All of it.
template <class Number> struct WholeLoad {
  FacetLoad<Number> linear;
  std::array<Vector2<Number>, 2> higher;  ///< the coefficients of P_2 and P_3
  int degree = 1;                         ///< from which on these are zero
};

/// Whether a body has weight.
inline bool has_force(const scene::Problem<2>& problem, int body) {
  const auto& by = problem.perturbed.by;
  return !problem.bodies[body].force.isZero(0) || (by && !by->force[body].isZero(0));
}
/// The force on a body per volume.
template <class Number> Vector2<Number> body_force(const scene::Problem<2>& problem, int body) {
  const auto& [by, loads, kinematics] = problem.perturbed;
  if (!by) return vector2<Number>(problem.bodies[body].force);
  return vector2<Number>(scene::first_of(problem).bodies[body].force) +
         Number(loads) * vector2<Number>(by->force[body]);
}

/// A polynomial on a piece of a facet of the first mesh, by that on the whole. \param degree 1: there is nothing beside
/// what is linear
template <class Number, class Value>
scene::EdgeCubic<Value> on_piece(const scene::EdgeCubic<Value>& whole, int degree, const scene::Piece<1>& piece) {
  const double from = piece.corner[0][0], to = piece.corner[1][0];
  if (degree > 1) return scene::on_stretch<Number>(whole, from, to);
  const auto& [a, b] = whole.linear;
  return {{between_ends(a, b, from), between_ends(a, b, to)}, whole.higher};
}

/// What acts on a facet of the first mesh: force per length, and pressure against its own normal.
template <class Number> struct GivenLoad {
  scene::EdgeCubic<Vector2<Number>> traction;
  scene::EdgeCubic<Number> pressure;
  int degree;  ///< of both
  bool has_traction, has_pressure;
};
/// That of a facet's data, or of what a perturbation adds to it.
template <class Number, class Data> GivenLoad<Number> given_on(const Data& data) {
  const auto vectors = [](const auto& of) { return std::array{vector2<Number>(of[0]), vector2<Number>(of[1])}; };
  const auto numbers = [](const std::array<double, 2>& of) { return std::array{Number(of[0]), Number(of[1])}; };
  const auto is_none = [](const auto& load) {
    if constexpr (requires { load.is_zero(); })
      return load.is_zero();
    else
      return load.isZero(0);
  };
  GivenLoad<Number> given{{vectors(data.traction), vectors(data.higher_traction)},
                          {numbers(data.pressure), numbers(data.higher_pressure)},
                          1,
                          !is_none(data.traction[0]) || !is_none(data.traction[1]),
                          data.pressure[0] != 0 || data.pressure[1] != 0};
  for (int k = 0; k < 2; ++k) {
    const bool pulls = !is_none(data.higher_traction[k]), presses = data.higher_pressure[k] != 0;
    if (pulls || presses) given.degree = k + 2;
    given.has_traction |= pulls;
    given.has_pressure |= presses;
  }
  return given;
}

/// The load on a piece of the facet.
template <class Number>
WholeLoad<Number> load_on_piece(const scene::Problem<2>& problem, const scene::Piece<1>& piece,
                                const GivenLoad<Number>& given) {
  const Vector2<Number> e = whole_facet<Number>(scene::first_of(problem).mesh, piece.of);
  const auto& corner = piece.corner;
  const Number width(corner[1][0] - corner[0][0]);
  WholeLoad<Number> load;
  load.degree = given.degree;
  if (given.has_traction) {
    const Number length = width * root(dot(e, e));
    const auto on = on_piece<Number>(given.traction, given.degree, piece);
    for (int i = 0; i < 2; ++i) load.linear[i] = length * on.linear[i];
    for (int k = 2; k <= given.degree; ++k) load.higher[k - 2] = length * on.higher[k - 2];
  }
  if (given.has_pressure) {
    const Vector2<Number> inward = width * turned(e);
    const auto on = on_piece<Number>(given.pressure, given.degree, piece);
    for (int i = 0; i < 2; ++i) load.linear[i] = load.linear[i] + on.linear[i] * inward;
    for (int k = 2; k <= given.degree; ++k) load.higher[k - 2] = load.higher[k - 2] + on.higher[k - 2] * inward;
  }
  return load;
}

/// What a perturbation loads a facet with, as it is, without its factor.
template <class Number> WholeLoad<Number> perturbing_load(const scene::Problem<2>& problem, int facet) {
  const scene::Piece<1> piece = scene::piece_of_facet(problem, facet);
  return load_on_piece(problem, piece, given_on<Number>(problem.perturbed.by->facets[piece.of]));
}
/// Whether it has anything there.
inline bool is_loaded(const scene::Perturbation<2>::Facet& added) {
  return !added.traction[0].is_zero() || !added.traction[1].is_zero() || added.pressure[0] != 0 ||
         added.pressure[1] != 0 || scene::degree_of_load<2>(added) > 1;
}
inline bool has_perturbing_load(const scene::Problem<2>& problem, int facet) {
  const auto& by = problem.perturbed.by;
  return by && is_loaded(by->facets[scene::piece_of_facet(problem, facet).of]);
}
/// What it has on a contact facet along d or t on the first side, against it on the second, at the first facet's
/// vertices.   \param which opening or shear
template <class Number>
std::array<Number, 2> contact_load(const scene::Problem<2>& problem, const scene::ContactFacet& pair,
                                   std::array<double, 2> scene::Perturbation<2>::Contact::*which) {
  const auto& by = problem.perturbed.by;
  if (!by) return {Number(0), Number(0)};
  const auto [of, corner] = scene::piece_of_facet(problem, pair.first);
  const auto& [a, b] = by->contact[by->contact_of[of]].*which;
  if (a == 0 && b == 0) return {Number(0), Number(0)};
  const Vector2<Number> e = along<Number>(problem, pair.first);
  const Number length = root(dot(e, e));
  return {length * between_ends(Number(a), Number(b), corner[0][0]),
          length * between_ends(Number(a), Number(b), corner[1][0])};
}
template <class Number>
std::array<Number, 2> opening_load(const scene::Problem<2>& problem, const scene::ContactFacet& pair) {
  return contact_load<Number>(problem, pair, &scene::Perturbation<2>::Contact::opening);
}
template <class Number>
std::array<Number, 2> shear_load(const scene::Problem<2>& problem, const scene::ContactFacet& pair) {
  return contact_load<Number>(problem, pair, &scene::Perturbation<2>::Contact::shear);
}

/// The prescribed load of a facet of Γ_τ but for corrections: those of the first mesh's facet, on its piece.
template <class Number> WholeLoad<Number> given_load(const scene::Problem<2>& problem, int facet) {
  const scene::Piece<1> piece = scene::piece_of_facet(problem, facet);
  const GivenLoad<Number> given = given_on<Number>(scene::first_of(problem).facets[piece.of]);
  WholeLoad<Number> load = load_on_piece(problem, piece, given);
  if (!has_perturbing_load(problem, facet)) return load;
  const WholeLoad<Number> added = perturbing_load<Number>(problem, facet);
  const Number factor(problem.perturbed.loads);
  load.degree = std::max(load.degree, added.degree);
  for (int i = 0; i < 2; ++i) {
    load.linear[i] = load.linear[i] + factor * added.linear[i];
    load.higher[i] = load.higher[i] + factor * added.higher[i];
  }
  return load;
}

}  // namespace bracket::bounds
