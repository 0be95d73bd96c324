// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "scene/mesh/raw_mesh.h"
#include "scene/mesh/topology.h"

namespace bracket::scene {

namespace {

/// The components whose boundary a side of a contact lies on.
template <int dim> std::set<int> components_of(const Mesh<dim>& mesh, const Side& side) {
  std::set<int> components;
  for (const auto& facet : mesh.boundary)
    if (facet.part != -1 && contains(side, mesh.parts[facet.part])) components.insert(mesh.cell_component[facet.cell]);
  return components;
}

/// Pairs of components, the lower first, that are in contact or bonded.
template <int dim> std::set<std::pair<int, int>> pairs_in_contact(const Mesh<dim>& mesh, const Scene<dim>& scene) {
  std::set<std::pair<int, int>> pairs;
  const auto add = [&](const Side& first, const Side& second) {
    for (const int one : components_of(mesh, first))
      for (const int other : components_of(mesh, second)) pairs.insert(std::minmax(one, other));
  };
  for (const ContactPair<dim>& pair : scene.contact) add(pair.first, pair.second);
  for (const Bond& bond : scene.bonds) add(bond.first, bond.second);
  return pairs;
}

}  // namespace

template <int dim> std::vector<std::string> untied(const Mesh<dim>& mesh, const Scene<dim>& scene) {
  std::map<int, int> component;  // of each vertex of the boundary
  for (const auto& facet : mesh.boundary)
    for (const int vertex : facet.vertices) component[vertex] = mesh.cell_component[facet.cell];
  std::vector<Vector<dim>> points;
  std::vector<int> owner;
  for (const auto& [vertex, of] : component) {
    points.push_back(mesh.vertices[vertex]);
    owner.push_back(of);
  }
  const double distance = coincidence(mesh);
  std::map<std::pair<int, int>, int> count;
  const std::vector<int> first = merged(points, distance);
  for (std::size_t i = 0; i < first.size(); ++i)
    if (owner[first[i]] != owner[i]) ++count[std::minmax(owner[first[i]], owner[i])];
  const std::set<std::pair<int, int>> in_contact = pairs_in_contact(mesh, scene);
  std::vector<std::string> notes;
  for (const auto& [pair, nodes] : count) {
    // One node is a corner that two bodies have in common, as those do that a third one parts.
    if (nodes < dim || in_contact.contains(pair)) continue;
    notes.push_back(
        fmt::format("'{}' and '{}' have {} nodes at the same places, and are neither joined nor in contact; to join "
                    "them, write mesh.merge = {:.0e}",
                    mesh.components[pair.first], mesh.components[pair.second], nodes, distance));
  }
  return notes;
}

template std::vector<std::string> untied(const Mesh<2>&, const Scene<2>&);
template std::vector<std::string> untied(const Mesh<3>&, const Scene<3>&);

}  // namespace bracket::scene
