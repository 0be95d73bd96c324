// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: newest-vertex bisection of triangles, whose edges are their facets.
#include <algorithm>
#include <cassert>
#include <tuple>

#include "scene/enclosure.h"
#include "scene/problem/refine.h"
#include "scene/problem/stretch.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// The edges that all three sides of the marked cells and conformity ask to be bisected: a cell of which any edge is
/// bisected has its refinement edge bisected, and so has a contact facet whose counterpart is. Each edge and each cell
/// at it are looked at once: linear time, and however the refinement edges were chosen on the coarsest mesh, all the
/// rounds together add no more than a multiple of the cells marked [Karkulik, Pavlicek & Praetorius, Constr. Approx. 38
/// (2013)].
std::vector<char> bisected_edges(const Problem<2>& problem, const std::vector<char>& marked) {
  const Mesh<2>& mesh = problem.mesh;
  std::vector<std::array<int, 2>> edge_cells(mesh.edges.size(), {-1, -1});
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    for (const int edge : mesh.cell_edges[cell]) {
      edge_cells[edge][edge_cells[edge][0] == -1 ? 0 : 1] = static_cast<int>(cell);
    }
  }
  std::vector<int> partner(mesh.edges.size(), -1);
  for (const ContactFacet& pair : problem.contact) {
    if (pair.second == -1) continue;
    const int first = mesh.boundary[pair.first].edge, second = mesh.boundary[pair.second].edge;
    partner[first] = second;
    partner[second] = first;
  }

  std::vector<char> bisected(mesh.edges.size(), false);
  std::vector<int> work;
  const auto bisect = [&](int edge) {
    if (bisected[edge]) return;
    bisected[edge] = true;
    work.push_back(edge);
  };
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    if (!marked[cell]) continue;
    for (const int edge : mesh.cell_edges[cell]) bisect(edge);
  }
  while (!work.empty()) {
    const int edge = work.back();
    work.pop_back();
    if (partner[edge] != -1) bisect(partner[edge]);
    for (const int cell : edge_cells[edge]) {
      if (cell != -1) bisect(mesh.cell_edges[cell][mesh.refinement_edge[cell]]);
    }
  }
  return bisected;
}

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

/// Halfway between two points of a simplex, in its barycentric coordinates.
template <std::size_t d> std::array<double, d> halfway(const std::array<double, d>& a, const std::array<double, d>& b) {
  std::array<double, d> middle;
  for (std::size_t i = 0; i < d; ++i) {
    middle[i] = 0.5 * (a[i] + b[i]);
    // The coordinates are at most 1: a multiple of 2⁻⁵² shifted by one is one still.
    if ((1 + middle[i]) - 1 == middle[i]) continue;
    fail(Status::budget, "", "the mesh cannot be refined any further: its cells are 52 halvings small");
  }
  return middle;
}

/// The pieces of the first mesh's cells that the children are.
std::vector<Piece<2>> pieces_of_cells(const Problem<2>& old, const Mesh<2>& mesh, const std::vector<int>& cell_parent,
                                      const Halves& halves) {
  std::vector<Piece<2>> pieces;
  pieces.reserve(mesh.cells.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int parent = cell_parent[c];
    const auto& vertices = old.mesh.cells[parent];
    const Piece<2> whole = piece_of_cell(old, parent);
    Piece<2> piece{whole.of, {}};
    for (int i = 0; i < 3; ++i) {
      const int vertex = mesh.cells[c][i];
      for (int k = 0; k < 3; ++k) {
        const auto& [from, to] = Simplex<2>::edges[k];
        if (vertices[k] == vertex) piece.corner[i] = whole.corner[k];
        if (halves.midpoint[old.mesh.cell_edges[parent][k]] == vertex)
          piece.corner[i] = halfway(whole.corner[from], whole.corner[to]);
      }
    }
    pieces.push_back(piece);
  }
  return pieces;
}

/// The first mesh's data on a piece of one of its facets, rounded.
FacetData<2> on_piece(FacetData<2> data, const Piece<1>& piece) {
  const FacetData<2> given = data;
  const double width = piece.corner[1][0] - piece.corner[0][0];
  for (int i = 0; i < 2; ++i) {
    const double t = piece.corner[i][0];
    data.traction[i] = between_ends(given.traction, t);
    data.pressure[i] = between_ends(given.pressure, t);
    data.correction[i] = width * between_ends(given.correction, t);
    data.displacement[i] = between_ends(given.displacement, t);
    data.normal_displacement[i] = between_ends(given.normal_displacement, t);
  }
  return data;
}

