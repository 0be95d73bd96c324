// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numbers>

#include "scene/mesh/topology.h"
#include "tests/scene/inputs.h"

namespace bracket::scene {
namespace {

using namespace test;

Mesh<2> blocks() {
  Scene<2> scene;
  scene.blocks = {{"a", {{{0, 3}, {-1, 1}}}, {3, 5}, ""}, {"b", {{{10, 10.7}, {0, 0.1}}}, {7, 1}, ""}};
  return build_mesh(scene);
}

/// What holds for every mesh, whatever it came from.
void expect_sound(const Mesh<2>& mesh) {
  ASSERT_EQ(mesh.cell_edges.size(), mesh.cells.size());
  ASSERT_EQ(mesh.cell_body.size(), mesh.cells.size());
  EXPECT_TRUE(std::is_sorted(mesh.edges.begin(), mesh.edges.end()));
  std::vector<int> cells_at_edge(mesh.edges.size(), 0);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    EXPECT_GT(volume(mesh, static_cast<int>(cell)), 0);
    for (int k = 0; k < 3; ++k) {
      const auto [lower, upper] = std::minmax(mesh.cells[cell][(k + 1) % 3], mesh.cells[cell][(k + 2) % 3]);
      EXPECT_EQ(mesh.edges[mesh.cell_edges[cell][k]], (std::array{lower, upper}));
      ++cells_at_edge[mesh.cell_edges[cell][k]];
    }
  }
  EXPECT_EQ(std::count(cells_at_edge.begin(), cells_at_edge.end(), 1),
            static_cast<std::ptrdiff_t>(mesh.boundary.size()));
  std::vector<Vector<2>> closed(mesh.bodies.size(), Vector<2>::Zero());
  std::vector<double> turning(mesh.bodies.size(), 0);  // ∫ x·n = 2 area: fails if normals point inwards
  std::vector<double> area(mesh.bodies.size(), 0);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    area[mesh.cell_body[cell]] += volume(mesh, static_cast<int>(cell));
  }
  double size = 0;
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
    const auto& facet = mesh.boundary[i];
    EXPECT_EQ(cells_at_edge[facet.edge], 1);
    EXPECT_EQ(mesh.cell_edges[facet.cell][facet.local], facet.edge);
    EXPECT_EQ(facet.vertices[0], mesh.cells[facet.cell][(facet.local + 1) % 3]);
    EXPECT_EQ(facet.vertices[1], mesh.cells[facet.cell][(facet.local + 2) % 3]);
    const int body = mesh.cell_body[facet.cell];
    const Vector<2> outward = normal(mesh, static_cast<int>(i)) * length(mesh, static_cast<int>(i));
    closed[body] += outward;
    turning[body] += mesh.vertices[facet.vertices[0]].dot(outward);
    size = std::max(size, mesh.vertices[facet.vertices[0]].norm());
  }
  for (std::size_t body = 0; body < mesh.bodies.size(); ++body) {
    const double rounding = 1e-15 * size * static_cast<double>(mesh.boundary.size());
    EXPECT_LE(closed[body].norm(), rounding);
    EXPECT_NEAR(turning[body], 2 * area[body], rounding * size);
  }
}

TEST(Blocks, AreSound) { expect_sound(blocks()); }

TEST(Blocks, SatisfyEulersFormulaAndFillTheRectangles) {
  const Mesh<2> mesh = blocks();
  const auto count = [](const auto& list) { return static_cast<std::ptrdiff_t>(list.size()); };
  EXPECT_EQ(count(mesh.vertices) - count(mesh.edges) + count(mesh.cells), 2);  // 1 for each simply connected body
  EXPECT_EQ(count(mesh.cells), 2 * (15 + 7));
  double area = 0;
  for (int cell = 0; cell < count(mesh.cells); ++cell) area += volume(mesh, cell);
  EXPECT_NEAR(area, 6 + 0.07, 1e-14);
}

