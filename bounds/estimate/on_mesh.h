// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "bounds/estimate/estimate.h"
#include "scene/voigt.h"

/// The two fields where the bracket needs them: strains on cells, displacements and tractions on boundary facets.
namespace bracket::bounds {

/// ε(u_h) at the vertices of a cell, between which it is linear (degree 1: constant).
template <int dim>
std::array<scene::Voigt<dim>, dim + 1> strain_at_vertices(const scene::Mesh<dim>& mesh,
                                                          const scene::Displacement<dim>& displacement, int cell);

/// Displacement at a boundary facet's vertices 0 and 1 and its midpoint; quadratic between.
template <int dim>
std::array<scene::Vector<dim>, 3> on_facet(const scene::Mesh<dim>& mesh, const scene::Displacement<dim>& displacement,
                                           int facet);

/// λn at a boundary facet's vertices; linear between.
template <int dim>
std::array<scene::Vector<dim>, std::size_t{dim}> tractions(const scene::Mesh<dim>& mesh,
                                                           const scene::Stress<dim>& stress, int facet);

/// The pressure of λ_h on a contact facet, at the first facet's vertices, as computed: what λ_h n has along d beside
/// the loads of a perturbed problem. The gap identity needs it as it is.
template <int dim>
std::array<double, std::size_t{dim}> plain_pressure(const scene::Problem<dim>& problem,
                                                    const scene::Stress<dim>& stress, const scene::ContactFacet& pair);

/// Keeps the largest value; a NaN stays.
inline void raise(double& largest, double value) {
  if (value > largest || std::isnan(value)) largest = value;
}

/// The largest displacement of a vertex, and the largest stress at a corner; not a number where one is not.
template <int dim> double largest_at_vertices(const scene::Displacement<dim>& displacement);
template <int dim> double largest_stress(const scene::Stress<dim>& stress);

/// The largest of the prescribed displacements and gaps.
template <int dim> double largest_given(const scene::Problem<dim>& problem);

/// ∫ q(f) over a simplex of a quadratic form q of a linear field, given at the corners: exact.
template <class Form, class Value, std::size_t n>
double integrate(const Form& q, const std::array<Value, n>& f, double volume) {
  Value sum = f[0];
  double of_corners = q(f[0]);
  for (std::size_t i = 1; i < n; ++i) {
    sum += f[i];
    of_corners += q(f[i]);
  }
  return volume / scene::Simplex<static_cast<int>(n) - 1>::hat_masses_of * (of_corners + q(sum));
}

/// Simpson's rule on an edge: exact for cubics.
inline double simpson(double at0, double middle, double at1, double length) {
  return length / 6 * (at0 + 4 * middle + at1);
}

}  // namespace bracket::bounds
