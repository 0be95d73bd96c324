// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bounds/certificate/judge.h"

/// What the judge's files share: exact geometry of cells, and fields on facets.
namespace bracket::bounds {

using Point = Vector2<Exact>;
using Corners = std::array<Point, 3>;

inline const Exact half(Rational(1, 2)), third(Rational(1, 3));

inline bool is_zero(const Point& v) { return is_zero(v.x) && is_zero(v.y); }

inline Corners corners_of(const scene::Mesh<2>& mesh, int cell) {
  Corners x;
  for (int k = 0; k < 3; ++k) x[k] = vector2<Exact>(mesh.vertices[mesh.cells[cell][k]]);
  return x;
}

inline Exact area(const Corners& x) { return half * cross(x[1] - x[0], x[2] - x[0]); }

/// Gradients of the barycentric coordinates.
inline std::array<Point, 3> gradients(const Corners& x) {
  const Exact doubled = Exact(2) * area(x);
  std::array<Point, 3> result;
  for (int k = 0; k < 3; ++k) {
    const Point &a = x[(k + 1) % 3], &b = x[(k + 2) % 3];
    result[k] = {(a.y - b.y) / doubled, (b.x - a.x) / doubled};
  }
  return result;
}

/// Corners of the part at side i → i + 1, in barycentric coordinates of the cell.
inline std::array<ExactVoigt, 3> part_corners(int i) {
  std::array<ExactVoigt, 3> result;
  result[0][i] = result[1][(i + 1) % 3] = Exact(1);
  result[2] = {third, third, third};
  return result;
}

inline Point at(const Corners& x, const ExactVoigt& barycentric) {
  return barycentric[0] * x[0] + barycentric[1] * x[1] + barycentric[2] * x[2];
}

inline ExactVoigt sum(const ExactVoigt& a, const ExactVoigt& b, const Exact& factor) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

/// σ (n ds)
inline Point on_normal(const ExactVoigt& s, const Point& n) {
  return {s[0] * n.x + s[2] * n.y, s[2] * n.x + s[1] * n.y};
}

/// Outward normal of a side of a body to its left, as long as the side.
inline Point outward(const Point& side) { return -turned(side); }

/// A field on a facet: at its vertices 0 and 1 and in the middle.
using OnFacet = std::array<Point, 3>;

inline OnFacet displacement_on(const scene::Mesh<2>& mesh, const ExactDisplacement& u, int facet) {
  const auto& [a, b] = mesh.boundary[facet].vertices;
  return {u.vertex[a], u.vertex[b], u.edge[mesh.boundary[facet].edge]};
}

/// λn per unit of the parameter along the facet.
inline OnFacet load_on(const scene::Mesh<2>& mesh, const ExactStress& stress, int facet) {
  const auto& [vertices, cell, local, edge, part] = mesh.boundary[facet];
  const Point n = outward(between<Exact>(mesh.vertices[vertices[0]], mesh.vertices[vertices[1]]));
  const auto& s = stress.cell[cell][(local + 1) % 3];
  const Point first = on_normal(s[0], n), second = on_normal(s[1], n);
  return {first, second, half * (first + second)};
}

/// The tractions of the data, per unit of the parameter, and what is added to them.
inline OnFacet traction_on(const scene::Problem<2>& problem, const std::vector<Corrected<Exact>>& added, int facet) {
  const auto& mesh = problem.mesh;
  const auto& [a, b] = mesh.boundary[facet].vertices;
  const Point side = between<Exact>(mesh.vertices[a], mesh.vertices[b]);
  const auto& data = problem.facets[facet];
  OnFacet result;
  if (!data.traction[0].isZero(0) || !data.traction[1].isZero(0)) {
    const Exact length = root(dot(side, side));
    for (int i = 0; i < 2; ++i) result[i] = length * vector2<Exact>(data.traction[i]);
  }
  for (int i = 0; i < 2; ++i) result[i] = result[i] - Exact(data.pressure[i]) * outward(side);
  for (const auto& [at_facet, load] : added)
    for (int i = 0; i < 2 && at_facet == facet; ++i) result[i] = result[i] + load[i];
  result[2] = half * (result[0] + result[1]);
  return result;
}

/// On a contact facet, at its first side's vertices and in the middle: r = (u' − u'')·d; so too g and p.
inline ExactVoigt approach(const scene::Problem<2>& problem, const ExactDisplacement& u,
                           const scene::ContactFacet& pair) {
  const Point d = vector2<Exact>(problem.facets[pair.first].normal);
  const OnFacet first = displacement_on(problem.mesh, u, pair.first);
  ExactVoigt r = {dot(first[0], d), dot(first[1], d), dot(first[2], d)};
  if (pair.second < 0) return r;
  const OnFacet second = displacement_on(problem.mesh, u, pair.second);
  return {r[0] - dot(second[1], d), r[1] - dot(second[0], d), r[2] - dot(second[2], d)};
}

/// The gap that the lower bound pays for.
inline ExactVoigt gap(const scene::ContactFacet& pair) {
  const Exact begin(pair.upper[0]), middle(pair.upper[1]), end(pair.upper[2]);
  return {begin, end, half * (half * (begin + end) + middle)};
}

inline ExactVoigt pressure(const scene::Problem<2>& problem, const ExactStress& stress,
                           const scene::ContactFacet& pair) {
  const Point d = vector2<Exact>(problem.facets[pair.first].normal);
  const OnFacet load = load_on(problem.mesh, stress, pair.first);
  const bool loaded = scene::is_loaded(problem.facets[pair.first]);  // of a perturbed problem
  const OnFacet given = loaded ? traction_on(problem, {}, pair.first) : OnFacet{};
  ExactVoigt p;
  for (int i = 0; i < 3; ++i) p[i] = dot(given[i] - load[i], d) / dot(d, d);
  return p;
}

}  // namespace bracket::bounds
