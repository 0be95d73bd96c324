// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Displacements by several processes of MPI.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/apps/command.h"
#include "tests/apps/space/scenes.h"

namespace bracket::apps::tests {
namespace {

using Json = nlohmann::json;

class OnRanks : public Command {
 protected:
  OnRanks() { write("boxes.toml", two_boxes); }
  /// The levels of a run. \param ranks 0: without
  Json levels(int ranks, const std::string& arguments) const {
    const std::string how = ranks > 0 ? fmt::format(" --ranks {}", ranks) : "";
    const Ended ended = shell("bracket run boxes.toml --json --no-report " + arguments + how);
    EXPECT_EQ(ended.status, 0) << ended.err;
    return Json::parse(ended.out)["levels"];
  }
  /// Has a signal sent to a run without end on two processes, once `condition` holds, a command of the shell.
  /// \param whom $run, the command itself, or $1 or $2, one of the processes
  /// \return as the command ended; on standard output, too, which of the processes are still there
  Ended signalled_once(const std::string& condition, const std::string& signal, const std::string& whom) const {
    return shell("rm -rf boxes.out; exec '" BRACKET_PROGRAM "' boxes.toml --no-report --json --quiet --ranks 2" +
                 std::string(endlessly) +
                 R"( & run=$!
children() { cat /proc/$1/task/*/children 2>/dev/null; }
until set -- $(for mpirun in $(children $run); do children $mpirun; done); [ $# -ge 2 ] && )" +
                 condition + "; do sleep 0.02; done; kill -" + signal + " " + whom +
                 "; wait $run; status=$?; for one; do grep -s State:.*[RSD] /proc/$one/status; done; exit $status");
  }
};

constexpr const char* at_once = "true";
constexpr const char* after_a_level = "[ $(cat boxes.out/history.csv 2>/dev/null | wc -l) -ge 2 ]";

// Both intervals hold the energy of one problem, and each level's displacements are those of one mesh: its upper bounds
// are the same number but for what the solvers leave, which is far below the width.
TEST_F(OnRanks, IntervalsMeetTheSerialOnes) {
  const std::string uniform = "--set refine.strategy=uniform --set refine.max_levels=2";
  const Json serial = levels(0, uniform);
  for (const int ranks : {1, 2, 4}) {
    const Json shared = levels(ranks, uniform);
    ASSERT_EQ(shared.size(), serial.size());
    for (std::size_t i = 0; i < serial.size(); ++i) {
      const double lower = serial[i]["lower"], upper = serial[i]["upper"];
      EXPECT_LE(shared[i]["lower"].get<double>(), upper) << ranks;
      EXPECT_GE(shared[i]["upper"].get<double>(), lower) << ranks;
      EXPECT_NEAR(shared[i]["upper"].get<double>(), upper, 1e-6 * (upper - lower)) << ranks;
      EXPECT_EQ(shared[i]["cells"], serial[i]["cells"]);
    }
  }
}

// More than the 20 000 unknowns up to which they are found by a factorisation.
TEST_F(OnRanks, ConjugateGradientsMeetTheFactorisation) {
  const std::string fine =
      "--set refine.strategy=none --set mesh.block.0.cells=[9,9,5] --set mesh.block.1.cells=[9,9,5]";
  const Json serial = levels(0, fine), shared = levels(2, fine);
  const double lower = serial[0]["lower"], upper = serial[0]["upper"];
  EXPECT_GT(shared[0]["primal_dofs"].get<int>(), 20000);
  EXPECT_NEAR(shared[0]["upper"].get<double>(), upper, 1e-6 * (upper - lower));
  EXPECT_LE(shared[0]["lower"].get<double>(), upper);
}

TEST_F(OnRanks, WhatProcessesDoNotKnowIsRefusedBeforeAnythingIsSolved) {
  write("blocks.toml", two_blocks);
  write("asks.toml", std::string(two_boxes) +
                         "[[quantity]]\nname = \"lift\"\ndisplacement = \"upper.top\"\n"
                         "direction = [0, 1, 0]\n");
  write("cube.toml",
        "schema = 1\ndim = 3\n[[mesh.block]]\nbody = \"b\"\nx = [0, 1]\ny = [0, 1]\nz = [0, 1]\ncells = [1, 1, 1]\n"
        "[bodies.b]\nE = 1\nnu = 0.3\n[boundary.\"b.left\"]\nfixed = [0, 0, 0]\n");
  for (const char* command :
       {"bracket run --ranks 2 blocks.toml", "bracket run --ranks 2 asks.toml", "bracket run --ranks 7 cube.toml",
        "bracket run --ranks 0 boxes.toml", "bracket run --ranks two boxes.toml",
        "PATH=/nowhere '" BRACKET_PROGRAM "' run --ranks 2 boxes.toml"}) {
    const Ended ended = shell(command);
    EXPECT_EQ(ended.status, 2) << command;
    EXPECT_EQ(ended.out, "") << command;
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
    EXPECT_EQ(ended.err.find("bracket: "), 0u) << ended.err;
  }
}

// A floating body is pulled off: nothing holds it, whoever solves.
TEST_F(OnRanks, LoadsThatNothingBalancesAreRefusedAsByOne) {
  const std::string pulled = "bracket boxes.toml --no-report --set boundary.upper.top.traction=[0,0.1,0]";
  EXPECT_EQ(shell(pulled).status, 4);
  const Ended ended = shell(pulled + " --quiet --ranks 2");
  EXPECT_EQ(ended.status, 4) << ended.err;
  EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
}

TEST_F(OnRanks, AProcessThatDiesEndsTheRunInOneLineAndItsLevelsHold) {
  for (const char* process : {"$1", "$2"}) {
    const Ended early = signalled_once(at_once, "KILL", process);
    EXPECT_EQ(early.status, 6) << early.err;
    EXPECT_EQ(std::ranges::count(early.err, '\n'), 1) << early.err;
    EXPECT_EQ(Json::parse(early.out)["status"], "not_guaranteed");
    const Ended late = signalled_once(after_a_level, "KILL", process);
    EXPECT_EQ(late.status, 5) << late.err;
    EXPECT_EQ(std::ranges::count(late.err, '\n'), 1) << late.err;
    EXPECT_NE(late.err.find("report.json"), std::string::npos) << late.err;
    const Json json = Json::parse(read("boxes.out/report.json"));
    EXPECT_GE(json["levels"].size(), 1u);
    for (const Json& level : json["levels"]) EXPECT_LT(level["lower"], level["upper"]);
  }
}

// OpenBLAS tries for ever where it gets no memory; a run does not, wherever the memory is too little for it.
TEST_F(OnRanks, LittleMemoryEndsTheRunInOneLine) {
  for (const int limit : {300000, 430000, 500000}) {
    const Ended ended = shell("ulimit -c 0; ulimit -v " + std::to_string(limit) +
                              "; timeout 120 '" BRACKET_PROGRAM
                              "' boxes.toml --no-report --json --quiet --ranks 2 --set refine.strategy=none "
                              "--set mesh.block.0.cells=[6,6,3] --set mesh.block.1.cells=[6,6,3]");
    EXPECT_TRUE(ended.status == 0 || ended.status == 6) << ended.status;
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), ended.status == 0 ? 0 : 1) << ended.err;
    if (ended.status == 6) {
      EXPECT_EQ(Json::parse(ended.out)["status"], "not_guaranteed");
    }
  }
}

TEST_F(OnRanks, WhoEndsTheCommandEndsItsProcesses) {
  const Ended ended = signalled_once(after_a_level, "TERM", "$run");
  EXPECT_EQ(ended.status, 128 + 15);
  EXPECT_EQ(ended.out, "");
}

TEST_F(OnRanks, TheProgramItselfLoadsNeitherPetscNorMpi) {
  const std::string loaded = shell("ldd '" BRACKET_PROGRAM "'").out;
  EXPECT_NE(loaded.find("bracket_primal"), std::string::npos) << loaded;
  for (const char* library : {"petsc", "libmpi"}) EXPECT_EQ(loaded.find(library), std::string::npos) << loaded;
}

}  // namespace
}  // namespace bracket::apps::tests
