// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: sides are made of edges.
#include "scene/mesh/bonds.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "scene/mesh/raw_mesh.h"
#include "scene/mesh/topology.h"
#include "scene/problem/facing.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

std::vector<int> facets_of(const Mesh<2>& mesh, const Side& side, const Bond& bond) {
  std::vector<int> facets;
  for (const std::string& part : side.parts) {
    const auto place = std::ranges::find(mesh.parts, part);
    if (place == mesh.parts.end())
      fail(Status::input, bond.where,
           fmt::format("the mesh has no boundary part '{}': {}", part, suggestion(part, mesh.parts)));
    const std::size_t before = facets.size();
    for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
      if (mesh.boundary[f].part == place - mesh.parts.begin()) facets.push_back(static_cast<int>(f));
    if (facets.size() == before)
      fail(Status::mesh, bond.where,
           fmt::format("'{}' has no line on the boundary; bodies that share their nodes are one without a bond", part));
  }
  return facets;
}

/// Of each vertex of the mesh, which one it becomes: those of the second side, those of the first that are as close.
std::vector<int> partners(const Mesh<2>& mesh, const std::vector<int>& first, const std::vector<int>& second) {
  double near = std::numeric_limits<double>::infinity();
  std::vector<int> vertices;  // those of the first side before those of the second
  for (const std::vector<int>* side : {&first, &second})
    for (const int facet : *side) {
      near = std::min(near, tolerance(mesh, facet));
      for (const int vertex : mesh.boundary[facet].vertices) vertices.push_back(vertex);
    }
  std::vector<Vector<2>> points;
  for (const int vertex : vertices) points.push_back(mesh.vertices[vertex]);
  std::vector<int> becomes(mesh.vertices.size());
  for (std::size_t v = 0; v < becomes.size(); ++v) becomes[v] = static_cast<int>(v);
  const std::vector<int> of = merged(points, near);
  for (std::size_t i = 0; i < of.size(); ++i) becomes[vertices[i]] = vertices[of[i]];
  return becomes;
}

[[noreturn]] void refuse_alone(const Mesh<2>& mesh, const Bond& bond, int facet, const std::vector<int>& across) {
  const auto [a, b] = positions(mesh, mesh.boundary[facet].vertices);
  Vector<2> nearest = a, to = a;
  double distance = -1;  // of the one of its ends that is farther from all nodes across, and the nearest of those
  for (const Vector<2>& end : {a, b}) {
    double least = std::numeric_limits<double>::infinity();
    Vector<2> found = end;
    for (const int other : across)
      for (const Vector<2>& x : positions(mesh, mesh.boundary[other].vertices))
        if ((x - end).norm() < least) {
          least = (x - end).norm();
          found = x;
        }
    if (least <= distance) continue;
    distance = least;
    nearest = found;
    to = end;
  }
  fail(Status::mesh, bond.where,
       fmt::format("bonded sides must coincide node by node: the edge of '{}' from {} to {} has no partner; the node "
                   "across nearest to {} is {}, {:.3g} away. Mesh both sides alike, or name parts that end where the "
                   "bond does",
                   mesh.parts[mesh.boundary[facet].part], point(a), point(b), point(to), point(nearest), distance));
}

Mesh<2> joined(Mesh<2> mesh, const Bond& bond, const std::string& where) {
  const std::vector<int> first = facets_of(mesh, bond.first, bond), second = facets_of(mesh, bond.second, bond);
  const std::vector<int> becomes = partners(mesh, first, second);
  const auto ends = [&](int facet) {
    std::array<int, 2> v = mesh.boundary[facet].vertices;
    for (int& vertex : v) vertex = becomes[vertex];
    return v;
  };
  std::map<std::array<int, 2>, int> waiting;
  for (const int facet : first) waiting[ends(facet)] = facet;
  std::vector<char> inside(mesh.boundary.size(), 0);
  for (const int facet : second) {
    const auto [a, b] = ends(facet);
    const auto partner = waiting.find({b, a});  // the other body is on the other side
    if (partner == waiting.end()) refuse_alone(mesh, bond, facet, first);
    inside[facet] = inside[partner->second] = 1;
    waiting.erase(partner);
  }
  if (!waiting.empty()) refuse_alone(mesh, bond, waiting.begin()->second, second);

  std::vector<PartEdge> part_edges;
  std::vector<int> number(mesh.vertices.size(), -1);
  Mesh<2> result;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (becomes[v] != static_cast<int>(v)) continue;
    number[v] = static_cast<int>(result.vertices.size());
    result.vertices.push_back(mesh.vertices[v]);
  }
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    if (inside[f] || mesh.boundary[f].part < 0) continue;
    const auto [a, b] = ends(static_cast<int>(f));
    part_edges.push_back({{number[a], number[b]}, mesh.boundary[f].part});
  }
  result.cells = std::move(mesh.cells);
  for (auto& cell : result.cells)
    for (int& vertex : cell) vertex = number[becomes[vertex]];
  result.cell_body = std::move(mesh.cell_body);
  result.bodies = std::move(mesh.bodies);
  result.parts = std::move(mesh.parts);
  result.notes = std::move(mesh.notes);
  result.coordinate_rounding = mesh.coordinate_rounding;
  result.notes.push_back(
      fmt::format("'{}' and '{}' are bonded along {} edge{}: one piece, without tractions of their own",
                  name(bond.first), name(bond.second), first.size(), first.size() == 1 ? "" : "s"));
  return with_topology(std::move(result), part_edges, where);
}

}  // namespace

Mesh<2> bonded(Mesh<2> mesh, const std::vector<Bond>& bonds, const std::string& where) {
  for (const Bond& bond : bonds) mesh = joined(std::move(mesh), bond, where);
  return mesh;
}

}  // namespace bracket::scene
