// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numbers>

#include "tests/scene/inputs.h"

namespace bracket::scene {
namespace {

using namespace test;

Vector<2> first_moment(const Mesh<2>& mesh) {
  Vector<2> sum = Vector<2>::Zero();
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    for (const int vertex : mesh.cells[cell]) sum += volume(mesh, static_cast<int>(cell)) / 3 * mesh.vertices[vertex];
  return sum;
}

/// As Gmsh exports a rectangle of two squares with two physical surfaces and curves (Mesh.SaveAll = 1).
const char* const from_gmsh = R"(*Heading
 two.inp
*NODE
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 2, 0, 0
6, 2, 1, 0
******* E L E M E N T S *************
*ELEMENT, type=T3D2, ELSET=Line1
1, 1, 2
*ELEMENT, type=T3D2, ELSET=Line2
2, 5, 6
*ELEMENT, type=CPS3, ELSET=Surface1
3, 1, 2, 3
4, 1, 3, 4
*ELEMENT, type=CPS3, ELSET=Surface2
5, 2, 5, 6
6, 2, 6, 3
*ELSET,ELSET=bottom
1,
*ELSET,ELSET=right
2,
*ELSET,ELSET=steel
3, 4,
*ELSET,ELSET=brass
5, 6,
)";

TEST(Abaqus, FilesOfGmsh) {
  const Folder folder;
  const auto file = folder.write("a.inp", from_gmsh);
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

/// As PrePoMax writes a part: capitals here and there, sets one to a line, generated and internal ones, surfaces by
/// side.
const char* const from_prepomax = R"(** Name: Model-1
*Heading
Hash: x1, Date: 01/01/2026, Unit system: MM_TON_S_C
*Node
1, 0.000000E+000, 0.000000E+000
2, 2.000000E+000, 0.000000E+000
3, 2.000000E+000, 1.000000E+000
4, 0.000000E+000, 1.000000E+000
5, 1.000000E+000, 0.000000E+000
6, 2.000000E+000, 5.000000E-001
7, 1.000000E+000, 1.000000E+000
8, 0.000000E+000, 5.000000E-001
*Element, Type=CPS8R, Elset=Shell_part-1
1, 1, 2, 3, 4, 5, 6, 7,
8
*Nset, Nset=Fix
1, 4, 8
*Nset, Nset=Generated, Generate
5, 8, 2
*Elset, Elset=Internal_Selection-1_Load, Internal
1
*Surface, Name=Load, Type=Element
Internal_Selection-1_Load, S2
*Surface, Name=Free, Type=Node
Fix
*Material, Name=Steel
*Elastic
210000, 0.3
*Solid section, Elset=Shell_part-1, Material=Steel
10
*Step
*Static
*Boundary, op=New
Fix, 1, 2, 0
*End step
)";

TEST(Abaqus, FilesOfPrePoMax) {
  const Folder folder;
  const auto file = folder.write("a.inp", from_prepomax);
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

/// As Abaqus/CAE writes an assembly: a square that is there twice, the second time moved and turned by a quarter.
std::string from_cae(const std::string& placement) {
  return R"(*Heading
*Preprint, echo=NO, model=NO
*Part, name="My part"
*Node
      1,           0.,           0.
      2,           2.,           0.
      3,           2.,           1.
      4,           0.,           1.
*Element, type=CPE4R
1, 1, 2, 3, 4
*Nset, nset=_PickedSet2, internal, generate
 1,  4,  1
*Elset, elset=_PickedSet2, internal
 1,
** Section: Section-1
*Solid Section, elset=_PickedSet2, material=steel
,
*End Part
*Assembly, name=Assembly
*Instance, name=Low-1, part="My part"
*End Instance
*Instance, name=High-1, part="MY PART"
)" + placement +
         R"(*End Instance
*Node
      1,     5.,    5.,   0.
*Nset, nset=Ref
 1,
*Nset, nset=base, instance=Low-1
 1, 2
*Elset, elset=_Joint_S3, internal, instance=Low-1
 1,
*Surface, type=ELEMENT, name=Joint
_Joint_S3, S3
*Surface, type=ELEMENT, name=Start
High-1.1, S1
*Nset, nset=Two
 Low-1.2, LOW-1.3
*End Assembly
)";
}

