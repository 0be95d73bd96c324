// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: triangles, whose edges are their facets.
#include "scene/problem/refine.h"

#include <cassert>

#include "scene/mesh/bisection.h"
#include "scene/mesh/curves.h"
#include "scene/problem/gap.h"
#include "scene/problem/halfway.h"
#include "scene/problem/stretch.h"

namespace bracket::scene {

namespace {

/// The edges that all three sides of the marked cells, conformity and the two sides of contacts ask to be halved.
std::vector<char> bisected_edges(const Problem<2>& problem, const std::vector<char>& marked) {
  const Mesh<2>& mesh = problem.mesh;
  std::vector<int> partner(mesh.edges.size(), -1), edges;
  for (const ContactFacet& pair : problem.contact) {
    if (pair.second == -1) continue;
    const int first = mesh.boundary[pair.first].edge, second = mesh.boundary[pair.second].edge;
    partner[first] = second;
    partner[second] = first;
  }
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    if (marked[cell]) edges.insert(edges.end(), mesh.cell_edges[cell].begin(), mesh.cell_edges[cell].end());
  return conforming(mesh, edges, partner);
}

/// The pieces of the first mesh's cells that the children are.
std::vector<Piece<2>> pieces_of_cells(const Problem<2>& old, const Bisected& bisected) {
  std::vector<Piece<2>> pieces;
  pieces.reserve(bisected.mesh.cells.size());
  for (std::size_t c = 0; c < bisected.mesh.cells.size(); ++c) {
    const int parent = bisected.cell_parent[c];
    const auto& vertices = old.mesh.cells[parent];
    const Piece<2> whole = piece_of_cell(old, parent);
    Piece<2> piece{whole.of, {}};
    for (int i = 0; i < 3; ++i) {
      const int vertex = bisected.mesh.cells[c][i];
      for (int k = 0; k < 3; ++k) {
        const auto& [from, to] = Simplex<2>::edges[k];
        if (vertices[k] == vertex) piece.corner[i] = whole.corner[k];
        if (bisected.midpoint[old.mesh.cell_edges[parent][k]] == vertex)
          piece.corner[i] = halfway(whole.corner[from], whole.corner[to]);
      }
    }
    pieces.push_back(piece);
  }
  return pieces;
}

/// The pieces of the first mesh's facets that the children are.
std::vector<Piece<1>> pieces_of_facets(const Problem<2>& old, const Bisected& bisected) {
  std::vector<Piece<1>> pieces;
  pieces.reserve(bisected.mesh.boundary.size());
  for (std::size_t f = 0; f < bisected.mesh.boundary.size(); ++f) {
    const int parent = bisected.facet_parent[f];
    const auto& vertices = old.mesh.boundary[parent].vertices;
    Piece<1> piece = piece_of_facet(old, parent);
    const auto middle = [&] { return halfway(piece.corner[0], piece.corner[1]); };
    if (bisected.mesh.boundary[f].vertices[0] != vertices[0])
      piece.corner[0] = middle();
    else if (bisected.mesh.boundary[f].vertices[1] != vertices[1])
      piece.corner[1] = middle();
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
  if (degree_of_load(given) == 1) return data;
  const double from = piece.corner[0][0], to = piece.corner[1][0];
  const auto traction = on_stretch<double>(EdgeCubic<Vector<2>>{given.traction, given.higher_traction}, from, to);
  const auto pressure = on_stretch<double>(EdgeCubic<double>{given.pressure, given.higher_pressure}, from, to);
  data.traction = traction.linear;
  data.higher_traction = traction.higher;
  data.pressure = pressure.linear;
  data.higher_pressure = pressure.higher;
  return data;
}

}  // namespace

template <int dim> Refined<dim> refine(const Problem<dim>& problem, const std::vector<char>& marked) {
  static_assert(dim == 2);
  assert(marked.size() == problem.mesh.cells.size());
  Bisected bisected = bisect(problem.mesh, bisected_edges(problem, marked));
  Refined<dim> refined;
  Problem<dim>& finer = refined.problem;
  finer.bodies = problem.bodies;
  finer.sampled = problem.sampled;
  finer.oscillation = problem.oscillation;
  finer.length_scale = problem.length_scale;
  finer.corrections = problem.corrections;
  finer.carries = problem.carries;
  finer.imbalance = problem.imbalance;
  finer.origin.first = problem.origin.first ? problem.origin.first : std::make_shared<const Problem<dim>>(problem);
  finer.origin.cells = pieces_of_cells(problem, bisected);
  finer.origin.facets = pieces_of_facets(problem, bisected);
  for (const Piece<dim - 1>& piece : finer.origin.facets)
    finer.facets.push_back(on_piece(finer.origin.first->facets[piece.of], piece));

  std::vector<int> first_child(problem.facets.size());
  for (std::size_t f = bisected.facet_parent.size(); f-- > 0;)
    first_child[bisected.facet_parent[f]] = static_cast<int>(f);
  const std::vector<int> contact_of_facet = contacts_by_first(*finer.origin.first);
  for (std::size_t i = 0; i < problem.contact.size(); ++i) {
    const int first = problem.contact[i].first, second = problem.contact[i].second;
    const auto add = [&](int one, int other) {
      const Piece<dim - 1>& piece = finer.origin.facets[one];
      finer.contact.push_back(on_piece(*finer.origin.first, contact_of_facet[piece.of], one, other, piece));
      refined.contact_parent.push_back(static_cast<int>(i));
    };
    const int one = first_child[first], other = second == -1 ? -1 : first_child[second];
    if (bisected.midpoint[problem.mesh.boundary[first].edge] == -1) {
      add(one, other);
    } else {  // the second facet runs the other way
      add(one, other == -1 ? -1 : other + 1);
      add(one + 1, other);
    }
  }
  finer.mesh = std::move(bisected.mesh);
  refined.cell_parent = std::move(bisected.cell_parent);
  return refined;
}

template <int dim>
Mesh<dim> finer_mesh(const Scene<dim>& scene, const Problem<dim>& problem, const std::vector<char>& marked) {
  static_assert(dim == 2);
  const std::size_t old = problem.mesh.vertices.size();
  Mesh<dim> finer = bisect(problem.mesh, bisected_edges(problem, marked)).mesh;
  return with_new_vertices_on_arcs(std::move(finer), arcs_of(scene, problem.mesh), old);
}

template Mesh<2> finer_mesh(const Scene<2>&, const Problem<2>&, const std::vector<char>&);
template Refined<2> refine(const Problem<2>&, const std::vector<char>&);

}  // namespace bracket::scene
