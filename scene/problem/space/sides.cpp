// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: contact facets coincide node by node.
#include "scene/problem/sides.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <unordered_map>

#include "scene/mesh/topology.h"
#include "scene/problem/matching.h"
#include "scene/problem/space/face.h"
#include "scene/problem/tolerance.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

std::vector<int> facets_of(const Mesh<3>& mesh, const Side& side, const std::string& where,
                           const std::vector<std::string>& others) {
  std::set<int> parts;
  for (const std::string& name : side.parts) parts.insert(part_named(mesh, name, where, others));
  std::vector<int> facets;
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
    if (parts.contains(mesh.boundary[f].part)) facets.push_back(static_cast<int>(f));
  return facets;
}

/// The facets before which the wall lies, within 25 degrees of their normals; a note if there are others.
std::vector<int> facets_before(Mesh<3>& mesh, const ContactPair<3>& pair) {
  const std::vector<int> all = facets_of(mesh, pair.first, pair.where, {});
  const auto* plane = std::get_if<PlaneObstacle>(&pair.second.obstacle);
  if (plane == nullptr) return all;
  const double facing = std::cos(25 * std::numbers::pi / 180) * plane->normal.norm();
  std::vector<int> facets;
  for (const int facet : all)
    if (-normal(mesh, facet).dot(plane->normal) >= facing) facets.push_back(facet);
  if (facets.empty())
    fail(Status::mesh, pair.where,
         fmt::format("no face of '{}' lies before {}; expected outward normals towards it", name(pair.first),
                     name(pair.second)));
  if (facets.size() < all.size())
    mesh.notes.push_back(fmt::format("{} of {} faces of '{}' lie before {}; the others are free", facets.size(),
                                     all.size(), name(pair.first), name(pair.second)));
  return facets;
}

std::set<int> vertices_of(const Mesh<3>& mesh, const std::vector<int>& facets) {
  std::set<int> vertices;
  for (const int facet : facets)
    vertices.insert(mesh.boundary[facet].vertices.begin(), mesh.boundary[facet].vertices.end());
  return vertices;
}

/// Of each vertex of the sides the least tolerance of the facets at it.
std::map<int, double> tolerances(const Mesh<3>& mesh, const std::vector<int>& facets) {
  std::map<int, double> least;
  for (const int facet : facets)
    for (const int vertex : mesh.boundary[facet].vertices) {
      const double near = tolerance(mesh, facet);
      const auto [known, fresh] = least.emplace(vertex, near);
      if (!fresh) known->second = std::min(known->second, near);
    }
  return least;
}

[[noreturn]] void refuse_vertex(const Mesh<3>& mesh, const ContactPair<3>& pair, bool of_first, int vertex,
                                const std::vector<int>& across, double near) {
  int nearest = -1;
  double distance = std::numeric_limits<double>::infinity();
  for (const int other : vertices_of(mesh, across)) {
    const double apart = (mesh.vertices[other] - mesh.vertices[vertex]).norm();
    if (apart >= distance) continue;
    distance = apart;
    nearest = other;
  }
  const Side &own = of_first ? pair.first : pair.second, &others = of_first ? pair.second : pair.first;
  fail(Status::mesh, pair.where,
       fmt::format("the sides of a contact must coincide node by node: the node {} of '{}' has no partner; the nearest "
                   "one of '{}' is {}, {:.3g} away, and {:.2g} is the most. Mesh both sides alike, or name parts that "
                   "end where the contact does",
                   point(mesh.vertices[vertex]), name(own), name(others), point(mesh.vertices[nearest]), distance,
                   near));
}

