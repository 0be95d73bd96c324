// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numbers>

#include "tests/scene/inputs.h"
#include "tests/support/mesh_files.h"

namespace bracket::scene {
namespace {

using namespace test;
using namespace bracket::tests;

Vector<2> first_moment(const Mesh<2>& mesh) {
  Vector<2> sum = Vector<2>::Zero();
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    for (const int vertex : mesh.cells[cell]) sum += volume(mesh, static_cast<int>(cell)) / 3 * mesh.vertices[vertex];
  return sum;
}

TEST(Abaqus, FilesOfGmsh) {
  const Folder folder;
  const auto file = folder.write("a.inp", abaqus_of_gmsh);
  const Mesh<2> plain = read_mesh<2>(file);
  EXPECT_EQ(plain.bodies, (std::vector<std::string>{"Surface1", "Surface2"}));
  const Mesh<2> mesh = build_mesh(scene_of(file, {"steel", "brass"}, {"bottom", "right"}));
  EXPECT_EQ(mesh.bodies, (std::vector<std::string>{"brass", "steel"}));
  EXPECT_EQ(mesh.components.size(), 1u);
  EXPECT_EQ(area(mesh, "steel"), 1);
  EXPECT_EQ(length_of(mesh, "bottom"), 1);
  EXPECT_EQ(length_of(mesh, "right"), 1);
  EXPECT_TRUE(mesh.notes.empty());
  expect_error([&] { build_mesh(scene_of(file, {"steal", "brass"})); }, Status::input, {"no body 'steal'", "'steel'"});
  expect_error(
      [&] {
        build_mesh(scene_of(file, {"steel", "brass"}, {"botom"}));
      },
      Status::input, {"no boundary part 'botom'", "'bottom'", "scene:botom"});
}

TEST(Abaqus, FilesOfPrePoMax) {
  const Folder folder;
  const auto file = folder.write("a.inp", abaqus_of_prepomax);
  const Mesh<2> mesh = build_mesh(scene_of(file, {"Shell_part-1"}, {"Fix", "Load"}));
  EXPECT_EQ(mesh.bodies, std::vector<std::string>{"Shell_part-1"});
  EXPECT_EQ(area(mesh, "Shell_part-1"), 2);
  EXPECT_EQ(length_of(mesh, "Fix"), 1);
  EXPECT_EQ(length_of(mesh, "Load"), 1);
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(normal(mesh, facet_at(mesh, "Load", {2, 0.5})), Vector<2>(1, 0));
  expect_note(mesh, "1 quadrilateral cut in two");
  expect_note(mesh, "all sides are straight");
  EXPECT_EQ(length_of(build_mesh(scene_of(file, {"Shell_part-1"}, {"Free"})), "Free"), 1);
}

TEST(Abaqus, AssembliesOfInstancesThatAreMovedAndTurned) {
  const Folder folder;
  const Mesh<2> moved = build_mesh(scene_of(folder.write("a.inp", abaqus_of_cae("0., 3., 0.\n")), {"Low-1", "High-1"},
                                            {"base", "Joint", "Start", "Two"}));
  EXPECT_EQ(moved.bodies.size(), 2u);
  EXPECT_EQ(moved.components.size(), 2u);
  EXPECT_EQ(area(moved, "Low-1"), 2);
  EXPECT_EQ(area(moved, "High-1"), 2);
  for (const auto& [part, length] : std::map<std::string, double>{{"base", 2}, {"Joint", 2}, {"Start", 2}, {"Two", 1}})
    EXPECT_EQ(length_of(moved, part), length) << part;
  EXPECT_EQ(normal(moved, facet_at(moved, "Joint", {1, 1})), Vector<2>(0, 1));
  EXPECT_LE((first_moment(moved) - Vector<2>(4, 2 * 0.5 + 2 * 3.5)).norm(), 1e-14);

  // First moved by (10, 0), then turned by a quarter about (10, 1): (x, y) → (10 + 1 − y, 1 + x).
  const Mesh<2> turned = build_mesh(scene_of(
      folder.write("b.inp", abaqus_of_cae("10., 0., 0.\n10., 1., 0., 10., 1., 1., 90.\n")), {"Low-1", "High-1"}));
  EXPECT_LE((first_moment(turned) - Vector<2>(2, 1) - 2 * Vector<2>(10 + 1 - 0.5, 1 + 1)).norm(), 1e-13);
  // By 30 degrees the area stays, and the moment turns with the body.
  const Mesh<2> oblique = build_mesh(
      scene_of(folder.write("c.inp", abaqus_of_cae("0., 5., 0.\n0., 0., 0., 0., 0., 2., 30.\n")), {"Low-1", "High-1"}));
  EXPECT_NEAR(area(oblique, "High-1"), 2, 1e-14);
  const Vector<2> centre = Eigen::Rotation2Dd(std::numbers::pi / 6) * Vector<2>(1, 5.5);
  EXPECT_LE((first_moment(oblique) - Vector<2>(2, 1) - 2 * centre).norm(), 1e-13);
}

TEST(Abaqus, SetsOfBothInstancesHaveTheirNames) {
  const Folder folder;
  std::string text = abaqus_of_cae("0., 3., 0.\n");
  text = replaced(text, "*Elset, elset=_PickedSet2, internal\n", "*Elset, elset=plate\n");
  text = replaced(text, "elset=_PickedSet2, material", "elset=PLATE, material");
  const Mesh<2> mesh = read_mesh<2>(folder.write("a.inp", text));
  EXPECT_EQ(mesh.bodies, (std::vector<std::string>{"Low-1.plate", "High-1.plate"}));
}

/// As CalculiX's examples: free with capitals and blanks, sets of sets, elements over several lines, other files.
TEST(Abaqus, FilesOfCalculixWithIncludes) {
  const Folder folder;
  folder.write("nodes.inp", "** the nodes\n 1, 0.d0, 0.0\n2,1.D0\n3,+1.,1.\n 4,,1.e0\n*NSET , NSET = Lower\n1,2\n");
  folder.write("more nodes.txt", "11, 3, 0\n12, 4, 0\n13, 4, 1\n");
  folder.write("sets.inp", R"(*NSET,
NSET=Both
Lower,Right
*ELSET,ELSET=Eall
Eleft, 20
*ELSET, elset=Eleft
2
)");
  const auto file = folder.write("a.inp",
                                 "\xef\xbb\xbf"
                                 R"(** comment
*NODE, NSET=Nall
*INCLUDE, INPUT=nodes.inp
*node, input="more nodes.txt"
*element,type=cps3,elset=Eleft
1, 1, 2,
3
*ELEMENT,TYPE=CPS3
2,1,3,4
20,11,12,13
*ELEMENT, TYPE=SPRINGA, ELSET=spring
30, 3, 11
*NSET,NSET=Right,GENERATE
2,3
*INCLUDE,INPUT=sets.inp
*SOLID SECTION , ELSET=Eleft,MATERIAL=EL
*ELSET,ELSET=Eright
20,
*SOLID  SECTION, ELSET=Eright, MATERIAL=EL
)");
  const Mesh<2> mesh = build_mesh(scene_of(file, {"Eleft", "Eright"}, {"Lower"}));
  EXPECT_EQ(area(mesh, "Eleft"), 1);
  EXPECT_EQ(area(mesh, "Eright"), 0.5);
  EXPECT_EQ(length_of(mesh, "Lower"), 1);
  expect_note(mesh, "1 element of type SPRINGA ignored");
  EXPECT_EQ(length_of(build_mesh(scene_of(file, {"Eleft", "Eright"}, {"Both"})), "Both"), 2);
  expect_error([&] { build_mesh(scene_of(file, {"Eleft", "Eall"})); }, Status::mesh, {"'Eleft'", "'Eall'"});
}

TEST(Abaqus, SidesOfShellsAndLinesOfSecondOrder) {
  const Folder folder;
  // CalculiX numbers the faces of a shell first, Abaqus its edges alone; a curved line has its middle last or second.
  const std::string nodes = "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n5,.5,0\n6,.5,1.1\n";
  for (const char* line : {"9,1,2,5", "9,1,5,2"}) {
    const Mesh<2> mesh = build_mesh(
        scene_of(folder.write("a.inp", nodes + "*ELEMENT,TYPE=S4,ELSET=all\n1,1,2,3,4\n*ELEMENT,TYPE=B32,ELSET=low\n" +
                                           line + "\n*SURFACE,NAME=right\n1,S4\n*SURFACE,NAME=top\nall,E3\n"),
                 {"all"}, {"low", "right", "top"}));
    EXPECT_EQ(normal(mesh, facet_at(mesh, "right", {0, 0})), Vector<2>(1, 0));
    EXPECT_EQ(normal(mesh, facet_at(mesh, "top", {0, 0})), Vector<2>(0, 1));
    EXPECT_EQ(normal(mesh, facet_at(mesh, "low", {0, 0})), Vector<2>(0, -1));
  }
}

}  // namespace
}  // namespace bracket::scene
