// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Displacements as CalculiX writes them.
#include <gtest/gtest.h>

#include "scene/text.h"
#include "tests/scene/field_files.h"

namespace bracket::scene {
namespace {

using namespace test;

/// The unit square of two triangles that the small files of tests/fields are of.
Mesh<2> square() {
  Scene<2> scene;
  scene.blocks = {bracket::tests::block("b", 0, 1, 0, 1, 1, 1)};
  scene.bodies = {{"b", isotropic<2>(1, 0.3, Plane::strain)}};
  return build_mesh(scene);
}

/// What CalculiX would write of a motion. \param width of node numbers: 10, or 5 in the short format
std::string frd_of(const Mesh<2>& mesh, int degree, const Motion& motion, int width) {
  const char format = width == 10 ? '1' : '0';
  const std::vector<Node> nodes = nodes_of(mesh, degree);
  const auto values = [&](const std::function<Vector<2>(const Node&)>& of) {
    std::string text;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      text += fmt::format(" -1{:{}}{:12.5E}{:12.5E}{:12.5E}\n", i + 1, width, of(nodes[i])[0], of(nodes[i])[1], 0.);
    return text + " -3\n";
  };
  std::string text = fmt::format("    1C\n    2C{:30}{:38}\n", nodes.size(), format);
  text += values([](const Node& node) { return node.x; });
  text += fmt::format("    3C{:30}{:38}\n", mesh.cells.size(), format);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    text += fmt::format(" -1{:{}}{:5}    0    1\n -2", cell + 1, width, degree == 1 ? 7 : 8);
    for (const int vertex : mesh.cells[cell]) text += fmt::format("{:{}}", vertex + 1, width);
    if (degree == 2)
      for (const int side : {2, 0, 1})
        text += fmt::format("{:{}}", mesh.vertices.size() + mesh.cell_edges[cell][side] + 1, width);
    text += "\n";
  }
  return text + " -3\n    1PSTEP\n" + fmt::format("  100CL  101 1.000000000{:12}{:38}\n", nodes.size(), format) +
         " -4  DISP        4    1\n -5  D1          1    2    1    0\n" +
         values([&](const Node& node) { return motion(node.body, node.x); }) + " 9999\n";
}

TEST(FrdField, OfTheMeshIsMatchedToSixDigits) {
  const Folder folder;
  const Mesh<2> mesh = two_blocks_mesh(3);
  for (const int degree : {1, 2})
    for (const int width : {5, 10}) {
      const GivenDisplacement given =
          read_field(folder.write("a.frd", frd_of(mesh, degree, quadratic_motion, width)), mesh);
      EXPECT_EQ(given.displacement.degree, degree);
      EXPECT_FALSE(given.interpolated);
      EXPECT_LE(error_in(mesh, given.displacement, quadratic_motion), 2e-5);
      EXPECT_GT(given.off, 1e-7);
      EXPECT_LE(given.off, 1e-5);
    }
}

TEST(FrdField, OfAnotherMeshIsInterpolated) {
  const Folder folder;
  const Mesh<2> mesh = two_blocks_mesh(4);
  const GivenDisplacement given =
      read_field(folder.write("a.frd", frd_of(two_blocks_mesh(3), 2, quadratic_motion, 10)), mesh);
  EXPECT_TRUE(given.interpolated);
  EXPECT_LE(error_in(mesh, given.displacement, quadratic_motion), 1e-4);
}

/// The displacement of each vertex and midpoint of the square, as the file says.
void expect_at(const GivenDisplacement& given, const Vector<2>& x, const Vector<2>& u) {
  const Mesh<2> mesh = square();
  const std::vector<Node> nodes = nodes_of(mesh, given.displacement.degree);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].x == x) {
      EXPECT_EQ(i < 4 ? given.displacement.vertex[i] : given.displacement.edge[i - 4], u);
      return;
    }
  ADD_FAILURE() << "no node there";
}

// CPS3, CPS6 and CPE6 of CalculiX 2.20, the first two with OUTPUT=3D.
TEST(FrdField, OfPlaneElementsMadeSolidIsTakenBack) {
  const GivenDisplacement linear = read_field(given_file("solid_linear.frd"), square());
  EXPECT_EQ(linear.displacement.degree, 1);
  expect_at(linear, {1, 1}, {-3.68852e-04, 2.13689e-02});
  const GivenDisplacement solid = read_field(given_file("solid_quadratic.frd"), square());
  EXPECT_EQ(solid.displacement.degree, 2);
  expect_at(solid, {0, 1}, {3.62477e-02, 9.03673e-02});
  expect_at(solid, {0.5, 0.5}, {9.46805e-04, 3.05417e-02});
  const GivenDisplacement plane = read_field(given_file("plane_quadratic.frd"), square());
  expect_at(plane, {0.5, 0}, {-3.62822e-03, 2.30331e-02});
}

TEST(FrdField, TheLastStepIsTaken) {
  const Folder folder;
  const Mesh<2> mesh = two_blocks_mesh(2);
  std::string text = frd_of(mesh, 1, quadratic_motion, 10);
  const std::string last = frd_of(mesh, 1, linear_motion, 10);
  text.insert(text.rfind(" 9999"), last.substr(last.find("    1PSTEP"), last.rfind(" 9999") - last.find("    1PSTEP")));
  const GivenDisplacement given = read_field(folder.write("a.frd", text), mesh);
  EXPECT_LE(error_in(mesh, given.displacement, linear_motion), 1e-5);
  ASSERT_EQ(given.notes.size(), 1u);
  EXPECT_NE(given.notes[0].find("the last of 2 displacements"), std::string::npos);
}

TEST(FrdField, WhatIsWrongIsOneLine) {
  const Folder folder;
  const Mesh<2> mesh = two_blocks_mesh(2);
  const std::string good = frd_of(mesh, 1, linear_motion, 10);
  const auto refused = [&](const std::string& text, const std::vector<std::string>& named) {
    expect_refused(folder.write("a.frd", text), mesh, named);
  };
  refused("", {"a.frd: has no nodes"});
  refused("hello\n", {"a.frd: has no nodes"});
  for (std::size_t cut = 200; cut + 6 < good.size(); cut += 97) refused(good.substr(0, cut), {"a.frd"});
  refused(good.substr(0, good.size() - 6), {"a.frd:", "9999, is missing: the file is truncated"});
  refused(replaced(good, "DISP", "FORC"), {"a.frd: has no displacements", "*NODE FILE"});
  const std::size_t first = good.find(" -1", good.find("DISP"));
  refused(std::string(good).replace(first + 13, 12, "         NaN"), {"the node 1 at (0, 0) has the displacement"});
  refused(std::string(good).replace(first + 13, 12, "        what"), {"a.frd:", "'what' is not a number"});
  refused(std::string(good).replace(first + 37, 12, " 1.00000E+00"), {"the node 1", "out of the plane by 1"});
  refused(std::string(good).erase(first, good.find('\n', first) + 1 - first), {"the node 1 has no displacement"});
  const std::string solid = read_text(given_file("solid_linear.frd"));
  expect_refused(folder.write("a.frd", replaced(solid, " -1        10-4.63115E-03", " -1        10 4.63115E-03")),
                 square(), {"the node 8 at (1, 0)", "node 10", "differently"});
  expect_refused(folder.write("a.frd", replaced(solid, " -1        10 1.00000E+00 0.00000E+00 5",
                                                " -1        10 1.50000E+00 0.00000E+00 5")),
                 square(), {"the node 8 at (1, 0)", "solid"});
}

}  // namespace
}  // namespace bracket::scene
