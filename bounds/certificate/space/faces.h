// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/space/vector3.h"

/// Loads on the faces of cells. One is written down once for both cells: as it acts on the first, the cell with the
/// lower number, at the vertices of its facet in the order of Simplex::facets. On the other it is the opposite, so
/// tractions are continuous.
namespace bracket::bounds::space {

struct Face {
  std::array<int, 2> cell = {-1, -1};   ///< −1: none, a boundary facet
  std::array<int, 2> local = {-1, -1};  ///< which facet of it
  std::array<int, 3> across{};          ///< which vertex of the second cell's facet is vertex i of the first's
};
/// As the numbers of facets. \pre topology_fault() finds none
std::vector<Face> faces_of(const scene::Mesh<3>& mesh);

/// A load on a face as it acts on one of its cells, at the vertices of that cell's facet.
template <class Number>
FacetVectors<Number> seen_from(const FacetVectors<Number>& load, const Face& face, bool second) {
  if (!second) return load;
  FacetVectors<Number> result;
  for (int i = 0; i < 3; ++i) result[face.across[i]] = -load[i];
  return result;
}
/// The other way round.
template <class Number>
FacetVectors<Number> as_of_face(const FacetVectors<Number>& load, const Face& face, bool second) {
  if (!second) return load;
  FacetVectors<Number> result;
  for (int i = 0; i < 3; ++i) result[i] = -load[face.across[i]];
  return result;
}

/// A force and its moment about some point.
template <class Number> struct Wrench { Vector3<Number> force{}, moment{}; };
template <class Number> void add(Wrench<Number>& sum, const Wrench<Number>& part) {
  sum.force = sum.force + part.force;
  sum.moment = sum.moment + part.moment;
}

/// What a load (density times area at the vertices) adds up to. \param x the vertices, seen from the point
template <class Number> Wrench<Number> resultant(const FacetVectors<Number>& load, const FacetVectors<Number>& x) {
  const Vector3<Number> all = sum(load);
  Vector3<Number> moment = cross(sum(x), all);
  for (int i = 0; i < 3; ++i) moment = moment + cross(x[i], load[i]);
  return {(Number(1) / Number(3)) * all, (Number(1) / Number(12)) * moment};
}

/// The smallest load with a resultant, in the sense of Σ |f_j|²: f_j = F + b × y_j, y from the centroid, with
///     b = 36 Y M / |N|² + 36 (M·N) N / (|N|² Σ |e|²),     N = (x_2 − x_1) × (x_3 − x_1), Y = Σ y yᵀ, e the edges
/// (docs/theory.md §7).   \param x the vertices, seen from the point of the moment
template <class Number> FacetVectors<Number> load_with(const Wrench<Number>& wanted, const FacetVectors<Number>& x) {
  const Vector3<Number> centroid = (Number(1) / Number(3)) * sum(x);
  const Vector3<Number> moment = wanted.moment - cross(centroid, wanted.force);
  const std::array<Vector3<Number>, 3> edge = {x[1] - x[0], x[2] - x[1], x[0] - x[2]};
  const Vector3<Number> normal = cross(edge[0], edge[1]);
  const Number factor = Number(36) / dot(normal, normal);
  const Number squares = dot(edge[0], edge[0]) + dot(edge[1], edge[1]) + dot(edge[2], edge[2]);
  FacetVectors<Number> y;
  for (int i = 0; i < 3; ++i) y[i] = x[i] - centroid;
  Vector3<Number> b = (dot(moment, normal) / squares) * normal;
  for (int i = 0; i < 3; ++i) b = b + dot(y[i], moment) * y[i];
  b = factor * b;
  FacetVectors<Number> load;
  for (int i = 0; i < 3; ++i) load[i] = wanted.force + cross(b, y[i]);
  return load;
}

}  // namespace bracket::bounds::space
