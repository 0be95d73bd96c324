// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// What files hold beside triangles of bodies that are apart, each in one group.
#include <gtest/gtest.h>

#include <numeric>

#include "tests/scene/inputs.h"
#include "tests/support/mesh_files.h"

namespace bracket::scene {
namespace {

using namespace test;
using namespace bracket::tests;

/// The unit square "block" with "bottom" and "top"; `extra` elements are added to its four.
std::string square(const std::string& names, const std::string& extra, const std::string& z = "0") {
  const auto lines = [](const std::string& text) { return std::ranges::count(text, '\n'); };
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" + std::to_string(3 + lines(names)) +
         "\n1 1 \"bottom\"\n1 2 \"top\"\n2 3 \"block\"\n" + names + "$EndPhysicalNames\n$Nodes\n4\n1 0 0 " + z +
         "\n2 1 0 " + z + "\n3 1 1 " + z + "\n4 0 1 " + z + "\n$EndNodes\n$Elements\n" +
         std::to_string(4 + lines(extra)) + "\n1 1 2 1 1 1 2\n2 1 2 2 3 3 4\n3 2 2 3 1 1 2 3\n4 2 2 3 1 1 3 4\n" +
         extra + "$EndElements\n";
}

TEST(MeshFile, APlaneAtAnyHeightIsRead) {
  const Folder folder;
  for (const std::string z : {"5", "-1e3", "+7", "0.1"}) {
    const Mesh<2> mesh = read_mesh<2>(folder.write("a.msh", square("", "", z)));
    EXPECT_EQ(area(mesh, "block"), 1);
    expect_note(mesh, "z = ");
  }
  EXPECT_TRUE(read_mesh<2>(folder.write("a.msh", square("", ""))).notes.empty());
}

TEST(MeshFile, ByteOrderMarksPlusSignsAndNumbersTooSmallAreRead) {
  const Folder folder;
  std::string text = replaced(square("", ""), "\n2 1 0 0\n", "\n+2 +1 1e-400 -0.0e+0\n");
  text = replaced(text, "\n4 0 1 0\n", "\n4 -1e-400 +1.0 0\n");
  const Mesh<2> mesh = read_mesh<2>(folder.write("a.msh", "\xef\xbb\xbf" + text));
  EXPECT_EQ(mesh.vertices, (std::vector<Vector<2>>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  for (const char* bad : {"1e400", "+-1", "++1", "+", "1d"})
    EXPECT_TRUE(error_of([&] {
      read_mesh<2>(
          folder.write("b.msh", replaced(square("", ""), "\n2 1 0 0\n", "\n2 " + std::string(bad) + " 0 0\n")));
    })) << bad;
}

TEST(MeshFile, WithoutGroupsCurvesAndSurfacesGoByTheirNumbers) {
  const Folder folder;
  GmshContent content = two_squares();
  content.names = "";
  std::string four = gmsh_4(content);  // entities 10 + group; now without groups
  for (const auto& [from, to] : {std::pair("15 0 0 0 1 1 0 1 5 2", "15 0 0 0 1 1 0 0 2"),
                                 std::pair("16 0 0 0 1 1 0 1 6 2", "16 0 0 0 1 1 0 0 2"),
                                 std::pair("17 0 0 0 1 1 0 1 7 2", "17 0 0 0 1 1 0 0 2"),
                                 std::pair("11 0 0 0 1 1 0 1 1 0", "11 0 0 0 1 1 0 0 0"),
                                 std::pair("12 0 0 0 1 1 0 1 2 0", "12 0 0 0 1 1 0 0 0")})
    four = replaced(four, from, to);
  const Mesh<2> mesh = read_mesh<2>(folder.write("4.msh", four));
  EXPECT_EQ(mesh.bodies, (std::vector<std::string>{"surface_11", "surface_12"}));
  EXPECT_EQ(mesh.parts, (std::vector<std::string>{"curve_15", "curve_16", "curve_17"}));
  EXPECT_EQ(length_of(mesh, "curve_16"), 1);
  // Without numbers, too: one body.
  const std::string two =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n$Elements\n1\n"
      "1 2 0 1 2 3\n$EndElements\n";
  EXPECT_EQ(read_mesh<2>(folder.write("2.msh", two)).bodies, std::vector<std::string>{"body"});
}

TEST(MeshFile, ALineInTwoGroupsHasTheNameThatTheSceneUses) {
  const Folder folder;
  const auto file = folder.write("a.msh", square("1 5 \"all\"\n", "9 1 2 5 1 1 2\n10 1 2 5 3 3 4\n"));
  const Mesh<2> plain = read_mesh<2>(file);
  EXPECT_EQ(length_of(plain, "bottom") + length_of(plain, "all"), 2 - length_of(plain, "top"));
  expect_note(plain, "'bottom' and 'all' share 1 line");
  const Mesh<2> one = build_mesh(scene_of(file, {"block"}, {"all"}));
  EXPECT_EQ(length_of(one, "all"), 2);
  const Mesh<2> two = build_mesh(scene_of(file, {"block"}, {"top"}));
  EXPECT_EQ(length_of(two, "top"), 1);
  EXPECT_EQ(length_of(two, "bottom"), 1);
  EXPECT_TRUE(two.notes.empty());
  expect_error(
      [&] {
        build_mesh(scene_of(file, {"block"}, {"all", "top"}));
      },
      Status::mesh, {"(1, 1) to (0, 1)", "'all'", "'top'", "scene:all", "scene:top"});
}

TEST(MeshFile, ACurveInTwoGroupsOfVersion4HasTheNameThatTheSceneUses) {
  const Folder folder;
  const std::string text = replaced(gmsh_4(two_squares()), "15 0 0 0 1 1 0 1 5 2 1 -1", "15 0 0 0 1 1 0 2 5 8 2 1 -1");
  const auto file = folder.write("a.msh", replaced(replaced(text, "$PhysicalNames\n5", "$PhysicalNames\n6"),
                                                   "1 7 \"joint above\"\n", "1 7 \"joint above\"\n1 8 \"ground\"\n"));
  EXPECT_EQ(length_of(build_mesh(scene_of(file, {"lower", "upper"}, {"ground"})), "ground"), 1);
  EXPECT_EQ(length_of(build_mesh(scene_of(file, {"lower", "upper"}, {"base"})), "base"), 1);
}

TEST(MeshFile, ASurfaceInTwoGroupsHasTheNameThatTheSceneUses) {
  const Folder folder;
  const auto file = folder.write("a.msh", square("2 5 \"everything\"\n", "9 2 2 5 1 1 2 3\n10 2 2 5 1 1 3 4\n"));
  for (const std::string name : {"block", "everything"}) {
    const Mesh<2> mesh = build_mesh(scene_of(file, {name}));
    EXPECT_EQ(mesh.bodies, std::vector<std::string>{name});
    EXPECT_EQ(area(mesh, name), 1);
    EXPECT_EQ(mesh.cells.size(), 2u);
  }
  expect_error(
      [&] {
        build_mesh(scene_of(file, {"block", "everything"}));
      },
      Status::mesh, {"'block'", "'everything'", "cell 3"});
  expect_note(read_mesh<2>(file), "'block' and 'everything' share 2 cells");
}

TEST(MeshFile, PartitionsAreRead) {
  const Folder folder;
  const Mesh<2> mesh = read_mesh<2>(folder.write("a.msh", gmsh_of_partitions));
  EXPECT_EQ(mesh.bodies, std::vector<std::string>{"block"});
  EXPECT_EQ(mesh.parts, std::vector<std::string>{"bottom"});
  EXPECT_EQ(length_of(mesh, "bottom"), 1);
  EXPECT_EQ(area(mesh, "block"), 1);
  EXPECT_TRUE(mesh.notes.empty());
}

TEST(MeshFile, NamedLinesInsideOfABodyAndPointsAreIgnoredWithANote) {
  const Folder folder;
  const auto file = folder.write("a.msh", square("0 9 \"corner\"\n1 6 \"inner\"\n", "8 15 2 9 1 1\n9 1 2 6 7 1 3\n"));
  const Mesh<2> mesh = read_mesh<2>(file);
  EXPECT_EQ(mesh.parts, (std::vector<std::string>{"bottom", "top"}));
  expect_note(mesh, "'corner'");
  expect_note(mesh, "1 line of 'inner'");
  expect_error([&] { build_mesh(scene_of(file, {"block"}, {"inner"})); }, Status::mesh, {"'inner'", "scene:inner"});
}

TEST(MeshFile, CoincidingNodesAreNamedAndMergedOnRequest) {
  const Folder folder;
  const std::string text = replaced(
      replaced(replaced(square("", ""), "$Nodes\n4", "$Nodes\n6"), "$EndNodes", "5 1e-9 0 0\n6 1 1 0\n$EndNodes"),
      "4 2 2 3 1 1 3 4\n", "4 2 2 3 1 5 6 4\n");
  Scene<2> scene = scene_of(folder.write("a.msh", text), {"block"});
  expect_error([&] { build_mesh(scene); }, Status::mesh, {"'top'", "2 nodes coincide", "--set mesh.merge=1e-06"});
  scene.merge = 1e-6;
  const Mesh<2> mesh = build_mesh(scene);
  EXPECT_EQ(mesh.vertices, (std::vector<Vector<2>>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(mesh.components.size(), 1u);
  EXPECT_EQ(length_of(mesh, "top"), 1);
  expect_note(mesh, "2 nodes merged");
  scene.merge = 1;
  expect_error([&] { build_mesh(scene); }, Status::mesh, {"mesh.merge = 1", "smaller"});
  scene.merge = 1e-10;
  expect_error([&] { build_mesh(scene); }, Status::mesh, {"pieces", "1 node coincides", "--set mesh.merge=1e-06"});
  scene.merge = -1;
  expect_error([&] { build_mesh(scene); }, Status::input, {"mesh.merge", "negative"});
}

// ---- quadrilaterals and second order --------------------------------------------------------------------------------

std::string elements(const std::vector<std::array<double, 2>>& nodes, const std::string& lines) {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(nodes.size()) + "\n";
  for (std::size_t i = 0; i < nodes.size(); ++i)
    text += std::to_string(i + 1) + " " + std::to_string(nodes[i][0]) + " " + std::to_string(nodes[i][1]) + " 0\n";
  return text + "$EndNodes\n$Elements\n" + std::to_string(std::ranges::count(lines, '\n')) + "\n" + lines +
         "$EndElements\n";
}

TEST(MeshFile, QuadrilateralsAreCutByTheBetterDiagonal) {
  const Folder folder;
  // A dart, which only the diagonal through its inner corner cuts into two triangles, from any corner and turned either
  // way; a kite, whose short diagonal is the better one.
  const std::vector<std::array<double, 2>> dart = {{0, 0}, {2, 1}, {0, 2}, {0.5, 1}},
                                           kite = {{0, 0}, {1, -1}, {4, 0}, {1, 1}};
  for (const auto& [shape, cut_at, expected] : {std::tuple(dart, 1, 1.5), std::tuple(kite, 1, 4.0)}) {
    for (int turn = 0; turn < 8; ++turn) {
      std::string line = "1 3 2 7 1";
      for (int k = 0; k < 4; ++k) line += " " + std::to_string(1 + ((turn < 4 ? k : 3 - k) + turn) % 4);
      const Mesh<2> mesh = read_mesh<2>(folder.write("a.msh", elements(shape, line + "\n")));
      EXPECT_NEAR(area(mesh, "7"), expected, 1e-15);
      ASSERT_EQ(mesh.cells.size(), 2u);
      for (const auto& cell : mesh.cells) EXPECT_NE(std::ranges::find(cell, cut_at), cell.end()) << turn;
      expect_note(mesh, "1 quadrilateral cut in two");
    }
  }
}

TEST(MeshFile, AQuadrilateralWithTwoCornersAtOneNodeIsATriangle) {
  const Folder folder;
  const Mesh<2> mesh = read_mesh<2>(folder.write("a.msh", elements({{0, 0}, {1, 0}, {0, 1}}, "1 3 2 7 1 1 2 3 3\n")));
  EXPECT_EQ(mesh.cells.size(), 1u);
}

TEST(MeshFile, SecondOrderIsStraightenedAndTheLargestHeightIsTold) {
  const Folder folder;
  // A triangle of 6 nodes beside a quadrilateral of 8; one side bulges by 0.25.
  const std::vector<std::array<double, 2>> nodes = {{0, 0},   {1, 0},   {1, 1}, {0, 1},      {0.5, 0},  {1, 0.5},
                                                    {0.5, 1}, {0, 0.5}, {2, 0}, {1.5, -.25}, {1.5, 0.5}};
  const std::string lines = "1 8 2 5 1 1 2 5\n2 8 2 6 2 2 9 10\n3 16 2 7 1 1 2 3 4 5 6 7 8\n4 9 2 7 2 2 9 3 10 11 6\n";
  const Mesh<2> mesh = read_mesh<2>(folder.write("a.msh", elements(nodes, lines)));
  EXPECT_EQ(mesh.vertices.size(), 5u);
  EXPECT_NEAR(area(mesh, "7"), 1.5, 1e-15);
  EXPECT_EQ(length_of(mesh, "5"), 1);
  EXPECT_EQ(length_of(mesh, "6"), 1);
  expect_note(mesh, "2 cells of second order straightened: the largest height above a chord is 0.25, at (1.5, -0.25)");
}

}  // namespace
}  // namespace bracket::scene
