// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <tuple>

#include "contact/contact.h"

namespace bracket::contact {
namespace {

/// The smallest part of a dissection that has all cells around a node.
struct Part {
  std::uint64_t last = 0;  ///< the largest path that may lead into it
  int depth = 0;           ///< 64: a single cell
};

Part smallest_part(std::uint64_t first, std::uint64_t last) {
  if (first == last) return {last, 64};
  const int depth = std::countl_zero(first ^ last);
  return {last | (std::numeric_limits<std::uint64_t>::max() >> depth), depth};
}

}  // namespace

std::vector<int> elimination(std::span<const std::uint64_t> cell_paths, std::span<const int> cell_nodes, int n_nodes) {
  const std::size_t nodes_per_cell = cell_paths.empty() ? 0 : cell_nodes.size() / cell_paths.size();
  std::vector<std::uint64_t> first(n_nodes, std::numeric_limits<std::uint64_t>::max()), last(n_nodes, 0);
  for (std::size_t k = 0; k < cell_nodes.size(); ++k) {
    const int node = cell_nodes[k];
    first[node] = std::min(first[node], cell_paths[k / nodes_per_cell]);
    last[node] = std::max(last[node], cell_paths[k / nodes_per_cell]);
  }
  std::vector<Part> part(n_nodes);
  for (int v = 0; v < n_nodes; ++v) part[v] = smallest_part(first[v], last[v]);
  std::vector<int> result(n_nodes);
  std::iota(result.begin(), result.end(), 0);
  // Parts one after the other, each after those that it is divided into.
  std::sort(result.begin(), result.end(), [&](int a, int b) {
    return std::tuple(part[a].last, -part[a].depth, a) < std::tuple(part[b].last, -part[b].depth, b);
  });
  return result;
}

}  // namespace bracket::contact
