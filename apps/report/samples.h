// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "bounds/bounds.h"

/// The fields at points where files and pictures need them.
namespace bracket::apps {

/// Pressure −d·σ(u_h)d on a contact pair's first facet, whose outward normal is d, by Bernstein coefficients from its
/// vertex 0 to its vertex 1.
std::vector<double> displacement_pressure(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                                          int facet);

/// The values of what has these coefficients at equally spaced points from end to end, so many that the lines between
/// them look like it.
std::vector<double> samples(const std::vector<double>& coefficients);

/// What a contact facet's quadratic, given by Bernstein coefficients, is at its vertices and the middles of its edges:
/// in the plane from vertex 0 to vertex 1, in space in the order of scene/on_facet.h.
template <int dim> scene::FacetQuadratic<dim> quadratic_at_nodes(const scene::FacetQuadratic<dim>& coefficients);
template <> scene::FacetQuadratic<2> quadratic_at_nodes<2>(const scene::FacetQuadratic<2>& coefficients);
template <> scene::FacetQuadratic<3> quadratic_at_nodes<3>(const scene::FacetQuadratic<3>& coefficients);

/// Of each cell its boundary facets, in the order of Simplex::facets; −1: none.
template <int dim> std::vector<std::array<int, std::size_t{dim} + 1>> facets_of_cells(const scene::Mesh<dim>& mesh);

/// Facets that follow one another along the boundary, by their indices in some list.
using Chain = std::vector<int>;
/// Boundary facets as one chain per connected piece; a closed one begins anywhere. Of indices into `facets`.
std::vector<Chain> chained(const scene::Mesh<2>& mesh, const std::vector<int>& facets);
/// The first side of a pair, likewise. Of indices into Problem::contact.
std::vector<Chain> chains(const scene::Problem<2>& problem, int pair);

/// The pressure up to which a contact facet of a pair is open but for rounding errors of λ_h: by the pair's largest
/// and, where that is rounding itself, by the largest stress in the pair's bodies.
template <int dim>
double rounding_of_pressure(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress,
                            const std::vector<bounds::ContactState>& contact, int pair);

/// Whether λ_h presses on a contact facet. \param rounding of its pair, as rounding_of_pressure()
bool presses(const bounds::ContactState& state, double rounding);

}  // namespace bracket::apps