/// Of each vertex of the second side that of the first that lies there.
std::map<int, int> partners(const Mesh<3>& mesh, const ContactPair<3>& pair, const std::vector<int>& first,
                            const std::vector<int>& second) {
  std::map<int, double> near = tolerances(mesh, first);
  const std::map<int, double> near_second = tolerances(mesh, second);
  const std::size_t n_first = near.size();
  double widest = 0;
  std::vector<int> vertices;
  for (const std::map<int, double>* side : {&std::as_const(near), &near_second})
    for (const auto& [vertex, distance] : *side) {
      vertices.push_back(vertex);
      widest = std::max(widest, distance);
    }
  near.insert(near_second.begin(), near_second.end());
  std::vector<Vector<3>> points;
  for (const int vertex : vertices) points.push_back(mesh.vertices[vertex]);
  const std::vector<int> place = merged(points, widest);  // a first vertex, where there is one
  std::map<int, std::vector<int>> together;
  for (std::size_t i = 0; i < place.size(); ++i) together[place[i]].push_back(vertices[i]);
  const std::set<int> of_first(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(n_first));
  std::map<int, int> result;
  std::set<int> taken;
  for (const auto& [key, group] : together)
    for (const int vertex : group) {
      if (of_first.contains(vertex)) continue;
      int best = -1;
      for (const int other : group) {
        if (!of_first.contains(other) || taken.contains(other)) continue;
        const double apart = (mesh.vertices[other] - mesh.vertices[vertex]).norm();
        if (apart > std::min(near[other], near[vertex])) continue;
        if (best < 0 || apart < (mesh.vertices[best] - mesh.vertices[vertex]).norm()) best = other;
      }
      if (best < 0) refuse_vertex(mesh, pair, false, vertex, first, near[vertex]);
      taken.insert(best);
      result[vertex] = best;
    }
  for (const int vertex : of_first)
    if (!taken.contains(vertex)) refuse_vertex(mesh, pair, true, vertex, second, near[vertex]);
  return result;
}

std::array<int, 3> in_order(std::array<int, 3> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

std::string corners_of(const Mesh<3>& mesh, int facet) {
  const auto x = positions(mesh, mesh.boundary[facet].vertices);
  return fmt::format("{}, {}, {}", point(x[0]), point(x[1]), point(x[2]));
}

/// A contact facet with the order in which its sides' vertices meet. \param place of each vertex, equal where they meet
template <class Place>
ContactFacetOf<3> facing_pair(const Mesh<3>& mesh, const ContactPair<3>& pair, int number, int first, int second,
                              const Place& place) {
  ContactFacetOf<3> of{number, first, second, {}, {}, {}};
  const auto &vertices = mesh.boundary[first].vertices, &others = mesh.boundary[second].vertices;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      if (place(others[k]) == place(vertices[i])) of.meets[i] = k;
  if (of.meets[1] != (of.meets[0] + 2) % 3)
    fail(Status::mesh, pair.where,
         fmt::format("the sides '{}' and '{}' do not face each other, but have the same outward normal at {}",
                     name(pair.first), name(pair.second), corners_of(mesh, first)));
  return of;
}

/// The facets of a pair, two by two, in the order of the first.
void match(const Mesh<3>& mesh, const ContactPair<3>& pair, int number, std::vector<ContactFacetOf<3>>& contact) {
  const std::vector<int> first = facets_of(mesh, pair.first, pair.where, {});
  const std::vector<int> second = facets_of(mesh, pair.second, pair.where, {"rigid"});
  for (const auto& [side, facets] : {std::pair(&pair.first, &first), std::pair(&pair.second, &second)})
    if (facets->empty()) fail(Status::mesh, pair.where, fmt::format("'{}' has no face on the boundary", name(*side)));
  const std::map<int, int> partner = partners(mesh, pair, first, second);
  std::map<std::array<int, 3>, int> across;  // facets of the second side, by vertices of the first
  for (const int facet : second) {
    std::array<int, 3> vertices = mesh.boundary[facet].vertices;
    for (int& vertex : vertices) vertex = partner.at(vertex);
    across[in_order(vertices)] = facet;
  }
  for (const int facet : first) {
    const auto& vertices = mesh.boundary[facet].vertices;
    const auto found = across.find(in_order(vertices));
    if (found == across.end())
      fail(Status::mesh, pair.where,
           fmt::format("the sides of a contact must coincide face by face: that of '{}' with the corners {} has no "
                       "partner on '{}', which has other faces between the same nodes",
                       name(pair.first), corners_of(mesh, facet), name(pair.second)));
    contact.push_back(facing_pair(mesh, pair, number, facet, found->second, [&](int vertex) {
      const auto known = partner.find(vertex);
      return known == partner.end() ? vertex : known->second;
    }));
    across.erase(found);
  }
  if (!across.empty())
    fail(Status::mesh, pair.where,
         fmt::format("the sides of a contact must coincide face by face: that of '{}' with the corners {} has no "
                     "partner on '{}', which has other faces between the same nodes",
                     name(pair.second), corners_of(mesh, across.begin()->second), name(pair.first)));
}

/// Of parts that are both sides: their facets two by two, the one of the lower body first.
void match_both(const Mesh<3>& mesh, const ContactPair<3>& pair, int number, std::vector<ContactFacetOf<3>>& contact) {
  const std::vector<int> facets = facets_of(mesh, pair.first, pair.where, {});
  double near = std::numeric_limits<double>::infinity();
  for (const int facet : facets) near = std::min(near, tolerance(mesh, facet));
  const std::set<int> of_facets = vertices_of(mesh, facets);
  const std::vector<int> vertices(of_facets.begin(), of_facets.end());
  std::vector<Vector<3>> points;
  for (const int vertex : vertices) points.push_back(mesh.vertices[vertex]);
  const std::vector<int> group = merged(points, near);
  std::map<int, int> place;
  for (std::size_t i = 0; i < vertices.size(); ++i) place[vertices[i]] = group[i];
  std::map<std::array<int, 3>, int> waiting;
  for (const int facet : facets) {
    std::array<int, 3> at = mesh.boundary[facet].vertices;
    for (int& vertex : at) vertex = place.at(vertex);
    const auto [other, fresh] = waiting.try_emplace(in_order(at), facet);
    if (fresh) continue;
    const auto body = [&](int f) { return std::pair(mesh.cell_body[mesh.boundary[f].cell], f); };
    const auto [first, second] = std::minmax(other->second, facet, [&](int a, int b) { return body(a) < body(b); });
    contact.push_back(facing_pair(mesh, pair, number, first, second, [&](int vertex) { return place.at(vertex); }));
    waiting.erase(other);
  }
  if (facets.empty()) fail(Status::mesh, pair.where, fmt::format("'{}' has no face on the boundary", name(pair.first)));
  if (waiting.empty()) return;
  fail(Status::mesh, pair.where,
       fmt::format("'{}' is both sides of a contact, and its face with the corners {} has none that lies on it",
                   name(pair.first), corners_of(mesh, waiting.begin()->second)));
}

}  // namespace

