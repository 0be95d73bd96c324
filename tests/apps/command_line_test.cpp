// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

class CommandLine : public Command {
 protected:
  CommandLine() { write("scene.toml", two_blocks); }
};

// One line that begins with the program's name and holds `part`; nothing on standard output.
void expect_refused(const Ended& ended, int status, const std::string& part) {
  EXPECT_EQ(ended.status, status) << ended.err;
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  EXPECT_EQ(ended.err.rfind("bracket: ", 0), 0u) << ended.err;
  EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
}

TEST_F(CommandLine, HelpAndVersionGoToStandardOutput) {
  const Ended help = shell("bracket --help");
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.err, "");
  for (const char* word : {"run", "check", "info", "Exit status"}) EXPECT_NE(help.out.find(word), std::string::npos);
  const Ended version = shell("bracket --version");
  EXPECT_EQ(version.status, 0);
  for (const char* word : {"bracket 0.", "deal.II 9.", "CHOLMOD", "OpenBLAS"})
    EXPECT_NE(version.out.find(word), std::string::npos) << version.out;
}

TEST_F(CommandLine, UsageErrors) {
  expect_refused(shell("bracket"), 2, "expected a command");
  expect_refused(shell("bracket rum scene.toml"), 2, "rum");
  expect_refused(shell("bracket run"), 2, "SCENE");
  expect_refused(shell("bracket run scene.toml other.toml"), 2, "other.toml");
  expect_refused(shell("bracket run scene.toml --fast"), 2, "--fast");
  expect_refused(shell("bracket run scene.toml -o"), 2, "-o");
  expect_refused(shell("bracket run scene.toml -o ''"), 2, "folder");
  expect_refused(shell("bracket check"), 2, "SCENE");
  expect_refused(shell("bracket info"), 2, "MESH");
}

TEST_F(CommandLine, WhatTheUserCanMendEndsInOneLineAndItsStatus) {
  expect_refused(shell("bracket run nowhere.toml"), 2, "nowhere.toml");
  expect_refused(shell("bracket run ."), 2, ".");
  expect_refused(shell("bracket info nowhere.msh"), 2, "nowhere.msh");
  expect_refused(shell("bracket run scene.toml --set bodies.lower.nuu=0.2"), 2, "nuu");
  expect_refused(shell("bracket check scene.toml --set bodies.lower.E=-1"), 2, "E");
  expect_refused(shell("bracket check scene.toml --set nonsense"), 2, "nonsense");
  write("empty.msh", "");
  expect_refused(shell("bracket info empty.msh"), 3, "empty.msh");
  // Pulled up as a whole: nothing holds the upper block.
  expect_refused(shell("bracket run scene.toml --set 'boundary.\"upper.top\".traction=[0, 0.1]'"), 4, "upper");
  EXPECT_EQ(shell("bracket check scene.toml --set 'boundary.\"upper.top\".traction=[0, 0.1]'").status, 4);
}

TEST_F(CommandLine, CheckRefusesWhatRunRefusesBeforeItSolves) {
  const std::string pushed = " scene.toml --set 'boundary.\"upper.left\"={fixed=[0, -0.01]}'";  // into the lower block
  for (const char* command : {"bracket check", "bracket run"}) {
    const Ended ended = shell(command + pushed + " --set 'boundary.\"lower.left\".fixed=[0, 0]'");
    EXPECT_EQ(ended.status, 4) << command;
    EXPECT_EQ(ended.err,
              "bracket: the displacements prescribed at the contact of 'upper.bottom' close its gap by up to 0.01 more "
              "than it has at (0, 1): no displacement of degree 2 is admissible\n");
  }
}

TEST_F(CommandLine, WhatIsNotDoneEndsInOneLineOnStandardError) {
  const auto expect_reason = [](const Ended& ended, int status, const std::string& part) {
    EXPECT_EQ(ended.status, status) << ended.err;
    EXPECT_NE(ended.out, "");
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_EQ(ended.err.rfind("bracket: ", 0), 0u) << ended.err;
    EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
  };
  expect_reason(shell("bracket run scene.toml --no-report --set refine.target=1e-9"), 5, "the target 1e-09");
  // The resultant passes through the end of the contact.
  std::string limit = two_blocks;
  const auto replace = [&](const std::string& from, const std::string& to) {
    limit.replace(limit.find(from), from.size(), to);
  };
  replace("[boundary.\"upper.left\"]\nsliding = 0.0\n", "");
  replace("x < 0.5 ? -0.1 : 0.09", "1 - 3*x");
  write("limit.toml", limit);
  const Ended none = shell("bracket run limit.toml");
  EXPECT_EQ(none.status, 4) << none.err;
  EXPECT_EQ(shell("bracket check limit.toml").status, 4);
  EXPECT_EQ(std::count(none.err.begin(), none.err.end(), '\n'), 1) << none.err;
  EXPECT_NE(none.err.find("a point reaction has infinite energy"), std::string::npos) << none.err;
}

TEST_F(CommandLine, ASceneWithoutEnergyPrintsZeros) {
  const Ended ended = shell("bracket run scene.toml --set 'boundary.\"upper.top\".traction=[0, 0]'");
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("\n● guaranteed error  ≤ 0 %"), std::string::npos) << ended.out;
  EXPECT_EQ(told_of("energy", ended.out), std::pair(0., 0.));
  EXPECT_EQ(ended.out.find("-0 "), std::string::npos) << ended.out;
  const std::string json = read("scene.out/report.json");
  EXPECT_EQ(json.find("-0.0"), std::string::npos) << json;
  EXPECT_EQ(json.find("null"), std::string::npos) << json;
}