TEST(Blocks, NameTheirSides) {
  const Mesh<2> mesh = blocks();
  ASSERT_EQ(mesh.parts.size(), 8u);
  const std::map<std::string, Vector<2>> outward = {
      {"left", {-1, 0}}, {"right", {1, 0}}, {"bottom", {0, -1}}, {"top", {0, 1}}};
  std::map<std::string, double> total;
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
    const auto& facet = mesh.boundary[i];
    ASSERT_NE(facet.part, -1);
    const std::string& part = mesh.parts[facet.part];
    EXPECT_EQ(part.substr(0, 2), mesh.bodies[mesh.cell_body[facet.cell]] + ".");
    EXPECT_EQ(normal(mesh, static_cast<int>(i)), outward.at(part.substr(2))) << part;
    total[part] += length(mesh, static_cast<int>(i));
  }
  EXPECT_NEAR(total["a.left"], 2, 1e-14);
  EXPECT_NEAR(total["a.top"], 3, 1e-14);
  EXPECT_NEAR(total["b.bottom"], 0.7, 1e-14);
}

TEST(Blocks, AreCutFromLowerLeftToUpperRight) {
  Scene<2> scene;
  scene.blocks = {{"a", {{{0, 1}, {0, 2}}}, {1, 1}, ""}};
  const Mesh<2> mesh = build_mesh(scene);
  const auto inner = std::find_if(mesh.edges.begin(), mesh.edges.end(), [&](const std::array<int, 2>& edge) {
    return mesh.vertices[edge[1]] - mesh.vertices[edge[0]] == Vector<2>(1, 2);
  });
  EXPECT_NE(inner, mesh.edges.end());
}

// Blocks that are written with a common side meet to the last bit, whatever the numbers of cells: 0.1 + (0.3 - 0.1),
// for one, is not 0.3.
TEST(Blocks, EndExactlyWhereTheyAreToldTo) {
  for (int k = 1; k <= 30; ++k) {
    const double from = 0.1 * k, to = from + 0.7 * k / 3;
    Scene<2> scene;
    scene.blocks = {{"a", {{{from, to}, {-to, from}}}, {7, k}, ""}};
    const Mesh<2> mesh = build_mesh(scene);
    EXPECT_EQ(mesh.vertices.front(), Vector<2>(from, -to));
    EXPECT_EQ(mesh.vertices.back(), Vector<2>(to, from));
  }
}

TEST(Topology, TurnsClockwiseCellsAndSaysSo) {
  Mesh<2> mesh;
  mesh.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.cells = {{0, 2, 1}, {0, 2, 3}};
  mesh.cell_body = {0, 0};
  mesh.bodies = {"a"};
  const Mesh<2> result = with_topology(mesh, {}, "here");
  expect_sound(result);
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_EQ(result.notes[0], "1 clockwise cell turned");
}

// A ring: boundary facets go around the hole clockwise, and Euler's formula counts the hole.
TEST(Topology, KnowsHoles) {
  Mesh<2> mesh;
  constexpr int n = 12;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    mesh.vertices.push_back({std::cos(angle), std::sin(angle)});
    mesh.vertices.push_back({2 * std::cos(angle), 2 * std::sin(angle)});
    const int next = 2 * ((i + 1) % n);
    mesh.cells.push_back({2 * i, 2 * i + 1, next + 1});
    mesh.cells.push_back({2 * i, next + 1, next});
  }
  mesh.cell_body.assign(mesh.cells.size(), 0);
  mesh.bodies = {"ring"};
  const Mesh<2> result = with_topology(mesh, {}, "here");
  expect_sound(result);
  EXPECT_EQ(result.vertices.size() + result.cells.size(), result.edges.size());
}

TEST(Quality, OfARightTriangle) {
  Scene<2> scene;
  scene.blocks = {{"a", {{{0, std::sqrt(3.0)}, {0, 1}}}, {1, 1}, ""}, {"b", {{{5, 15}, {0, 1}}}, {20, 2}, ""}};
  const Quality measured = quality(build_mesh(scene));
  EXPECT_NEAR(measured.smallest_angle, 30, 1e-12);
  EXPECT_NEAR(measured.largest_angle, 90, 1e-12);
  EXPECT_NEAR(measured.largest_area, std::sqrt(3.0) / 2, 1e-15);
  EXPECT_NEAR(measured.smallest_area, 0.125, 1e-15);
}

