// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/geometry.h"

/// What supports prescribe at vertices, by the data of the first mesh.
namespace bracket::bounds {

/// What a perturbation adds to the displacements prescribed at the ends of a facet of the first mesh.
struct Added {
  std::array<scene::TwofoldVector<2>, 2> end = {};  ///< U
  std::array<double, 2> normal = {0, 0};            ///< of U_n beside U·n
  double factor = 0;                                ///< 0: nothing
};

/// The displacement that a facet of Γ_u on the first mesh prescribes, at a point of it.
struct Held {
  std::array<scene::Vector<2>, 2> end = {scene::Vector<2>::Zero(), scene::Vector<2>::Zero()};  ///< at its vertices
  double t = 0;  ///< the point: 0 at vertex 0, 1 at vertex 1
  Added added = {};
};
/// U there.
template <class Number> Vector2<Number> added(const Held& held) {
  return between_ends(vector2<Number>(held.added.end[0]), vector2<Number>(held.added.end[1]), held.t);
}

/// What a facet of Γ_0 on the first mesh prescribes along its normal, at a point of it: linear between its vertices. At
/// a vertex that is fixed it is what that displacement has along the normal.
struct Slide {
  scene::Vector<2> normal = scene::Vector<2>::Zero();
  std::array<double, 2> end = {0, 0};
  std::array<bool, 2> fixed = {false, false};
  std::array<scene::Vector<2>, 2> displacement = {scene::Vector<2>::Zero(), scene::Vector<2>::Zero()};  ///< where fixed
  double t = 0;
  Added added = {};
};
/// U_n there.
template <class Number> Number added(const Slide& slide) {
  const Vector2<Number> n = vector2<Number>(slide.normal);
  std::array<Number, 2> end;
  for (int i = 0; i < 2; ++i) end[i] = dot(vector2<Number>(slide.added.end[i]), n) + Number(slide.added.normal[i]);
  return between_ends(end[0], end[1], slide.t);
}
template <class Number> Number value(const Slide& slide) {
  std::array<Number, 2> end;
  for (int i = 0; i < 2; ++i)
    end[i] = slide.fixed[i] ? dot(vector2<Number>(slide.displacement[i]), vector2<Number>(slide.normal))
                            : Number(slide.end[i]);
  const Number own = between_ends(end[0], end[1], slide.t);
  return slide.added.factor == 0 ? own : own + Number(slide.added.factor) * added<Number>(slide);
}

/// What the supports prescribe at a vertex.
struct VertexSupport {
  bool fixed = false;
  Held held;       ///< if fixed
  int slides = 0;  ///< else: u·normal = value, for up to two normals
  std::array<Slide, 2> slide;
};
std::vector<VertexSupport> vertex_supports(const scene::Problem<2>& problem);

/// Of each vertex of the first mesh: the facet of Γ_u that holds it, −1: none, and which of its ends it is.
struct FacetEnd {
  int facet = -1;
  int end = 0;
};
std::vector<FacetEnd> fixed_vertices(const scene::Problem<2>& first);
/// What is prescribed at the ends of a facet of Γ_0. \param fixed as fixed_vertices() has them
std::array<Slide, 2> slides_of(const scene::Problem<2>& problem, const std::vector<FacetEnd>& fixed, int facet);
/// What is prescribed at the ends of a facet of Γ_u.
std::array<Held, 2> holds_of(const scene::Problem<2>& problem, int facet);
template <class Number> std::array<Vector2<Number>, 2> held_at(const scene::Problem<2>& problem, int facet) {
  std::array<Vector2<Number>, 2> u;
  const auto holds = holds_of(problem, facet);
  for (int i = 0; i < 2; ++i) {
    const auto& [a, b] = holds[i].end;
    u[i] = between_ends(vector2<Number>(a), vector2<Number>(b), holds[i].t);
    if (holds[i].added.factor != 0) u[i] = u[i] + Number(holds[i].added.factor) * added<Number>(holds[i]);
  }
  return u;
}

/// The vector along `normal` that moves u onto u·normal = value.
template <class Number>
Vector2<Number> onto(const Vector2<Number>& u, const scene::Vector<2>& normal, const Number& value) {
  const Vector2<Number> n = vector2<Number>(normal);
  const Number missing = value - dot(n, u);
  return (missing / dot(n, n)) * n;
}

/// What is to be added to a vertex's plain displacement.
template <class Number> Vector2<Number> shift(const VertexSupport& support, const scene::Vector<2>& displacement) {
  const Vector2<Number> u = vector2<Number>(displacement);
  if (support.fixed) {  // in this order: the first difference is small, the second may be smaller still
    const auto& [a, b] = support.held.end;
    const Vector2<Number> from = between<Number>(displacement, a);
    const double t = support.held.t;
    const Vector2<Number> own = t == 0   ? from
                                : t == 1 ? between<Number>(displacement, b)
                                         : from + Number(t) * between<Number>(a, b);
    const double factor = support.held.added.factor;
    return factor == 0 ? own : own + Number(factor) * added<Number>(support.held);
  }
  if (support.slides == 0) return {};
  if (support.slides == 1) return onto(u, support.slide[0].normal, value<Number>(support.slide[0]));
  const Vector2<Number> a = vector2<Number>(support.slide[0].normal), b = vector2<Number>(support.slide[1].normal);
  const Number of_a = value<Number>(support.slide[0]) - dot(a, u), of_b = value<Number>(support.slide[1]) - dot(b, u);
  const Number determinant = cross(a, b);
  return {(of_a * b.y - of_b * a.y) / determinant, (of_b * a.x - of_a * b.x) / determinant};
}

/// u·d of a vertex, moved onto its support. Along a normal of its support it is the prescribed value, to the last bit.
template <class Number>
Number component(const VertexSupport& support, const scene::Vector<2>& displacement, const scene::Vector<2>& d) {
  for (int i = 0; i < support.slides; ++i) {
    if (support.slide[i].normal == d) return value<Number>(support.slide[i]);
    if (support.slide[i].normal == -d) return -value<Number>(support.slide[i]);
  }
  const Vector2<Number> along = vector2<Number>(d);
  return dot(vector2<Number>(displacement), along) + dot(shift<Number>(support, displacement), along);
}

/// Whether a support leaves a vertex no motion at all, or none along d.
inline bool holds(const VertexSupport& support) { return support.fixed || support.slides == 2; }
inline bool holds(const VertexSupport& support, const scene::Vector<2>& d) {
  return holds(support) || (support.slides == 1 && (support.slide[0].normal == d || support.slide[0].normal == -d));
}

/// What a support would prescribe without a perturbation, and what the perturbation adds, not times its factor.
VertexSupport own_part(VertexSupport support);
VertexSupport added_part(VertexSupport support);

}  // namespace bracket::bounds
