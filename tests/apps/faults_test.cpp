// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <tuple>

#include "apps/plots/picture.h"
#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// What the surroundings may do to a run: little memory, full disks, closed streams, other programs.
class Faults : public Command {
 protected:
  Faults() { write("scene.toml", two_blocks); }

  Json report() const { return Json::parse(read("scene.out/report.json")); }

  static std::string on_cells(int n) {
    std::string scene = two_blocks;
    for (std::size_t at; (at = scene.find("[4, 4]")) != std::string::npos;)
      scene.replace(at, 6, "[" + std::to_string(n) + ", " + std::to_string(n) + "]");
    return scene;
  }
};

void expect_one_line(const Ended& ended, int status, const std::string& part) {
  EXPECT_EQ(ended.status, status) << ended.err;
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(ended.err.rfind("bracket: ", 0), 0u) << ended.err;
  EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
  EXPECT_EQ(ended.err.find('\n'), ended.err.size() - 1) << ended.err;
}

void expect_interval(const Ended& ended, int status) {
  EXPECT_EQ(ended.status, status) << ended.err;
  const auto [lower, upper] = told_of("energy", ended.out);
  EXPECT_LT(lower, upper);
}

const std::string uniformly = " --set refine.strategy=uniform --set refine.max_cells=100000000";

TEST_F(Faults, WhereTheMemoryDoesNotSufficeTheLevelsSoFarStand) {
  const Ended ended = shell("ulimit -v 1000000; bracket run scene.toml --no-report" + uniformly);
  expect_interval(ended, 5);
  EXPECT_NE(ended.err.find("the memory did not suffice for "), std::string::npos) << ended.err;
  EXPECT_EQ(ended.err.find('\n'), ended.err.size() - 1) << ended.err;
  EXPECT_EQ(report()["status"], "budget_spent");
  EXPECT_GT(report()["levels"].size(), 2u);
}

TEST_F(Faults, WhereTheMemoryDoesNotSufficeForAnyLevelTheStatusIs6) {
  write("scene.toml", on_cells(2000));
  expect_one_line(shell("ulimit -v 1300000; bracket run scene.toml"), 6, "the memory did not suffice for ");
}

TEST_F(Faults, AnyLimitOfTheAddressSpaceIsMetAtOnce) {
  bool starts = false;
  for (int limit = 350000; limit <= 950000; limit += 150000) {
    const std::string within =
        "ulimit -c 0; ulimit -v " + std::to_string(limit) + "; timeout -s KILL 60 '" + BRACKET_PROGRAM + "' ";
    const bool started = shell(within + "--version").status == 0;
    EXPECT_TRUE(started || !starts) << limit;
    starts = started;
    const Ended ended = shell(within + "run scene.toml --no-report");
    if (!starts)
      EXPECT_NE(ended.status, 0) << limit;
    else if (ended.status == 0)
      expect_interval(ended, 0);
    else
      expect_one_line(ended, 6, "did not suffice for ");
  }
  EXPECT_TRUE(starts);
}

TEST_F(Faults, MemoryIsAskedForInLargePagesByTheProgramsOwnAllocator) {
  const Ended ended = shell("MALLOC_CONF=stats_print:true bracket --version");
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.err.find("opt.thp: \"always\""), std::string::npos) << ended.err;
}

TEST_F(Faults, UzawasIterationEndsWhenTheTimeIsSpent) {
  write("scene.toml", on_cells(20));
  const std::string slowly = "bracket run scene.toml --no-report --set solve.dual=uzawa --set refine.max_seconds=1";
  expect_one_line(shell(slowly), 6, "stresses: the time is spent after ");
  // Two levels take a third of the second, the next one seconds: each takes some 16 times as long as that before it.
  write("scene.toml", on_cells(2));
  const Ended ended = shell(slowly + " --set refine.target=1e-9" + uniformly);
  expect_interval(ended, 5);
  EXPECT_NE(ended.err.find("stresses: the time is spent after "), std::string::npos) << ended.err;
  EXPECT_EQ(report()["status"], "budget_spent");
}

TEST_F(Faults, AFolderInUseIsRefused) {
  const Ended ended = shell("'" BRACKET_PROGRAM "' run scene.toml" + std::string(endlessly) +
                            R"( >/dev/null 2>&1 & first=$!
until [ -e scene.out/report.json ]; do sleep 0.02; done
bracket run scene.toml
echo $?
kill -9 $first
wait $first)");
  EXPECT_EQ(ended.out, "2\n");
  EXPECT_NE(ended.err.find("scene.out: is in use by another run"), std::string::npos) << ended.err;
  expect_interval(shell("bracket run scene.toml"), 0);  // a run that was killed keeps nothing
}