InContact<3> in_contact(const Scene<3>& scene, Mesh<3> mesh) {
  InContact<3> result{std::move(mesh), {}};
  std::vector<int> pair_of(result.mesh.boundary.size(), -1);
  for (std::size_t i = 0; i < scene.contact.size(); ++i) {
    const ContactPair<3>& pair = scene.contact[i];
    const std::size_t before = result.contact.size();
    if (is_rigid(pair.second) && std::ranges::find(result.mesh.parts, "rigid") != result.mesh.parts.end())
      fail(Status::input, pair.where, "'rigid' means a wall, but the mesh has a part of that name; rename the part");
    if (is_wall(pair.second)) {
      for (const int facet : facets_before(result.mesh, pair))
        result.contact.push_back({static_cast<int>(i), facet, -1, {}, {}, {}});
    } else if (pair.first.parts == pair.second.parts) {
      match_both(result.mesh, pair, static_cast<int>(i), result.contact);
    } else {
      match(result.mesh, pair, static_cast<int>(i), result.contact);
    }
    for (std::size_t c = before; c < result.contact.size(); ++c)
      for (const int facet : {result.contact[c].first, result.contact[c].second}) {
        if (facet == -1) continue;
        if (pair_of[facet] != -1)
          fail(Status::input, pair.where,
               fmt::format("'{}' is in two contacts", result.mesh.parts[result.mesh.boundary[facet].part]));
        pair_of[facet] = static_cast<int>(i);
      }
  }
  return result;
}

std::vector<Vector<3>> with_directions_of_contact(const Scene<3>& scene, std::vector<Vector<3>> normals,
                                                  const std::vector<ContactFacetOf<3>>& contact) {
  for (const ContactFacetOf<3>& pair : contact) {
    if (pair.second != -1) {
      normals[pair.second] = -normals[pair.first];
    } else if (const auto* plane = std::get_if<PlaneObstacle>(&scene.contact[pair.pair].second.obstacle)) {
      normals[pair.first] = -plane->normal.normalized();
    }
  }
  return normals;
}

FacetValues<6> drawn_gap(const Scene<3>& scene, const Problem<3>& problem, const ContactFacetOf<3>& facet) {
  FacetValues<6> gap{{}, 0, 0};
  const auto* plane = std::get_if<PlaneObstacle>(&scene.contact[facet.pair].second.obstacle);
  if (plane == nullptr) return gap;
  const Vector<3>& d = problem.facets[facet.first].normal;
  const Face face = positions(problem.mesh, problem.mesh.boundary[facet.first].vertices);
  for (int i = 0; i < 3; ++i) {
    gap.value[i] = (plane->point - face[i]).dot(d);
    gap.largest = std::max(gap.largest, std::abs(gap.value[i]));
  }
  for (int e = 0; e < 3; ++e) {
    const auto& [i, k] = Simplex<2>::edges[e];
    gap.value[3 + e] = 0.5 * (gap.value[i] + gap.value[k]);
  }
  return gap;
}

}  // namespace bracket::scene
