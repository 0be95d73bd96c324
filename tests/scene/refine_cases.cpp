// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scene/refine_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "scene/mesh/topology.h"
#include "tests/scene/inputs.h"

namespace bracket::scene::test {

double linear(const Vector<2>& x) { return 0.3 + 0.5 * x[0] - 0.7 * x[1]; }
double other_linear(const Vector<2>& x) { return -0.2 + 0.9 * x[0] + 0.4 * x[1]; }
double quadratic(const Vector<2>& x) { return 0.1 + 0.2 * x[0] - 0.3 * x[1] + 0.5 * x[0] * x[0] - 0.4 * x[0] * x[1]; }

namespace {

Scene<2> three_blocks_scene() {
  Scene<2> scene;
  scene.blocks = {{"a", {{{0, 2}, {0, 1}}}, {4, 3}, ""},
                  {"b", {{{0, 2}, {1, 2}}}, {4, 2}, ""},
                  {"c", {{{2, 3}, {0, 1}}}, {2, 3}, ""}};
  scene.bodies = {{"a", isotropic<2>(1, 0, Plane::strain)},
                  {"b", isotropic<2>(2, 0.3, Plane::strain)},
                  {"c", isotropic<2>(3, 0.2, Plane::strain)}};
  scene.bodies.at("b").force = {0.5, -1};
  scene.boundary = {{"a.bottom", {ConditionKind::fixed, {linear, other_linear}, ""}},
                    {"b.left", {ConditionKind::sliding, {linear}, ""}},
                    {"b.top", {ConditionKind::traction, {other_linear, linear}, ""}},
                    {"c.right", {ConditionKind::pressure, {linear}, ""}}};
  scene.contact = {
      {"a.top", "b.bottom", quadratic, ""}, {"c.left", "a.right", quadratic, ""}, {"c.bottom", "rigid", quadratic, ""}};
  return scene;
}

Vector<2> jagged(const Vector<2>& x) {
  return x + 0.08 * Vector<2>(std::sin(57 * x[0] + 91 * x[1]), std::cos(83 * x[0] - 31 * x[1]));
}

}  // namespace

RefineCase three_blocks(const std::string& name, const std::function<Vector<2>(const Vector<2>&)>& map) {
  const Scene<2> scene = three_blocks_scene();
  const Mesh<2> straight = build_mesh(scene);
  Mesh<2> mesh;
  for (const Vector<2>& vertex : straight.vertices) mesh.vertices.push_back(map(vertex));
  mesh.cells = straight.cells;
  mesh.cell_body = straight.cell_body;
  mesh.bodies = straight.bodies;
  mesh.parts = straight.parts;
  std::vector<PartEdge> part_edges;
  for (const auto& facet : straight.boundary) part_edges.push_back({facet.vertices, facet.part});
  return {name, fix_data(scene, with_topology(std::move(mesh), part_edges, name))};
}

std::vector<RefineCase> refine_cases() {
  std::vector<RefineCase> all;
  all.push_back(three_blocks("blocks", [](const Vector<2>& x) { return x; }));
  all.push_back(three_blocks("jagged", jagged));
  all.push_back(three_blocks("ring", [](const Vector<2>& x) {
    return Vector<2>((3 - x[1]) * std::cos(1.5 * x[0]), (3 - x[1]) * std::sin(1.5 * x[0]));
  }));
  all.push_back(three_blocks("flat", [](const Vector<2>& x) { return Vector<2>(x[0], 1e-3 * x[1]); }));
  all.push_back(three_blocks("far", [](const Vector<2>& x) -> Vector<2> { return jagged(x) + Vector<2>(-700, 300); }));
  all.push_back(three_blocks("any refinement edges", jagged));
  std::mt19937 random(7);
  for (char& edge : all.back().problem.mesh.refinement_edge) edge = static_cast<char>(random() % 3);

  const Folder folder;
  Scene<2> scene;
  scene.mesh_file = folder.write("a.msh", gmsh_4(two_squares()));
  scene.bodies = {{"lower", isotropic<2>(1, 0, Plane::strain)}, {"upper", isotropic<2>(1, 0, Plane::strain)}};
  scene.boundary = {{"base", {ConditionKind::fixed, {linear, other_linear}, ""}}};
  scene.contact = {{"joint above", "joint below", quadratic, ""}};
  all.push_back({"gmsh", fix_data(scene, build_mesh(scene))});
  return all;
}

std::vector<char> some(const Mesh<2>& mesh, std::mt19937& random, unsigned one_of) {
  std::vector<char> marked(mesh.cells.size());
  for (char& mark : marked) mark = random() % one_of == 0;
  return marked;
}

void expect_conforming(const Mesh<2>& mesh) {
  ASSERT_EQ(mesh.cell_edges.size(), mesh.cells.size());
  ASSERT_EQ(mesh.cell_body.size(), mesh.cells.size());
  ASSERT_EQ(mesh.refinement_edge.size(), mesh.cells.size());
  EXPECT_EQ((std::set(mesh.edges.begin(), mesh.edges.end()).size()), mesh.edges.size());
  std::vector<int> up(mesh.edges.size(), 0), down(mesh.edges.size(), 0);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    ASSERT_GT(volume(mesh, static_cast<int>(cell)), 0);
    for (int k = 0; k < 3; ++k) {
      const int from = mesh.cells[cell][(k + 1) % 3], to = mesh.cells[cell][(k + 2) % 3];
      const int edge = mesh.cell_edges[cell][k];
      ASSERT_EQ(mesh.edges[edge], (std::array{std::min(from, to), std::max(from, to)}));
      ++(from < to ? up : down)[edge];
    }
  }
  std::vector<char> boundary(mesh.edges.size(), false);
  for (const auto& facet : mesh.boundary) {
    ASSERT_EQ(mesh.cell_edges[facet.cell][facet.local], facet.edge);
    EXPECT_EQ(facet.vertices[0], mesh.cells[facet.cell][(facet.local + 1) % 3]);
    EXPECT_EQ(facet.vertices[1], mesh.cells[facet.cell][(facet.local + 2) % 3]);
    EXPECT_FALSE(boundary[facet.edge]);
    boundary[facet.edge] = true;
  }
  for (std::size_t edge = 0; edge < mesh.edges.size(); ++edge) {
    EXPECT_LE(up[edge], 1);
    EXPECT_LE(down[edge], 1);
    EXPECT_EQ(up[edge] + down[edge], boundary[edge] ? 1 : 2);
  }
}

}  // namespace bracket::scene::test
