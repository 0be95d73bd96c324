// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: facets are edges, and follow each other.
#include "scene/problem/facing.h"

#include <algorithm>
#include <limits>
#include <map>

#include "scene/mesh/angles.h"

namespace bracket::scene {

namespace {

const double smooth = std::cos(radians(20)), facing = std::cos(radians(50));

/// The normals of a side's facets at their vertices.
struct Ends {
  std::vector<std::array<Vector<2>, 2>> normal;  ///< as the side's facets
  std::vector<char> shared;                      ///< whether the facet before says the same of vertex 0
};

Ends ends_of(const Mesh<2>& mesh, const std::vector<Vector<2>>& normals, const std::vector<int>& side,
             const Arcs& arcs) {
  std::map<int, std::size_t> begins;  // which of the facets begins at a vertex
  for (std::size_t i = 0; i < side.size(); ++i) begins[mesh.boundary[side[i]].vertices[0]] = i;
  Ends ends{{}, std::vector<char>(side.size(), 0)};
  std::vector<char> continued = ends.shared;  // whether the facet behind says the same of vertex 1
  for (const int facet : side) ends.normal.push_back({normals[facet], normals[facet]});
  for (std::size_t i = 0; i < side.size(); ++i) {
    const auto next = begins.find(mesh.boundary[side[i]].vertices[1]);
    if (next == begins.end()) continue;
    const Vector<2>&one = normals[side[i]], &other = normals[side[next->second]];
    if (one.dot(other) < smooth) continue;
    ends.shared[next->second] = continued[i] = 1;
    if (one != other) ends.normal[i][1] = ends.normal[next->second][0] = (one + other).normalized();
  }
  // Where a side ends it goes on bending as it did: the normal is the mirror image of that at the other end.
  for (std::size_t i = 0; i < side.size(); ++i) {
    const Vector<2>& n = normals[side[i]];
    auto& [begin, end] = ends.normal[i];
    const auto mirrored = [&n](const Vector<2>& other) { return Vector<2>(2 * n.dot(other) * n - other); };
    if (!continued[i] && begin != n)
      end = mirrored(begin);
    else if (!ends.shared[i] && end != n)
      begin = mirrored(end);
  }
  for (std::size_t i = 0; i < side.size(); ++i) {
    const auto& facet = mesh.boundary[side[i]];
    if (facet.part < 0 || !arcs[facet.part]) continue;
    for (int end = 0; end < 2; ++end) {
      const Vector<2> radius = (mesh.vertices[facet.vertices[end]] - arcs[facet.part]->center).normalized();
      ends.normal[i][end] = radius.dot(normals[side[i]]) > 0 ? radius : Vector<2>(-radius);
    }
  }
  return ends;
}

/// Where the facet lies from x on along the direction of both; its normals are linear between its vertices.
struct Hit {
  double t, distance;
};
Hit hit(const Vector<2>& x, const Vector<2>& normal, const std::array<Vector<2>, 2>& facet,
        const std::array<Vector<2>, 2>& normals) {
  const auto& [a, b] = facet;
  double t = 0.5;
  Vector<2> d;
  const int rounds = normals[0] == normals[1] ? 1 : 8;  // each makes the error as small as the bend is
  for (int round = 0; round < rounds; ++round) {
    const double at = std::clamp(t, 0.0, 1.0);
    d = direction(normal, at == 0   ? normals[0]
                          : at == 1 ? normals[1]
                                    : Vector<2>(((1 - at) * normals[0] + at * normals[1]).normalized()));
    t = cross(x - a, d) / cross(b - a, d);
  }
  return {t, (a + t * (b - a) - x).dot(d)};
}

}  // namespace

Vector<2> direction(const Vector<2>& first, const Vector<2>& second) {
  return second == -first ? first : Vector<2>((first - second).normalized());
}

std::vector<Landing> landings(const Mesh<2>& mesh, const std::vector<Vector<2>>& normals, const std::vector<int>& from,
                              const std::vector<int>& onto, const Arcs& arcs) {
  const Ends own = ends_of(mesh, normals, from, arcs), other = ends_of(mesh, normals, onto, arcs);
  struct Edge {
    std::array<Vector<2>, 2> ends;
    double length, near;
  };
  std::vector<Edge> edges;
  for (const int facet : onto)
    edges.push_back({positions(mesh, mesh.boundary[facet].vertices), length(mesh, facet), tolerance(mesh, facet)});
  std::vector<Landing> result;
  for (std::size_t i = 0; i < from.size(); ++i)
    for (int end = own.shared[i] ? 1 : 0; end < 2; ++end) {
      const int vertex = mesh.boundary[from[i]].vertices[end];
      const Vector<2>&x = mesh.vertices[vertex], &n = own.normal[i][end];
      Landing nearest{vertex, -1, 0, -1, 0};
      for (std::size_t j = 0; j < onto.size(); ++j) {
        if (normals[from[i]].dot(normals[onto[j]]) > -facing) continue;
        const auto& [points, length, near] = edges[j];
        const auto [t, distance] = hit(x, n, points, other.normal[j]);
        if (!(t * length >= -near && (t - 1) * length <= near)) continue;
        if (nearest.facet >= 0 && std::abs(distance) >= std::abs(nearest.distance)) continue;
        const auto& ends = mesh.boundary[onto[j]].vertices;
        const int at = t * length <= near ? ends[0] : (1 - t) * length <= near ? ends[1] : -1;
        nearest = {vertex, onto[j], t, at, distance};
      }
      if (nearest.facet >= 0) result.push_back(nearest);
    }
  return result;
}

}  // namespace bracket::scene
