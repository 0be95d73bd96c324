// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cassert>

#include "contact/contact.h"
#include "contact/large_pages.h"

namespace bracket::contact {
namespace {

/// For each node, in increasing order, itself and the neighbours that come after it.
struct LowerGraph {
  std::vector<int> begin;
  std::vector<int> neighbours;
};

LowerGraph lower_graph(int n_nodes, std::span<const int> cell_nodes, int nodes_per_cell) {
  std::vector<int> first(n_nodes + 1, 0);  // cells around a node, one node after the other
  for (int node : cell_nodes) ++first[node + 1];
  for (int v = 0; v < n_nodes; ++v) first[v + 1] += first[v];
  std::vector<int> around(cell_nodes.size());
  std::vector<int> fill(first.begin(), first.end() - 1);
  for (std::size_t k = 0; k < cell_nodes.size(); ++k)
    around[fill[cell_nodes[k]]++] = static_cast<int>(k) / nodes_per_cell;

  LowerGraph graph;
  graph.begin.reserve(n_nodes + 1);
  graph.begin.push_back(0);
  for (int v = 0; v < n_nodes; ++v) {
    const std::size_t start = graph.neighbours.size();
    graph.neighbours.push_back(v);
    for (int k = first[v]; k < first[v + 1]; ++k)
      for (int node : cell_nodes.subspan(static_cast<std::size_t>(around[k]) * nodes_per_cell, nodes_per_cell))
        if (node > v) graph.neighbours.push_back(node);
    const auto from = graph.neighbours.begin() + static_cast<std::ptrdiff_t>(start);
    std::sort(from, graph.neighbours.end());
    graph.neighbours.erase(std::unique(from, graph.neighbours.end()), graph.neighbours.end());
    graph.begin.push_back(static_cast<int>(graph.neighbours.size()));
  }
  return graph;
}

}  // namespace

Assembly::Assembly(std::vector<int> nodes, std::span<const int> cell_nodes, int nodes_per_cell) {
  assert(!nodes.empty() && nodes.front() == 0);
  const int n_nodes = static_cast<int>(nodes.size()) - 1;
  const LowerGraph graph = lower_graph(n_nodes, cell_nodes, nodes_per_cell);

  const int n = nodes.back();
  std::vector<int> first(n + 1, 0);
  for (int v = 0; v < n_nodes; ++v) {
    int size = 0;
    for (int k = graph.begin[v]; k < graph.begin[v + 1]; ++k)
      size += nodes[graph.neighbours[k] + 1] - nodes[graph.neighbours[k]];
    for (int column = nodes[v]; column < nodes[v + 1]; ++column) first[column + 1] = first[column] + size--;
  }
  matrix_.resize(n, n);
  matrix_.resizeNonZeros(first.back());
  use_large_pages(matrix_.valuePtr(), first.back());
  use_large_pages(matrix_.innerIndexPtr(), first.back());
  std::copy(first.begin(), first.end(), matrix_.outerIndexPtr());
  for (int v = 0; v < n_nodes; ++v)
    for (int column = nodes[v]; column < nodes[v + 1]; ++column) {
      int* row = matrix_.innerIndexPtr() + first[column];
      for (int k = graph.begin[v]; k < graph.begin[v + 1]; ++k) {
        const int node = graph.neighbours[k];
        for (int i = std::max(nodes[node], column); i < nodes[node + 1]; ++i) *row++ = i;
      }
    }
  matrix_.coeffs().setZero();
}

void Assembly::add(std::span<const int> unknowns, const Eigen::Ref<const Eigen::MatrixXd>& cell) {
  assert(cell.rows() == cell.cols() && cell.rows() == static_cast<Eigen::Index>(unknowns.size()));
  const int size = static_cast<int>(unknowns.size());
  for (int j = 0; j < size; ++j) {
    const int column = unknowns[j];
    if (column < 0) continue;
    const int* const begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column];
    const int* const end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column + 1];
    const int* place = begin;
    for (int i = 0; i < size; ++i) {
      if (unknowns[i] < column) continue;
      // The unknowns of a node follow each other: mostly the next entry is the one.
      if (++place >= end || *place != unknowns[i]) place = std::lower_bound(begin, end, unknowns[i]);
      assert(place != end && *place == unknowns[i]);
      matrix_.valuePtr()[place - matrix_.innerIndexPtr()] += cell(i, j);
    }
  }
}

Eigen::SparseMatrix<double> Assembly::take() {
  Eigen::SparseMatrix<double> sum;
  sum.swap(matrix_);
  return sum;
}

}  // namespace bracket::contact
