// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "scene/enclosure.h"
#include "scene/scene.h"

/// Weights on contacts.
namespace bracket::bounds {

/// A quadratic on each contact facet of the first mesh, as Problem::contact.
template <int dim> using FacetWeights = std::vector<scene::FacetQuadratic<dim>>;

/// Where the coefficient of a vertex of the facet is, and of an edge: in the plane of what lies between the ends.
template <int dim> constexpr int vertex_place(int i) { return dim == 2 ? 2 * i : i; }
template <int dim> constexpr int edge_place(int e) { return dim == 2 ? 1 : 3 + e; }

/// What is linear.
template <int dim> scene::FacetQuadratic<dim> quadratic(const std::array<double, std::size_t{dim}>& at_vertices) {
  scene::FacetQuadratic<dim> result;
  for (int i = 0; i < dim; ++i) result[vertex_place<dim>(i)] = at_vertices[i];
  for (std::size_t e = 0; e < scene::Simplex<dim - 1>::edges.size(); ++e) {
    const auto& [i, k] = scene::Simplex<dim - 1>::edges[e];
    result[edge_place<dim>(static_cast<int>(e))] = (at_vertices[i] + at_vertices[k]) / 2;
  }
  return result;
}

/// Weights below and above what is meant.
template <int dim> struct ContactWeights {
  FacetWeights<dim> below, above;
  bool weighted = false;
  scene::Enclosure size;  ///< length or area of what they are the indicator of; 0: they are weights of their own
};

/// Quantity::weight of a pair.
/// \throw scene::Error (input) where it is not one quadratic on a facet, or jumps from one to the next
ContactWeights<2> given_weights(const scene::Problem<2>& first, const scene::Quantity<2>& quantity, int pair);
ContactWeights<3> given_weights(const scene::Problem<3>& first, const scene::Quantity<3>& quantity, int pair);

/// Functions that agree up to rounding where facets of a pair meet, made to do so exactly: as in the plane they do; in
/// space, where edges have a coefficient, too, of those that meet the largest is taken (`above`), or the smallest.
FacetWeights<2> continuous(const scene::Problem<2>& first, FacetWeights<2> weights, bool above);
FacetWeights<3> continuous(const scene::Problem<3>& first, FacetWeights<3> weights, bool above);

/// ∫ w g by the lower or the upper gap of the current mesh, w linear on the facets of the first one.
scene::Enclosure weighted_gap(const scene::Problem<2>& problem, const FacetWeights<2>& weights, bool upper);
scene::Enclosure weighted_gap(const scene::Problem<3>& problem, const FacetWeights<3>& weights, bool upper);

/// At the vertices of contact facets where what is prescribed on both sides leaves no motion along d.
template <int dim> std::vector<std::array<bool, std::size_t{dim}>> held_corners(const scene::Problem<dim>& problem);

}  // namespace bracket::bounds