TEST_F(CommandLine, OverridesChangeTheScene) {
  const Ended stiff = shell("bracket run scene.toml --json --set bodies.lower.E=1e3 --set bodies.upper.E=2e3");
  const Ended given = shell("bracket run scene.toml --json");
  ASSERT_EQ(stiff.status, 0) << stiff.err;
  // Energies of a problem with given forces go with the inverse of the modulus.
  const auto lower = [](const Ended& ended) {
    return nlohmann::json::parse(ended.out)["energy"]["lower"].get<double>();
  };
  EXPECT_NEAR(1e3 * lower(stiff), lower(given), 1e-9 * std::abs(lower(given)));
}

TEST_F(CommandLine, CheckTellsWhatItUnderstoodAndWritesNothing) {
  const Ended ended = shell("bracket check scene.toml");
  EXPECT_EQ(ended.status, 0) << ended.err;
  for (const char* part : {"body lower: 32 cells, area 1 mm²", "lower.bottom: 4 edges, length 1 mm: fixed",
                           "upper.right: 4 edges, length 1 mm: free",
                           "upper.bottom on lower.top, without friction: 4 edges; gap 0 to 0 mm\n",
                           "areas 0.0312 to 0.0312 mm²", "solvable"})
    EXPECT_NE(ended.out.find(part), std::string::npos) << ended.out;
  EXPECT_EQ(shell("ls").out, "scene.toml\n");
}

TEST_F(CommandLine, CheckHasNoUnitsThatItDoesNotKnow) {
  const std::string heavy = "bracket check scene.toml --set 'bodies.lower.body_force=[0, -2]'";
  EXPECT_NE(shell(heavy).out.find("body force (0, -2) N/mm³\n"), std::string::npos);
  const Ended ended = shell(heavy + " --set 'units=\"furlongs\"'");
  for (const char* part : {"body force (0, -2)\n", "length 1: fixed", "gap 0 to 0\n", "area 1, body"})
    EXPECT_NE(ended.out.find(part), std::string::npos) << ended.out;
}

TEST_F(CommandLine, CheckAndRunTellBondedSides) {
  std::string bonded = two_blocks;
  bonded.replace(bonded.find("gap = 0.0"), 9, "law = \"bonded\"");
  write("bonded.toml", bonded);
  const std::string note = "'upper.bottom' and 'lower.top' are bonded along 4 edges";
  const Ended check = shell("bracket check bonded.toml");
  EXPECT_EQ(check.status, 0) << check.err;
  EXPECT_NE(check.out.find("lower.top: 0 edges, length 0 mm: bonded to upper.bottom"), std::string::npos) << check.out;
  EXPECT_NE(check.err.find(note), std::string::npos) << check.err;
  const Ended run = shell("bracket run bonded.toml --no-report");
  EXPECT_NE(run.err.find(note), std::string::npos) << run.err;
}

TEST_F(CommandLine, InfoCountsAMeshAndTellsWhatItMended) {
  // A unit square of two triangles, the second clockwise.
  write("square.msh", R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
1 1 "base"
2 2 "plate"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
3
1 1 2 1 1 1 2
2 2 2 2 1 1 2 3
3 2 2 2 1 1 4 3
$EndElements
)");
  const Ended ended = shell("bracket info square.msh");
  EXPECT_EQ(ended.status, 0) << ended.err;
  for (const char* part : {"2 cells, 4 vertices, 5 edges", "angles 45.0 to 90.0", "body plate: 2 cells, area 1",
                           "base: 1 edges, length 1", "without a name: 3 edges, length 3"})
    EXPECT_NE(ended.out.find(part), std::string::npos) << ended.out;
  EXPECT_EQ(ended.err.rfind("note: ", 0), 0u) << ended.err;
}

TEST_F(CommandLine, PipedOutputHoldsNoControlCharacters) {
  const Ended ended = shell("bracket run scene.toml");
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.err, "");
  EXPECT_EQ(ended.out.find('\033'), std::string::npos);
  EXPECT_EQ(ended.out.find('\r'), std::string::npos);
}

TEST_F(CommandLine, ATerminalGetsProgressAndColourUnlessNotWanted) {
  const std::string on_terminal = "script -qec \"'" BRACKET_PROGRAM "' run scene.toml";
  const auto holds = [](const Ended& ended, const char* part) { return ended.out.find(part) != std::string::npos; };
  const Ended plain = shell("unset NO_COLOR; " + on_terminal + "\" /dev/null");
  EXPECT_TRUE(holds(plain, "\033[1m● guaranteed error")) << plain.out;
  EXPECT_TRUE(holds(plain, "\r\033[K")) << plain.out;
  EXPECT_FALSE(holds(shell("NO_COLOR=1 " + on_terminal + "\" /dev/null"), "\033[1m"));
  EXPECT_FALSE(holds(shell(on_terminal + " --quiet\" /dev/null"), "\r\033[K"));
}

}  // namespace
}  // namespace bracket::apps::tests
