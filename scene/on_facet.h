// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/bernstein.h"
#include "scene/mesh/simplex.h"

/// Polynomials on a facet by their Bernstein coefficients: in the plane from its vertex 0 to its vertex 1; in space, of
/// degree 1 or 2, those of its vertices, then those of its edges as Simplex<2>::edges has them.
namespace bracket::scene {

template <int dim> constexpr int n_on_facet(int degree) { return n_bernstein<dim - 1>(degree); }
/// The degree of what has so many coefficients.
template <int dim> constexpr int degree_on_facet(std::size_t n) {
  return dim == 2 ? static_cast<int>(n) - 1 : n == 3 ? 1 : 2;
}

/// Where coefficient k of a degree is that of a vertex: which; else −1.
template <int dim> constexpr int vertex_of_coefficient(int degree, int k) {
  if constexpr (dim == 2) return k == 0 ? 0 : k == degree ? 1 : -1;
  if constexpr (dim == 3) return k < 3 ? k : -1;
}

/// The mean over the facet of the polynomial of coefficient k of a degree times the hat function of vertex i.
template <int dim> constexpr Fraction hat_mean(int degree, int k, int i) {
  if constexpr (dim == 2) return bernstein_mass(degree, k, 1, i);
  if (degree == 1) return {k == i ? 2 : 1, 12};
  if (k < 3) return {k == i ? 3 : 1, 30};
  return {k - 3 == i ? 1 : 2, 30};  // edge i is opposite to vertex i
}

/// The coefficients of a linear function. \param at_vertices its values there
template <class Number, class Value, std::size_t dim>
std::vector<Value> linear_on_facet(const std::array<Value, dim>& at_vertices, int degree) {
  std::vector<Value> result;
  if constexpr (dim == 2) {
    for (int k = 0; k <= degree; ++k)
      result.push_back(linear_coefficient<Number>(at_vertices[0], at_vertices[1], degree, k));
  } else {
    result.assign(at_vertices.begin(), at_vertices.end());
    for (int e = 0; e < 3 && degree == 2; ++e) {
      const auto& [a, b] = Simplex<2>::edges[e];
      result.push_back(linear_coefficient<Number>(at_vertices[a], at_vertices[b], 2, 1));
    }
  }
  return result;
}

/// In space: a function of degree 1 or 2 as one of degree 2.
template <class Number, class Value> std::vector<Value> quadratic_on_facet(const std::vector<Value>& c) {
  return c.size() == 3 ? linear_on_facet<Number>(std::array<Value, 3>{c[0], c[1], c[2]}, 2) : c;
}

/// The mean of f times a linear function over the facet.
template <class Number, std::size_t dim>
Number mean_with_linear(const std::vector<Number>& f, const std::array<Number, dim>& at_vertices) {
  constexpr int d = static_cast<int>(dim);
  const int degree = degree_on_facet<d>(f.size());
  Number sum(0);
  for (std::size_t k = 0; k < f.size(); ++k)
    for (int i = 0; i < d; ++i)
      sum += number<Number>(hat_mean<d>(degree, static_cast<int>(k), i)) * (f[k] * at_vertices[i]);
  return sum;
}

}  // namespace bracket::scene
