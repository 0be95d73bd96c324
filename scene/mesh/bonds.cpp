// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/mesh/bonds.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "scene/mesh/raw_mesh.h"
#include "scene/mesh/topology.h"
#include "scene/problem/tolerance.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

template <int dim> std::vector<int> facets_of(const Mesh<dim>& mesh, const Side& side, const Bond& bond) {
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
           fmt::format("'{}' has no {} on the boundary; bodies that share their nodes are one without a bond", part,
                       dim == 2 ? "line" : "face"));
  }
  return facets;
}

/// Of each vertex of the mesh, which one it becomes: those of the second side, those of the first that are as close.
template <int dim>
std::vector<int> partners(const Mesh<dim>& mesh, const std::vector<int>& first, const std::vector<int>& second) {
  double near = std::numeric_limits<double>::infinity();
  std::vector<int> vertices;  // those of the first side before those of the second
  for (const std::vector<int>* side : {&first, &second})
    for (const int facet : *side) {
      near = std::min(near, tolerance(mesh, facet));
      for (const int vertex : mesh.boundary[facet].vertices) vertices.push_back(vertex);
    }
  std::vector<Vector<dim>> points;
  for (const int vertex : vertices) points.push_back(mesh.vertices[vertex]);
  std::vector<int> becomes(mesh.vertices.size());
  for (std::size_t v = 0; v < becomes.size(); ++v) becomes[v] = static_cast<int>(v);
  const std::vector<int> of = merged(points, near);
  for (std::size_t i = 0; i < of.size(); ++i) becomes[vertices[i]] = vertices[of[i]];
  return becomes;
}

template <int dim>
[[noreturn]] void refuse_alone(const Mesh<dim>& mesh, const Bond& bond, int facet, const std::vector<int>& across) {
  const auto ends = positions(mesh, mesh.boundary[facet].vertices);
  Vector<dim> nearest = ends[0], to = ends[0];
  double distance = -1;  // of the one of its vertices that is farthest from all nodes across, and the nearest of those
  for (const Vector<dim>& end : ends) {
    double least = std::numeric_limits<double>::infinity();
    Vector<dim> found = end;
    for (const int other : across)
      for (const Vector<dim>& x : positions(mesh, mesh.boundary[other].vertices))
        if ((x - end).norm() < least) {
          least = (x - end).norm();
          found = x;
        }
    if (least <= distance) continue;
    distance = least;
    nearest = found;
    to = end;
  }
  std::vector<std::string> corners;
  for (const Vector<dim>& end : ends) corners.push_back(point(end));
  fail(Status::mesh, bond.where,
       fmt::format(
           "bonded sides must coincide node by node: the {} of '{}' {} {} has no partner; the node across "
           "nearest to {} is {}, {:.3g} away. Mesh both sides alike, or name parts that end where the bond does",
           dim == 2 ? "edge" : "face", mesh.parts[mesh.boundary[facet].part], dim == 2 ? "from" : "with the corners",
           fmt::join(corners, dim == 2 ? " to " : ", "), point(to), point(nearest), distance));
}

template <int dim> Mesh<dim> joined(Mesh<dim> mesh, const Bond& bond, const std::string& where) {
  const std::vector<int> first = facets_of(mesh, bond.first, bond), second = facets_of(mesh, bond.second, bond);
  const std::vector<int> becomes = partners(mesh, first, second);
  const auto ends = [&](int facet) {
    std::array<int, dim> v = mesh.boundary[facet].vertices;
    for (int& vertex : v) vertex = becomes[vertex];
    return v;
  };
  const auto turning = [](std::array<int, dim> v) {  // in space a facet may begin with any of its vertices
    if (dim == 3) std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    return v;
  };
  std::map<std::array<int, dim>, int> waiting;
  for (const int facet : first) waiting[turning(ends(facet))] = facet;
  std::vector<char> inside(mesh.boundary.size(), 0);
  for (const int facet : second) {
    std::array<int, dim> across = ends(facet);
    std::reverse(across.begin(), across.end());
    const auto partner = waiting.find(turning(across));  // the other body is on the other side
    if (partner == waiting.end()) refuse_alone(mesh, bond, facet, first);
    inside[facet] = inside[partner->second] = 1;
    waiting.erase(partner);
  }
  if (!waiting.empty()) refuse_alone(mesh, bond, waiting.begin()->second, second);

  std::vector<PartFacet<dim>> part_facets;
  std::vector<int> number(mesh.vertices.size(), -1);
  Mesh<dim> result;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (becomes[v] != static_cast<int>(v)) continue;
    number[v] = static_cast<int>(result.vertices.size());
    result.vertices.push_back(mesh.vertices[v]);
  }
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    if (inside[f] || mesh.boundary[f].part < 0) continue;
    std::array<int, dim> vertices = ends(static_cast<int>(f));
    for (int& vertex : vertices) vertex = number[vertex];
    part_facets.push_back({vertices, mesh.boundary[f].part});
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
      fmt::format("'{}' and '{}' are bonded along {} {}{}: one piece, without tractions of their own", name(bond.first),
                  name(bond.second), first.size(), dim == 2 ? "edge" : "face", first.size() == 1 ? "" : "s"));
  return with_topology(std::move(result), part_facets, where);
}

}  // namespace

template <int dim> Mesh<dim> bonded(Mesh<dim> mesh, const std::vector<Bond>& bonds, const std::string& where) {
  for (const Bond& bond : bonds) mesh = joined(std::move(mesh), bond, where);
  return mesh;
}

template Mesh<2> bonded(Mesh<2>, const std::vector<Bond>&, const std::string&);
template Mesh<3> bonded(Mesh<3>, const std::vector<Bond>&, const std::string&);

}  // namespace bracket::scene
