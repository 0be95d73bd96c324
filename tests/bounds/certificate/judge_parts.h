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

/// The coordinates of a cell as functions of those of its part at side i → i + 1.
inline std::array<Polynomial, 3> coordinates_on_part(int i) {
  std::array<Polynomial, 3> result;
  for (int k = 0; k < 3; ++k)
    result[k] = Polynomial::linear({Exact(k == i ? 1 : 0), Exact(k == (i + 1) % 3 ? 1 : 0), third});
  return result;
}

inline StressField sum(const StressField& a, const StressField& b, const Exact& factor) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

/// σ (n ds)
inline Field on_normal(const StressField& s, const Point& n) {
  return {n.x * s[0] + n.y * s[2], n.x * s[2] + n.y * s[1]};
}

/// Outward normal of a side of a body to its left, as long as the side.
inline Point outward(const Point& side) { return -turned(side); }

inline Polynomial dot(const Field& a, const Point& b) { return b.x * a[0] + b.y * a[1]; }
inline Polynomial dot(const Field& a, const Field& b) { return a[0] * b[0] + a[1] * b[1]; }
inline Field operator-(const Field& a, const Field& b) { return {a[0] - b[0], a[1] - b[1]}; }
inline Field operator+(const Field& a, const Field& b) { return {a[0] + b[0], a[1] + b[1]}; }
inline bool is_zero(const Field& a) { return a[0].is_zero() && a[1].is_zero(); }
inline Field on_side(const Field& a, int i, int j) { return {a[0].on_side(i, j), a[1].on_side(i, j)}; }
inline Field reversed(const Field& a) { return {a[0].reversed(), a[1].reversed()}; }
inline Field between_points(const Point& a, const Point& b) {
  return {Polynomial::linear({a.x, b.x}), Polynomial::linear({a.y, b.y})};
}

/// On a facet from its vertex 0 to its vertex 1: u, and λn per unit of the parameter.
inline Field displacement_on(const scene::Mesh<2>& mesh, const ExactDisplacement& u, int facet) {
  const auto& on = mesh.boundary[facet];
  const auto& [i, j] = scene::Simplex<2>::facets[on.local];
  return on_side(u.cell[on.cell], i, j);
}
inline Field load_on(const scene::Mesh<2>& mesh, const ExactStress& stress, int facet) {
  const auto& on = mesh.boundary[facet];
  const Point n = outward(between<Exact>(mesh.vertices[on.vertices[0]], mesh.vertices[on.vertices[1]]));
  return on_side(on_normal(stress.cell[on.cell][(on.local + 1) % 3], n), 0, 1);
}

/// Linear between the ends, and beside it Legendre's polynomials of degrees 2 and 3.
inline Field load_of(const std::array<Point, 2>& ends, const std::array<Point, 2>& higher) {
  const auto term = [](int i, int j, int factor) { return Polynomial::monomial(2, {i, j, 0}, Exact(factor)); };
  const std::array<Polynomial, 2> legendre = {term(2, 0, 1) + term(1, 1, -4) + term(0, 2, 1),
                                              term(3, 0, -1) + term(2, 1, 9) + term(1, 2, -9) + term(0, 3, 1)};
  Field result = between_points(ends[0], ends[1]);
  for (int k = 0; k < 2; ++k)
    if (!is_zero(higher[k])) result = result + Field{higher[k].x * legendre[k], higher[k].y * legendre[k]};
  return result;
}

/// The tractions of the data, per unit of the parameter, and what is added to them.
inline Field traction_on(const scene::Problem<2>& problem, const std::vector<Corrected<Exact>>& added, int facet) {
  const auto& mesh = problem.mesh;
  const auto& [a, b] = mesh.boundary[facet].vertices;
  const Point side = between<Exact>(mesh.vertices[a], mesh.vertices[b]);
  const auto& data = problem.facets[facet];
  std::array<Point, 2> linear, higher;
  const auto is_none = [](const scene::Vector<2>& x) { return x.isZero(0); };
  if (!std::ranges::all_of(data.traction, is_none) || !std::ranges::all_of(data.higher_traction, is_none)) {
    const Exact length = root(dot(side, side));
    for (int i = 0; i < 2; ++i) linear[i] = length * vector2<Exact>(data.traction[i]);
    for (int i = 0; i < 2; ++i) higher[i] = length * vector2<Exact>(data.higher_traction[i]);
  }
  for (int i = 0; i < 2; ++i) linear[i] = linear[i] - Exact(data.pressure[i]) * outward(side);
  for (int i = 0; i < 2; ++i) higher[i] = higher[i] - Exact(data.higher_pressure[i]) * outward(side);
  for (const auto& [at_facet, load] : added)
    for (int i = 0; i < 2 && at_facet == facet; ++i) linear[i] = linear[i] + load[i];
  return load_of(linear, higher);
}