/// Fills the boundary and its data. \return with the first of each old facet's one or two children, in its order
std::pair<Problem<2>, std::vector<int>> with_boundary(Problem<2> problem, const Problem<2>& old, const Halves& halves) {
  Mesh<2>& mesh = problem.mesh;
  std::vector<int> slot(mesh.edges.size());  // 3 cell + side, the only one where the edge is on the boundary
  for (std::size_t i = 0; i < 3 * mesh.cells.size(); ++i) slot[mesh.cell_edges[i / 3][i % 3]] = static_cast<int>(i);
  std::vector<int> first_child;
  for (std::size_t i = 0; i < old.mesh.boundary.size(); ++i) {
    const auto& facet = old.mesh.boundary[i];
    const auto& [a, b] = facet.vertices;
    const Piece<1> whole = piece_of_facet(old, static_cast<int>(i));
    const auto add = [&](const std::array<int, 2>& vertices, int edge, const Piece<1>& piece) {
      mesh.boundary.push_back({vertices, slot[edge] / 3, slot[edge] % 3, edge, facet.part});
      problem.facets.push_back(on_piece(first_of(old).facets[piece.of], piece));
      problem.origin.facets.push_back(piece);
    };
    first_child.push_back(static_cast<int>(mesh.boundary.size()));
    const int middle = halves.midpoint[facet.edge];
    if (middle == -1) {
      add(facet.vertices, halves.first[facet.edge], whole);
    } else {
      const auto cut = halfway(whole.corner[0], whole.corner[1]);
      add({a, middle}, half_at(old.mesh, halves, facet.edge, a), {whole.of, {whole.corner[0], cut}});
      add({middle, b}, half_at(old.mesh, halves, facet.edge, b), {whole.of, {cut, whole.corner[1]}});
    }
  }
  return {std::move(problem), std::move(first_child)};
}

}  // namespace

ContactFacet on_piece(const ContactFacet& given, int first, int second, const Piece<1>& piece) {
  ContactFacet facet{given.pair, first, second, {}, {}};
  const double from = piece.corner[0][0], to = piece.corner[1][0];
  const auto cut = [&](const std::array<double, 3>& whole) {
    return on_stretch(std::array<Enclosure, 3>{whole[0], whole[1], whole[2]}, from, to);
  };
  const auto below = cut(given.lower), above = cut(given.upper);
  for (int i = 0; i < 3; ++i) {
    facet.lower[i] = lower(below[i]);
    facet.upper[i] = upper(above[i]);
  }
  return facet;
}

template <int dim> Refined<dim> refine(const Problem<dim>& problem, const std::vector<char>& marked) {
  static_assert(dim == 2);
  assert(marked.size() == problem.mesh.cells.size());
  assert(problem.mesh.refinement_edge.size() == problem.mesh.cells.size());
  Refined<dim> refined;
  refined.problem.bodies = problem.bodies;
  refined.problem.oscillation = problem.oscillation;
  refined.problem.length_scale = problem.length_scale;
  refined.problem.corrections = problem.corrections;
  refined.problem.carries = problem.carries;
  refined.problem.imbalance = problem.imbalance;
  Origin<dim>& origin = refined.problem.origin;
  origin.first = problem.origin.first ? problem.origin.first : std::make_shared<const Problem<dim>>(problem);
  auto [mesh, halves] = with_halved_edges(problem.mesh, bisected_edges(problem, marked));
  std::tie(refined.problem.mesh, refined.cell_parent) = with_children(std::move(mesh), problem.mesh, halves);
  origin.cells = pieces_of_cells(problem, refined.problem.mesh, refined.cell_parent, halves);
  std::vector<int> first_child;
  std::tie(refined.problem, first_child) = with_boundary(std::move(refined.problem), problem, halves);
  const std::vector<int> contact_of_facet = contacts_by_first(*origin.first);
  for (std::size_t i = 0; i < problem.contact.size(); ++i) {
    const int first = problem.contact[i].first, second = problem.contact[i].second;
    const auto add = [&](int one, int other) {
      const Piece<dim - 1>& piece = refined.problem.origin.facets[one];
      refined.problem.contact.push_back(on_piece(origin.first->contact[contact_of_facet[piece.of]], one, other, piece));
      refined.contact_parent.push_back(static_cast<int>(i));
    };
    const int one = first_child[first], other = second == -1 ? -1 : first_child[second];
    if (halves.midpoint[problem.mesh.boundary[first].edge] == -1) {
      add(one, other);
    } else {  // the second facet runs the other way
      add(one, other == -1 ? -1 : other + 1);
      add(one + 1, other);
    }
  }
  return refined;
}

template Refined<2> refine(const Problem<2>&, const std::vector<char>&);

}  // namespace bracket::scene
