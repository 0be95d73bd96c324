// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/mesh/dissection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "scene/mesh/topology.h"
#include "tests/support/scenes.h"

namespace bracket::scene {
namespace {

using Paths = std::vector<std::uint64_t>;

Mesh<2> squares(int nx, int ny) {
  Scene<2> scene;
  scene.blocks = {tests::block("a", 0, nx, 0, ny, nx, ny)};
  scene.bodies = {{"a", isotropic<2>(1, 0.3, Plane::strain)}};
  return build_mesh(scene);
}

/// A fan of triangles around one point, each smaller than the one before.
Mesh<2> fan(int n_cells) {
  Mesh<2> mesh;
  mesh.vertices = {{0, 0}};
  double size = 1;
  for (int i = 0; i <= n_cells; ++i, size /= 1.2) {
    const double angle = 6.0 * i / n_cells;
    mesh.vertices.push_back(size * Vector<2>(std::cos(angle), std::sin(angle)));
    if (i > 0) mesh.cells.push_back({0, i, i + 1});
  }
  mesh.cell_body.assign(mesh.cells.size(), 0);
  mesh.bodies = {"a"};
  return with_topology(std::move(mesh), {}, "fan");
}

/// Refined `times` at the vertex nearest to the origin.
Mesh<2> graded(int times) {
  Scene<2> scene = tests::two_blocks(4);
  Problem<2> problem = fix_data(scene, build_mesh(scene));
  for (int k = 0; k < times; ++k) {
    const auto& mesh = problem.mesh;
    std::vector<char> marked(mesh.cells.size(), 0);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      for (const int v : mesh.cells[c])
        if (mesh.vertices[v].isZero(0)) marked[c] = 1;
    problem = refine(problem, marked).problem;
  }
  return problem.mesh;
}

std::vector<Mesh<2>> meshes() { return {squares(1, 1), squares(7, 1), squares(8, 8), fan(1), fan(40), graded(30)}; }

/// Each part of more than one cell has two parts, neither with less than a quarter of its cells.
void expect_halves(Paths paths, int depth) {
  if (paths.size() < 2) return;
  ASSERT_LT(depth, 64);
  const auto second =
      std::partition(paths.begin(), paths.end(), [&](std::uint64_t path) { return !(path >> (63 - depth) & 1); });
  const Paths first(paths.begin(), second), rest(second, paths.end());
  EXPECT_GE(4 * std::min(first.size(), rest.size()), paths.size());
  expect_halves(first, depth + 1);
  expect_halves(rest, depth + 1);
}

TEST(Dissection, HalvesEachComponentDownToSingleCells) {
  for (const auto& mesh : meshes()) {
    const Paths paths = dissect(mesh);
    ASSERT_EQ(paths.size(), mesh.cells.size());
    std::map<int, Paths> of_component;
    for (std::size_t c = 0; c < paths.size(); ++c) of_component[mesh.cell_component[c]].push_back(paths[c]);
    for (const auto& [component, own] : of_component) expect_halves(own, 0);
  }
}

TEST(Dissection, RepeatsItself) {
  for (const auto& mesh : meshes()) EXPECT_EQ(dissect(mesh), dissect(mesh));
}

// It looks at facets, and at coordinates only for what comes before what.
TEST(Dissection, OfCellsThatAllLieOnEachOther) {
  Mesh<2> mesh = squares(5, 4);
  for (auto& x : mesh.vertices) x = {3, 3};
  expect_halves(dissect(mesh), 0);
}

/// The facets that the first cut goes through.
int first_cut(const Mesh<2>& mesh, const Paths& paths) {
  std::vector<int> sides(mesh.edges.size(), 0);
  for (std::size_t c = 0; c < paths.size(); ++c)
    for (const int e : mesh.cell_edges[c]) sides[e] |= paths[c] >> 63 ? 1 : 2;
  return static_cast<int>(std::count(sides.begin(), sides.end(), 3));
}

// A strip of n × m squares has a straight cut of m facets in the middle; with a crack along a line of its mesh, one of
// as many fewer as the crack has, for its two sides are no neighbours though they lie on each other.
TEST(Dissection, CutsFewFacets) {
  const Mesh<2> strip = squares(40, 4);
  EXPECT_EQ(first_cut(strip, dissect(strip)), 4);

  Mesh<2> cracked = squares(16, 8);
  const auto copy = [&](int vertex) {
    cracked.vertices.push_back(Vector<2>(cracked.vertices[vertex]));
    return static_cast<int>(cracked.vertices.size()) - 1;
  };
  std::map<int, int> other_side;  // from the bottom up to the middle of x = 8
  for (int v = 0, n = static_cast<int>(cracked.vertices.size()); v < n; ++v)
    if (cracked.vertices[v][0] == 8 && cracked.vertices[v][1] < 4) other_side[v] = copy(v);
  for (auto& cell : cracked.cells) {
    const bool right = std::all_of(cell.begin(), cell.end(), [&](int v) { return cracked.vertices[v][0] >= 8; });
    for (int& v : cell)
      if (const auto found = other_side.find(v); right && found != other_side.end()) v = found->second;
  }
  Mesh<2> mesh;
  std::tie(mesh.vertices, mesh.cells, mesh.cell_body, mesh.bodies) =
      std::tie(cracked.vertices, cracked.cells, cracked.cell_body, cracked.bodies);
  mesh = with_topology(std::move(mesh), {}, "cracked");
  EXPECT_EQ(first_cut(mesh, dissect(mesh)), 4);
}

}  // namespace
}  // namespace bracket::scene
