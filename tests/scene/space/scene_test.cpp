// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/scene/space/boxes.h"

namespace bracket::scene {
namespace {

using namespace test;

const std::string scene_in_space = R"(schema = 1
dim = 3
title = "a block on a slab"
[[mesh.block]]
body = "slab"
x = [0, 1]
y = [0, 1]
z = [0, 2]
cells = [2, 1, 3]
[[mesh.block]]
body = "block"
x = [0, 1]
y = [1, 2]
z = [0, 2]
cells = [2, 2, 3]
[bodies.slab]
E = 1.0
nu = 0.3
[bodies.block]
stiffness = [[3, 1, 1, 0, 0, 0], [1, 3, 1, 0, 0, 0], [1, 1, 3, 0, 0, 0], [0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]]
body_force = [0, -0.5, 0.25]
[boundary."slab.bottom"]
fixed = ["x*z", 0, 0]
[boundary."block.front"]
sliding = 0
[boundary."block.back"]
pressure = "z + y"
[boundary."block.top"]
traction = [0, "-z", 0]
[[contact]]
first = "block.bottom"
second = "slab.top"
gap = "0.001*z^2"
[[contact]]
first = "block.left"
second = { plane = { point = [-0.1, 0, 0], normal = [1, 0, 0] } }
[refine]
strategy = "adaptive"
[solve]
dual = "local"
)";

TEST(SceneInSpace, IsRead) {
  const Folder folder;
  const auto file = folder.write("a.toml", scene_in_space);
  EXPECT_EQ(dimension_of(file), 3);
  const Scene<3> scene = read_scene<3>(file);
  ASSERT_EQ(scene.blocks.size(), 2u);
  EXPECT_EQ(scene.blocks[1].range[2], (std::array<double, 2>{0, 2}));
  EXPECT_EQ(scene.blocks[1].cells, (std::array{2, 2, 3}));
  EXPECT_EQ(scene.solve.degree, 2);
  EXPECT_EQ(scene.solve.dual, Dual::local);
  EXPECT_EQ(scene.bodies.at("block").force, Vector<3>(0, -0.5, 0.25));
  EXPECT_EQ(scene.bodies.at("block").material.stiffness()(3, 3), 1);
  EXPECT_EQ(scene.boundary.at("block.back").value[0]({5, 2, 3}), 5);
  EXPECT_DOUBLE_EQ((*scene.contact[0].gap)({5, 2, 3}), 0.009);
  EXPECT_TRUE(std::holds_alternative<PlaneObstacle>(scene.contact[1].second.obstacle));
  const Problem<3> problem = fix_data(scene, build_mesh(scene));
  EXPECT_EQ(problem.mesh.cells.size(), 6u * (6 + 12));
  EXPECT_EQ(problem.contact.size(), 12u + 12);
  expect_error([&] { read_scene<2>(file); }, Status::input, {"dim must be 2"});
}

TEST(SceneInSpace, TellsWhatItDoesNotKnow) {
  const Folder folder;
  const std::vector<std::array<std::string, 3>> faults = {
      {"dim = 3", "dim = 3\nplane = \"strain\"", "plane belongs to two dimensions"},
      {"dim = 3", "dim = 4", "dim must be 3"},
      {"cells = [2, 1, 3]", "cells = [2, 1]", "mesh.block.cells must be a list of 3"},
      {"z = [0, 2]\ncells = [2, 1, 3]", "cells = [2, 1, 3]", "'z'"},
      {"fixed = [\"x*z\", 0, 0]", "fixed = [0, 0]", "list of 3"},
      {"fixed = [\"x*z\", 0, 0]", "fixed = [\"x*w\", 0, 0]", "unknown name 'w'"},
      {"dual = \"local\"", "dual = \"hybrid\"", "\"local\""},
      {"dual = \"local\"", "degree = 3", "1 or 2"},
      {"gap = \"0.001*z^2\"", "law = { winkler = 1 }", "three dimensions know"},
      {"{ plane = {", "{ line = {", "line"},
      {"[refine]", "[curves.\"slab.top\"]\ncircle = \"detect\"\n[refine]", "arcs of the plane"},
      {"first = \"block.left\"", "first = \"block.left\"\nzones = 3", "zones"},
      {"[refine]", "[[quantity]]\nrotation = \"block.top\"\n[refine]", "rotation"},
      {"nu = 0.3", "nu = 0.5", "(-1, 0.5)"}};
  for (const auto& [from, to, named] : faults) {
    std::string text = scene_in_space;
    text.replace(text.find(from), from.size(), to);
    expect_error([&] { read_scene<3>(folder.write("a.toml", text)); }, Status::input, {"a.toml:", named});
  }
  std::string plane = replaced(two_blocks(), "schema = 1", "schema = 1\ndim = 2");
  EXPECT_EQ(dimension_of(folder.write("b.toml", plane)), 2);
  EXPECT_EQ(dimension_of(folder.write("b.toml", two_blocks())), 2);
  plane = replaced(two_blocks(), "x = [0, 1]\ny = [0, 1]", "x = [0, 1]\ny = [0, 1]\nz = [0, 1]");
  expect_error([&] { read_scene<2>(folder.write("b.toml", plane)); }, Status::input, {"b.toml:", "dim = 3"});
}

}  // namespace
}  // namespace bracket::scene
