// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Meshes that are written read back as they were.
#include "scene/mesh/write.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/scene/inputs.h"
#include "tests/support/scenes.h"

namespace bracket::scene {
namespace {

using namespace test;
using bracket::tests::block;

/// Two bodies that touch, refined here and there, with coordinates of all lengths and signs.
Problem<2> refined_blocks() {
  Scene<2> scene = bracket::tests::two_blocks(3);
  scene.blocks = {block("lower", -1. / 3, 1e-7 / 3, -0.7, 1e-17, 3, 2),
                  block("upper", -1. / 3, 1e-7 / 3, 1e-17, 0.1, 3, 2)};
  Problem<2> problem = bracket::tests::problem(scene);
  for (int level = 0; level < 3; ++level) {
    std::vector<char> marked(problem.mesh.cells.size(), 0);
    for (std::size_t cell = 0; cell < marked.size(); cell += 3) marked[cell] = 1;
    problem = refine(problem, marked).problem;
  }
  return problem;
}

/// The name of the part of each facet, by its vertices.
std::map<std::array<int, 2>, std::string> part_names(const Mesh<2>& mesh) {
  std::map<std::array<int, 2>, std::string> names;
  for (const auto& facet : mesh.boundary) names[facet.vertices] = facet.part == -1 ? "" : mesh.parts[facet.part];
  return names;
}

void expect_written(const Mesh<2>& read, const Mesh<2>& written) {
  EXPECT_EQ(read.vertices, written.vertices);
  EXPECT_EQ(read.cells, written.cells);
  ASSERT_EQ(read.cell_body.size(), written.cell_body.size());
  for (std::size_t cell = 0; cell < read.cell_body.size(); ++cell)
    EXPECT_EQ(read.bodies[read.cell_body[cell]], written.bodies[written.cell_body[cell]]);
  EXPECT_EQ(part_names(read), part_names(written));
  EXPECT_EQ(read.components, written.components);
  EXPECT_EQ(read.coordinate_rounding, written.coordinate_rounding);
}

TEST(WrittenMesh, ReadsBackToTheLastBit) {
  const Folder folder;
  const Mesh<2> mesh = refined_blocks().mesh;
  for (const int degree : {1, 2}) {
    expect_written(read_mesh<2>(folder.write("a.msh", gmsh_text(mesh, degree))), mesh);
    for (const Plane plane : {Plane::strain, Plane::stress})
      expect_written(read_mesh<2>(folder.write("a.inp", abaqus_text(mesh, degree, plane))), mesh);
  }
}

TEST(WrittenMesh, OfSecondOrderHasExactMidpoints) {
  const Folder folder;
  const Mesh<2> mesh = refined_blocks().mesh;
  for (const Mesh<2>& read : {read_mesh<2>(folder.write("a.msh", gmsh_text(mesh, 2))),
                              read_mesh<2>(folder.write("a.inp", abaqus_text(mesh, 2, Plane::strain)))})
    expect_note(read, fmt::format("{} cells of second order straightened: ", mesh.cells.size()));
  const std::string text = gmsh_text(mesh, 2);
  for (std::size_t edge = 0; edge < mesh.edges.size(); ++edge) {
    const auto& [a, b] = mesh.edges[edge];
    const Vector<2> middle = 0.5 * (mesh.vertices[a] + mesh.vertices[b]);
    EXPECT_NE(text.find(fmt::format("\n{} {:.17g} {:.17g} 0\n", mesh.vertices.size() + edge + 1, middle[0], middle[1])),
              std::string::npos);
  }
}

// CalculiX reads 20 characters of a number and then stops.
TEST(WrittenMesh, NumbersCutOffAfterTwentyCharactersAreNearlyTheSame) {
  const Mesh<2> mesh = refined_blocks().mesh;
  const std::string text = abaqus_text(mesh, 1, Plane::strain);
  std::size_t line = text.find('\n') + 1;
  for (const Vector<2>& x : mesh.vertices) {
    const std::size_t comma = text.find(", ", line) + 2, second = text.find(", ", comma) + 2;
    line = text.find('\n', line) + 1;
    EXPECT_NEAR(std::stod(text.substr(comma, std::min<std::size_t>(20, second - 2 - comma))), x[0], 1e-17);
    EXPECT_NEAR(std::stod(text.substr(second, std::min<std::size_t>(20, line - 1 - second))), x[1], 1e-17);
  }
}

TEST(WrittenMesh, NamesThatAFormatCannotHoldAreRefused) {
  Mesh<2> mesh = refined_blocks().mesh;
  mesh.parts[0] = "a \"quote\"";
  expect_error([&] { gmsh_text(mesh, 1); }, Status::input, {"a \"quote\"", "Gmsh"});
  expect_error([&] { abaqus_text(mesh, 1, Plane::strain); }, Status::input, {"a \"quote\"", "Abaqus"});
  mesh.parts[0] = "LOWER.Top";
  expect_error([&] { abaqus_text(mesh, 1, Plane::strain); }, Status::input, {"'LOWER.Top'", "'lower.top'"});
  const Folder folder;
  expect_written(read_mesh<2>(folder.write("a.msh", gmsh_text(mesh, 1))), mesh);
  mesh.parts[0] = "joint, left side";
  expect_written(read_mesh<2>(folder.write("a.inp", abaqus_text(mesh, 1, Plane::strain))), mesh);
}

}  // namespace
}  // namespace bracket::scene
