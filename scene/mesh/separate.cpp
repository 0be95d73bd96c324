// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <map>
#include <numeric>
#include <set>

#include "scene/mesh/raw_mesh.h"

namespace bracket::scene {

namespace {

/// A cell at a vertex, and which of its vertices it is.
struct Corner {
  int cell;
  int local;
};

/// Corners at one vertex that hang together through facets that are not cut.
template <int dim>
std::vector<std::vector<Corner>> fans(const Mesh<dim>& mesh, const std::vector<Corner>& corners,
                                      const std::vector<char>& is_cut) {
  const int count = static_cast<int>(corners.size());
  std::vector<int> ranks(count), parents(count);
  std::iota(parents.begin(), parents.end(), 0);
  boost::disjoint_sets<int*, int*> together(ranks.data(), parents.data());
  std::map<int, int> first;  // corner at each facet
  for (int i = 0; i < count; ++i) {
    for (int turn = 1; turn <= dim; ++turn) {  // the facets at the vertex are those opposite to the others
      const int facet = cell_facets(mesh, corners[i].cell)[(corners[i].local + turn) % (dim + 1)];
      if (is_cut[facet]) continue;
      const auto [known, fresh] = first.emplace(facet, i);
      if (!fresh) together.union_set(known->second, i);
    }
  }
  std::map<int, std::vector<Corner>> sets;
  for (int i = 0; i < count; ++i) sets[together.find_set(i)].push_back(corners[i]);
  std::vector<std::vector<Corner>> result;
  for (auto& [representative, set] : sets) result.push_back(std::move(set));
  return result;
}

/// Whether fans have no body in common: what touches by a point only does not hang together. Of one body it would be a
/// fault of the mesh, which is told later on.
template <int dim> bool of_different_bodies(const Mesh<dim>& mesh, const std::vector<std::vector<Corner>>& sets) {
  std::set<int> known;
  for (const auto& corners : sets) {
    std::set<int> bodies;
    for (const Corner& corner : corners) bodies.insert(mesh.cell_body[corner.cell]);
    for (const int body : bodies)
      if (!known.insert(body).second) return false;
  }
  return true;
}

}  // namespace

template <int dim> bool separate(Mesh<dim>& mesh, const std::vector<int>& cut) {
  std::vector<char> is_cut(n_facets(mesh), 0), at_cut(mesh.vertices.size(), 0);
  for (const int facet : cut) is_cut[facet] = 1;
  for (std::size_t cell = 0; cell < mesh.cells.size() && !cut.empty(); ++cell)
    for (int local = 0; local <= dim; ++local)
      if (is_cut[cell_facets(mesh, static_cast<int>(cell))[local]])
        for (const int vertex : facet_vertices(mesh, static_cast<int>(cell), local)) at_cut[vertex] = 1;
  std::vector<int> body(mesh.vertices.size(), -1);
  std::vector<char> looked_at = at_cut;  // and vertices that bodies share
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    for (const int vertex : mesh.cells[cell]) {
      if (body[vertex] != -1 && body[vertex] != mesh.cell_body[cell]) looked_at[vertex] = 1;
      body[vertex] = mesh.cell_body[cell];
    }
  }
  std::map<int, std::vector<Corner>> corners;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    for (int local = 0; local <= dim; ++local)
      if (looked_at[mesh.cells[cell][local]])
        corners[mesh.cells[cell][local]].push_back({static_cast<int>(cell), local});

  bool separated = false;
  for (const auto& [vertex, at] : corners) {
    const auto sets = fans(mesh, at, is_cut);
    if (!at_cut[vertex] && !of_different_bodies(mesh, sets)) continue;
    for (std::size_t i = 1; i < sets.size(); ++i) {
      separated = true;
      for (const auto& [cell, local] : sets[i]) mesh.cells[cell][local] = static_cast<int>(mesh.vertices.size());
      mesh.vertices.push_back(mesh.vertices[vertex]);
    }
  }
  return separated;
}

template bool separate(Mesh<2>&, const std::vector<int>&);
template bool separate(Mesh<3>&, const std::vector<int>&);

}  // namespace bracket::scene
