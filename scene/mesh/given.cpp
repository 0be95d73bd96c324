// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "scene/mesh/raw_mesh.h"
#include "scene/range.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// \param what that has the place, for messages
template <class What> void check_place(int place, std::size_t count, const char* word, const What& what) {
  if (place < 0 || place >= static_cast<int>(count))
    fail(Status::mesh, "", fmt::format("{} has the {} {}; expected 0 to {}", what(), word, place, count - 1));
}

}  // namespace

RawMesh raw_mesh_of(const GivenMesh<2>& given) {
  RawMesh raw;
  raw.body_word = "cell set";
  for (std::size_t i = 0; i < given.vertices.size(); ++i) {
    const Vector<2>& x = given.vertices[i];
    for (const double coordinate : x) check_size(coordinate, "", fmt::format("a coordinate of the vertex {}", i));
    raw.nodes.push_back({static_cast<RawMesh::Tag>(i), {x[0], x[1], 0}});
  }
  raw.coordinate_rounding = rounding_of(raw.nodes);
  for (std::size_t i = 0; i < given.cells.size(); ++i) {
    const auto& [a, b, c] = given.cells[i];
    for (const int vertex : given.cells[i])
      check_place(vertex, given.vertices.size(), "vertex", [i] { return fmt::format("the cell {}", i); });
    raw.cells.push_back({static_cast<RawMesh::Tag>(i), {a, b, c, -1}});
  }
  for (const auto& [name, cells] : given.bodies) {
    for (const int cell : cells)
      check_place(cell, given.cells.size(), "cell", [&name = name] { return "the body '" + name + "'"; });
    raw.bodies.push_back({name, cells});
  }
  for (const auto& [name, facets] : given.parts) {
    RawMesh::Set part{name, {}};
    for (const auto& [a, b] : facets) {
      for (const int vertex : {a, b})
        check_place(vertex, given.vertices.size(), "vertex", [&name = name] { return "the part '" + name + "'"; });
      part.members.push_back(static_cast<int>(raw.lines.size()));
      raw.lines.push_back({static_cast<RawMesh::Tag>(part.members.size() - 1), {a, b, -1, -1}});
    }
    raw.parts.push_back(std::move(part));
  }
  return raw;
}

}  // namespace bracket::scene
