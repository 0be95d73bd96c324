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

/// The prescribed load of a facet of Γ_τ but for corrections: those of the first mesh's facet, on its piece.
template <class Number> FacetLoad<Number> given_load(const scene::Problem<2>& problem, int facet) {
  const auto [of, corner] = scene::piece_of_facet(problem, facet);
  const scene::Problem<2>& first = scene::first_of(problem);
  const scene::FacetData<2>& data = first.facets[of];
  const Vector2<Number> e = whole_facet<Number>(first.mesh, of);
  const Number width(corner[1][0] - corner[0][0]);
  FacetLoad<Number> load;
  if (!data.traction[0].isZero(0) || !data.traction[1].isZero(0)) {
    const Number length = width * root(dot(e, e));
    for (int i = 0; i < 2; ++i)
      load[i] =
          length * between_ends(vector2<Number>(data.traction[0]), vector2<Number>(data.traction[1]), corner[i][0]);
  }
  if (data.pressure[0] != 0 || data.pressure[1] != 0) {
    const Vector2<Number> inward = width * turned(e);
    for (int i = 0; i < 2; ++i)
      load[i] = load[i] + between_ends(Number(data.pressure[0]), Number(data.pressure[1]), corner[i][0]) * inward;
  }
  return load;
}

}  // namespace bracket::bounds
