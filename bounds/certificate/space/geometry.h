// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/space/vector3.h"

/// The bodies and their data as they are meant: cells, facets and data of the first mesh, cut at dyadic points. No
/// coordinate of a vertex that refinement made is looked at.
namespace bracket::bounds::space {

/// The value at a point of a facet of what is linear on it: exact at its vertices.
/// \param at the point's barycentric coordinates 1 and 2
template <class Value, class Number>
Value interpolated(const std::array<Value, 3>& v, const std::array<double, 2>& at) {
  const auto& [s, t] = at;
  if (s == 0 && t == 0) return v[0];
  if (s == 1) return v[1];
  if (t == 1) return v[2];
  Value result = v[0];
  if (s != 0) result = result + Number(s) * (v[1] - v[0]);
  if (t != 0) result = result + Number(t) * (v[2] - v[0]);
  return result;
}
/// The same of plain data.
template <class Number>
Vector3<Number> given_at(const std::array<scene::Vector<3>, 3>& v, const std::array<double, 2>& at) {
  return interpolated<Vector3<Number>, Number>({vector3<Number>(v[0]), vector3<Number>(v[1]), vector3<Number>(v[2])},
                                               at);
}
template <class Number> Number given_at(const std::array<double, 3>& v, const std::array<double, 2>& at) {
  return interpolated<Number, Number>({Number(v[0]), Number(v[1]), Number(v[2])}, at);
}

/// A cell's corners as seen from its first: differences of given coordinates, or dyadic combinations of them.
template <class Number> std::array<Vector3<Number>, 4> corners(const scene::Problem<3>& problem, int cell) {
  const scene::Problem<3>& first = scene::first_of(problem);
  const auto of = [&](int whole) -> std::array<Vector3<Number>, 3> {
    const auto& v = first.mesh.cells[whole];
    std::array<Vector3<Number>, 3> edge;
    for (int k = 0; k < 3; ++k) edge[k] = between<Number>(first.mesh.vertices[v[0]], first.mesh.vertices[v[k + 1]]);
    return edge;
  };
  std::array<Vector3<Number>, 4> x{};
  if (!problem.origin.first) {
    const auto edge = of(cell);
    for (int k = 0; k < 3; ++k) x[k + 1] = edge[k];
    return x;
  }
  const auto& [whole, corner] = problem.origin.cells[cell];
  const auto edge = of(whole);
  for (int i = 1; i < 4; ++i)
    for (int k = 0; k < 3; ++k)
      if (const double step = corner[i][k] - corner[0][k]; step != 0) x[i] = x[i] + Number(step) * edge[k];
  return x;
}

/// Six times the volume of a cell. \param x its corners
template <class Number> Number volume6(const std::array<Vector3<Number>, 4>& x) {
  return dot(x[1] - x[0], cross(x[2] - x[0], x[3] - x[0]));
}

/// What balanced_stress() asks of a cell; of a flat one, normals of small facets by their short edges and the volume by
/// the smallest facet, so that little cancels. \param x its corners
template <class Number> scene::BlockGeometry<3, Number> cell_geometry(const std::array<Vector3<Number>, 4>& x) {
  scene::BlockGeometry<3, Number> result{x, {}, Number(0)};
  const auto size = [](const Vector3<Number>& v) {
    const double a = rounded(v[0]), b = rounded(v[1]), c = rounded(v[2]);
    return a * a + b * b + c * c;
  };
  std::array<Vector3<Number>, 4> normal;  // inward, twice the area
  int smallest = 0;
  for (int k = 0; k < 4; ++k) {
    const auto& [a, b, c] = scene::Simplex<3>::facets[k];
    const std::array<Vector3<Number>, 3> edge = {x[b] - x[a], x[c] - x[b], x[a] - x[c]};
    int longest = 0;
    for (int e = 1; e < 3; ++e)
      if (size(edge[e]) > size(edge[longest])) longest = e;
    normal[k] = cross(edge[(longest + 2) % 3], edge[(longest + 1) % 3]);
    if (size(normal[k]) < size(normal[smallest])) smallest = k;
  }
  int nearest = scene::Simplex<3>::facets[smallest][0];
  for (const int vertex : scene::Simplex<3>::facets[smallest])
    if (size(x[smallest] - x[vertex]) < size(x[smallest] - x[nearest])) nearest = vertex;
  result.scaled_volume = dot(x[smallest] - x[nearest], normal[smallest]);
  for (int k = 0; k < 4; ++k)
    for (int i = 0; i < 3; ++i) result.gradient[k][i] = normal[k][i] / result.scaled_volume;
  return result;
}

/// A facet of the first mesh from its vertex 0 to its vertices 1 and 2.
template <class Number> std::array<Vector3<Number>, 2> whole_facet(const scene::Mesh<3>& first, int facet) {
  const auto& v = first.boundary[facet].vertices;
  return {between<Number>(first.vertices[v[0]], first.vertices[v[1]]),
          between<Number>(first.vertices[v[0]], first.vertices[v[2]])};
}
/// Its outward normal, as long as its area.
template <class Number> Vector3<Number> whole_area_vector(const scene::Mesh<3>& first, int facet) {
  const auto [e, f] = whole_facet<Number>(first, facet);
  return Number(0.5) * cross(e, f);
}
/// The part of its facet that a piece is: dyadic.
template <class Number> Number fraction(const scene::Piece<2>& piece) {
  const auto& c = piece.corner;
  const auto step = [&](int i, int k) { return Number(c[i][k] - c[0][k]); };
  return step(1, 0) * step(2, 1) - step(1, 1) * step(2, 0);
}

/// The corners of a facet as seen from a point.
template <class Number>
FacetVectors<Number> arms(const scene::Problem<3>& problem, const scene::Vector<3>& from, int facet) {
  const auto [of, corner] = scene::piece_of_facet(problem, facet);
  const scene::Mesh<3>& first = scene::first_of(problem).mesh;
  const auto& v = first.boundary[of].vertices;
  FacetVectors<Number> whole, x;
  for (int i = 0; i < 3; ++i) whole[i] = between<Number>(from, first.vertices[v[i]]);
  for (int i = 0; i < 3; ++i) x[i] = interpolated<Vector3<Number>, Number>(whole, corner[i]);
  return x;
}

/// Corner 0 of a cell as seen from a point.
template <class Number>
Vector3<Number> arm_of_cell(const scene::Problem<3>& problem, const scene::Vector<3>& from, int cell) {
  const auto [of, corner] = scene::piece_of_cell(problem, cell);
  const scene::Mesh<3>& first = scene::first_of(problem).mesh;
  const auto& v = first.cells[of];
  Vector3<Number> x = between<Number>(from, first.vertices[v[0]]);
  for (int k = 0; k < 3; ++k)
    if (corner[0][k] != 0)
      x = x + Number(corner[0][k]) * between<Number>(first.vertices[v[0]], first.vertices[v[k + 1]]);
  return x;
}

/// Whether a body has weight.
inline bool has_force(const scene::Problem<3>& problem, int body) {
  const auto& by = problem.perturbed.by;
  return !problem.bodies[body].force.isZero(0) || (by && !by->force[body].isZero(0));
}
/// The force on a body per volume.
template <class Number> Vector3<Number> body_force(const scene::Problem<3>& problem, int body) {
  const auto& [by, loads, kinematics] = problem.perturbed;
  if (!by) return vector3<Number>(problem.bodies[body].force);
  return vector3<Number>(scene::first_of(problem).bodies[body].force) +
         Number(loads) * vector3<Number>(by->force[body]);
}

/// A correction of the first mesh's loads, by its true amount: load density times area at the facet's vertices.
template <class Number> struct Corrected {
  int facet;  ///< of the first mesh
  FacetVectors<Number> load;
};

/// A load on a piece of a facet of the first mesh, density times area at its corners, by what is given at the vertices
/// of the whole: force per area, and pressure against its own normal.
template <class Number>
FacetVectors<Number> load_on_piece(const scene::Problem<3>& problem, const scene::Piece<2>& piece, bool has_traction,
                                   const FacetVectors<Number>& traction, const std::array<double, 3>& pressure) {
  const Vector3<Number> area_vector =
      fraction<Number>(piece) * whole_area_vector<Number>(scene::first_of(problem).mesh, piece.of);
  FacetVectors<Number> load{};
  if (has_traction) {
    const Number area = root(dot(area_vector, area_vector));
    for (int i = 0; i < 3; ++i) load[i] = area * interpolated<Vector3<Number>, Number>(traction, piece.corner[i]);
  }
  if (std::ranges::any_of(pressure, [](double p) { return p != 0; }))
    for (int i = 0; i < 3; ++i) load[i] = load[i] - given_at<Number>(pressure, piece.corner[i]) * area_vector;
  return load;
}

/// What a perturbation loads a facet with, as it is, without its factor; and whether it has anything there.
template <class Number> FacetVectors<Number> perturbing_load(const scene::Problem<3>& problem, int facet) {
  const scene::Piece<2> piece = scene::piece_of_facet(problem, facet);
  const auto& added = problem.perturbed.by->facets[piece.of];
  const auto& traction = added.traction;
  const bool has_traction = std::ranges::any_of(traction, [](const auto& t) { return !t.is_zero(); });
  return load_on_piece<Number>(
      problem, piece, has_traction,
      {vector3<Number>(traction[0]), vector3<Number>(traction[1]), vector3<Number>(traction[2])}, added.pressure);
}
inline bool is_loaded(const scene::Perturbation<3>::Facet& added) {
  return std::ranges::any_of(added.traction, [](const auto& t) { return !t.is_zero(); }) ||
         std::ranges::any_of(added.pressure, [](double p) { return p != 0; });
}
inline bool has_perturbing_load(const scene::Problem<3>& problem, int facet) {
  const auto& by = problem.perturbed.by;
  return by && is_loaded(by->facets[scene::piece_of_facet(problem, facet).of]);
}
/// What it has on a contact facet along d on the first side, against it on the second, at the first facet's vertices.
template <class Number>
std::array<Number, 3> opening_load(const scene::Problem<3>& problem, const scene::ContactFacetOf<3>& pair) {
  const scene::Piece<2> piece = scene::piece_of_facet(problem, pair.first);
  std::array<Number, 3> load = {Number(0), Number(0), Number(0)};
  const auto& by = problem.perturbed.by;
  if (!by) return load;
  const auto& opening = by->contact[by->contact_of[piece.of]].opening;
  if (std::ranges::all_of(opening, [](double o) { return o == 0; })) return load;
  const Vector3<Number> n =
      fraction<Number>(piece) * whole_area_vector<Number>(scene::first_of(problem).mesh, piece.of);
  const Number area = root(dot(n, n));
  for (int i = 0; i < 3; ++i) load[i] = area * given_at<Number>(opening, piece.corner[i]);
  return load;
}

/// Adds what corrections have on a facet of Γ_τ to a load on it.
template <class Number>
void add_corrections(const scene::Problem<3>& problem, const std::vector<Corrected<Number>>& corrections, int facet,
                     FacetVectors<Number>& load) {
  if (corrections.empty()) return;
  const scene::Piece<2> piece = scene::piece_of_facet(problem, facet);
  for (const auto& [of, added] : corrections)
    for (int i = 0; i < 3 && of == piece.of; ++i)
      load[i] = load[i] + fraction<Number>(piece) * interpolated<Vector3<Number>, Number>(added, piece.corner[i]);
}

/// All that is prescribed as the load of a facet: load density times area at its vertices.
template <class Number>
FacetVectors<Number> prescribed_load(const scene::Problem<3>& problem,
                                     const std::vector<Corrected<Number>>& corrections, int facet) {
  const scene::Piece<2> piece = scene::piece_of_facet(problem, facet);
  const auto& data = scene::first_of(problem).facets[piece.of];
  const auto& t = data.traction;
  const bool has_traction = std::ranges::any_of(t, [](const auto& one) { return !one.isZero(0); });
  FacetVectors<Number> load =
      load_on_piece<Number>(problem, piece, has_traction,
                            {vector3<Number>(t[0]), vector3<Number>(t[1]), vector3<Number>(t[2])}, data.pressure);
  if (has_perturbing_load(problem, facet)) {
    const auto added = perturbing_load<Number>(problem, facet);
    for (int i = 0; i < 3; ++i) load[i] = load[i] + Number(problem.perturbed.loads) * added[i];
  }
  add_corrections(problem, corrections, facet, load);
  return load;
}

/// Whether anything is prescribed as its load.
template <class Number>
bool carries_load(const scene::Problem<3>& problem, const std::vector<Corrected<Number>>& corrections, int facet) {
  const int of = scene::piece_of_facet(problem, facet).of;
  return scene::is_loaded(scene::first_of(problem).facets[of]) || has_perturbing_load(problem, facet) ||
         std::ranges::any_of(corrections, [&](const auto& one) { return one.facet == of; });
}

}  // namespace bracket::bounds::space
