// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/estimate/estimate.h"

/// The two fields where the bracket needs them: strains on cells, displacements and tractions on boundary facets.
namespace bracket::bounds {

/// ε(u_h) at the vertices of a cell, between which it is linear (degree 1: constant).
template <int dim>
std::array<scene::Voigt<dim>, 3> strain_at_vertices(const scene::Mesh<dim>& mesh,
                                                    const scene::Displacement<dim>& displacement, int cell);

/// Displacement at a boundary facet's vertices 0 and 1 and its midpoint; quadratic between.
template <int dim>
std::array<scene::Vector<dim>, 3> on_facet(const scene::Mesh<dim>& mesh, const scene::Displacement<dim>& displacement,
                                           int facet);

/// λn at a boundary facet's vertices 0 and 1; linear between.
template <int dim>
std::array<scene::Vector<dim>, 2> tractions(const scene::Mesh<dim>& mesh, const scene::Stress<dim>& stress, int facet);

/// The largest of the prescribed displacements and gaps.
template <int dim> double largest_given(const scene::Problem<dim>& problem);

/// σ n
template <int dim> scene::Vector<dim> traction(const scene::Voigt<dim>& stress, const scene::Vector<dim>& n) {
  return {stress[0] * n[0] + stress[2] * n[1], stress[2] * n[0] + stress[1] * n[1]};
}

/// ∫ q(f) over a triangle of a quadratic form q of a linear field, given at the corners: exact.
template <class Form, class Value> double integrate(const Form& q, const std::array<Value, 3>& f, double area) {
  return area / 12 * (q(f[0]) + q(f[1]) + q(f[2]) + q(Value(f[0] + f[1] + f[2])));
}

/// Simpson's rule: exact for cubics.
inline double simpson(double at0, double middle, double at1, double length) {
  return length / 6 * (at0 + 4 * middle + at1);
}

}  // namespace bracket::bounds
