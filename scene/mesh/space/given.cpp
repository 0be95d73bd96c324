// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: tetrahedra of one's own.
#include <fmt/format.h>

#include "scene/mesh/topology.h"
#include "scene/range.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// \param what that has the place, for messages
template <class What> void check_place_in(int place, std::size_t count, const char* word, const What& what) {
  if (place < 0 || place >= static_cast<int>(count))
    fail(Status::mesh, "", fmt::format("{} has the {} {}; expected 0 to {}", what(), word, place, count - 1));
}

}  // namespace

Mesh<3> mesh_of_given(const GivenMesh<3>& given, const std::string& where) {
  Mesh<3> mesh;
  std::vector<int> number(given.vertices.size(), -1);
  for (std::size_t i = 0; i < given.cells.size(); ++i)
    for (const int vertex : given.cells[i]) {
      check_place_in(vertex, given.vertices.size(), "vertex", [i] { return fmt::format("the cell {}", i); });
      number[vertex] = 0;
    }
  for (std::size_t v = 0; v < number.size(); ++v) {
    for (const double coordinate : given.vertices[v])
      check_size(coordinate, "", fmt::format("a coordinate of the vertex {}", v));
    if (number[v] == -1) continue;
    number[v] = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(given.vertices[v]);
  }
  mesh.cells = given.cells;
  for (auto& cell : mesh.cells)
    for (int& vertex : cell) vertex = number[vertex];
  mesh.cell_body.assign(mesh.cells.size(), given.bodies.empty() ? 0 : -1);
  if (given.bodies.empty()) mesh.bodies = {"body"};
  for (const auto& [name, cells] : given.bodies) {
    for (const int cell : cells) {
      check_place_in(cell, given.cells.size(), "cell", [&name = name] { return "the body '" + name + "'"; });
      mesh.cell_body[cell] = static_cast<int>(mesh.bodies.size());
    }
    mesh.bodies.push_back(name);
  }
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    if (mesh.cell_body[cell] == -1) fail(Status::mesh, where, fmt::format("the cell {} is in no body", cell));
  std::vector<PartFacet<3>> part_facets;
  for (const auto& [name, facets] : given.parts) {
    for (std::array<int, 3> facet : facets) {
      for (int& vertex : facet) {
        check_place_in(vertex, given.vertices.size(), "vertex", [&name = name] { return "the part '" + name + "'"; });
        vertex = number[vertex];
      }
      part_facets.push_back({facet, static_cast<int>(mesh.parts.size())});
    }
    mesh.parts.push_back(name);
  }
  return with_topology(std::move(mesh), part_facets, where);
}

}  // namespace bracket::scene
