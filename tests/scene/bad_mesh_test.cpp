// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/scene/inputs.h"

namespace bracket::scene {
namespace {

using namespace test;

struct Case {
  std::string text;
  std::vector<std::string> named;  // what the message must say
  Status status = Status::mesh;
};

void expect_refused(const Folder& folder, const std::string& name, const Case& bad) {
  const auto file = folder.write("bad.msh", bad.text);
  const auto error = error_of([&] { read_mesh<2>(file); });
  ASSERT_TRUE(error.has_value()) << name << " was read";
  EXPECT_EQ(error->status(), bad.status) << name << ": " << error->what();
  const std::string line = error->what();
  EXPECT_EQ(line.find('\n'), std::string::npos) << name;
  EXPECT_EQ(line.find(file.string()), 0u) << name << ": " << line;
  for (const std::string& part : bad.named) EXPECT_NE(line.find(part), std::string::npos) << name << ": " << line;
}

GmshContent changed(const std::function<void(GmshContent&)>& change) {
  GmshContent content = two_squares();
  change(content);
  return content;
}

TEST(BadMesh, FilesThatAreNotWhatIsReadAreRefused) {
  const Folder folder;
  const std::string two = gmsh_2(two_squares()), four = gmsh_4(two_squares());
  const std::map<std::string, Case> cases = {
      {"empty", {"", {"not a Gmsh mesh"}}},
      {"something else", {"# vtk DataFile Version 2.0\n", {"'#'", "not a Gmsh mesh"}}},
      {"garbage number", {replaced(two, "\n2 1 0 0\n", "\n2 1.0.0 0 0\n"), {"1.0.0", "not a number"}}},
      {"huge integer", {replaced(two, "\n2 1 0 0\n", "\n99999999999999999999999 1 0 0\n"), {"not an integer"}}},
      {"smallest integer", {replaced(two, "1 1 2 5 3 1 2\n", "1 1 2 -9223372036854775808 3 1 2\n"), {"out of range"}}},
      {"infinite", {replaced(two, "\n2 1 0 0\n", "\n2 inf 0 0\n"), {"node 2", "finite"}}},
      {"not a number", {replaced(two, "\n2 1 0 0\n", "\n2 nan 0 0\n"), {"node 2", "finite"}}},
      {"more nodes announced", {replaced(two, "$Nodes\n8\n", "$Nodes\n9\n"), {"$EndNodes", "truncated"}}},
      {"10^12 nodes in 2.2", {replaced(two, "$Nodes\n8\n", "$Nodes\n1000000000000\n"), {"truncated"}}},
      {"10^12 nodes in 4.1", {replaced(four, "\n2 11 1 7\n", "\n2 11 1 1000000000000\n"), {"not an integer"}}},
      {"10^18 nodes in all", {replaced(four, "\n2 8 1 8\n", "\n3 1000000000000000000 1 8\n"), {"truncated"}}},
      {"10^12 elements", {replaced(two, "$Elements\n7\n", "$Elements\n1000000000000\n"), {"truncated"}}},
      {"negative count", {replaced(two, "$Nodes\n8\n", "$Nodes\n-8\n"), {"-8"}}},
      {"fewer nodes announced", {replaced(two, "$Nodes\n8\n", "$Nodes\n7\n"), {"$EndNodes is expected"}}},
      {"end missing", {two.substr(0, two.find("$EndElements")), {"$EndElements", "truncated"}}},
      {"no format", {two.substr(two.find("$PhysicalNames")), {"$MeshFormat"}}},
      {"no elements", {two.substr(0, two.find("$Elements")), {"no triangles"}}},
      {"no nodes", {two.substr(0, two.find("$Nodes")) + two.substr(two.find("$Elements")), {"the node 1,"}}},
      {"node missing", {replaced(two, " 4 5 7 8\n", " 4 5 7 88\n"), {"node 88", "triangle 7"}}},
      {"node twice", {replaced(two, "\n8 0 2 0\n", "\n7 0 2 0\n"), {"node 7", "twice"}}},
      {"tetrahedron", {replaced(four, "2 12 2 1\n7 5 7 8\n", "3 12 4 1\n7 5 7 8 1\n"), {"3D"}}},
      {"another element", {replaced(two, "7 2 2 2 4 5 7 8\n", "7 777 2 2 4 5 7 8\n"), {"777"}}},
      {"out of plane", {replaced(two, "\n7 1 2 0\n", "\n7 1 2 0.5\n"), {"node 7", "z = 0.5", "3D"}}},
  };
  for (const auto& [name, bad] : cases) expect_refused(folder, name, bad);
}

TEST(BadMesh, MeshesThatNoBodyCanHaveAreRefused) {
  const Folder folder;
  const std::map<std::string, std::pair<GmshContent, std::vector<std::string>>> cases = {
      {"no triangles", {changed([](GmshContent& c) { c.triangles.clear(); }), {"no triangles", "physical surfaces"}}},
      {"no surface", {changed([](GmshContent& c) { c.triangles[2].physical = 0; }), {"cell 6", "physical surface"}}},
      {"degenerate",
       {changed([](GmshContent& c) {
          c.nodes[1] = {0.5, 0.5};
        }),
        {"degenerate", "(0.5, 0.5)"}}},
      {"all at one point",
       {changed([](GmshContent& c) {
          c.nodes.assign(8, {0, 0});
        }),
        {"degenerate"}}},
      {"far too large",
       {changed([](GmshContent& c) {
          c.nodes[1] = {1e200, -1e200};
        }),
        {"node 2", "1e+200"}}},
      {"duplicate",
       {changed([](GmshContent& c) {
          c.triangles.push_back({2, {7, 4, 6}});
        }),
        {"duplicate"}}},
      {"three at an edge",
       {changed([](GmshContent& c) {
          c.nodes.push_back({0.4, 0.3});
          c.triangles.push_back({1, {0, 2, 8}});
        }),
        {"more than two", "(0, 0)", "(1, 1)"}}},
      {"overlap",
       {changed([](GmshContent& c) {
          c.nodes[3] = {2, -1};
        }),
        {"overlap", "(0, 0)", "(1, 1)"}}},
      {"pieces",
       {changed([](GmshContent& c) { c.triangles[2].physical = c.triangles[3].physical = 1; }), {"'lower'", "pieces"}}},
      {"pieces by a point",
       {changed([](GmshContent& c) {
          c.triangles[2] = {1, {2, 5, 6}};
          c.nodes[5] = {3, 1};
          c.triangles.pop_back();
          c.lines.pop_back();
        }),
        {"'lower'", "pieces"}}},
      {"no edge",
       {changed([](GmshContent& c) {
          c.lines[1].nodes = {1, 3};
        }),
        {"'joint below'", "no edge"}}},
      {"line on a free node",
       {changed([](GmshContent& c) {
          c.nodes.push_back({5, 5});
          c.lines[1].nodes = {1, 8};
        }),
        {"'joint below'", "no cell"}}},
      {"two groups of one name",
       {changed([](GmshContent& c) { c.names = replaced(c.names, "\"upper\"", "\"lower\""); }), {"'lower'"}}},
  };
  for (const auto& [name, bad] : cases) {
    expect_refused(folder, name + " (2.2)", {gmsh_2(bad.first), bad.second});
    expect_refused(folder, name + " (4.1)", {gmsh_4(bad.first), bad.second});
  }
}

// Two squares of one body, joined by a chain of cells, that touch at a corner as well: each vertex there has four
// facets.
TEST(BadMesh, ABodyThatHangsByAPointIsRefused) {
  const Folder folder;
  GmshContent content;
  content.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}, {2, 2}, {1, 2}, {3, 0}, {3, 1}};
  content.triangles = {{1, {0, 1, 2}}, {1, {0, 2, 3}}, {1, {2, 4, 5}}, {1, {2, 5, 6}}, {1, {1, 7, 0}}};
  content.nodes[7] = {3, -1};
  content.triangles[4] = {1, {0, 7, 1}};        // below the first square …
  content.triangles.push_back({1, {1, 7, 4}});  // … and up to the second
  content.triangles.push_back({1, {1, 4, 8}});
  content.triangles.pop_back();
  content.triangles.push_back({1, {4, 7, 5}});
  const auto file = folder.write("bad.msh", gmsh_2(content));
  const auto error = error_of([&] { read_mesh<2>(file); });
  ASSERT_TRUE(error.has_value());
  EXPECT_NE(std::string(error->what()).find("hangs by a point only at (1, 1)"), std::string::npos) << error->what();
}

TEST(BadMesh, MissingFilesAndFoldersAreInputErrors) {
  const Folder folder;
  for (const auto& file : {folder.path() / "absent.msh", folder.path()}) {
    const auto error = error_of([&] { read_mesh<2>(file); });
    ASSERT_TRUE(error.has_value());
    EXPECT_EQ(error->status(), Status::input);
    EXPECT_NE(std::string(error->what()).find(file.string()), std::string::npos) << error->what();
  }
}

}  // namespace
}  // namespace bracket::scene
