// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of mesh files that share nodes, or nodes that coincide.
#include <gtest/gtest.h>

#include "tests/scene/inputs.h"

namespace bracket::scene {
namespace {

using namespace test;

/// Two unit squares, "lower" and "upper", that share the nodes of "joint".
GmshContent joined_squares() {
  GmshContent content;
  content.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 2}, {0, 2}};
  content.lines = {{5, {0, 1}}, {6, {2, 3}}};
  content.triangles = {{1, {0, 1, 2}}, {1, {0, 2, 3}}, {2, {3, 2, 4}}, {2, {3, 4, 5}}};
  content.names = "1 5 \"base\"\n1 6 \"joint\"\n2 1 \"lower\"\n2 2 \"upper\"\n";
  return content;
}

// Whatever their order and however far from the origin: those within reach of each other are one, others are not.
TEST(JoinedBodies, BodiesThatTouchAreMergedInAnyOrder) {
  const Folder folder;
  constexpr int n = 7;
  for (const double far : {0.0, 1e6}) {
    GmshContent content;
    const auto add_square = [&](int group, double x, double sign) {
      for (int i = 0; i <= n; ++i)
        for (const int j : {0, 1}) content.nodes.push_back({far + x + j, far + double(i) / n + sign * 1e-9 * (i % 3)});
      const int first = static_cast<int>(content.nodes.size()) - 2 * (n + 1);
      for (int i = 0; i < n; ++i) {
        const int a = first + 2 * i;
        content.triangles.push_back({group, {a, a + 1, a + 3}});
        content.triangles.push_back({group, {a, a + 3, a + 2}});
      }
    };
    add_square(1, 0, 1);
    add_square(2, 1, -1);
    for (const bool reversed : {false, true}) {
      if (reversed) {
        const int last = static_cast<int>(content.nodes.size()) - 1;
        std::ranges::reverse(content.nodes);
        for (auto& cell : content.triangles)
          for (int& node : cell.nodes) node = last - node;
      }
      Scene<2> scene = scene_of(folder.write("a.msh", gmsh_2(content)), {"1", "2"});
      EXPECT_EQ(build_mesh(scene).components.size(), 2u);
      scene.merge = 1e-7;
      const Mesh<2> mesh = build_mesh(scene);
      EXPECT_EQ(mesh.components, std::vector<std::string>{"1 + 2"});
      EXPECT_EQ(mesh.vertices.size(), 3u * (n + 1));
      EXPECT_EQ(mesh.boundary.size(), 4u + 2 * n);
    }
  }
}

TEST(JoinedBodies, BlocksHaveNoNodesToMerge) {
  Scene<2> scene = stacked(1, {});
  scene.merge = 1e-6;
  expect_error([&] { build_mesh(scene); }, Status::input, {"mesh.merge", "blocks"});
}

TEST(JoinedBodies, BodiesThatTouchAndAreNeitherJoinedNorInContactAreNamed) {
  const Folder folder;
  Scene<2> scene = scene_of(folder.write("a.msh", gmsh_2(two_squares())), {"lower", "upper"});
  expect_note(build_mesh(scene), "'lower' and 'upper' have 2 nodes at the same places");
  scene.contact = {{"joint below", "joint above", constant(0), "scene:contact"}};
  EXPECT_TRUE(build_mesh(scene).notes.empty());
  scene.contact.clear();
  scene.merge = 1e-6;
  EXPECT_EQ(build_mesh(scene).notes.size(), 3u);  // merged; the two names are inside
}

TEST(JoinedBodies, BodiesThatShareNodesAreOnePieceOfTwoMaterials) {
  const Folder folder;
  const auto file = folder.write("a.msh", gmsh_4(joined_squares()));
  const Mesh<2> mesh = build_mesh(scene_of(file, {"lower", "upper"}, {"base"}));
  EXPECT_EQ(mesh.bodies, (std::vector<std::string>{"lower", "upper"}));
  EXPECT_EQ(mesh.components, std::vector<std::string>{"lower + upper"});
  EXPECT_EQ(mesh.vertices.size(), 6u);
  EXPECT_EQ(mesh.boundary.size(), 6u);
  expect_note(mesh, "1 line of 'joint' inside of bodies ignored");
  expect_error(
      [&] {
        build_mesh(scene_of(file, {"lower", "upper"}, {"joint"}));
      },
      Status::mesh, {"'joint'", "share", "first = \"joint\"", "scene:joint"});
}

