// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "scene/text.h"
#include "tests/scene/inputs.h"

namespace bracket::scene {
namespace {

using namespace test;

Scene<2> read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const Folder folder;
  return read_scene<2>(folder.write("a.toml", text), overrides);
}

TEST(Scene, EveryKeyIsRead) {
  const Folder folder;
  const auto file = folder.write("a.toml", two_blocks());
  const Scene<2> scene = read_scene<2>(file);
  EXPECT_EQ(scene.file, file.string());
  EXPECT_EQ(scene.title, "Two blocks");
  EXPECT_EQ(scene.units, "N, mm, MPa");
  EXPECT_EQ(scene.plane, Plane::strain);
  ASSERT_EQ(scene.blocks.size(), 2u);
  EXPECT_EQ(scene.blocks[1].body, "upper");
  EXPECT_EQ(scene.blocks[1].range[1], (std::array<double, 2>{1, 2}));
  EXPECT_EQ(scene.blocks[1].cells, (std::array<int, 2>{4, 4}));
  EXPECT_EQ(scene.blocks[1].where, file.string() + ":10:1");
  EXPECT_EQ(scene.bodies.at("lower").material.stiffness(), isotropic<2>(1, 0.3, Plane::strain).stiffness());
  EXPECT_EQ(scene.bodies.at("upper").material.stiffness()(0, 1), 1);
  EXPECT_EQ(scene.bodies.at("upper").material.stiffness()(1, 1), 2);
  EXPECT_EQ(scene.bodies.at("upper").force, Vector<2>(0.5, -1));
  const Condition<2>& load = scene.boundary.at("upper.top");
  EXPECT_EQ(load.kind, ConditionKind::traction);
  EXPECT_EQ(load.value[1]({0.25, 2}), -0.1);
  EXPECT_EQ(load.value[1]({0.75, 2}), 0.09);
  EXPECT_EQ(scene.boundary.at("lower.bottom").kind, ConditionKind::fixed);
  EXPECT_EQ(scene.boundary.at("upper.left").kind, ConditionKind::sliding);
  ASSERT_EQ(scene.contact.size(), 1u);
  EXPECT_EQ(name(scene.contact[0].first), "upper.bottom");
  EXPECT_EQ(name(scene.contact[0].second), "lower.top");
  EXPECT_DOUBLE_EQ((*scene.contact[0].gap)({2, 0}), 0.04);
  EXPECT_EQ(scene.refine.strategy, Strategy::none);
  EXPECT_EQ(scene.refine.target, 1e-3);
  EXPECT_EQ(scene.refine.bulk, 0.7);
  EXPECT_EQ(scene.refine.max_levels, 3);
  EXPECT_EQ(scene.refine.max_cells, 1000);
  EXPECT_EQ(scene.refine.max_seconds, 60);
  EXPECT_EQ(scene.solve.degree, 1);
}

TEST(Scene, WhatMayBeLeftOutHasItsDefault) {
  const Scene<2> scene = read(R"(schema = 1
mesh.block = [{ body = "a", x = [0, 1], y = [0, 1], cells = [1, 1] }]
bodies.a = { E = 1, nu = 0 }
contact = [{ first = "a.top", second = "rigid" }]
)");
  EXPECT_EQ(scene.refine.strategy, Strategy::none);
  EXPECT_EQ(scene.solve.degree, 2);
  EXPECT_EQ(scene.solve.dual, Dual::hybrid);
  EXPECT_FALSE(scene.contact[0].gap);  // as drawn
  EXPECT_TRUE(scene.boundary.empty());
  EXPECT_EQ(scene.bodies.at("a").force, Vector<2>(0, 0));
}

TEST(Scene, DegreeIsChosenByTheTargetAndTheBulkByTheDegree) {
  const auto solved = [](const std::string& settings) {
    return read(
        "schema = 1\nmesh.block = [{ body = 'a', x = [0, 1], y = [0, 1], cells = [1, 1] }]\n"
        "bodies.a = { E = 1, nu = 0 }\n" +
        settings);
  };
  const auto chosen = [&](const std::string& settings) {
    return solved("solve.degree = 'auto'\n" + settings).solve.degree;
  };
  EXPECT_EQ(chosen(""), 2);
  EXPECT_EQ(chosen("refine.target = 0.1"), 2);
  EXPECT_EQ(chosen("refine.target = 0.01"), 3);
  EXPECT_EQ(chosen("refine.target = 1e-4"), 4);
  EXPECT_EQ(chosen("refine.target = 1e-4\nsolve.dual = 'uzawa'"), 2);
  EXPECT_EQ(
      chosen("refine.target = 1e-4\ncontact = [{ first = 'a.bottom', second = 'rigid', law = { coulomb = 0.3 } }]"), 2);
  EXPECT_EQ(degree_for(0.01, 1000), 2);
  EXPECT_EQ(degree_for(1e-3, 1000), 3);
  EXPECT_EQ(degree_for(1e-6, 1000), 4);
  EXPECT_EQ(solved("solve.degree = 2").refine.bulk, 0.5);
  EXPECT_EQ(solved("solve.degree = 3").refine.bulk, 0.8);
  EXPECT_EQ(solved("solve.degree = 4\nrefine.bulk = 0.5").refine.bulk, 0.5);
}

TEST(Scene, FormulasKnowCoordinatesAndConstants) {
  const Scene<2> scene = read(two_blocks(), {"boundary.upper.top.traction=['sin(pi*x)*y', '1e-3*e^(x)']"});
  const auto& value = scene.boundary.at("upper.top").value;
  EXPECT_NEAR(value[0]({0.5, 3}), 3, 1e-15);
  EXPECT_NEAR(value[1]({2, 0}), 1e-3 * std::exp(2), 1e-17);
  const Function<2> copy = value[0];  // copies do not share a point
  EXPECT_NEAR(copy({0.5, 7}), 7, 1e-14);
  EXPECT_NEAR(value[0]({0.5, 3}), 3, 1e-15);
}

TEST(Scene, AMeshFileIsRelativeToTheScene) {
  const Folder folder;
  folder.write("m.msh", gmsh_4(two_squares()));
  const auto file = folder.write("a.toml", R"(schema = 1
[mesh]
file = "m.msh"
[bodies]
lower = { E = 1, nu = 0 }
upper = { E = 1, nu = 0 }
[boundary."joint below"]
pressure = 1
)");
  const Scene<2> scene = read_scene<2>(file);
  EXPECT_EQ(scene.mesh_file, folder.path() / "m.msh");
  EXPECT_EQ(fix_data(scene, build_mesh(scene)).bodies.size(), 2u);
}

TEST(Scene, AMissingMeshFileIsNamedWithItsPlaceInTheScene) {
  const Folder folder;
  const auto file = folder.write("a.toml", "schema = 1\nmesh.file = 'absent.msh'\n[bodies.a]\nE = 1\nnu = 0\n");
  const auto error = error_of([&] { build_mesh(read_scene<2>(file)); });
  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->status(), Status::input);
  EXPECT_EQ(std::string(error->what()).find(file.string() + ":2:"), 0u) << error->what();
  EXPECT_NE(std::string(error->what()).find("absent.msh"), std::string::npos);
}

