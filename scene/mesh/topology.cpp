// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: an edge is a facet, and cells turn round one way or the other.
#include "scene/mesh/topology.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cassert>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

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

Vector<2> centre(const Mesh<2>& mesh, int cell) {
  const auto& [a, b, c] = mesh.cells[cell];
  return (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3;
}

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

/// Bisection cuts the longest edge of each coarse cell first: the shapes of its descendants are then the best. Among
/// equals, the one with the lowest number, so that neighbours agree.
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

/// The components and their names, in the order of their first bodies.
Mesh<2> with_components(Mesh<2> mesh) {
  const int cells = static_cast<int>(mesh.cells.size());
  std::vector<int> ranks(cells), parents(cells);
  std::iota(parents.begin(), parents.end(), 0);
  boost::disjoint_sets<int*, int*> connected(ranks.data(), parents.data());
  std::vector<int> first(n_facets(mesh), -1);
  for (int cell = 0; cell < cells; ++cell) {
    for (const int facet : cell_facets(mesh, cell)) {
      if (first[facet] == -1) first[facet] = cell;
      connected.union_set(first[facet], cell);
    }
  }
  std::map<int, std::set<int>> bodies;  // of each set, by its representative
  for (int cell = 0; cell < cells; ++cell) bodies[connected.find_set(cell)].insert(mesh.cell_body[cell]);
  std::vector<std::pair<std::set<int>, int>> sets;
  for (const auto& [representative, of] : bodies) sets.emplace_back(of, representative);
  std::ranges::sort(sets);
  std::vector<int> number(cells, -1);
  for (const auto& [of, representative] : sets) {
    number[representative] = static_cast<int>(mesh.components.size());
    std::vector<std::string> names;
    for (const int body : of) names.push_back(mesh.bodies[body]);
    mesh.components.push_back(fmt::format("{}", fmt::join(names, " + ")));
  }
  for (int cell = 0; cell < cells; ++cell) mesh.cell_component.push_back(number[connected.find_set(cell)]);
  return mesh;
}

/// Each body must belong to one component, and not hang by a point.
void check_connected(const Mesh<2>& mesh, const std::string& where) {
  std::vector<int> first(mesh.bodies.size(), -1);
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    int& known = first[mesh.cell_body[cell]];
    if (known == -1) known = cell;
    if (mesh.cell_component[known] == mesh.cell_component[cell]) continue;
    const std::string mend = coinciding_nodes(mesh, mesh.cell_body[cell]);
    fail(Status::mesh, where,
         fmt::format("the body '{}' falls into pieces: no chain of cells leads from {} to {}; {}",
                     mesh.bodies[mesh.cell_body[cell]], point(centre(mesh, known)), point(centre(mesh, cell)),
                     mend.empty() ? "make each a body" : mend));
  }
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

double coincidence(const Mesh<2>& mesh) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : mesh.edges) shortest = std::min(shortest, (mesh.vertices[b] - mesh.vertices[a]).norm());
  return std::pow(10, std::floor(std::log10(1e-6 * shortest)));
}

std::string coinciding_nodes(const Mesh<2>& mesh, int body) {
  std::set<int> of_body;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    if (mesh.cell_body[cell] == body) of_body.insert(mesh.cells[cell].begin(), mesh.cells[cell].end());
  const std::vector<int> vertices(of_body.begin(), of_body.end());
  std::vector<Vector<2>> points;
  for (const int vertex : vertices) points.push_back(mesh.vertices[vertex]);
  const double distance = coincidence(mesh);
  const std::vector<int> first = merged(points, distance);
  int count = 0;
  Vector<2> at = {0, 0};
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == static_cast<int>(i)) continue;
    if (count++ == 0) at = points[i];
  }
  if (count == 0) return "";
  return fmt::format("{} node{} with others, at {} for one; to make them one, write --set mesh.merge={:.0e}", count,
                     count == 1 ? " coincides" : "s coincide", point(at), distance);
}

Mesh<2> completed(Mesh<2> mesh, const std::vector<PartEdge>& part_edges, const std::string& where) {
  mesh.refinement_edge = longest_edges(mesh);
  mesh = with_components(std::move(mesh));
  check_connected(mesh, where);
  return with_parts(std::move(mesh), part_edges);
}

Mesh<2> with_topology(Mesh<2> mesh, const std::vector<PartEdge>& part_edges, const std::string& where) {
  return completed(with_edges(std::move(mesh), where), part_edges, where);
}

}  // namespace bracket::scene