/// On a contact facet, along its first side: r = (u' − u'')·d; so too g and p.
inline Polynomial approach(const scene::Problem<2>& problem, const ExactDisplacement& u,
                           const scene::ContactFacet& pair) {
  const Point d = vector2<Exact>(problem.facets[pair.first].normal);
  const Polynomial r = dot(displacement_on(problem.mesh, u, pair.first), d);
  return pair.second < 0 ? r : r - dot(displacement_on(problem.mesh, u, pair.second), d).reversed();
}

/// A gap by its Bernstein coefficients.
inline Polynomial gap_of(const std::array<double, 3>& c) {
  return Polynomial::monomial(2, {2, 0, 0}, Exact(c[0])) + Polynomial::monomial(2, {1, 1, 0}, Exact(2) * Exact(c[1])) +
         Polynomial::monomial(2, {0, 2, 0}, Exact(c[2]));
}
/// The gap that the lower bound pays for. That of two-sided facets is a function near its bounds, which the certificate
/// is asked for.
inline Polynomial gap(const scene::Problem<2>& problem, const scene::ContactFacet& pair) {
  if (!pair.law.two_sided) return gap_of(pair.upper);
  const auto c = kept_gap<Exact>(problem, first_contacts(problem), pair);
  return Polynomial::monomial(2, {2, 0, 0}, c[0]) + Polynomial::monomial(2, {1, 1, 0}, Exact(2) * c[1]) +
         Polynomial::monomial(2, {0, 2, 0}, c[2]);
}

/// What friction does not see of the slip, which the certificate is asked for: of a jump, and of a perturbation.
inline Polynomial unseen(const scene::Problem<2>& problem, const scene::ContactFacet& pair) {
  const auto c = unseen_slip<Exact>(problem, first_contacts(problem), pair);
  if (c.empty()) return Polynomial();
  return Polynomial::monomial(2, {2, 0, 0}, c[0]) + Polynomial::monomial(2, {1, 1, 0}, Exact(2) * c[1]) +
         Polynomial::monomial(2, {0, 2, 0}, c[2]);
}

/// What friction sees of (u' − u'')·t likewise, and τ, per unit of the parameter as p is.
inline Polynomial slip(const scene::Problem<2>& problem, const ExactDisplacement& u, const scene::ContactFacet& pair) {
  const Point t = turned(vector2<Exact>(problem.facets[pair.first].normal));
  const Polynomial v = dot(displacement_on(problem.mesh, u, pair.first), t);
  const Polynomial seen = v - unseen(problem, pair);
  return pair.second < 0 ? seen : seen - dot(displacement_on(problem.mesh, u, pair.second), t).reversed();
}
/// λn on a facet of Γ_0 or Γ_K less the load of a perturbed problem there: what the support or the other side does.
inline Field reaction_on(const scene::Problem<2>& problem, const ExactStress& stress, int facet) {
  const Field load = load_on(problem.mesh, stress, facet);
  return scene::is_loaded(problem.facets[facet]) ? load - traction_on(problem, {}, facet) : load;
}
inline Polynomial shear(const scene::Problem<2>& problem, const ExactStress& stress, const scene::ContactFacet& pair) {
  const Point t = turned(vector2<Exact>(problem.facets[pair.first].normal));
  return (Exact(-1) / dot(t, t)) * dot(reaction_on(problem, stress, pair.first), t);
}
inline Exact length_of(const scene::Problem<2>& problem, const scene::ContactFacet& pair) {
  const auto& [a, b] = problem.mesh.boundary[pair.first].vertices;
  const Point side = between<Exact>(problem.mesh.vertices[a], problem.mesh.vertices[b]);
  return root(dot(side, side));
}
inline Polynomial linear_on(const std::array<double, 2>& ends) {
  return Polynomial::linear({Exact(ends[0]), Exact(ends[1])});
}

inline Polynomial pressure(const scene::Problem<2>& problem, const ExactStress& stress,
                           const scene::ContactFacet& pair) {
  const Point d = vector2<Exact>(problem.facets[pair.first].normal);
  return (Exact(-1) / dot(d, d)) * dot(reaction_on(problem, stress, pair.first), d);
}

}  // namespace bracket::bounds
