// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: what the children of cells and facets inherit.
#include "scene/problem/refine.h"

#include <algorithm>
#include <cassert>
#include <map>

#include "scene/mesh/space/bisection.h"
#include "scene/problem/space/face_gap.h"

namespace bracket::scene {

namespace {

/// The first mesh's data on a piece of one of its facets, rounded.
FacetData<3> data_on(FacetData<3> data, const Piece<2>& piece) {
  const FacetData<3> given = data;
  const double share = share_of_face(piece.corner);
  for (int i = 0; i < 3; ++i) {
    const OnFace& at = piece.corner[i];
    data.traction[i] = linear_at(given.traction, at);
    data.pressure[i] = linear_at(given.pressure, at);
    data.correction[i] = share * linear_at(given.correction, at);
    data.displacement[i] = linear_at(given.displacement, at);
    data.normal_displacement[i] = linear_at(given.normal_displacement, at);
  }
  return data;
}

/// The children of each facet of the old mesh.
std::vector<std::vector<int>> children_of(const BisectedCells& bisected, std::size_t n_facets) {
  std::vector<std::vector<int>> children(n_facets);
  for (std::size_t f = 0; f < bisected.facet_parent.size(); ++f)
    children[bisected.facet_parent[f]].push_back(static_cast<int>(f));
  return children;
}

std::array<int, 3> glued_vertices_of(const BisectedCells& bisected, int facet) {
  std::array<int, 3> vertices = bisected.mesh.boundary[facet].vertices;
  for (int& vertex : vertices) vertex = bisected.glued[vertex];
  return vertices;
}

std::array<int, 3> rising(std::array<int, 3> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

/// Which vertex of the second facet lies on each of the first.
std::array<int, 3> meeting(const BisectedCells& bisected, int first, int second) {
  const auto one = glued_vertices_of(bisected, first), other = glued_vertices_of(bisected, second);
  std::array<int, 3> meets;
  for (int i = 0; i < 3; ++i) {
    meets[i] = static_cast<int>(std::find(other.begin(), other.end(), one[i]) - other.begin());
    assert(meets[i] < 3 && bisected.mesh.vertices[bisected.mesh.boundary[first].vertices[i]] ==
                               bisected.mesh.vertices[bisected.mesh.boundary[second].vertices[meets[i]]]);
  }
  return meets;
}

}  // namespace

template <> Refined<3> refine(const Problem<3>& problem, const std::vector<char>& marked) {
  BisectedCells bisected = bisect(problem, marked);
  Refined<3> refined;
  Problem<3>& finer = refined.problem;
  finer.bodies = problem.bodies;
  finer.sampled = problem.sampled;
  finer.oscillation = problem.oscillation;
  finer.length_scale = problem.length_scale;
  finer.corrections = problem.corrections;
  finer.carries = problem.carries;
  finer.imbalance = problem.imbalance;
  finer.origin.first = problem.origin.first ? problem.origin.first : std::make_shared<const Problem<3>>(problem);
  finer.origin.cells = std::move(bisected.cells);
  finer.origin.facets = std::move(bisected.facets);
  for (const Piece<2>& piece : finer.origin.facets)
    finer.facets.push_back(data_on(finer.origin.first->facets[piece.of], piece));

  const auto children = children_of(bisected, problem.facets.size());
  const std::vector<int> contact_of_facet = contacts_by_first(*finer.origin.first);
  for (std::size_t i = 0; i < problem.contact.size(); ++i) {
    const int first = problem.contact[i].first, second = problem.contact[i].second;
    std::map<std::array<int, 3>, int> across;
    if (second != -1)
      for (const int child : children[second]) across[rising(glued_vertices_of(bisected, child))] = child;
    for (const int one : children[first]) {
      const int other = second == -1 ? -1 : across.at(rising(glued_vertices_of(bisected, one)));
      const Piece<2>& piece = finer.origin.facets[one];
      finer.contact.push_back(on_piece(*finer.origin.first, contact_of_facet[piece.of], one, other, piece));
      if (other != -1) finer.contact.back().meets = meeting(bisected, one, other);
      refined.contact_parent.push_back(static_cast<int>(i));
    }
  }
  finer.mesh = std::move(bisected.mesh);
  refined.cell_parent = std::move(bisected.cell_parent);
  return refined;
}

template <> Mesh<3> finer_mesh(const Scene<3>&, const Problem<3>& problem, const std::vector<char>& marked) {
  std::vector<char> below = marked;
  Problem<3> finer = problem;
  for (int times = 0; times < 3; ++times) {
    Refined<3> refined = refine(finer, below);
    std::vector<char> children;
    for (const int parent : refined.cell_parent) children.push_back(below[parent]);
    below = std::move(children);
    finer = std::move(refined.problem);
  }
  return std::move(finer.mesh);
}

}  // namespace bracket::scene
