// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/scene/inputs.h"
#include "tests/support/mesh_files.h"

namespace bracket::scene {
namespace {

using namespace test;
using namespace bracket::tests;

TEST(Unv, FilesOfSalomeWithTheirGroups) {
  const Folder folder;
  const auto file = folder.write("a.UNV", unv_of_salome);
  const Mesh<2> mesh = build_mesh(scene_of(file, {"plate"}, {"bottom"}));
  EXPECT_EQ(area(mesh, "plate"), 1);
  EXPECT_EQ(length_of(mesh, "bottom"), 1);
  EXPECT_EQ(length_of(build_mesh(scene_of(file, {"plate"}, {"corner nodes"})), "corner nodes"), 2);
  expect_note(mesh, "1 elements that are neither");
}

TEST(Unv, SecondOrderAndElementsInNoGroup) {
  const Folder folder;
  const Mesh<2> mesh = read_mesh<2>(folder.write("a.unv", unv_of_second_order));
  EXPECT_EQ(mesh.bodies, (std::vector<std::string>{"below", "body"}));
  EXPECT_EQ(area(mesh, "below"), 2);
  EXPECT_EQ(area(mesh, "body"), 2);
  EXPECT_EQ(length_of(mesh, "below"), 2);
  expect_note(mesh, "2 cells of second order straightened: the largest height above a chord is 0.5, at (1, -0.5)");
}

TEST(Unv, FaultsAreToldWithTheirPlace) {
  const Folder folder;
  const auto changed = [](const std::string& from, const std::string& to) { return replaced(unv_of_salome, from, to); };
  const std::map<std::string, std::pair<std::string, std::vector<std::string>>> cases = {
      {"empty", {"", {"no triangles"}}},
      {"something else", {"solid x\n", {":1:", "not a universal file"}}},
      {"3D", {changed("         2        41", "         2       111"), {"3D", ".msh", ".inp"}}},
      {"axisymmetric", {changed("         2        41", "         2        81"), {"axisymmetric"}}},
      {"node missing",
       {changed("         1         3         4", "         1         3        44"), {"element 3", "node 44"}}},
      {"too few nodes", {changed("         1         3         4", "         1         3"), {"element 3", "2 of 3"}}},
      {"element in group missing",
       {changed("8         3         0", "8        33         0"), {"'plate'", "element 33"}}},
      {"short group", {changed("0         0         2\nplate", "0         0         4\nplate"), {"'plate'", "2 of 4"}}},
      {"two of a name", {changed("corner nodes", "plate"), {"two groups", "'plate'"}}},
  };
  for (const auto& [name, bad] : cases) {
    SCOPED_TRACE(name);
    const auto file = folder.write("a.unv", bad.first);
    expect_error([&] { read_mesh<2>(file); }, Status::mesh, bad.second);
  }
}

TEST(Unv, CutAtAnyByteOrWithAnyByteChangedItIsReadOrRefused) {
  const Folder folder;
  for (std::size_t at = 0; at < unv_of_salome.size(); ++at) {
    std::string changed = unv_of_salome;
    changed[at] = "9- \n\0D"[at % 6];
    for (const std::string& text : {unv_of_salome.substr(0, at), changed}) {
      const auto error = error_of([&] { read_mesh<2>(folder.write("a.unv", text)); });
      if (error) {
        EXPECT_EQ(error->status(), Status::mesh) << error->what();
      }
    }
  }
}

}  // namespace
}  // namespace bracket::scene
