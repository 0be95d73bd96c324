// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/order.h"

#include <cholmod.h>
#include <signal.h>

#include <mutex>
#include <new>
#include <numeric>

namespace bracket::contact {
namespace {

/// The graph (lower triangle, no diagonal) of the nodes that keep an unknown before the last ones.
struct NodeGraph {
  std::vector<int> node;  ///< which node each vertex of the graph is
  std::vector<int> begin;
  std::vector<int> neighbours;
};

NodeGraph node_graph(const Eigen::SparseMatrix<double>& stiffness, const std::vector<int>& nodes,
                     const std::vector<char>& is_last) {
  const int n_nodes = static_cast<int>(nodes.size()) - 1;
  NodeGraph graph;
  std::vector<int> speaker(n_nodes, -1);  // the first unknown of a node that is not last speaks for the node
  std::vector<int> vertex(stiffness.rows(), -1);
  for (int v = 0; v < n_nodes; ++v)
    for (int i = nodes[v]; i < nodes[v + 1]; ++i) {
      if (is_last[i]) continue;
      if (speaker[v] < 0) {
        speaker[v] = i;
        vertex[i] = static_cast<int>(graph.node.size());
        graph.node.push_back(v);
      }
    }
  graph.begin.push_back(0);
  for (int v : graph.node) {
    const int column = speaker[v];
    for (Eigen::SparseMatrix<double>::InnerIterator entry(stiffness, column); entry; ++entry)
      if (entry.row() > column && vertex[entry.row()] >= 0) graph.neighbours.push_back(vertex[entry.row()]);
    graph.begin.push_back(static_cast<int>(graph.neighbours.size()));
  }
  return graph;
}

/// Keeps a signal's handler, with its flags and mask, from METIS, which sets its own by signal().
class KeptHandler {
 public:
  explicit KeptHandler(int signal) : signal_(signal) { sigaction(signal, nullptr, &action_); }
  ~KeptHandler() { sigaction(signal_, &action_, nullptr); }
  KeptHandler(const KeptHandler&) = delete;
  KeptHandler& operator=(const KeptHandler&) = delete;

 private:
  int signal_;
  struct sigaction action_;
};
/// Where the memory does not suffice for METIS, CHOLMOD returns what is no permutation, as if all were well.
bool is_permutation(const std::vector<int>& order) {
  std::vector<char> found(order.size(), 0);
  for (const int i : order) {
    if (i < 0 || i >= static_cast<int>(order.size()) || found[i]) return false;
    found[i] = 1;
  }
  return true;
}

std::vector<int> dissect(NodeGraph& graph) {
  const std::size_t n = graph.node.size();
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  if (graph.neighbours.empty()) return order;
  cholmod_sparse pattern{};
  pattern.nrow = pattern.ncol = n;
  pattern.nzmax = graph.neighbours.size();
  pattern.p = graph.begin.data();
  pattern.i = graph.neighbours.data();
  pattern.stype = -1;
  pattern.itype = CHOLMOD_INT;
  pattern.xtype = CHOLMOD_PATTERN;
  pattern.dtype = CHOLMOD_DOUBLE;
  pattern.sorted = pattern.packed = 1;
  cholmod_common common;
  cholmod_start(&common);
  common.print = 0;
  const bool small = n < 500;  // minimum degree is faster there, and as good
  // METIS draws from rand() and sets signal handlers, both of the whole process: two dissections at once would not
  // repeat from run to run.
  static std::mutex metis;
  const std::lock_guard<std::mutex> lock(metis);
  const KeptHandler abort(SIGABRT), terminate(SIGTERM);
  const int done = small ? cholmod_amd(&pattern, nullptr, 0, order.data(), &common)
                         : cholmod_metis(&pattern, nullptr, 0, 0, order.data(), &common);
  cholmod_finish(&common);
  if (!done || !is_permutation(order)) throw std::bad_alloc();
  return order;
}

}  // namespace

std::vector<int> order(const Eigen::SparseMatrix<double>& stiffness, const std::vector<int>& nodes,
                       const std::vector<int>& last) {
  std::vector<char> is_last(stiffness.rows(), 0);
  for (int i : last) is_last[i] = 1;
  NodeGraph graph = node_graph(stiffness, nodes, is_last);
  std::vector<int> result;
  result.reserve(stiffness.rows());
  for (int vertex : dissect(graph)) {
    const int node = graph.node[vertex];
    for (int i = nodes[node]; i < nodes[node + 1]; ++i)
      if (!is_last[i]) result.push_back(i);
  }
  result.insert(result.end(), last.begin(), last.end());
  return result;
}

}  // namespace bracket::contact
