// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "scene/field/on_scene.h"
#include "tests/scene/inputs.h"

namespace bracket::scene {
namespace {

using namespace test;

/// Two unit squares, one on the other, which share the vertices between them; one triangle is clockwise, one vertex has
/// no cell.
GivenMesh<2> two_squares_in_code() {
  GivenMesh<2> mesh;
  mesh.vertices = {{9, 9}, {0, 0}, {1, 0}, {0, 1}, {1, 1}, {0, 2}, {1, 2}};
  mesh.cells = {{1, 2, 4}, {1, 3, 4}, {3, 4, 6}, {3, 6, 5}};
  mesh.bodies = {{"lower", {0, 1}}, {"upper", {2, 3}}};
  mesh.parts = {{"bottom", {{1, 2}}}, {"joint", {{4, 3}}}, {"top", {{5, 6}}}};
  return mesh;
}

Scene<2> scene_on(GivenMesh<2> mesh) {
  Scene<2> scene;
  scene.given = std::move(mesh);
  for (const char* body : {"lower", "upper"}) scene.bodies.emplace(body, isotropic<2>(1, 0.3, Plane::strain));
  scene.boundary["bottom"] = {ConditionKind::fixed, {constant(0), constant(0)}};
  scene.contact = {{"joint", "joint", {}}};
  return scene;
}

TEST(GivenMesh, IsTreatedAsThatOfAFile) {
  const Mesh<2> mesh = build_mesh(scene_on(two_squares_in_code()));
  EXPECT_EQ(mesh.vertices.size(), 8u);  // those of the joint twice, the one without a cell not at all
  EXPECT_EQ(mesh.bodies, (std::vector<std::string>{"lower", "upper"}));
  EXPECT_EQ(area(mesh, "lower"), 1);
  EXPECT_EQ(area(mesh, "upper"), 1);
  EXPECT_EQ(length_of(mesh, "top"), 1);
  EXPECT_EQ(length_of(mesh, "joint"), 2);
  expect_note(mesh, "clockwise");
}

TEST(GivenMesh, IsRefusedWhereItDoesNotHangTogether) {
  const auto refused = [](void (*change)(GivenMesh<2>&), Status status, const std::vector<std::string>& named) {
    GivenMesh<2> mesh = two_squares_in_code();
    change(mesh);
    const auto action = [scene = scene_on(mesh)] { build_mesh(scene); };
    expect_error(action, status, named);
    EXPECT_EQ(error_of(action)->where(), "");
  };
  refused([](auto& mesh) { mesh.cells[1][2] = 7; }, Status::mesh, {"the cell 1 has the vertex 7", "0 to 6"});
  refused([](auto& mesh) { mesh.cells[3][0] = -1; }, Status::mesh, {"the cell 3 has the vertex -1"});
  refused([](auto& mesh) { mesh.bodies["upper"][0] = 4; }, Status::mesh, {"the body 'upper' has the cell 4"});
  refused([](auto& mesh) { mesh.bodies["upper"].pop_back(); }, Status::mesh, {"the cell 3 is in no cell set"});
  refused([](auto& mesh) { mesh.parts["top"][0][1] = 8; }, Status::mesh, {"the part 'top' has the vertex 8"});
  refused([](auto& mesh) { mesh.parts["top"][0][1] = 4; }, Status::mesh, {"from (0, 2) to (1, 1)", "no edge"});
  refused([](auto& mesh) { mesh.parts.erase("bottom"); }, Status::input, {"boundary.\"bottom\"", "no boundary part"});
  refused([](auto& mesh) { mesh.vertices[2][1] = std::nan(""); }, Status::input, {"the vertex 2", "finite"});
  refused([](auto& mesh) { mesh = {}; }, Status::mesh, {"no triangles"});
  Scene<2> twice = scene_on(two_squares_in_code());
  twice.mesh_file = "a.msh";
  expect_error([&] { build_mesh(twice); }, Status::input, {"either a file or blocks"});
}

TEST(Error, TellsItsPlaceApartFromWhatIsWrong) {
  const Error error(Status::mesh, "a: b.msh:3", "what: is wrong");
  EXPECT_STREQ(error.what(), "a: b.msh:3: what: is wrong");
  EXPECT_EQ(error.where(), "a: b.msh:3");
  EXPECT_EQ(error.message(), "what: is wrong");
  EXPECT_EQ(Error(Status::mesh, "what: is wrong").message(), "what: is wrong");
}

TEST(NodalDisplacement, IsMatchedLikeThatOfAFile) {
  const Scene<2> scene = scene_on(two_squares_in_code());
  const Mesh<2> mesh = refine(fix_data(scene, build_mesh(scene)), std::vector<char>(4, 1)).problem.mesh;
  NodalDisplacement field;
  field.nodes = mesh.vertices;
  for (const Vector<2>& x : mesh.vertices) field.values.emplace_back(x[0] * x[1], x[1] - 3 * x[0]);
  for (const auto& cell : mesh.cells) field.cells.push_back({cell.begin(), cell.end()});
  const FieldOnScene found = field_on_scene(scene, field);
  EXPECT_EQ(found.refinements, 1);
  EXPECT_EQ(found.given.displacement.degree, 1);
  EXPECT_EQ(found.given.displacement.vertex, field.values);
  field.cells[0].push_back(0);
  field.cells[0].push_back(0);
  expect_error([&] { field_on_scene(scene, field); }, Status::input, {"the displacement", "5 nodes"});
  EXPECT_EQ(error_of([&] { field_on_scene(scene, field); })->where(), "");
}

}  // namespace
}  // namespace bracket::scene