TEST(JoinedBodies, AContactThatNamesTheLineBetweenBodiesSeparatesThem) {
  const Folder folder;
  GmshContent content = joined_squares();
  content.lines.push_back({7, {3, 2}});  // the other name of the same line
  content.names += "1 7 \"other side\"\n";
  Scene<2> scene = scene_of(folder.write("a.msh", gmsh_2(content)), {"lower", "upper"}, {"base"});
  scene.contact = {{"joint", "other side", constant(0), "scene:contact"}};
  const Mesh<2> mesh = build_mesh(scene);
  EXPECT_EQ(mesh.components, (std::vector<std::string>{"lower", "upper"}));
  EXPECT_EQ(mesh.vertices.size(), 8u);
  EXPECT_EQ(mesh.boundary.size(), 8u);
  EXPECT_EQ(length_of(mesh, "joint"), 1);
  EXPECT_EQ(length_of(mesh, "other side"), 1);
  EXPECT_EQ(mesh.cell_body[mesh.boundary[facet_at(mesh, "joint", {0.5, 1})].cell], 0);
  const Problem<2> problem = fix_data(scene, mesh);
  ASSERT_EQ(problem.contact.size(), 1u);
  EXPECT_NE(problem.contact[0].second, -1);
}

TEST(JoinedBodies, OneNameOfTheLineBetweenBodiesSeparatesThemAsACrack) {
  const Folder folder;
  Scene<2> scene = scene_of(folder.write("a.msh", gmsh_4(joined_squares())), {"lower", "upper"}, {"base"});
  scene.contact = {{"joint", "joint", constant(0), "scene:contact"}};
  const Mesh<2> mesh = build_mesh(scene);
  EXPECT_EQ(mesh.components, (std::vector<std::string>{"lower", "upper"}));
  EXPECT_EQ(length_of(mesh, "joint"), 2);
  EXPECT_EQ(fix_data(scene, mesh).contact.size(), 1u);
}

// Bodies whose nodes were merged are separated again where they touch, and joined elsewhere: an upper block on two
// lower ones, bonded to the left one.
TEST(JoinedBodies, MergedBodiesAreJoinedButForTheirContact) {
  const Folder folder;
  GmshContent content;
  content.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}, {1, 1}, {2, 1}, {1, 2}};
  content.triangles = {{1, {0, 1, 2}}, {1, {0, 2, 3}},  {2, {4, 5, 6}},
                       {2, {4, 6, 7}}, {3, {8, 9, 11}}, {3, {9, 10, 11}}};
  content.lines = {{5, {6, 7}}, {6, {9, 10}}, {7, {1, 2}}, {8, {4, 7}}};
  content.names = "1 5 \"a\"\n1 6 \"b\"\n1 7 \"c\"\n1 8 \"d\"\n2 1 \"left\"\n2 2 \"right\"\n2 3 \"upper\"\n";
  Scene<2> scene = scene_of(folder.write("a.msh", gmsh_2(content)), {"left", "right", "upper"});
  scene.merge = 1e-9;
  EXPECT_EQ(build_mesh(scene).components, std::vector<std::string>{"left + right + upper"});
  scene.contact = {{"a", "b", constant(0), ""}, {"c", "d", constant(0), ""}};
  const Mesh<2> mesh = build_mesh(scene);
  EXPECT_EQ(mesh.components, (std::vector<std::string>{"left + upper", "right"}));
  EXPECT_EQ(mesh.vertices.size(), 10u);
  EXPECT_EQ(fix_data(scene, mesh).contact.size(), 2u);
}

TEST(JoinedBodies, BodiesThatShareButAPointAreSeparate) {
  const Folder folder;
  GmshContent content;
  content.nodes = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, -1}};
  content.triangles = {{1, {0, 1, 2}}, {2, {1, 4, 3}}};
  const Mesh<2> mesh = read_mesh<2>(folder.write("a.msh", gmsh_2(content)));
  EXPECT_EQ(mesh.components.size(), 2u);
  EXPECT_EQ(mesh.vertices.size(), 6u);
}

TEST(JoinedBodies, ACrackInsideOfABodyOpensBetweenItsTips) {
  const Folder folder;
  constexpr int n = 4;  // squares on each side; the crack runs along y = 1/2 from x = 1/4 to 3/4
  GmshContent content;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) content.nodes.push_back({double(i) / n, double(j) / n});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      content.triangles.push_back({1, {a, a + 1, a + n + 2}});
      content.triangles.push_back({1, {a, a + n + 2, a + n + 1}});
    }
  const int tip = 2 * (n + 1) + 1;
  content.lines = {{5, {tip, tip + 1}}, {5, {tip + 1, tip + 2}}, {6, {tip, tip + 1}}, {6, {tip + 1, tip + 2}}};
  Scene<2> scene = scene_of(folder.write("a.msh", gmsh_2(content)), {"1"});
  scene.contact = {{"5", "6", constant(0), ""}};
  const Mesh<2> mesh = build_mesh(scene);
  EXPECT_EQ(mesh.vertices.size(), 26u);  // only the middle of the crack is doubled
  EXPECT_EQ(mesh.boundary.size(), 4u * n + 4);
  EXPECT_EQ(mesh.components.size(), 1u);
}

}  // namespace
}  // namespace bracket::scene
