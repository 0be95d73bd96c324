// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: newest-vertex bisection of triangles, whose edges are their facets.
#include "scene/mesh/bisection.h"

#include <algorithm>
#include <cassert>
#include <tuple>

#include "scene/text.h"

namespace bracket::scene {

namespace {

/// What becomes of the edges of the old mesh, in the numbers of the new one.
struct Halves {
  std::vector<int> midpoint;  ///< vertex of each edge, −1: not bisected
  std::vector<int> first;     ///< the edge itself or the half at its lower vertex; the other half follows
};

/// The half of an old edge that ends at an old vertex.
int half_at(const Mesh<2>& old, const Halves& halves, int edge, int vertex) {
  return halves.first[edge] + (old.edges[edge][1] == vertex ? 1 : 0);
}

/// Vertices and halved edges of the new mesh; names and notes.
std::pair<Mesh<2>, Halves> with_halved_edges(const Mesh<2>& old, const std::vector<char>& bisected) {
  const std::size_t count = std::count(bisected.begin(), bisected.end(), true);
  Mesh<2> mesh;
  mesh.bodies = old.bodies;
  mesh.components = old.components;
  mesh.parts = old.parts;
  mesh.notes = old.notes;
  mesh.coordinate_rounding = old.coordinate_rounding;
  mesh.vertices.reserve(old.vertices.size() + count);
  mesh.vertices = old.vertices;
  mesh.edges.reserve(old.edges.size() + 3 * count);  // the other half, and a new edge in either cell
  Halves halves;
  halves.midpoint.reserve(old.edges.size());
  halves.first.reserve(old.edges.size());
  for (std::size_t edge = 0; edge < old.edges.size(); ++edge) {
    const auto& [a, b] = old.edges[edge];
    halves.first.push_back(static_cast<int>(mesh.edges.size()));
    if (!bisected[edge]) {
      halves.midpoint.push_back(-1);
      mesh.edges.push_back({a, b});
      continue;
    }
    const int middle = static_cast<int>(mesh.vertices.size());
    halves.midpoint.push_back(middle);
    // Does not depend on the order of the ends: on the two sides of a contact it is the same to the last bit.
    mesh.vertices.push_back(0.5 * (old.vertices[a] + old.vertices[b]));
    mesh.edges.push_back({a, middle});
    mesh.edges.push_back({b, middle});
  }
  return {std::move(mesh), std::move(halves)};
}

/// A child has half its parent's area, until rounding of the coordinates spoils its shape.
void check_resolved(const Mesh<2>& mesh, int cell, double parent_area) {
  if (volume(mesh, cell) > 0.1 * parent_area) return;  // at least a quarter, were it exact
  fail(Status::budget, "",
       "the mesh cannot be refined any further at " + point(mesh.vertices[mesh.cells[cell][0]]) +
           ": its cells are as small as the rounding of coordinates");
}

/// Fills the cells, their edges and the edges inside of old cells. A bisected cell a, b, c with refinement edge bc is
/// cut from a to the midpoint m of bc; each half m, p, q has its refinement edge pq opposite to m, and is cut from m if
/// that is to be bisected, too. The refinement edge of children is edge 0.
std::pair<Mesh<2>, std::vector<int>> with_children(Mesh<2> mesh, const Mesh<2>& old, const Halves& halves) {
  const std::size_t count = old.cells.size() + 2 * (mesh.vertices.size() - old.vertices.size());
  mesh.cells.reserve(count);
  mesh.cell_edges.reserve(count);
  mesh.cell_body.reserve(count);
  mesh.cell_component.reserve(count);
  mesh.refinement_edge.reserve(count);
  std::vector<int> cell_parent;
  cell_parent.reserve(count);
  const auto add_edge = [&](int one, int other) {
    mesh.edges.push_back({std::min(one, other), std::max(one, other)});
    return static_cast<int>(mesh.edges.size()) - 1;
  };
  const auto add_cell = [&](int parent, const std::array<int, 3>& vertices, const std::array<int, 3>& edges, int cut) {
    mesh.cells.push_back(vertices);
    mesh.cell_edges.push_back(edges);
    mesh.cell_body.push_back(old.cell_body[parent]);
    mesh.cell_component.push_back(old.cell_component[parent]);
    mesh.refinement_edge.push_back(static_cast<char>(cut));
    cell_parent.push_back(parent);
  };
  // The half m, p, q of `parent`, of which pq is an old edge, qm and mp are new.
  const auto add_half = [&](int parent, const std::array<int, 3>& vertices, int pq, int qm, int mp) {
    const auto& [m, p, q] = vertices;
    const int n = halves.midpoint[pq];
    if (n == -1) {
      add_cell(parent, vertices, {halves.first[pq], qm, mp}, 0);
      return;
    }
    const int nm = add_edge(n, m);
    add_cell(parent, {n, m, p}, {mp, half_at(old, halves, pq, p), nm}, 0);
    add_cell(parent, {n, q, m}, {qm, nm, half_at(old, halves, pq, q)}, 0);
  };
  for (std::size_t i = 0; i < old.cells.size(); ++i) {
    const int parent = static_cast<int>(i);
    const int cut = old.refinement_edge[i];
    const auto& edges = old.cell_edges[i];
    const int bc = edges[cut], ca = edges[(cut + 1) % 3], ab = edges[(cut + 2) % 3];
    const int m = halves.midpoint[bc];
    if (m == -1) {
      add_cell(parent, old.cells[i], {halves.first[edges[0]], halves.first[edges[1]], halves.first[edges[2]]}, cut);
      continue;
    }
    const auto [b, c] = facet_vertices(old, parent, cut);
    const int a = old.cells[i][cut];
    const int am = add_edge(a, m);
    const std::size_t first = mesh.cells.size();
    add_half(parent, {m, a, b}, ab, half_at(old, halves, bc, b), am);
    add_half(parent, {m, c, a}, ca, am, half_at(old, halves, bc, c));
    const double area = volume(old, parent);
    for (std::size_t child = first; child < mesh.cells.size(); ++child) {
      check_resolved(mesh, static_cast<int>(child), area);
    }
  }
  return {std::move(mesh), std::move(cell_parent)};
}

/// Fills the boundary. \return with the parent of each facet; of two halves the first comes first
std::pair<Mesh<2>, std::vector<int>> with_boundary(Mesh<2> mesh, const Mesh<2>& old, const Halves& halves) {
  std::vector<int> slot(mesh.edges.size());  // 3 cell + side, the only one where the edge is on the boundary
  for (std::size_t i = 0; i < 3 * mesh.cells.size(); ++i) slot[mesh.cell_edges[i / 3][i % 3]] = static_cast<int>(i);
  std::vector<int> facet_parent;
  for (std::size_t i = 0; i < old.boundary.size(); ++i) {
    const auto& facet = old.boundary[i];
    const auto& [a, b] = facet.vertices;
    const auto add = [&](const std::array<int, 2>& vertices, int edge) {
      mesh.boundary.push_back({vertices, slot[edge] / 3, slot[edge] % 3, edge, facet.part});
      facet_parent.push_back(static_cast<int>(i));
    };
    const int middle = halves.midpoint[facet.edge];
    if (middle == -1) {
      add(facet.vertices, halves.first[facet.edge]);
    } else {
      add({a, middle}, half_at(old, halves, facet.edge, a));
      add({middle, b}, half_at(old, halves, facet.edge, b));
    }
  }
  return {std::move(mesh), std::move(facet_parent)};
}

}  // namespace

std::vector<char> conforming(const Mesh<2>& mesh, const std::vector<int>& edges, const std::vector<int>& partner) {
  std::vector<std::array<int, 2>> edge_cells(mesh.edges.size(), {-1, -1});
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    for (const int edge : mesh.cell_edges[cell]) {
      edge_cells[edge][edge_cells[edge][0] == -1 ? 0 : 1] = static_cast<int>(cell);
    }
  }
  std::vector<char> bisected(mesh.edges.size(), false);
  std::vector<int> work;
  const auto bisect = [&](int edge) {
    if (bisected[edge]) return;
    bisected[edge] = true;
    work.push_back(edge);
  };
  for (const int edge : edges) bisect(edge);
  while (!work.empty()) {
    const int edge = work.back();
    work.pop_back();
    if (!partner.empty() && partner[edge] != -1) bisect(partner[edge]);
    for (const int cell : edge_cells[edge]) {
      if (cell != -1) bisect(mesh.cell_edges[cell][mesh.refinement_edge[cell]]);
    }
  }
  return bisected;
}

Bisected bisect(const Mesh<2>& old, const std::vector<char>& edges) {
  assert(edges.size() == old.edges.size() && old.refinement_edge.size() == old.cells.size());
  Bisected result;
  auto [mesh, halves] = with_halved_edges(old, edges);
  std::tie(mesh, result.cell_parent) = with_children(std::move(mesh), old, halves);
  std::tie(result.mesh, result.facet_parent) = with_boundary(std::move(mesh), old, halves);
  result.midpoint = std::move(halves.midpoint);
  return result;
}

}  // namespace bracket::scene
