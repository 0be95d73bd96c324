// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "bounds/certificate/space/geometry.h"

/// What supports prescribe at nodes, by the data of the first mesh. A node is a vertex, with its displacement, or an
/// edge, with what the displacement's Bernstein coefficient has beside the mean of those at its ends.
namespace bracket::bounds::space {

/// What a perturbation adds to the displacements prescribed at the vertices of a facet of the first mesh.
struct Added {
  std::array<scene::TwofoldVector<3>, 3> end = {};  ///< U
  std::array<double, 3> normal = {0, 0, 0};         ///< of U_n beside U·n
  double factor = 0;                                ///< 0: nothing
};

/// The displacement that a facet of Γ_u on the first mesh prescribes, at a point of it; zero for an edge.
struct Prescribed {
  std::array<scene::Vector<3>, 3> end = scene::at_vertices<3>(scene::Vector<3>(scene::Vector<3>::Zero()));
  std::array<double, 2> at = {0, 0};  ///< barycentric coordinates 1, 2
  Added added = {};
};
/// U there.
template <class Number> Vector3<Number> added(const Prescribed& held) {
  const auto& u = held.added.end;
  return interpolated<Vector3<Number>, Number>({vector3<Number>(u[0]), vector3<Number>(u[1]), vector3<Number>(u[2])},
                                               held.at);
}
template <class Number> Vector3<Number> value(const Prescribed& held) {
  const Vector3<Number> own = given_at<Number>(held.end, held.at);
  return held.added.factor == 0 ? own : own + Number(held.added.factor) * added<Number>(held);
}

/// What a facet of Γ_0 on the first mesh prescribes along its normal, at a point of it: linear between its vertices,
/// and at a vertex that is fixed what that displacement has along the normal; zero for an edge.
struct Slide {
  scene::Vector<3> normal = scene::Vector<3>::Zero();
  std::array<double, 3> end = {0, 0, 0};
  std::array<bool, 3> fixed = {false, false, false};
  std::array<scene::Vector<3>, 3> displacement = Prescribed{}.end;  ///< where fixed
  std::array<double, 2> at = {0, 0};
  Added added = {};
};
/// U_n there.
template <class Number> Number added(const Slide& slide) {
  std::array<Number, 3> end;
  for (int i = 0; i < 3; ++i)
    end[i] = dot(vector3<Number>(slide.added.end[i]), vector3<Number>(slide.normal)) + Number(slide.added.normal[i]);
  return interpolated<Number, Number>(end, slide.at);
}
template <class Number> Number value(const Slide& slide) {
  std::array<Number, 3> end;
  for (int i = 0; i < 3; ++i)
    end[i] = slide.fixed[i] ? dot(vector3<Number>(slide.displacement[i]), vector3<Number>(slide.normal))
                            : Number(slide.end[i]);
  const Number own = interpolated<Number, Number>(end, slide.at);
  return slide.added.factor == 0 ? own : Number(own + Number(slide.added.factor) * added<Number>(slide));
}

/// What the supports prescribe at a node.
struct NodeSupport {
  bool fixed = false;
  Prescribed held;  ///< if fixed
  int slides = 0;   ///< else: u·normal = value, for up to three independent normals
  std::array<Slide, 3> slide;
};

/// Of each vertex of the first mesh: the facet of Γ_u that holds it, −1: none, and which of its vertices it is.
struct FacetCorner {
  int facet = -1;
  int corner = 0;
};
std::vector<FacetCorner> fixed_vertices(const scene::Problem<3>& first);
/// What is prescribed at the vertices of a facet of Γ_0. \param fixed as fixed_vertices() has them
std::array<Slide, 3> slides_of(const scene::Problem<3>& problem, const std::vector<FacetCorner>& fixed, int facet);
/// What is prescribed at the vertices of a facet of Γ_u.
std::array<Prescribed, 3> holds_of(const scene::Problem<3>& problem, int facet);
template <class Number> FacetVectors<Number> held_at(const scene::Problem<3>& problem, int facet) {
  const auto holds = holds_of(problem, facet);
  return {value<Number>(holds[0]), value<Number>(holds[1]), value<Number>(holds[2])};
}

/// The number of an edge as a node.
inline int node_of_edge(const scene::Mesh<3>& mesh, int edge) { return static_cast<int>(mesh.vertices.size()) + edge; }
/// The nodes of a boundary facet: its vertices, then its edges as Simplex<2>::edges has them.
std::array<int, 6> nodes_of_facet(const scene::Mesh<3>& mesh, int facet);
/// The node of a contact's second facet that lies on node k of the first; −1: a wall.
int node_across(const scene::Mesh<3>& mesh, const scene::ContactFacetOf<3>& pair, int k);

/// Of the nodes.
struct NodeSupports {
  std::vector<NodeSupport> support;  ///< of those that have any
  std::vector<int> of_node;          ///< index into them; −1: none
  const NodeSupport& of(int node) const {
    static const NodeSupport none;
    return of_node[node] < 0 ? none : support[of_node[node]];
  }
};
NodeSupports node_supports(const scene::Problem<3>& problem, const std::vector<FacetCorner>& fixed);

/// Whether a support leaves a node no motion at all, or d is one of the directions in which it holds it.
inline bool holds(const NodeSupport& support) { return support.fixed || support.slides == 3; }
inline bool holds(const NodeSupport& support, const scene::Vector<3>& d) {
  return holds(support) || std::any_of(support.slide.begin(), support.slide.begin() + support.slides,
                                       [&](const Slide& one) { return one.normal == d || one.normal == -d; });
}

/// Where a node that holds() is.
template <class Number> Vector3<Number> place(const NodeSupport& support) {
  if (support.fixed) return value<Number>(support.held);
  std::array<Vector3<Number>, 3> n;
  for (int k = 0; k < 3; ++k) n[k] = vector3<Number>(support.slide[k].normal);
  const Number determinant = dot(n[0], cross(n[1], n[2]));
  Vector3<Number> sum{};
  for (int k = 0; k < 3; ++k)
    sum = sum + (value<Number>(support.slide[k]) / determinant) * cross(n[(k + 1) % 3], n[(k + 2) % 3]);
  return sum;
}

/// v as far as a support lets a node move.
template <class Number> Vector3<Number> free_part(const NodeSupport& support, const Vector3<Number>& v) {
  if (holds(support)) return {};
  if (support.slides == 0) return v;
  const Vector3<Number> a = vector3<Number>(support.slide[0].normal);
  if (support.slides == 1) return v - (dot(a, v) / dot(a, a)) * a;
  const Vector3<Number> along = cross(a, vector3<Number>(support.slide[1].normal));
  return (dot(along, v) / dot(along, along)) * along;
}

/// What is to be added to a node's plain value u: the shortest way onto its support.
template <class Number> Vector3<Number> shift(const NodeSupport& support, const scene::Vector<3>& u) {
  if (holds(support)) return place<Number>(support) - vector3<Number>(u);
  if (support.slides == 0) return {};
  const auto missing = [&](int k) {
    return value<Number>(support.slide[k]) - dot(vector3<Number>(support.slide[k].normal), vector3<Number>(u));
  };
  const Vector3<Number> a = vector3<Number>(support.slide[0].normal);
  if (support.slides == 1) return (missing(0) / dot(a, a)) * a;
  const Vector3<Number> b = vector3<Number>(support.slide[1].normal), along = cross(a, b);
  const Number squared = dot(along, along);
  return (missing(0) / squared) * cross(b, along) + (missing(1) / squared) * cross(along, a);
}

/// u·d of a node, moved onto its support. Along a normal of its support it is the prescribed value, to the last bit.
template <class Number>
Number component(const NodeSupport& support, const scene::Vector<3>& u, const scene::Vector<3>& d) {
  for (int i = 0; i < support.slides; ++i) {
    if (support.slide[i].normal == d) return value<Number>(support.slide[i]);
    if (support.slide[i].normal == -d) return -value<Number>(support.slide[i]);
  }
  const Vector3<Number> along = vector3<Number>(d);
  if (holds(support)) return dot(place<Number>(support), along);
  return dot(vector3<Number>(u), along) + dot(shift<Number>(support, u), along);
}

}  // namespace bracket::bounds::space
