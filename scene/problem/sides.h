// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/problem/projection.h"

/// What the contacts of a scene are on a mesh.
namespace bracket::scene {

/// \param others names that might be meant as well \throw Error (input) where the mesh has no part of that name
int part_named(const Mesh<2>& mesh, const std::string& name, const std::string& where,
               const std::vector<std::string>& others = {});

/// A mesh whose contact sides are cut alike, and the facets in contact, pair by pair; gaps are still to be filled in.
struct InContact {
  Mesh<2> mesh;
  std::vector<ContactFacet> contact;
};
/// \throw Error (input: unknown parts; mesh: sides that do not face each other, or no obstacle)
InContact in_contact(const Scene<2>& scene, Mesh<2> mesh);

/// The facets' normals with the directions of contact: of two sides that of both, on a line against its normal.
std::vector<Vector<2>> with_directions_of_contact(const Scene<2>& scene, std::vector<Vector<2>> normals,
                                                  const std::vector<ContactFacet>& contact);

/// The distance of the two sides along d, or to the line, linear between the ends; to a wall none.
EdgeValues<3> drawn_gap(const Scene<2>& scene, const Problem<2>& problem, const ContactFacet& facet);

/// The distance to the circle along d as a function of a point, at points from which d hits it.
Function<2> distance(const CircleObstacle& obstacle, const Vector<2>& d);

}  // namespace bracket::scene