TEST(Abaqus, AssembliesOfInstancesThatAreMovedAndTurned) {
  const Folder folder;
  const Mesh<2> moved = build_mesh(scene_of(folder.write("a.inp", from_cae("0., 3., 0.\n")), {"Low-1", "High-1"},
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
  const Mesh<2> turned = build_mesh(
      scene_of(folder.write("b.inp", from_cae("10., 0., 0.\n10., 1., 0., 10., 1., 1., 90.\n")), {"Low-1", "High-1"}));
  EXPECT_LE((first_moment(turned) - Vector<2>(2, 1) - 2 * Vector<2>(10 + 1 - 0.5, 1 + 1)).norm(), 1e-13);
  // By 30 degrees the area stays, and the moment turns with the body.
  const Mesh<2> oblique = build_mesh(
      scene_of(folder.write("c.inp", from_cae("0., 5., 0.\n0., 0., 0., 0., 0., 2., 30.\n")), {"Low-1", "High-1"}));
  EXPECT_NEAR(area(oblique, "High-1"), 2, 1e-14);
  const Vector<2> centre = Eigen::Rotation2Dd(std::numbers::pi / 6) * Vector<2>(1, 5.5);
  EXPECT_LE((first_moment(oblique) - Vector<2>(2, 1) - 2 * centre).norm(), 1e-13);
}

TEST(Abaqus, SetsOfBothInstancesHaveTheirNames) {
  const Folder folder;
  std::string text = from_cae("0., 3., 0.\n");
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

TEST(Abaqus, FaultsAreToldWithFileAndLine) {
  const Folder folder;
  const std::string whole = from_gmsh, cae = from_cae("0., 3., 0.\n");
  const std::map<std::string, std::pair<std::string, std::vector<std::string>>> cases = {
      {"empty", {"", {"no triangles"}}},
      {"no keyword", {"1, 2, 3\n", {":1:", "keyword"}}},
      {"star", {"*NODE\n1,0,0\n*\n", {":3:", "keyword"}}},
      {"bad number", {replaced(whole, "2, 1, 0, 0", "2, 1.x, 0, 0"), {":5:", "1.x", "not a number"}}},
      {"huge", {replaced(whole, "2, 1, 0, 0", "2, 1e60, 0, 0"), {":5:", "1e60"}}},
      {"bad label", {replaced(whole, "2, 1, 0, 0", "x2, 1, 0, 0"), {":5:", "x2"}}},
      {"node twice", {replaced(whole, "2, 1, 0, 0", "1, 1, 0, 0"), {":5:", "node 1", "twice"}}},
      {"node missing", {replaced(whole, "5, 2, 5, 6", "5, 2, 5, 66"), {":19:", "element 5", "node 66"}}},
      {"element twice", {replaced(whole, "5, 2, 5, 6", "4, 2, 5, 6"), {":19:", "element 4", "twice"}}},
      {"too many nodes", {replaced(whole, "5, 2, 5, 6", "5, 2, 5, 6, 1"), {":19:", "has 4 nodes", "CPS3 has 3"}}},
      {"cut short", {whole.substr(0, whole.find(", 5, 6\n6")), {":19:", "has 1 node"}}},
      {"3D", {replaced(whole, "type=CPS3, ELSET=Surface1", "type=C3D4, ELSET=Surface1"), {":15:", "3D"}}},
      {"axisymmetric", {replaced(whole, "type=CPS3, ELSET=Surface1", "type=CAX3, ELSET=S"), {":15:", "axisymmetric"}}},
      {"unknown element", {whole + "*ELSET,ELSET=x\n77\n", {":30:", "element 77"}}},
      {"unknown set", {whole + "*ELSET,ELSET=x\nstel\n", {":30:", "'stel'", "'steel'"}}},
      {"unknown node set", {whole + "*NSET,NSET=x\ny\n", {":30:", "'y'"}}},
      {"holds itself", {whole + "*ELSET,ELSET=x\nx\n", {":30:", "itself"}}},
      {"no such side", {whole + "*SURFACE,NAME=x\nsteel, S4\n", {":30:", "S4"}}},
      {"step 0", {whole + "*ELSET,ELSET=x,GENERATE\n1,2,0\n", {":30:", "step"}}},
      {"set without a name", {whole + "*NSET\n1\n", {":29:", "NSET"}}},
      {"generated nodes", {whole + "*NGEN\n1,3\n", {":29:", "NGEN"}}},
      {"included file missing", {whole + "*INCLUDE, INPUT=nowhere.inp\n", {":29:", "nowhere.inp", "no such file"}}},
      {"includes itself", {whole + "*INCLUDE, INPUT=bad.inp\n", {":29:", "itself"}}},
      {"no part", {replaced(cae, "part=\"MY PART\"", "part=Mine"), {"'Mine'", "MY PART"}}},
      {"no instance", {replaced(cae, "nset=base, instance=Low-1", "nset=base, instance=Low"), {"'Low'", "'Low-1'"}}},
      {"part without end", {cae.substr(0, cae.find("*End Part")), {":3:", "*END PART", "truncated"}}},
      {"short rotation", {from_cae("0,0,0\n0,0,0,0,0,1\n"), {"seven"}}},
      {"no axis", {from_cae("0,0,0\n0,0,1,0,0,1,90\n"), {"axis"}}},
  };
  for (const auto& [name, bad] : cases) {
    SCOPED_TRACE(name);
    const auto file = folder.write("bad.inp", bad.first);
    expect_error([&] { read_mesh<2>(file); }, Status::mesh, bad.second);
  }
}

// A set of sets of sets … would have 16^40 members, were they counted.
TEST(Abaqus, SetsOfSetsDoNotGrow) {
  const Folder folder;
  std::string text = from_gmsh;
  std::string last = "steel";
  for (int i = 0; i < 40; ++i) {
    const std::string name = "set" + std::to_string(i);
    text += "*ELSET,ELSET=" + name + "\n";
    for (int k = 0; k < 16; ++k) text += last + ",";
    text += "\n";
    last = name;
  }
  const Mesh<2> mesh = build_mesh(scene_of(folder.write("a.inp", text), {"set39", "brass"}));
  EXPECT_EQ(area(mesh, "set39"), 1);
}

TEST(Abaqus, CutAtAnyByteOrWithAnyByteChangedItIsReadOrRefused) {
  const Folder folder;
  for (const std::string& whole :
       {std::string(from_gmsh), std::string(from_prepomax), from_cae("1,2\n0,0,0,0,0,1,9\n")})
    for (std::size_t at = 0; at < whole.size(); ++at) {
      std::string changed = whole;
      changed[at] = "9-*,\n\0="[at % 7];
      for (const std::string& text : {whole.substr(0, at), changed}) {
        const auto file = folder.write("a.inp", text);
        const auto error = error_of([&] { read_mesh<2>(file); });
        if (error) {
          EXPECT_EQ(error->status(), Status::mesh) << error->what();
          EXPECT_EQ(std::string(error->what()).find('\n'), std::string::npos);
        }
      }
    }
}

}  // namespace
}  // namespace bracket::scene
