// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/problem/projection.h"

/// What the contacts of a scene are on a mesh.
namespace bracket::scene {

/// \param others names that might be meant as well \throw Error (input) where the mesh has no part of that name
template <int dim>
int part_named(const Mesh<dim>& mesh, const std::string& name, const std::string& where,
               const std::vector<std::string>& others = {});

/// A mesh whose contact sides are cut alike, and the facets in contact, pair by pair; gaps are still to be filled in.
template <int dim> struct InContact {
  Mesh<dim> mesh;
  std::vector<ContactFacetOf<dim>> contact;
};
/// \throw Error (input: unknown parts; mesh: sides that do not face each other, or no obstacle, or, in space, do not
///        coincide node by node within tolerance())
InContact<2> in_contact(const Scene<2>& scene, Mesh<2> mesh);
InContact<3> in_contact(const Scene<3>& scene, Mesh<3> mesh);

/// The facets' normals with the directions of contact: of two sides that of both, on a line or a plane against its
/// normal.
std::vector<Vector<2>> with_directions_of_contact(const Scene<2>& scene, std::vector<Vector<2>> normals,
                                                  const std::vector<ContactFacet>& contact);
std::vector<Vector<3>> with_directions_of_contact(const Scene<3>& scene, std::vector<Vector<3>> normals,
                                                  const std::vector<ContactFacetOf<3>>& contact);

/// The distance of the two sides along d, or to the line, linear between the ends; to a wall none.
FacetValues<3> drawn_gap(const Scene<2>& scene, const Problem<2>& problem, const ContactFacet& facet);
/// To the plane, as Bernstein coefficients; elsewhere none: sides coincide.
FacetValues<6> drawn_gap(const Scene<3>& scene, const Problem<3>& problem, const ContactFacetOf<3>& facet);

/// The distance to the circle along d as a function of a point, at points from which d hits it.
Function<2> distance(const CircleObstacle& obstacle, const Vector<2>& d);

}  // namespace bracket::scene
