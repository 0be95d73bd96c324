// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "contact/contact.h"
#include "scene/mesh/dissection.h"
#include "tests/support/scenes.h"

namespace bracket::contact {
namespace {

using Paths = std::vector<std::uint64_t>;

struct Cells {
  Paths paths;
  std::vector<int> nodes;
  int nodes_per_cell, n_nodes;
};

/// The columns of L (without the diagonal) of a matrix in which the nodes of a cell are coupled, eliminated in turn.
std::vector<std::set<int>> factor(const Cells& cells, const std::vector<int>& sequence) {
  std::vector<int> place(cells.n_nodes);
  for (int k = 0; k < cells.n_nodes; ++k) place[sequence[k]] = k;
  std::vector<std::set<int>> columns(cells.n_nodes);
  const auto per_cell = static_cast<std::size_t>(cells.nodes_per_cell);
  for (std::size_t k = 0; k < cells.nodes.size(); ++k)
    for (std::size_t l = k - k % per_cell; l < k - k % per_cell + per_cell; ++l)
      if (const int row = place[cells.nodes[l]], column = place[cells.nodes[k]]; row > column)
        columns[column].insert(row);
  for (auto& column : columns)
    if (!column.empty())  // to the parent in the elimination tree
      columns[*column.begin()].insert(std::next(column.begin()), column.end());
  return columns;
}

/// Random ways to cells, each a part of its own; cells of random nodes, most of them near each other.
Cells random_cells(int n_cells, int nodes_per_cell, std::mt19937& random) {
  Cells cells{{}, {}, nodes_per_cell, n_cells + 10};
  const auto divide = [&](const auto& self, int size, std::uint64_t path, int depth) -> void {
    if (size == 1) return cells.paths.push_back(path);
    const int first = 1 + static_cast<int>(random() % (size - 1));
    self(self, first, path, depth + 1);
    self(self, size - first, path | std::uint64_t{1} << (63 - depth), depth + 1);
  };
  if (n_cells > 0) divide(divide, n_cells, 0, 0);
  std::vector<int> near(10);
  std::iota(near.begin(), near.end(), 0);
  for (int c = 0; c < n_cells; ++c) {
    std::shuffle(near.begin(), near.end(), random);
    for (int k = 0; k < nodes_per_cell; ++k) cells.nodes.push_back(c + near[k]);
  }
  return cells;
}

/// How many leading bits numbers have in common.
int common_bits(const Paths& numbers) {
  int common = 64;
  for (const auto number : numbers) common = std::min(common, std::countl_zero(number ^ numbers.front()));
  return common;
}

/// Of two nodes, one with all its cells in a part and the other with all in the part beside it, L has no entry; one
/// with cells in both comes after them.
void expect_separated(const Cells& cells, const std::vector<int>& sequence) {
  const auto columns = factor(cells, sequence);
  std::vector<Paths> around(cells.n_nodes);
  for (std::size_t k = 0; k < cells.nodes.size(); ++k)
    around[cells.nodes[k]].push_back(cells.paths[k / cells.nodes_per_cell]);
  for (int a = 0; a < cells.n_nodes; ++a)
    for (int b = a + 1; b < cells.n_nodes; ++b) {
      const Paths &earlier = around[sequence[a]], &later = around[sequence[b]];
      if (earlier.empty() || later.empty()) continue;
      const int shared = common_bits({earlier.front(), later.front()});
      EXPECT_FALSE(shared >= common_bits(earlier) && common_bits(later) > common_bits(earlier));
      if (shared < common_bits(earlier) && shared < common_bits(later)) {
        EXPECT_EQ(columns[a].count(b), 0u);
      }
    }
}

TEST(Elimination, SeparatesThePartsOfADissection) {
  std::mt19937 random(1);
  for (const int n_cells : {0, 1, 2, 3, 20, 100})
    for (const int nodes_per_cell : {1, 2, 3, 6}) {
      const Cells cells = random_cells(n_cells, nodes_per_cell, random);
      std::vector<int> sequence = elimination(cells.paths, cells.nodes, cells.n_nodes);
      expect_separated(cells, sequence);
      EXPECT_EQ(elimination(cells.paths, cells.nodes, cells.n_nodes), sequence);
      std::sort(sequence.begin(), sequence.end());
      for (int v = 0; v < cells.n_nodes; ++v) EXPECT_EQ(sequence[v], v);
    }
}

/// Entries of L on a square of n × n vertices, which are its nodes.
std::size_t fill(int n) {
  scene::Scene<2> s;
  s.blocks = {tests::block("a", 0, 1, 0, 1, n - 1, n - 1)};
  s.bodies = {{"a", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
  const scene::Mesh<2> mesh = scene::build_mesh(s);
  Cells cells{scene::dissect(mesh), {}, 3, n * n};
  for (const auto& cell : mesh.cells) cells.nodes.insert(cells.nodes.end(), cell.begin(), cell.end());
  std::size_t entries = 0;
  for (const auto& column : factor(cells, elimination(cells.paths, cells.nodes, n * n))) entries += 1 + column.size();
  return entries;
}

// George (SIAM J. Numer. Anal. 10, 1973): 31/4 n² log₂ n + O(n²) by the dissection made for a square in which vertices
// are coupled across both diagonals.
TEST(Elimination, FillsSquaresNoMoreThanTheirOwnDissection) {
  for (const int n : {9, 17, 33, 65}) EXPECT_LE(static_cast<double>(fill(n)), 31.0 / 4 * n * n * std::log2(n)) << n;
}

}  // namespace
}  // namespace bracket::contact
