// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

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

template <int dim> RawMesh raw_mesh_of(const GivenMesh<dim>& given) {
  RawMesh raw;
  raw.dimension = dim;
  raw.body_word = "cell set";
  for (std::size_t i = 0; i < given.vertices.size(); ++i) {
    const Vector<dim>& x = given.vertices[i];
    for (const double coordinate : x) check_size(coordinate, "", fmt::format("a coordinate of the vertex {}", i));
    raw.nodes.push_back({static_cast<RawMesh::Tag>(i), {x[0], x[1], dim == 3 ? x[dim - 1] : 0}});
  }
  raw.coordinate_rounding = rounding_of(raw.nodes, dim);
  const auto element = [](std::size_t tag, const auto& vertices) {
    RawMesh::Element result{.tag = static_cast<RawMesh::Tag>(tag)};
    std::copy(vertices.begin(), vertices.end(), result.corners.begin());
    return result;
  };
  for (std::size_t i = 0; i < given.cells.size(); ++i) {
    for (const int vertex : given.cells[i])
      check_place(vertex, given.vertices.size(), "vertex", [i] { return fmt::format("the cell {}", i); });
    raw.cells.push_back(element(i, given.cells[i]));
  }
  for (const auto& [name, cells] : given.bodies) {
    for (const int cell : cells)
      check_place(cell, given.cells.size(), "cell", [&name = name] { return "the body '" + name + "'"; });
    raw.bodies.push_back({name, cells});
  }
  for (const auto& [name, facets] : given.parts) {
    RawMesh::Set part{name, {}};
    for (const auto& facet : facets) {
      for (const int vertex : facet)
        check_place(vertex, given.vertices.size(), "vertex", [&name = name] { return "the part '" + name + "'"; });
      part.members.push_back(static_cast<int>(raw.lines.size()));
      raw.lines.push_back(element(part.members.size() - 1, facet));
    }
    raw.parts.push_back(std::move(part));
  }
  return raw;
}

template RawMesh raw_mesh_of(const GivenMesh<2>&);
template RawMesh raw_mesh_of(const GivenMesh<3>&);

}  // namespace bracket::scene
