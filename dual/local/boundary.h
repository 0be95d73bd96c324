// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dual/local/star.h"

/// What the boundary asks of the loads.
namespace bracket::dual {

/// The loads that a facet has to have: of Γ_τ those of the data, of Γ_K the pressure's; zero inside and on Γ_u and Γ_0.
/// \param pressure of each contact, at the vertices of its first facet, force per area
template <int dim>
std::vector<FacetVector<dim>> given_loads(const scene::Problem<dim>& problem, const Facets<dim>& facets,
                                          const std::vector<std::array<double, std::size_t{dim}>>& pressure);

/// The displacements prescribed on facets on Γ_u and, along the normal, Γ_0, by their moments: dual to loads; else
/// zero.
template <int dim>
std::vector<FacetVector<dim>> prescribed_moments(const scene::Problem<dim>& problem, const Facets<dim>& facets);

/// The number of a boundary facet among all.
template <int dim> int number_of(const scene::Mesh<dim>& mesh, int boundary) {
  return cell_facets(mesh, mesh.boundary[boundary].cell)[mesh.boundary[boundary].local];
}

}  // namespace bracket::dual
