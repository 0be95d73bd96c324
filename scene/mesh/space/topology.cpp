// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: tetrahedra, their edges and their facets.
#include "scene/mesh/topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cassert>
#include <cmath>
#include <numeric>
#include <tuple>

#include "scene/text.h"

namespace bracket::scene {

namespace {

std::string corners_of(const Mesh<3>& mesh, const std::array<int, 4>& cell) {
  return fmt::format("{}, {}, {}, {}", point(mesh.vertices[cell[0]]), point(mesh.vertices[cell[1]]),
                     point(mesh.vertices[cell[2]]), point(mesh.vertices[cell[3]]));
}

/// Turns cells that are inside out; refuses degenerate ones.
Mesh<3> turned(Mesh<3> mesh, const std::string& where) {
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const auto x = positions(mesh, mesh.cells[cell]);
    const double content = volume<3>(x);
    double longest = 0;
    for (const auto& [i, j] : Simplex<3>::edges) longest = std::max(longest, (x[j] - x[i]).norm());
    if (!(std::abs(content) > 1e-14 * longest * longest * longest) || !std::isfinite(longest))
      fail(Status::mesh, where,
           fmt::format("the cell with the corners {} is degenerate: its volume is {:.3g}",
                       corners_of(mesh, mesh.cells[cell]), content));
    if (content > 0) continue;
    std::swap(mesh.cells[cell][2], mesh.cells[cell][3]);
    ++count;
  }
  if (count > 0)
    mesh.notes.push_back(
        fmt::format("{} cell{} that {} inside out turned", count, count == 1 ? "" : "s", count == 1 ? "is" : "are"));
  return mesh;
}

/// A part of a cell, by its vertices, the lowest first, and its place: n cell + the number of the part.
template <std::size_t n> struct Slot {
  std::array<int, n> vertices;
  int place;
};

/// Sorted by vertices, then places, in linear time but for few that share their lowest vertex.
template <std::size_t n> std::vector<Slot<n>> sorted(const std::vector<Slot<n>>& slots, std::size_t n_vertices) {
  std::vector<int> start(n_vertices + 1, 0);
  for (const auto& slot : slots) ++start[slot.vertices[0] + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<Slot<n>> result(slots.size());
  std::vector<int> next(start.begin(), start.end() - 1);
  for (const auto& slot : slots) result[next[slot.vertices[0]]++] = slot;
  for (std::size_t v = 0; v < n_vertices; ++v)
    std::sort(result.begin() + start[v], result.begin() + start[v + 1], [](const Slot<n>& a, const Slot<n>& b) {
      return std::tie(a.vertices, a.place) < std::tie(b.vertices, b.place);
    });
  return result;
}

template <std::size_t n> std::array<int, n> in_order(std::array<int, n> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

void number_edges(Mesh<3>& mesh) {
  std::vector<Slot<2>> slots;
  slots.reserve(6 * mesh.cells.size());
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    for (int e = 0; e < 6; ++e) {
      const auto& [i, j] = Simplex<3>::edges[e];
      slots.push_back({in_order(std::array{mesh.cells[cell][i], mesh.cells[cell][j]}), static_cast<int>(6 * cell) + e});
    }
  mesh.cell_edges.resize(mesh.cells.size());
  for (const Slot<2>& slot : sorted(slots, mesh.vertices.size())) {
    if (mesh.edges.empty() || mesh.edges.back() != slot.vertices) mesh.edges.push_back(slot.vertices);
    mesh.cell_edges[slot.place / 6][slot.place % 6] = static_cast<int>(mesh.edges.size()) - 1;
  }
}

/// Two cells on one facet must lie on different sides of it: one has it turned one way, the other the other.
void check_neighbours(const Mesh<3>& mesh, const Slot<3>* slots, std::ptrdiff_t count, const std::string& where) {
  const auto seen = [&](int k) { return facet_vertices(mesh, slots[k].place / 4, slots[k].place % 4); };
  if (count == 2) {
    const auto one = seen(0);
    auto other = seen(1);
    std::rotate(other.begin(), std::find(other.begin(), other.end(), one[0]), other.end());
    if (other[1] == one[2]) return;
  }
  for (std::ptrdiff_t i = 0; i < count; ++i)
    for (std::ptrdiff_t j = 0; j < i; ++j)
      if (in_order(mesh.cells[slots[i].place / 4]) == in_order(mesh.cells[slots[j].place / 4]))
        fail(Status::mesh, where, "there are duplicate cells at " + point(centre(mesh, slots[i].place / 4)));
  const auto x = positions(mesh, slots[0].vertices);
  fail(Status::mesh, where,
       fmt::format("{} at the facet with the corners {}, {}, {}",
                   count > 2 ? "more than two cells meet" : "cells overlap", point(x[0]), point(x[1]), point(x[2])));
}

void number_facets(Mesh<3>& mesh, const std::string& where) {
  std::vector<Slot<3>> slots;
  slots.reserve(4 * mesh.cells.size());
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    for (int k = 0; k < 4; ++k)
      slots.push_back({in_order(facet_vertices(mesh, static_cast<int>(cell), k)), static_cast<int>(4 * cell) + k});
  slots = sorted(slots, mesh.vertices.size());
  mesh.facet_numbers.resize(mesh.cells.size());
  for (std::size_t from = 0, to; from < slots.size(); from = to) {
    for (to = from + 1; to < slots.size() && slots[to].vertices == slots[from].vertices;) ++to;
    const int cell = slots[from].place / 4, local = slots[from].place % 4;
    if (to - from > 1)
      check_neighbours(mesh, &slots[from], static_cast<std::ptrdiff_t>(to - from), where);
    else
      mesh.boundary.push_back({facet_vertices(mesh, cell, local), cell, local, -1, -1});
    for (std::size_t i = from; i < to; ++i)
      mesh.facet_numbers[slots[i].place / 4][slots[i].place % 4] = mesh.facet_count;
    ++mesh.facet_count;
  }
}

/// No body may hang by an edge: two facets of the boundary meet at each of its edges.
void check_edges(const Mesh<3>& mesh, const std::string& where) {
  std::vector<int> facets(mesh.edges.size(), 0);
  for (const auto& facet : mesh.boundary)
    for (const int edge : facet_edges(mesh, facet)) {
      if (++facets[edge] <= 2) continue;
      const auto [a, b] = positions(mesh, mesh.edges[edge]);
      fail(Status::mesh, where,
           fmt::format("the body '{}' hangs by an edge only from {} to {}", mesh.bodies[mesh.cell_body[facet.cell]],
                       point(a), point(b)));
    }
}

/// Nor by a point: the cells at each vertex hang together through facets at it.
void check_vertices(const Mesh<3>& mesh, const std::string& where) {
  const int corners = 4 * static_cast<int>(mesh.cells.size());  // vertices of cells, each a thing of its own
  std::vector<int> ranks(corners), parents(corners), first(3 * n_facets(mesh), -1);
  std::iota(parents.begin(), parents.end(), 0);
  boost::disjoint_sets<int*, int*> together(ranks.data(), parents.data());
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    for (int k = 0; k < 4; ++k) {
      const auto vertices = facet_vertices(mesh, static_cast<int>(cell), k);
      for (int i = 0; i < 3; ++i) {
        const auto rank = std::count_if(vertices.begin(), vertices.end(), [&](int v) { return v < vertices[i]; });
        int& known = first[3 * mesh.facet_numbers[cell][k] + rank];
        const int corner = 4 * static_cast<int>(cell) + Simplex<3>::facets[k][i];
        if (known == -1) known = corner;
        together.union_set(known, corner);
      }
    }
  std::vector<int> star(mesh.vertices.size(), -1);
  for (int corner = 0; corner < corners; ++corner) {
    const int vertex = mesh.cells[corner / 4][corner % 4], set = together.find_set(corner);
    if (star[vertex] == -1) star[vertex] = set;
    if (star[vertex] != set)
      fail(Status::mesh, where,
           fmt::format("the body '{}' hangs by a point only at {}", mesh.bodies[mesh.cell_body[corner / 4]],
                       point(mesh.vertices[vertex])));
  }
}

}  // namespace

EdgeRank edge_rank(const Mesh<3>& mesh, int edge) {
  const auto [a, b] = positions(mesh, mesh.edges[edge]);
  std::array<double, 3> first = {a[0], a[1], a[2]}, second = {b[0], b[1], b[2]};
  if (second < first) std::swap(first, second);
  return {(b - a).squaredNorm(), first, second};
}

std::vector<char> longest_edges(const Mesh<3>& mesh) {
  std::vector<char> longest;
  longest.reserve(mesh.cells.size());
  for (const auto& edges : mesh.cell_edges) {
    const auto rank = [&](int edge) { return edge_rank(mesh, edge); };
    longest.push_back(static_cast<char>(std::ranges::max_element(edges, {}, rank) - edges.begin()));
  }
  return longest;
}

Mesh<3> with_edges(Mesh<3> mesh, const std::string& where) {
  mesh = turned(std::move(mesh), where);
  number_edges(mesh);
  number_facets(mesh, where);
  return mesh;
}

Mesh<3> completed(Mesh<3> mesh, const std::vector<PartFacet<3>>& part_facets, const std::string& where) {
  mesh.refinement_edge = longest_edges(mesh);
  mesh = with_components(std::move(mesh));
  check_whole(mesh, where);
  check_edges(mesh, where);
  check_vertices(mesh, where);
  const auto key = [](const Mesh<3>::Facet& facet) { return in_order(facet.vertices); };
  for (const PartFacet<3>& given : part_facets) {
    const auto facet = std::ranges::lower_bound(mesh.boundary, in_order(given.vertices), {}, key);
    assert(facet != mesh.boundary.end() && key(*facet) == in_order(given.vertices));
    facet->part = given.part;
  }
  return mesh;
}

}  // namespace bracket::scene
