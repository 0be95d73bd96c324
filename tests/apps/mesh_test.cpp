// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// bracket mesh: a scene's mesh for another program.
#include <algorithm>

#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

class MeshCommand : public Command {
 protected:
  MeshCommand() { write("scene.toml", two_blocks); }
};

TEST_F(MeshCommand, WritesEachKindAndInfoReadsIt) {
  for (const std::string ending : {"msh", "inp"}) {
    const Ended ended = shell("bracket mesh scene.toml -o two." + ending + " --refine 1");
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(ended.out.find("two." + ending + ": "), 0u);
    const Ended info = shell("bracket info two." + ending);
    EXPECT_EQ(info.status, 0) << info.err;
    for (const char* name : {"body lower", "body upper", "upper.bottom", "lower.top"})
      EXPECT_NE(info.out.find(name), std::string::npos) << name;
  }
  EXPECT_EQ(shell("bracket mesh scene.toml -o two.vtu --degree 1").status, 0);
  EXPECT_EQ(read("two.vtu").find("<?xml"), 0u);
}

TEST_F(MeshCommand, OfARunsMeshGivesItsBracketAgain) {
  EXPECT_EQ(shell("bracket mesh scene.toml -o two.msh --refine 2 --degree 1").status, 0);
  std::string scene = read("scene.toml");
  for (std::size_t at; (at = scene.find("[[mesh.block]]")) != std::string::npos;)
    scene.erase(at, scene.find("\n[", at + 1) + 1 - at);
  write("again.toml", "mesh.file = \"two.msh\"\n" + scene);
  const Ended blocks = shell(
      "bracket run scene.toml --quiet --no-report --set refine.strategy=uniform "
      "--set refine.target=0 --set refine.max_levels=3");
  const Ended file = shell("bracket run again.toml --quiet --no-report --set refine.strategy=none");
  EXPECT_EQ(file.status, 0) << file.err;
  const std::size_t comma = blocks.out.find(',');
  EXPECT_EQ(file.out.substr(file.out.find(',') + 1, 16), blocks.out.substr(comma + 1, 16)) << blocks.out << file.out;
}

TEST_F(MeshCommand, WritesOverAFileOnlyWhenAsked) {
  write("two.msh", "mine");
  const Ended ended = shell("bracket mesh scene.toml -o two.msh");
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.err, "bracket: two.msh: is there already; --force writes over it\n");
  EXPECT_EQ(read("two.msh"), "mine");
  EXPECT_EQ(shell("bracket mesh scene.toml -o two.msh --force").status, 0);
  EXPECT_EQ(read("two.msh").find("$MeshFormat"), 0u);
  shell("ln -s two.msh link.msh && mkdir folder.msh");
  for (const char* name : {"link.msh", "folder.msh"})
    EXPECT_EQ(shell(std::string("bracket mesh scene.toml --force -o ") + name).status, 2) << name;
  EXPECT_EQ(shell("ls *.part").status, 2);
}

TEST_F(MeshCommand, WhatCannotBeIsOneLine) {
  for (const std::string arguments :
       {"scene.toml", "scene.toml -o two.stl", "scene.toml -o two", "scene.toml -o two.msh --refine -1",
        "scene.toml -o two.msh --degree 3", "scene.toml -o two.msh --refine 20", "scene.toml -o nowhere/two.msh",
        "missing.toml -o two.msh", "scene.toml -o two.msh --set bodies.upper.E=-1", "-o two.msh"}) {
    const Ended ended = shell("bracket mesh " + arguments);
    EXPECT_EQ(ended.status, 2) << arguments;
    EXPECT_EQ(ended.out, "") << arguments;
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << arguments << ended.err;
  }
  EXPECT_EQ(shell("ls two*").status, 2);
}

}  // namespace
}  // namespace bracket::apps::tests