// An L of three blocks, and the same with a name for its foot: one piece without seams, whose parts go round it.
TEST(Blocks, OfOneBodyAreOnePiece) {
  Scene<2> scene;
  scene.blocks = {{"l", {{{0, 1}, {0, 1}}}, {3, 3}, ""},
                  {"l", {{{1, 3}, {0, 1}}}, {4, 3}, "", "foot"},
                  {"l", {{{0, 1}, {1, 2.5}}}, {3, 5}, ""}};
  scene.bodies.emplace("l", isotropic<2>(1, 0, Plane::strain));
  const Mesh<2> mesh = build_mesh(scene);
  EXPECT_EQ(mesh.bodies, (std::vector<std::string>{"l"}));
  EXPECT_EQ(mesh.components.size(), 1u);
  EXPECT_EQ(mesh.vertices.size(), 16u + 4 * 4 + 4 * 5);
  EXPECT_EQ(mesh.cells.size(), 18u + 24 + 30);
  std::map<std::string, double> lengths;
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    ASSERT_GE(mesh.boundary[f].part, 0);
    lengths[mesh.parts[mesh.boundary[f].part]] += length(mesh, static_cast<int>(f));
  }
  const std::map<std::string, double> expected = {{"l.left", 2.5},  {"l.bottom", 1},      {"l.top", 1},
                                                  {"l.right", 1.5}, {"l.foot.bottom", 2}, {"l.foot.right", 1},
                                                  {"l.foot.top", 2}};
  ASSERT_EQ(lengths.size(), expected.size());
  for (const auto& [part, length] : expected) EXPECT_DOUBLE_EQ(lengths.at(part), length) << part;
}

TEST(Blocks, OfOneBodyThatDoNotHangTogetherAreRefused) {
  Scene<2> scene;
  scene.blocks = {{"b", {{{0, 1}, {0, 1}}}, {1, 1}, ""}, {"b", {{{1, 2}, {1, 2}}}, {1, 1}, ""}};
  scene.bodies.emplace("b", isotropic<2>(1, 0, Plane::strain));
  for (const double x : {1.0, 1.5}) {
    scene.blocks[1].range[0] = {x, 2};
    const auto error = error_of([&] { build_mesh(scene); });
    ASSERT_TRUE(error.has_value());
    EXPECT_EQ(error->status(), Status::mesh) << error->what();
  }
}

// Of rectangles a : 1 cut in two a + 1/a, whatever their size is.
TEST(Flatness, IsThatOfRectanglesAndWarnsOfLocalStresses) {
  for (const double ratio : {1.0, 2.0, 5.0, 50.0})
    for (const double size : {1e-6, 1.0, 1e6}) {
      Scene<2> scene;
      scene.blocks = {{"b", {{{0, 20 * size}, {-size, size}}}, {10, static_cast<int>(ratio)}, ""}};
      scene.bodies = {{"b", isotropic<2>(1, 0.3, Plane::strain)}};
      const Mesh<2> mesh = build_mesh(scene);
      for (const double one : flatness(mesh)) EXPECT_NEAR(one, ratio + 1 / ratio, 1e-10 * ratio);
      EXPECT_TRUE(mesh.notes.empty());
      scene.solve = {.dual = Dual::local};
      const Mesh<2> local = build_mesh(scene);
      ASSERT_EQ(local.notes.size(), ratio >= 5 ? 1u : 0u) << ratio;
      if (ratio < 5) continue;
      EXPECT_NE(local.notes[0].find(ratio == 50 ? "swept 8 times;" : "swept 2 times;"), std::string::npos)
          << local.notes[0];
      scene.solve.sweeps = 3;
      EXPECT_NE(build_mesh(scene).notes[0].find("swept 3 times, as asked"), std::string::npos);
    }
}

TEST(Flatness, IsThatOfAHundredthOfTheCells) {
  std::vector<double> of(1000, 2.0);
  EXPECT_EQ(common_flatness({}), 0);
  EXPECT_EQ(common_flatness({3}), 3);
  for (int i = 0; i < 9; ++i) of[100 * i] = 50;
  EXPECT_EQ(common_flatness(of), 2);
  of[999] = 50;
  EXPECT_EQ(common_flatness(of), 50);
  EXPECT_EQ(sweeps_for(2), 1);
  EXPECT_EQ(sweeps_for(flat), 1);
  for (double flatness = 1; flatness < 100; ++flatness) EXPECT_LE(sweeps_for(flatness), sweeps_for(flatness + 1));
}

}  // namespace
}  // namespace bracket::scene
