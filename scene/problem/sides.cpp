// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: facets are edges.
#include "scene/problem/sides.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/mesh/angles.h"
#include "scene/problem/cutting.h"
#include "scene/problem/facing.h"
#include "scene/text.h"

namespace bracket::scene {

template <int dim>
int part_named(const Mesh<dim>& mesh, const std::string& name, const std::string& where,
               const std::vector<std::string>& others) {
  const auto found = std::find(mesh.parts.begin(), mesh.parts.end(), name);
  if (found == mesh.parts.end()) {
    std::vector<std::string> known = others;
    known.insert(known.end(), mesh.parts.begin(), mesh.parts.end());
    fail(Status::input, where, fmt::format("the mesh has no boundary part '{}': {}", name, suggestion(name, known)));
  }
  return static_cast<int>(found - mesh.parts.begin());
}
template int part_named(const Mesh<2>&, const std::string&, const std::string&, const std::vector<std::string>&);
template int part_named(const Mesh<3>&, const std::string&, const std::string&, const std::vector<std::string>&);

namespace {

std::vector<int> parts_of(const Mesh<2>& mesh, const Side& side, const std::string& where,
                          const std::vector<std::string>& others) {
  std::vector<int> parts;
  for (const std::string& name : side.parts) parts.push_back(part_named(mesh, name, where, others));
  return parts;
}

/// Whether an obstacle lies before a facet: within 25 degrees of its normal, and all along it.
bool lies_before(const Mesh<2>& mesh, int facet, const Side& obstacle) {
  const Vector<2> n = normal(mesh, facet);
  if (const auto* line = std::get_if<LineObstacle>(&obstacle.obstacle))
    return -n.dot(line->normal) >= std::cos(radians(25)) * line->normal.norm();
  const auto* round = std::get_if<CircleObstacle>(&obstacle.obstacle);
  if (round == nullptr) return true;
  const auto& [center, radius] = round->circle;
  for (const Vector<2>& x : positions(mesh, mesh.boundary[facet].vertices)) {
    if (std::abs(cross(x - center, n)) >= radius) return false;
    if (!round->inside && (x - center).dot(n) >= 0) return false;
  }
  return true;
}

/// The facets of the parts that are not taken and before which the wall lies; a note if there are others.
std::vector<int> facets_before(Mesh<2>& mesh, const ContactPair<2>& pair, std::vector<char>& taken) {
  const std::vector<int> parts = parts_of(mesh, pair.first, pair.where, {});
  std::vector<int> facets;
  std::size_t all = 0;
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    if (std::find(parts.begin(), parts.end(), mesh.boundary[f].part) == parts.end()) continue;
    ++all;
    if (taken[f] || !lies_before(mesh, static_cast<int>(f), pair.second)) continue;
    taken[f] = 1;
    facets.push_back(static_cast<int>(f));
  }
  if (facets.empty())
    fail(Status::mesh, pair.where,
         fmt::format("no edge of '{}' faces {}; expected outward normals towards it", name(pair.first),
                     name(pair.second)));
  if (facets.size() < all)
    mesh.notes.push_back(fmt::format("{} of {} edges of '{}' face {}; the others are free", facets.size(), all,
                                     name(pair.first), name(pair.second)));
  return facets;
}

}  // namespace

InContact<2> in_contact(const Scene<2>& scene, Mesh<2> mesh) {
  std::vector<SideParts> sides;  // of the pairs of two bodies
  for (const ContactPair<2>& pair : scene.contact) {
    if (is_rigid(pair.second) && std::find(mesh.parts.begin(), mesh.parts.end(), "rigid") != mesh.parts.end())
      fail(Status::input, pair.where, "'rigid' means a wall, but the mesh has a part of that name; rename the part");
    const std::vector<int> first = parts_of(mesh, pair.first, pair.where, {});
    if (!is_wall(pair.second)) sides.push_back({first, parts_of(mesh, pair.second, pair.where, {"rigid"}), pair.where});
  }
  const Arcs arcs = arcs_of(scene, mesh);
  CutAlike cut = cut_alike(std::move(mesh), sides, arcs);
  InContact<2> result{std::move(cut.mesh), {}};
  std::size_t of_bodies = 0;
  std::vector<char> taken(result.mesh.boundary.size(), 0);
  for (const FacetPairs& pairs : cut.pairs)
    for (const auto& [one, other] : pairs) taken[one] = taken[other] = 1;
  for (std::size_t i = 0; i < scene.contact.size(); ++i) {
    const int pair = static_cast<int>(i);
    if (is_wall(scene.contact[i].second)) {
      for (const int facet : facets_before(result.mesh, scene.contact[i], taken))
        result.contact.push_back({pair, facet, -1, {}, {}, {}});
    } else {
      for (const auto& [one, other] : cut.pairs[of_bodies++]) result.contact.push_back({pair, one, other, {}, {}, {}});
    }
  }
  return result;
}

std::vector<Vector<2>> with_directions_of_contact(const Scene<2>& scene, std::vector<Vector<2>> normals,
                                                  const std::vector<ContactFacet>& contact) {
  for (const ContactFacet& pair : contact) {
    if (pair.second != -1) {
      normals[pair.first] = direction(normals[pair.first], normals[pair.second]);
      normals[pair.second] = -normals[pair.first];
    } else if (const auto* line = std::get_if<LineObstacle>(&scene.contact[pair.pair].second.obstacle)) {
      normals[pair.first] = -line->normal.normalized();
    }
  }
  return normals;
}

Function<2> distance(const CircleObstacle& obstacle, const Vector<2>& d) {
  return enclosed<2>([circle = obstacle.circle, inside = obstacle.inside, d](const auto& x) {
    using std::sqrt;
    const auto from_x = x[0] - circle.center[0], from_y = x[1] - circle.center[1];
    const auto along = from_x * d[0] + from_y * d[1], beside = from_x * d[1] - from_y * d[0];
    const auto half_chord = sqrt(circle.radius * circle.radius - beside * beside);
    return inside ? half_chord - along : -half_chord - along;
  });
}

FacetValues<3> drawn_gap(const Scene<2>& scene, const Problem<2>& problem, const ContactFacet& facet) {
  const Mesh<2>& mesh = problem.mesh;
  const Vector<2>& d = problem.facets[facet.first].normal;
  const auto one = positions(mesh, mesh.boundary[facet.first].vertices);
  double start = 0, end = 0;
  if (facet.second != -1) {
    const auto other = positions(mesh, mesh.boundary[facet.second].vertices);
    start = (other[1] - one[0]).dot(d);
    end = (other[0] - one[1]).dot(d);
  } else if (const auto* line = std::get_if<LineObstacle>(&scene.contact[facet.pair].second.obstacle)) {
    start = (line->point - one[0]).dot(d);
    end = (line->point - one[1]).dot(d);
  }
  return {{start, end, 0.5 * (start + end)}, 0, std::max(std::abs(start), std::abs(end))};
}

}  // namespace bracket::scene
