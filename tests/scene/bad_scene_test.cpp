// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/scene/inputs.h"

namespace bracket::scene {
namespace {

using namespace test;

void expect_refused(const std::function<void()>& action, const std::string& name,
                    const std::vector<std::string>& named) {
  const auto error = error_of(action);
  ASSERT_TRUE(error.has_value()) << name << " was accepted";
  EXPECT_EQ(error->status(), Status::input) << name << ": " << error->what();
  const std::string line = error->what();
  EXPECT_EQ(line.find('\n'), std::string::npos) << name;
  for (const std::string& part : named) EXPECT_NE(line.find(part), std::string::npos) << name << ": " << line;
}

struct Change {
  std::string from, to;
  std::vector<std::string> named;
};

TEST(BadScene, IsRefusedWithItsPlace) {
  const std::vector<Change> changes = {
      // keys and sections
      {"schema = 1", "schema = 2", {":1:10", "schema must be 1"}},
      {"schema = 1\n", "", {"'schema' is missing"}},
      {"schema = 1", "schema = 1.0", {"schema must be an integer"}},
      {"schema = 1", "schema = ", {":1:", "TOML"}},
      // what toml++ asserts, or is undefined for
      {"schema = 1", "schema = 1\n[[.5", {":2:3: not valid TOML"}},
      {"title = ", "x = 1\u00e92\ntitle = ", {":2:6: not valid TOML: only strings"}},
      {"title = ", "x = 0x\u00a7\ntitle = ", {":2:7: not valid TOML: only strings"}},
      {"title = ", "titel = ", {":2:1", "'titel'", "did you mean 'title'?"}},
      {"title = \"Two blocks\"", "title = 5", {"title must be a string, not a number"}},
      {"\"strain\"", "\"strian\"", {":4:9", "strian", "'strain'"}},
      {"\"strain\"", "true", {"plane must be a string, not a boolean"}},
      // mesh
      {"[[mesh.block]]\nbody = \"upper\"", "[mesh]\nfile = 'a.msh'\nbody = \"upper\"", {"'body' in [mesh]"}},
      {"[[mesh.block]]\nbody = \"lower\"", "[mesh]\nfile = \"a.msh\"\n[[mesh.block]]\nbody = \"lower\"", {"either"}},
      {"body = \"lower\"\nx", "bdy = \"lower\"\nx", {":6:1", "'bdy'", "'body'", "[[mesh.block]]"}},
      {"body = \"lower\"\nx", "body = \"\"\nx", {"mesh.block.body must not be empty"}},
      {"body = \"lower\"\nx", "x", {":5:1", "'body' is missing"}},
      {"y = [1, 2]", "y = [2, 1]", {":13:5", "mesh.block.y", "empty"}},
      {"y = [1, 2]", "y = [1, 1]", {"mesh.block.y"}},
      {"y = [1, 2]", "y = [1, 2, 3]", {"list of 2"}},
      {"y = [1, 2]", "y = [1, nan]", {"mesh.block.y must be finite"}},
      {"y = [1, 2]", "y = [1, inf]", {"mesh.block.y must be finite"}},
      {"y = [1, 2]", "y = [1, \"2\"]", {"must be a number, not a string"}},
      {"y = [1, 2]\ncells = [4, 4]", "y = [1, 2]\ncells = [4, 0]", {"mesh.block.cells", "is 0"}},
      {"y = [1, 2]\ncells = [4, 4]", "y = [1, 2]\ncells = [4.5, 4]", {"mesh.block.cells must be an integer"}},
      {"y = [1, 2]\ncells = [4, 4]", "y = [1, 2]\ncells = [4, 3000000000]", {"3000000000"}},
      // bodies
      {"E = 1.0", "E = 0", {":16:5", "bodies.lower.E must be > 0"}},
      {"E = 1.0", "E = -1", {"bodies.lower.E must be > 0, is -1"}},
      {"E = 1.0", "E = nan", {"finite"}},
      {"E = 1.0", "E = inf", {"finite"}},
      {"E = 1.0", "E = \"1\"", {"bodies.lower.E must be a number"}},
      {"E = 1.0\n", "", {":15:1", "'E' is missing in [bodies.lower]"}},
      {"E = 1.0\nnu = 0.3\n", "", {":15:1", "E and nu, or stiffness"}},
      {"E = 1.0", "E = 1.7e308", {":16:5", "bodies.lower.E", "between 1e-50 and 1e+50", "1.7e+308"}},
      {"E = 1.0", "E = 1e-200", {":16:5", "bodies.lower.E", "between 1e-50 and 1e+50", "1e-200"}},
      {"E = 1.0", "E = 1.0\nE = 2.0", {":17:", "'E = 2.0' defines again"}},
      {"E = 1.0", "e = 1.0", {"'e'", "'E'"}},
      {"nu = 0.3", "nu = 0.5", {":17:6", "bodies.lower.nu", "(-1, 0.5)", "plane strain"}},
      {"nu = 0.3", "nu = -1", {"bodies.lower.nu"}},
      {"nu = 0.3", "nuu = 0.3", {":17:1", "'nuu'", "'nu'"}},
      {"body_force = [0.5, -1.0]", "body_force = 0.5", {"list of 2, not a number"}},
      {"body_force = [0.5, -1.0]", "body_force = [0.5, inf]", {"finite"}},
      {"body_force = [0.5, -1.0]", "body_force = [0.5, -1e200]", {"bodies.upper.body_force", "-1e+200"}},
      {"[3, 1, 0], [1, 2", "[3, 1.001, 0], [1, 2", {"bodies.upper.stiffness is not symmetric"}},
      {"[3, 1, 0], [1, 2, 0]", "[3, 3, 0], [3, 2, 0]", {"not positive definite"}},
      {"[0, 0, 1]]", "[0, 0, 0]]", {"not positive definite"}},
      {"[0, 0, 1]]", "[0, 0, -1]]", {"not positive definite"}},
      {"[0, 0, 1]]", "[0, 0, nan]]", {"finite"}},
      {"[0, 0, 1]]", "[0, 0]]", {"list of 3"}},
      {"[0, 0, 1]]", "[0, 0, 1]]\nE = 1", {"both"}},
      {"[bodies.upper]", "[bodies.uper]", {":18:1", "'uper'", "'upper'"}},
      // boundary
      {"sliding = 0.0", "sliding = 0.0\npressure = 1", {":23:1", "upper.left", "two conditions"}},
      {"sliding = 0.0", "", {"upper.left", "no condition"}},
      {"sliding = 0.0", "sliding = 0.0\n\t[boundary.\"upper.left\"]", {":25:", "'[boundary.\"upper.left\"]' defines"}},
      {"sliding = 0.0", "slidng = 0.0", {":24:1", "'slidng'", "'sliding'"}},
      {"sliding = 0.0", "sliding = [0.0, 0.0]", {"a number or an expression"}},
      {"sliding = 0.0", "sliding = nan", {"finite"}},
      {"fixed = [0.0, 0.0]", "fixed = 0", {"boundary.\"lower.bottom\".fixed", "list of 2"}},
      {"fixed = [0.0, 0.0]", "fixed = [0.0, true]", {":22:15", "not a boolean"}},
      {"\"0\", \"x", "\"2*z\", \"x", {":26:13", "2*z", "'z'"}},
      {"\"0\", \"x", "\"2*(x\", \"x", {":26:13", "2*(x"}},
      {"\"0\", \"x", "\"\", \"x", {":26:13", "expression"}},
      {"\"0\", \"x", "\"1, 2\", \"x", {"one value"}},
      {"\"0\", \"x", "\"x = 1\", \"x", {"=="}},
      {"\"0\", \"x", "\"x = 1 ? 2 : 3\", \"x", {"=="}},
      {"\"0\", \"x", "\"sin(x, y)\", \"x", {"sin"}},
      {"\"0\", \"x", "\"1 \\n + q\", \"x", {"q"}},
      // contact
      {"first = \"upper.bottom\"", "frist = \"upper.bottom\"", {":28:1", "'frist'", "'first'"}},
      {"first = \"upper.bottom\"\n", "", {":27:1", "'first' is missing"}},
      {"first = \"upper.bottom\"", "first = \"rigid\"", {":28:9", "contact.first", "second side"}},
      {"second = \"lower.top\"", "second = 3", {"contact.second must be a string"}},
      {"gap = \"0.01*x^2\"", "gap = inf", {"contact.gap must be finite"}},
      {"gap = \"0.01*x^2\"", "gap = [0]", {"contact.gap"}},
      {"[[contact]]", "[contact]", {"[[contact]]"}},
      // refine, solve
      {"\"none\"", "\"adaptiv\"", {":32:12", "unknown", "adaptiv", "'adaptive'"}},
      {"target = 1e-3", "target = -1", {"refine.target", "-1"}},
      {"bulk = 0.7", "bulk = 0", {"refine.bulk", "(0, 1]"}},
      {"bulk = 0.7", "bulk = 1.5", {"refine.bulk", "1.5"}},
      {"max_levels = 3", "max_levels = 0", {"refine.max_levels"}},
      {"max_cells = 1000", "max_cells = 0", {"refine.max_cells"}},
      {"max_cells = 1000", "max_cels = 1000", {"'max_cels'", "'max_cells'"}},
      {"max_seconds = 60", "max_seconds = 0", {"refine.max_seconds"}},
      {"degree = 1", "degree = 5", {"solve.degree must be from 1 to 4"}},
      {"degree = 1", "degree = 0", {"solve.degree"}},
      {"degree = 1", "degree = \"best\"", {"solve.degree", "\"auto\""}},
      {"\"hybrid\"", "\"hybird\"", {"unknown", "'hybrid'"}},
      {"[solve]", "[solv]", {":38:", "'solv'", "'solve'"}},
  };
  const Folder folder;
  for (const auto& [from, to, named] : changes) {
    const auto file = folder.write("bad.toml", replaced(two_blocks(), from, to));
    std::vector<std::string> all = named;
    all.push_back(file.string() + ":");
    expect_refused([&] { read_scene<2>(file); }, from + " -> " + to, all);
  }
}

TEST(BadScene, PlaneStressAllowsIncompressibilityButNotMore) {
  const Folder folder;
  const std::string stress = replaced(two_blocks(), "\"strain\"", "\"stress\"");
  EXPECT_NO_THROW(read_scene<2>(folder.write("a.toml", replaced(stress, "nu = 0.3", "nu = 0.5"))));
  const auto file = folder.write("b.toml", replaced(stress, "nu = 0.3", "nu = 0.51"));
  expect_refused([&] { read_scene<2>(file); }, "nu = 0.51", {"bodies.lower.nu", "plane stress"});
}

TEST(BadScene, FilesThatAreNoneAreRefused) {
  const Folder folder;
  expect_refused([&] { read_scene<2>(folder.path() / "absent.toml"); }, "absent", {"absent.toml", "no such file"});
  expect_refused([&] { read_scene<2>(folder.path()); }, "folder", {"directory"});
  expect_refused([&] { read_scene<2>(folder.write("a.toml", "")); }, "empty", {"a.toml", "empty"});
  expect_refused([&] { read_scene<2>(folder.write("b.toml", "# nothing\n")); }, "comment", {"b.toml", "empty"});
  expect_refused([&] { read_scene<2>(folder.write("c.toml", "schema = 1\n")); }, "no mesh", {"'mesh' is missing"});
  expect_refused([&] { read_scene<2>(folder.write("d.toml", "schema = 1\nmesh = {}\n")); }, "mesh", {"either"});
  expect_refused([&] { read_scene<2>(folder.write("e.toml", "schema = 1\nmesh.file = 'a'\n")); }, "no bodies",
                 {"'bodies' is missing"});
  expect_refused([&] { read_scene<2>(folder.write("f.toml", std::string(1000, '['))); }, "nested", {"TOML"});
  expect_refused([&] { read_scene<2>(folder.write("g.toml", std::string("\0\xff\x80", 3))); }, "binary", {"TOML"});
}

TEST(BadOverride, IsNamed) {
  const Folder folder;
  const auto file = folder.write("a.toml", two_blocks());
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases = {
      {"bodies.uper.E=1", {"'uper'", "'upper'"}},
      {"bodies.lower.EE=1", {"'EE'", "'E'"}},
      {"bodies.lower.E=-1", {"bodies.lower.E must be > 0"}},
      {"bodies.lower.E.x=1", {"'bodies.lower.E' is a value"}},
      {"bodies.lower.E=oops", {"must be a number, not a string"}},
      {"bodies.lower.E=", {"must be a number, not a string"}},
      {"bodies.lower.E=1\nnu=2", {"must be a number, not a string"}},
      {"bodies.lower.E", {"key=value"}},
      {"", {"key=value"}},
      {"=1", {"key"}},
      {"bodies..E=1", {"empty"}},
      {"contact.1.gap=0", {"'contact' is a list with 1 entries", "'1'"}},
      {"contact.gap=0", {"'contact' is a list", "'gap'"}},
      {"contact.-1.gap=0", {"'-1'"}},
      {"contact.0.gap=x +* 2", {"x +* 2"}},
      {"boundary.upper.left.traction=[0, 0]", {"two conditions"}},
      {"boundary.upper.left.slidin=0", {"'slidin'", "'sliding'"}},
      {"refine.strategy=unifrom", {"'uniform'"}},
      {"solve.dual=\"uzava\"", {"\"uzava\"", "'uzawa'"}},
      {"slove.degree=1", {"'slove'", "'solve'"}},
      {"mesh.file=a.msh", {"either"}},
  };
  for (const auto& [override, named] : cases) {
    std::vector<std::string> all = named;
    if (override.find("upper.left.traction") == std::string::npos && override.find('\n') == std::string::npos) {
      all.push_back("--set " + override + ":");  // the two conditions are found at the part's own place
    }
    expect_refused([&] { read_scene<2>(file, {override}); }, override, all);
  }
}

TEST(BadScene, BlocksThatCannotBeAreRefused) {
  Scene<2> scene;
  scene.blocks = {{"a", {{{0, 1}, {0, 1}}}, {1, 1}, "one"}, {"a", {{{0.5, 1.5}, {0, 1}}}, {1, 1}, "other"}};
  expect_refused([&] { build_mesh(scene); }, "overlapping", {"other:", "'a'"});
  scene.blocks = {{"a", {{{0, 1}, {0, 1}}}, {2000000000, 2000000000}, "here"}};
  expect_refused([&] { build_mesh(scene); }, "too many", {"here:", "cells"});
  scene.blocks = {{"a", {{{1, 1 + 1e-15}, {0, 1}}}, {8, 8}, "here"}};
  scene.mesh_where = "the mesh";
  const auto thin = error_of([&] { build_mesh(scene); });
  ASSERT_TRUE(thin.has_value());
  EXPECT_EQ(thin->status(), Status::mesh);
  EXPECT_EQ(std::string(thin->what()).find("the mesh: "), 0u) << thin->what();
}

}  // namespace
}  // namespace bracket::scene
