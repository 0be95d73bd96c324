// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// A load on a facet per unit of its parameter, at its two ends.
template <class Number> using FacetLoad = std::array<Vector2<Number>, 2>;

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

/// A load on a piece of a facet of the first mesh, by what is given at the ends of the whole: force per length, and
/// pressure against its own normal.
template <class Number>
FacetLoad<Number> load_on_piece(const scene::Problem<2>& problem, const scene::Piece<1>& piece, bool has_traction,
                                const std::array<Vector2<Number>, 2>& traction, const std::array<double, 2>& pressure) {
  const Vector2<Number> e = whole_facet<Number>(scene::first_of(problem).mesh, piece.of);
  const auto& corner = piece.corner;
  const Number width(corner[1][0] - corner[0][0]);
  FacetLoad<Number> load;
  if (has_traction) {
    const Number length = width * root(dot(e, e));
    for (int i = 0; i < 2; ++i) load[i] = length * between_ends(traction[0], traction[1], corner[i][0]);
  }
  if (pressure[0] != 0 || pressure[1] != 0) {
    const Vector2<Number> inward = width * turned(e);
    for (int i = 0; i < 2; ++i)
      load[i] = load[i] + between_ends(Number(pressure[0]), Number(pressure[1]), corner[i][0]) * inward;
  }
  return load;
}

/// What a perturbation has on a facet of Γ_τ, as it is, without its factor.
template <class Number> FacetLoad<Number> perturbing_load(const scene::Problem<2>& problem, int facet) {
  const scene::Piece<1> piece = scene::piece_of_facet(problem, facet);
  const auto& added = problem.perturbed.by->facets[piece.of];
  const bool has_traction = !added.traction[0].is_zero() || !added.traction[1].is_zero();
  return load_on_piece<Number>(problem, piece, has_traction,
                               {vector2<Number>(added.traction[0]), vector2<Number>(added.traction[1])},
                               added.pressure);
}
/// Whether it has anything there.
inline bool is_loaded(const scene::Perturbation<2>::Facet& added) {
  return !added.traction[0].is_zero() || !added.traction[1].is_zero() || added.pressure[0] != 0 ||
         added.pressure[1] != 0;
}
inline bool has_perturbing_load(const scene::Problem<2>& problem, int facet) {
  const auto& by = problem.perturbed.by;
  return by && is_loaded(by->facets[scene::piece_of_facet(problem, facet).of]);
}
/// What it has on a contact facet along d on the first side, against it on the second, at the first facet's vertices.
template <class Number>
std::array<Number, 2> opening_load(const scene::Problem<2>& problem, const scene::ContactFacet& pair) {
  const auto& by = problem.perturbed.by;
  if (!by) return {Number(0), Number(0)};
  const auto [of, corner] = scene::piece_of_facet(problem, pair.first);
  const auto& [a, b] = by->contact[by->contact_of[of]].opening;
  if (a == 0 && b == 0) return {Number(0), Number(0)};
  const Vector2<Number> e = along<Number>(problem, pair.first);
  const Number length = root(dot(e, e));
  return {length * between_ends(Number(a), Number(b), corner[0][0]),
          length * between_ends(Number(a), Number(b), corner[1][0])};
}

/// The prescribed load of a facet of Γ_τ but for corrections: those of the first mesh's facet, on its piece.
template <class Number> FacetLoad<Number> given_load(const scene::Problem<2>& problem, int facet) {
  const scene::Piece<1> piece = scene::piece_of_facet(problem, facet);
  const scene::FacetData<2>& data = scene::first_of(problem).facets[piece.of];
  const bool has_traction = !data.traction[0].isZero(0) || !data.traction[1].isZero(0);
  FacetLoad<Number> load =
      load_on_piece<Number>(problem, piece, has_traction,
                            {vector2<Number>(data.traction[0]), vector2<Number>(data.traction[1])}, data.pressure);
  if (!has_perturbing_load(problem, facet)) return load;
  const FacetLoad<Number> added = perturbing_load<Number>(problem, facet);
  for (int i = 0; i < 2; ++i) load[i] = load[i] + Number(problem.perturbed.loads) * added[i];
  return load;
}

}  // namespace bracket::bounds