TEST(Override, ReplacesAndAdds) {
  const Scene<2> scene =
      read(two_blocks(), {"bodies.lower.E=1e6", "refine.max_cells = 5000", "title=Three: 1 and 2", "units=\"m\"",
                          "contact.0.gap=-0.5*x", "mesh.block.1.cells=[8, 2]", "boundary.lower.bottom.fixed=[1, 'x']",
                          "boundary.\"upper.left\".sliding=0.25", "boundary.lower.right.pressure=3",
                          "boundary.'lower.left'.pressure='y'", "mesh.block.0.x.1=5", "bodies.lower.body_force=[0, 9]",
                          "boundary.joint above . pressure = 4"});
  EXPECT_EQ(scene.bodies.at("lower").material.stiffness(), isotropic<2>(1e6, 0.3, Plane::strain).stiffness());
  EXPECT_EQ(scene.bodies.at("lower").force, Vector<2>(0, 9));
  EXPECT_EQ(scene.refine.max_cells, 5000);
  EXPECT_EQ(scene.title, "Three: 1 and 2");
  EXPECT_EQ(scene.units, "m");
  EXPECT_EQ((*scene.contact[0].gap)({2, 0}), -1);
  EXPECT_EQ(scene.blocks[1].cells, (std::array<int, 2>{8, 2}));
  EXPECT_EQ(scene.blocks[0].range[0], (std::array<double, 2>{0, 5}));
  EXPECT_EQ(scene.boundary.at("lower.bottom").value[0]({0, 0}), 1);
  EXPECT_EQ(scene.boundary.at("lower.bottom").value[1]({7, 0}), 7);
  EXPECT_EQ(scene.boundary.at("upper.left").value[0]({0, 0}), 0.25);
  EXPECT_EQ(scene.boundary.at("lower.right").kind, ConditionKind::pressure);
  EXPECT_EQ(scene.boundary.at("lower.left").value[0]({0, 6}), 6);
  EXPECT_EQ(scene.boundary.at("joint above").value[0]({0, 0}), 4);
  EXPECT_EQ(scene.boundary.size(), 6u);
}

