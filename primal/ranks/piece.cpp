// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "primal/ranks/piece.h"

#include <metis.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

namespace bracket::primal {

namespace {

/// The pairs of cells that share a facet or lie on the two sides of a contact.
std::vector<std::array<int, 2>> neighbours(const scene::Problem<3>& problem) {
  const auto& mesh = problem.mesh;
  std::vector<std::array<int, 2>> result;
  std::vector<int> first(scene::n_facets(mesh), -1);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const int f : scene::cell_facets(mesh, static_cast<int>(c))) {
      if (first[f] >= 0) result.push_back({first[f], static_cast<int>(c)});
      first[f] = static_cast<int>(c);
    }
  for (const auto& pair : problem.contact)
    if (pair.second >= 0) result.push_back({mesh.boundary[pair.first].cell, mesh.boundary[pair.second].cell});
  std::erase_if(result, [](const auto& pair) { return pair[0] == pair[1]; });
  return result;
}

/// The process of each cell.
std::vector<idx_t> parts(const scene::Problem<3>& problem, int processes) {
  auto n = static_cast<idx_t>(problem.mesh.cells.size());
  std::vector<idx_t> part(n, 0);
  if (processes == 1) return part;
  const auto pairs = neighbours(problem);
  std::vector<idx_t> begin(n + 1, 0);
  for (const auto& pair : pairs)
    for (const int c : pair) ++begin[c + 1];
  for (idx_t c = 0; c < n; ++c) begin[c + 1] += begin[c];
  std::vector<idx_t> next(begin.begin(), begin.end() - 1), beside(begin.back());
  for (const auto& [a, b] : pairs) {
    beside[next[a]++] = b;
    beside[next[b]++] = a;
  }
  idx_t constraints = 1, wanted = processes, cut_edges = 0;
  if (METIS_PartGraphKway(&n, &constraints, begin.data(), beside.data(), nullptr, nullptr, nullptr, &wanted, nullptr,
                          nullptr, nullptr, &cut_edges, part.data()) != METIS_OK)
    throw std::runtime_error("METIS cannot cut the mesh");
  return part;
}

}  // namespace

void make_distinct(std::vector<int>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

Pieces cut(const scene::Problem<3>& problem, const Nodes<3>& nodes, const std::vector<std::vector<int>>& linked,
           int processes) {
  const auto& mesh = problem.mesh;
  const std::vector<idx_t> part = parts(problem, processes);
  // A node belongs to the first process that has a cell of it; a process numbers its own in the order of its cells.
  std::vector<int> owner(nodes.node.size(), processes);
  std::vector<std::vector<int>> cells(processes);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) cells[part[c]].push_back(static_cast<int>(c));
  Pieces pieces;
  pieces.of.resize(processes);
  pieces.at.resize(processes);
  pieces.number.assign(nodes.node.size(), -1);
  int numbered = 0;
  for (int p = 0; p < processes; ++p) {
    pieces.of[p].degree = nodes.degree;
    pieces.of[p].first = numbered;
    for (const int c : cells[p])
      for (const int i : cell_nodes(mesh, nodes, c))
        if (owner[i] == processes) {
          owner[i] = p;
          pieces.number[i] = numbered++;
        }
    pieces.of[p].end = numbered;
  }
  std::map<int, std::vector<int>> with;
  for (const auto& group : linked)
    for (const int i : group) with[i].insert(with[i].end(), group.begin(), group.end());
  std::vector<int> last(processes, -1);  // cell that a process has been given
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const std::vector<int> list = cell_nodes(mesh, nodes, static_cast<int>(c));
    const auto give = [&](int p) {
      if (last[p] == static_cast<int>(c)) return;
      last[p] = static_cast<int>(c);
      Piece& piece = pieces.of[p];
      piece.cell_body.push_back(mesh.cell_body[c]);
      for (const int i : list) {
        piece.cell_nodes.push_back(pieces.number[i]);
        pieces.at[p].push_back(i);
      }
      for (const int v : mesh.cells[c]) piece.corners.push_back(mesh.vertices[v]);
    };
    for (const int i : list) {
      give(owner[i]);
      if (const auto found = with.find(i); found != with.end())
        for (const int j : found->second) give(owner[j]);
    }
  }
  for (int p = 0; p < processes; ++p) {
    pieces.of[p].n_nodes = numbered;
    make_distinct(pieces.at[p]);
  }
  return pieces;
}

}  // namespace bracket::primal
