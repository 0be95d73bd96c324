// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "scene/mesh/readers.h"
#include "tests/scene/inputs.h"

namespace bracket::scene {
namespace {

using namespace test;

void expect_same(const Mesh<2>& a, const Mesh<2>& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.cells, b.cells);
  EXPECT_EQ(a.cell_body, b.cell_body);
  EXPECT_EQ(a.bodies, b.bodies);
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.cell_edges, b.cell_edges);
  EXPECT_EQ(a.parts, b.parts);
  EXPECT_EQ(a.notes, b.notes);
  ASSERT_EQ(a.boundary.size(), b.boundary.size());
  for (std::size_t i = 0; i < a.boundary.size(); ++i) {
    EXPECT_EQ(a.boundary[i].vertices, b.boundary[i].vertices);
    EXPECT_EQ(a.boundary[i].part, b.boundary[i].part);
    EXPECT_EQ(a.boundary[i].cell, b.boundary[i].cell);
  }
}

TEST(Gmsh, BothVersionsGiveTheSameMesh) {
  const Folder folder;
  const Mesh<2> two = read_mesh<2>(folder.write("2.msh", gmsh_2(two_squares())));
  const Mesh<2> four = read_mesh<2>(folder.write("4.msh", gmsh_4(two_squares())));
  expect_same(two, four);
  EXPECT_EQ(two.bodies, (std::vector<std::string>{"lower", "upper"}));
  EXPECT_EQ(two.parts, (std::vector<std::string>{"base", "joint below", "joint above"}));
  EXPECT_EQ(two.vertices.size(), 8u);
  EXPECT_EQ(two.boundary.size(), 8u);
  EXPECT_TRUE(two.notes.empty());
  for (const auto& [part, x] :
       std::map<std::string, Vector<2>>{{"base", {0.5, 0}}, {"joint below", {0.5, 1}}, {"joint above", {0.5, 1}}}) {
    const auto& facet = two.boundary[facet_at(two, part, x)];
    EXPECT_EQ(0.5 * (two.vertices[facet.vertices[0]] + two.vertices[facet.vertices[1]]), x) << part;
    EXPECT_EQ(two.bodies[two.cell_body[facet.cell]], part == "joint above" ? "upper" : "lower");
  }
}

TEST(Gmsh, WindowsLineEndsAndStrangeSectionsDoNotMatter) {
  const Folder folder;
  const std::string plain = gmsh_4(two_squares());
  std::string windows;
  for (const char c : plain) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const std::string odd =
      "$Comments\n3 1 what $Nodes\n$EndComments\n" + plain + "$Periodic\n1\n0 1 2\n0\n1\n1 2\n$EndPeriodic\n";
  const Mesh<2> expected = read_mesh<2>(folder.write("plain.msh", plain));
  expect_same(expected, read_mesh<2>(folder.write("windows.msh", windows)));
  expect_same(expected, read_mesh<2>(folder.write("odd.msh", odd)));
}

TEST(Gmsh, UnusedNodesAreDroppedAndGroupsWithoutNameHaveTheirNumber) {
  const Folder folder;
  GmshContent content = two_squares();
  content.names = "2 1 \"lower\"\n";
  content.nodes.insert(content.nodes.begin(), {7, 7});  // a centre of a circle, say
  for (auto* elements : {&content.lines, &content.triangles}) {
    for (auto& element : *elements) {
      for (int& node : element.nodes) ++node;
    }
  }
  const Mesh<2> mesh = read_mesh<2>(folder.write("a.msh", gmsh_2(content)));
  EXPECT_EQ(mesh.vertices.size(), 8u);
  EXPECT_EQ(mesh.vertices[0], Vector<2>(0, 0));
  EXPECT_EQ(mesh.bodies, (std::vector<std::string>{"lower", "2"}));
  EXPECT_EQ(mesh.parts, (std::vector<std::string>{"5", "6", "7"}));
}

TEST(Gmsh, TagsMayBeSparseAndInAnyOrder) {
  const Folder folder;
  const Mesh<2> expected = read_mesh<2>(folder.write("a.msh", gmsh_2(two_squares())));
  // Nodes stand in the same order but have other tags: 1 → 1000000000000, 8 → 3.
  std::string text = gmsh_2(two_squares());
  text = replaced(text, "\n1 0 0 0\n", "\n1000000000000 0 0 0\n");
  text = replaced(text, "\n8 0 2 0\n", "\n-3 0 2 0\n");
  text = replaced(text, "1 1 2 5 3 1 2\n", "1 1 2 5 3 1000000000000 2\n");
  text = replaced(text, " 4 1 2 3\n", " 4 1000000000000 2 3\n");
  text = replaced(text, " 4 1 3 4\n", " 4 1000000000000 3 4\n");
  text = replaced(text, " 4 5 7 8\n", " 4 5 7 -3\n");
  expect_same(expected, read_mesh<2>(folder.write("b.msh", text)));
}

TEST(Gmsh, ClockwiseCellsAreTurned) {
  const Folder folder;
  GmshContent content = two_squares();
  const Mesh<2> expected = read_mesh<2>(folder.write("a.msh", gmsh_2(content)));
  std::swap(content.triangles[1].nodes[1], content.triangles[1].nodes[2]);
  std::swap(content.triangles[3].nodes[1], content.triangles[3].nodes[2]);
  Mesh<2> turned = read_mesh<2>(folder.write("b.msh", gmsh_2(content)));
  EXPECT_EQ(turned.notes, std::vector<std::string>{"2 clockwise cells turned"});
  turned.notes.clear();
  expect_same(expected, turned);
}

/// By the project's own reader, whatever the heading has become.
Mesh<2> read_by_itself(const std::filesystem::path& file) {
  return mesh_of(read_gmsh(file), Scene<2>{}, file.string());
}

// Cut anywhere, a file is either refused in the proper way or, if only its last line end is gone, whole.
TEST(Gmsh, CutAtAnyByteItIsRefused) {
  const Folder folder;
  for (const std::string& whole : {gmsh_2(two_squares()), gmsh_4(two_squares())}) {
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const auto file = folder.write("cut.msh", whole.substr(0, size));
      const auto error = error_of([&] { read_by_itself(file); });
      ASSERT_EQ(error.has_value(), size + 1 < whole.size()) << size;
      if (!error) continue;
      EXPECT_EQ(error->status(), Status::mesh);
      EXPECT_EQ(std::string(error->what()).find('\n'), std::string::npos);
    }
  }
}

// One byte changed: whatever it does, it does not crash, and what is read is a sound number of things.
TEST(Gmsh, AnyByteChangedItIsReadOrRefused) {
  const Folder folder;
  const std::string whole = gmsh_4(two_squares());
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const char c : {'9', '-', '$', ' ', '\0'}) {
      std::string changed = whole;
      changed[at] = c;
      const auto file = folder.write("changed.msh", changed);
      const auto error = error_of([&] { EXPECT_EQ(read_by_itself(file).cells.size(), 4u); });
      if (error) {
        EXPECT_EQ(error->status(), Status::mesh);
      }
    }
  }
}

}  // namespace
}  // namespace bracket::scene