TEST(Override, MayGiveTheFirstConditionOfAScene) {
  const std::string bare = R"(schema = 1
mesh.block = [{ body = "a", x = [0, 1], y = [0, 1], cells = [1, 1] }]
bodies.a = { E = 1, nu = 0 }
)";
  const Scene<2> scene = read(bare, {"boundary.a.left.sliding=0", "boundary.a.right.pressure=1", "solve.degree=1"});
  EXPECT_TRUE(scene.boundary.contains("a.left"));
  EXPECT_TRUE(scene.boundary.contains("a.right"));
  EXPECT_EQ(scene.solve.degree, 1);
}

TEST(Names, TheNearestIsFound) {
  const std::vector<std::string> known = {"fixed", "sliding", "traction", "pressure"};
  EXPECT_EQ(nearest("fixd", known), "fixed");
  EXPECT_EQ(nearest("tracktion", known), "traction");
  EXPECT_EQ(nearest("presure", known), "pressure");
  EXPECT_EQ(nearest("slding", known), "sliding");
  EXPECT_EQ(nearest("x", {}), "");
}

// Cut anywhere, a scene is read or refused as input; never anything else.
TEST(Scene, CutAtAnyByteItIsReadOrRefused) {
  const Folder folder;
  const std::string whole = two_blocks();
  int read_whole = 0;
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    const auto file = folder.write("cut.toml", whole.substr(0, size));
    const auto error = error_of([&] { read_scene<2>(file); });
    if (!error) {
      ++read_whole;
      continue;
    }
    EXPECT_EQ(error->status(), Status::input);
    EXPECT_EQ(std::string(error->what()).find('\n'), std::string::npos);
    EXPECT_EQ(std::string(error->what()).find(file.string()), 0u) << error->what();
  }
  EXPECT_GE(read_whole, 2);
}

TEST(Scene, AnyByteChangedItIsReadOrRefused) {
  const Folder folder;
  const std::string whole = two_blocks();
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const char c : {'9', '"', '[', '\n', '\xff'}) {
      std::string changed = whole;
      changed[at] = c;
      const auto file = folder.write("changed.toml", changed);
      const auto error = error_of([&] { read_scene<2>(file); });
      if (error) {
        EXPECT_EQ(error->status(), Status::input);
      }
    }
  }
}

}  // namespace
}  // namespace bracket::scene
