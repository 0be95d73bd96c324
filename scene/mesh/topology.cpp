// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: an edge is a facet, and cells turn round one way or the other.
#include "scene/mesh/topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "scene/mesh/raw_mesh.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// A side of a cell, seen from the lower of its two vertices.
struct CellEdge {
  int upper;  // the other vertex
  int slot;   // 3 cell + side
};

std::array<int, 2> ends(const Mesh<2>& mesh, int slot) { return facet_vertices(mesh, slot / 3, slot % 3); }

std::string edge_at(const Mesh<2>& mesh, const std::array<int, 2>& edge) {
  return fmt::format("from {} to {}", point(mesh.vertices[edge[0]]), point(mesh.vertices[edge[1]]));
}

/// Turns clockwise cells; refuses degenerate ones.
Mesh<2> turned(Mesh<2> mesh, const std::string& where) {
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    auto& [a, b, c] = mesh.cells[cell];
    const double area = volume(mesh, static_cast<int>(cell));
    const double longest = std::max({(mesh.vertices[b] - mesh.vertices[a]).squaredNorm(),
                                     (mesh.vertices[c] - mesh.vertices[b]).squaredNorm(),
                                     (mesh.vertices[a] - mesh.vertices[c]).squaredNorm()});
    if (!(std::abs(area) > 1e-14 * longest) || !std::isfinite(longest)) {  // also where a square over- or underflows
      fail(Status::mesh, where,
           fmt::format("the cell with the corners {}, {}, {} is degenerate: its area is {:.3g}",
                       point(mesh.vertices[a]), point(mesh.vertices[b]), point(mesh.vertices[c]), area));
    }
    if (area > 0) continue;
    std::swap(b, c);
    ++count;
  }
  if (count > 0) mesh.notes.push_back(fmt::format("{} clockwise cell{} turned", count, count == 1 ? "" : "s"));
  return mesh;
}

/// Two cells on one edge must lie on different sides of it: one walks it up, the other down.
void check_neighbours(const Mesh<2>& mesh, const CellEdge* sides, std::ptrdiff_t count, const std::string& where) {
  const std::array<int, 2> edge = ends(mesh, sides[0].slot);
  if (count == 2 && edge != ends(mesh, sides[1].slot)) return;
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    for (std::ptrdiff_t j = 0; j < i; ++j) {
      const auto& one = mesh.cells[sides[i].slot / 3];
      const auto& other = mesh.cells[sides[j].slot / 3];
      if (!std::is_permutation(one.begin(), one.end(), other.begin())) continue;
      fail(Status::mesh, where, "there are duplicate cells at " + point(centre(mesh, sides[i].slot / 3)));
    }
  }
  fail(Status::mesh, where,
       fmt::format("{} at the edge {}", count > 2 ? "more than two cells meet" : "cells overlap", edge_at(mesh, edge)));
}

/// No body may hang by a point.
void check_connected(const Mesh<2>& mesh, const std::string& where) {
  std::vector<int> facets(mesh.vertices.size(), 0);
  for (const auto& facet : mesh.boundary) {
    for (const int vertex : facet.vertices) {
      if (++facets[vertex] <= 2) continue;
      fail(Status::mesh, where,
           fmt::format("the body '{}' hangs by a point only at {}", mesh.bodies[mesh.cell_body[facet.cell]],
                       point(mesh.vertices[vertex])));
    }
  }
}

Mesh<2> with_parts(Mesh<2> mesh, const std::vector<PartEdge>& part_edges) {
  std::vector<int> facet_of_edge(mesh.edges.size(), -1);
  for (std::size_t facet = 0; facet < mesh.boundary.size(); ++facet) {
    facet_of_edge[mesh.boundary[facet].edge] = static_cast<int>(facet);
  }
  for (const PartEdge& given : part_edges) {
    const std::array<int, 2> key = {std::ranges::min(given.vertices), std::ranges::max(given.vertices)};
    const auto edge = std::lower_bound(mesh.edges.begin(), mesh.edges.end(), key);
    assert(edge != mesh.edges.end() && *edge == key && facet_of_edge[edge - mesh.edges.begin()] != -1);
    mesh.boundary[facet_of_edge[edge - mesh.edges.begin()]].part = given.part;
  }
  return mesh;
}

}  // namespace

std::vector<char> longest_edges(const Mesh<2>& mesh) {
  std::vector<char> longest;
  longest.reserve(mesh.cells.size());
  for (const auto& edges : mesh.cell_edges) {
    const auto rank = [&](int edge) {
      const auto& [a, b] = mesh.edges[edge];
      return std::pair((mesh.vertices[b] - mesh.vertices[a]).squaredNorm(), -edge);
    };
    longest.push_back(static_cast<char>(std::ranges::max_element(edges, {}, rank) - edges.begin()));
  }
  return longest;
}

// Sides are put into one bucket per lower vertex, which a few others share: the
// edges come out sorted, in linear time.
Mesh<2> with_edges(Mesh<2> mesh, const std::string& where) {
  mesh = turned(std::move(mesh), where);
  const int slots = 3 * static_cast<int>(mesh.cells.size());
  std::vector<int> start(mesh.vertices.size() + 1, 0);
  for (int slot = 0; slot < slots; ++slot) ++start[std::ranges::min(ends(mesh, slot)) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<CellEdge> sides(slots);
  std::vector<int> next(start.begin(), start.end() - 1);
  for (int slot = 0; slot < slots; ++slot) {
    const auto [lower, upper] = std::ranges::minmax(ends(mesh, slot));
    sides[next[lower]++] = {upper, slot};
  }
  mesh.cell_edges.resize(mesh.cells.size());
  mesh.edges.reserve(mesh.cells.size() * 3 / 2 + mesh.cells.size() / 16);
  for (std::size_t lower = 0; lower < mesh.vertices.size(); ++lower) {
    const auto bucket = sides.begin() + start[lower];
    const auto bucket_end = sides.begin() + start[lower + 1];
    std::sort(bucket, bucket_end, [](const CellEdge& a, const CellEdge& b) {
      return a.upper != b.upper ? a.upper < b.upper : a.slot < b.slot;
    });
    for (auto side = bucket; side != bucket_end;) {
      const int edge = static_cast<int>(mesh.edges.size());
      mesh.edges.push_back({static_cast<int>(lower), side->upper});
      const auto last =
          std::find_if(side, bucket_end, [&](const CellEdge& other) { return other.upper != side->upper; });
      if (last - side > 1) {
        check_neighbours(mesh, &*side, last - side, where);
      } else {
        mesh.boundary.push_back({ends(mesh, side->slot), side->slot / 3, side->slot % 3, edge, -1});
      }
      for (; side != last; ++side) mesh.cell_edges[side->slot / 3][side->slot % 3] = edge;
    }
  }
  return mesh;
}

Mesh<2> completed(Mesh<2> mesh, const std::vector<PartEdge>& part_edges, const std::string& where) {
  mesh.refinement_edge = longest_edges(mesh);
  mesh = with_components(std::move(mesh));
  check_whole(mesh, where);
  check_connected(mesh, where);
  return with_parts(std::move(mesh), part_edges);
}

}  // namespace bracket::scene
