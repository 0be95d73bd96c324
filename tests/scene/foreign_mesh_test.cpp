// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// What libgmsh reads in a process of its own.
#include <gtest/gtest.h>

#include <cstring>

#include "scene/mesh/readers.h"
#include "tests/scene/inputs.h"

namespace bracket::scene {
namespace {

using namespace test;

template <class Value> std::string bytes(const std::vector<Value>& values) {
  std::string text(values.size() * sizeof(Value), '\0');
  std::memcpy(text.data(), values.data(), text.size());
  return text;
}

/// As gmsh_2(), binary.
std::string binary_gmsh_2(const GmshContent& content) {
  const std::string plain = gmsh_2(content);
  const std::size_t names = plain.find("$PhysicalNames"), nodes = plain.find("$Nodes");
  std::string text = "$MeshFormat\n2.2 1 8\n" + bytes<int>({1}) + "\n$EndMeshFormat\n" +
                     plain.substr(names, nodes - names) + "$Nodes\n" + std::to_string(content.nodes.size()) + "\n";
  for (std::size_t i = 0; i < content.nodes.size(); ++i)
    text += bytes<int>({static_cast<int>(i + 1)}) + bytes<double>({content.nodes[i][0], content.nodes[i][1], 0});
  text += "\n$EndNodes\n$Elements\n" + std::to_string(content.lines.size() + content.triangles.size()) + "\n";
  int tag = 0;
  for (const auto& [type, elements] : {std::pair(1, content.lines), std::pair(2, content.triangles)}) {
    text += bytes<int>({type, static_cast<int>(elements.size()), 2});
    for (const auto& element : elements) {
      text += bytes<int>({++tag, element.physical, element.physical});
      for (const int node : element.nodes) text += bytes<int>({node + 1});
    }
  }
  return text + "\n$EndElements\n";
}

void expect_two_squares(const Mesh<2>& mesh) {
  ASSERT_EQ(mesh.bodies, (std::vector<std::string>{"lower", "upper"}));
  EXPECT_EQ(mesh.parts, (std::vector<std::string>{"base", "joint below", "joint above"}));
  EXPECT_EQ(mesh.components.size(), 2u);  // nodes that coincide stay apart
  EXPECT_EQ(area(mesh, "lower"), 1);
  EXPECT_EQ(area(mesh, "upper"), 1);
  for (const char* part : {"base", "joint below", "joint above"}) EXPECT_EQ(length_of(mesh, part), 1);
}

TEST(ForeignMesh, BinaryGmsh) {
  const Folder folder;
  expect_two_squares(read_mesh<2>(folder.write("a mesh.msh", binary_gmsh_2(two_squares()))));
}

TEST(ForeignMesh, GmshOfVersions1And4) {
  const Folder folder;
  const Mesh<2> one = read_mesh<2>(folder.write("1.msh", R"($NOD
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$ENDNOD
$ELM
3
1 1 7 1 2 1 2
2 2 9 1 3 1 2 3
3 2 9 1 3 1 3 4
$ENDELM
)"));
  EXPECT_EQ(area(one, "9"), 1);
  EXPECT_EQ(length_of(one, "7"), 1);
  const Mesh<2> four = read_mesh<2>(folder.write("4.msh", R"($MeshFormat
4 0 8
$EndMeshFormat
$PhysicalNames
1
2 3 "block"
$EndPhysicalNames
$Entities
0 0 1 0
1 0 0 0 1 1 0 1 3 0
$EndEntities
$Nodes
1 4
1 2 0 4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
1 2
1 2 2 2
1 1 2 3
2 1 3 4
$EndElements
)"));
  EXPECT_EQ(area(four, "block"), 1);
}

TEST(ForeignMesh, NastranByPropertyNumbers) {
  const Folder folder;
  const Mesh<2> mesh = read_mesh<2>(folder.write("a.bdf", R"($ a square
GRID,1,0,0.0,0.0,0.0
GRID,2,0,1.0,0.0,0.0
GRID,3,0,1.0,1.0,0.0
GRID,4,0,0.0,1.0,0.0
CBAR,5,2,1,2
CTRIA3,1,7,1,2,3
CTRIA3,2,7,1,3,4
ENDDATA
)"));
  EXPECT_EQ(area(mesh, "surface_7"), 1);
  EXPECT_EQ(length_of(mesh, "curve_2"), 1);
}

TEST(ForeignMesh, WhatLibgmshRefusesIsOneLine) {
  const Folder folder;
  const std::string whole = binary_gmsh_2(two_squares());
  for (std::size_t size = 40; size < whole.size() - 20; size += 61) {
    const auto file = folder.write("cut.msh", whole.substr(0, size));
    expect_error([&] { read_mesh<2>(file); }, Status::mesh, {file.string()});
  }
  const auto file = folder.write("whole.msh", whole);
  expect_error([&] { read_by_libgmsh(file, std::chrono::seconds(0)); }, Status::mesh, {"did not end within 0 s"});
  expect_error([&] { read_mesh<2>(folder.write("a.geo", "Point(1) = {0, 0, 0};")); }, Status::mesh, {"gmsh -2"});
  expect_error([&] { read_mesh<2>(folder.write("a.vtu", "<VTKFile>")); }, Status::mesh, {"a.vtu", ".msh", ".inp"});
  expect_error([&] { read_mesh<2>(folder.path() / "absent.vtu"); }, Status::input, {"no such file"});
  expect_error([&] { read_mesh<2>(folder.path() / "absent.bdf"); }, Status::input, {"no such file"});
  std::filesystem::create_directory(folder.path() / "folder.bdf");
  expect_error([&] { read_mesh<2>(folder.path() / "folder.bdf"); }, Status::input, {"directory"});
}

// libgmsh 4.8 crashes on its own .diff files, which read_mesh() does not give it.
TEST(ForeignMesh, ACrashOfLibgmshIsOneLine) {
  const Folder folder;
  const auto file = folder.write("a.diff", "\n\n\n Finite element mesh (GridFE):\n\n");
  expect_error([&] { read_by_libgmsh(file); }, Status::mesh, {file.string(), "libgmsh"});
}

// libgmsh takes what it does not know for a script, and runs it.
TEST(ForeignMesh, ScriptsAreNotRun) {
  const Folder folder;
  const auto trace = folder.path() / "trace";
  for (const char* name : {"a.unv", "a.bdf", "a.mesh", "a.vtk", "a.msh", "a.med", "a.cgns", "a.txt", "a"})
    for (const char* before : {"", "$MeshFormat\n3 0 8\n$EndMeshFormat\n", "$NOD\n0\n$ENDNOD\n"}) {
      const auto file = folder.write(name, before + ("SystemCall \"touch " + trace.string() + "\";\n"));
      EXPECT_TRUE(error_of([&] { read_mesh<2>(file); })) << name;
      EXPECT_FALSE(std::filesystem::exists(trace)) << name << before;
    }
}

}  // namespace
}  // namespace bracket::scene