TEST_F(Faults, SymbolicLinksAreNotWrittenThrough) {
  for (const char* name : {".bracket", "report.json", "mesh.svg", "report.html", "history.csv.part"}) {
    const std::string link = "scene.out/" + std::string(name);
    shell("rm -rf scene.out; mkdir scene.out; echo mine > mine; touch scene.out/.bracket; ln -sf ../mine " + link);
    expect_one_line(shell("bracket run scene.toml"), 2, link + ": is a symbolic link");
    EXPECT_EQ(read("mine"), "mine\n") << name;
  }
}

TEST_F(Faults, ALinkMadeDuringTheRunIsNotWrittenThrough) {
  shell("echo mine > mine; '" BRACKET_PROGRAM "' run scene.toml" + std::string(endlessly) + R"( >/dev/null 2>&1 & run=$!
until [ -e scene.out/report.json ]; do sleep 0.02; done
for name in history.csv history.csv.part solution_5.vtu; do ln -sf ../mine scene.out/$name; done
until [ -e scene.out/solution_6.vtu ] || ! kill -0 $run; do sleep 0.02; done
kill -9 $run
wait $run)");
  EXPECT_TRUE(fs::exists(directory / "scene.out/solution_6.vtu"));
  EXPECT_EQ(read("mine"), "mine\n");
}

TEST_F(Faults, NothingDependsOnStandardError) {
  for (const char* where : {"2>&-", "2>/dev/full"}) {
    const std::string to = " " + std::string(where);
    expect_interval(shell("bracket run scene.toml --set refine.target=1e-9" + to), 5);
    expect_interval(shell("PATH=/nowhere; bracket run scene.toml" + to), 0);
    EXPECT_EQ(shell("bracket run nowhere.toml" + to).status, 2);
  }
  const Ended piped = shell("{ bracket run scene.toml --set refine.target=1e-9 3>&1 1>&2 2>&3; echo $? >&2; } | true");
  EXPECT_EQ(piped.err.substr(piped.err.size() - 2), "5\n");
}

TEST_F(Faults, StandardOutputIsNeeded) {
  for (const char* where : {">&-", ">/dev/full"})
    expect_one_line(shell("bracket run scene.toml --no-report " + std::string(where)), 2, "standard output");
}

TEST_F(Faults, ADiskThatIsFullAfterTheFirstLevelLeavesTheReport) {
  const std::string run =
      "; bracket run scene.toml --set solve.degree=1 --set refine.strategy=adaptive --set refine.max_levels=2"
      " --set refine.target=1e-9";
  // In blocks of 512 bytes: the fields of the first level fit, and here those of the second do not, there, on fewer
  // cells, the report.
  const std::string few = " --set 'mesh.block.0.cells=[1, 1]' --set 'mesh.block.1.cells=[1, 1]'";
  for (const auto& [blocks, cells, missing] :
       {std::tuple("270", std::string(), "solution_1.vtu"), std::tuple("100", few, "report.html")}) {
    const Ended ended = shell("ulimit -f " + std::string(blocks) + run + cells);
    expect_interval(ended, 5);
    EXPECT_NE(ended.err.find("note: scene.out/" + std::string(missing) + ".part: cannot be written: File too large\n"),
              std::string::npos)
        << ended.err;
    EXPECT_EQ(report()["status"], "budget_spent");
    EXPECT_EQ(report()["levels"].size(), 2u);
    EXPECT_FALSE(fs::exists(directory / "scene.out" / missing));
    EXPECT_EQ(shell("ls scene.out").out.find(".part"), std::string::npos);
  }
}

TEST_F(Faults, AGnuplotThatHangsIsKilled) {
  shell(R"(mkdir bin
printf '#!/bin/sh\ntrap "" TERM\necho $$ > pid\nsleep 1000\nsleep 1000\n' > bin/gnuplot
chmod +x bin/gnuplot)");
  const std::string path = std::getenv("PATH");
  const fs::path before = fs::current_path();
  fs::current_path(directory);
  setenv("PATH", ("bin:" + path).c_str(), 1);
  const auto start = std::chrono::steady_clock::now();
  const Drawings drawings = draw({{"mesh", "", 1, 1, ""}}, false, std::chrono::seconds(1));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  setenv("PATH", path.c_str(), 1);
  fs::current_path(before);
  EXPECT_TRUE(drawings.drawn.empty());
  EXPECT_EQ(drawings.missing, std::vector<std::string>{"mesh.svg: gnuplot did not end within 1 s"});
  EXPECT_LT(seconds.count(), 5);
  EXPECT_NE(shell("kill -0 $(cat pid)").status, 0);
}

TEST_F(Faults, APictureCutShortIsNotTaken) {
  shell("mkdir bin && printf '#!/bin/sh\\necho \"<svg>\"\\n' > bin/gnuplot && chmod +x bin/gnuplot");
  const Ended ended = shell("PATH=\"$PWD/bin:$PATH\"; bracket run scene.toml");
  expect_interval(ended, 0);
  EXPECT_NE(ended.err.find("note: mesh.svg: gnuplot failed: the picture is cut short\n"), std::string::npos)
      << ended.err;
}

}  // namespace
}  // namespace bracket::apps::tests
