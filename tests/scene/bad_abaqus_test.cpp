// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/scene/inputs.h"
#include "tests/support/mesh_files.h"

namespace bracket::scene {
namespace {

using namespace test;
using namespace bracket::tests;

TEST(BadAbaqus, FaultsAreToldWithFileAndLine) {
  const Folder folder;
  const std::string whole = abaqus_of_gmsh, cae = abaqus_of_cae("0., 3., 0.\n");
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
      {"3D", {replaced(whole, "type=CPS3, ELSET=Surface1", "type=C3D8, ELSET=Surface1"), {":15:", "3D"}}},
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
      {"short rotation", {abaqus_of_cae("0,0,0\n0,0,0,0,0,1\n"), {"seven"}}},
      {"no axis", {abaqus_of_cae("0,0,0\n0,0,1,0,0,1,90\n"), {"axis"}}},
  };
  for (const auto& [name, bad] : cases) {
    SCOPED_TRACE(name);
    const auto file = folder.write("bad.inp", bad.first);
    expect_error([&] { read_mesh<2>(file); }, Status::mesh, bad.second);
  }
}

// A set of sets of sets … would have 16^40 members, were they counted.
TEST(BadAbaqus, SetsOfSetsDoNotGrow) {
  const Folder folder;
  std::string text = abaqus_of_gmsh;
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

TEST(BadAbaqus, CutAtAnyByteOrWithAnyByteChangedItIsReadOrRefused) {
  const Folder folder;
  for (const std::string& whole : {abaqus_of_gmsh, abaqus_of_prepomax, abaqus_of_cae("1,2\n0,0,0,0,0,1,9\n")})
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
