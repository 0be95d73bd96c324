// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <signal.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

class Levels : public Command {
 protected:
  Levels() { write("scene.toml", two_blocks); }

  Json report() const { return Json::parse(read("scene.out/report.json")); }

  // As many levels in every place that tells of them.
  void expect_levels(std::size_t n) const {
    EXPECT_EQ(report()["levels"].size(), n);
    const std::string history = read("scene.out/history.csv"), collection = read("scene.out/solution.pvd");
    EXPECT_EQ(std::ranges::count(history, '\n'), static_cast<std::ptrdiff_t>(n + 1));
    const std::regex entry(R"re(timestep="(\d+)" part="\d" file="((solution|contact)_\1\.vtu)")re");
    std::sregex_iterator found(collection.begin(), collection.end(), entry), none;
    EXPECT_EQ(std::distance(found, none), static_cast<std::ptrdiff_t>(2 * n));
    for (; found != none; ++found) EXPECT_TRUE(fs::exists(directory / "scene.out" / (*found)[2].str()));
  }
};

const std::string to_a_twentieth = " --set refine.strategy=adaptive --set refine.target=0.05";

TEST_F(Levels, TheRunsIntervalIsTheIntersectionOfItsLevels) {
  const Ended ended = shell("bracket run scene.toml" + to_a_twentieth);
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Json json = report();
  ASSERT_GT(json["levels"].size(), 2u);
  expect_levels(json["levels"].size());
  double lower = -INFINITY, upper = INFINITY;
  for (const Json& level : json["levels"]) {
    lower = std::max(lower, level["lower"].get<double>());
    upper = std::min(upper, level["upper"].get<double>());
  }
  EXPECT_EQ(json["energy"]["lower"], lower);
  EXPECT_EQ(json["energy"]["upper"], upper);
  EXPECT_LE(json["relative_error_bound"], 0.05);
  EXPECT_NEAR(json["relative_width"], (upper - lower) / -lower, 1e-15);
  EXPECT_NEAR(json["error_bound"], std::sqrt(2 * (upper - lower)), 1e-15);
  EXPECT_EQ(json["status"], "done");
}

TEST_F(Levels, TheHeadlineIsRoundedUp) {
  const Ended ended = shell("bracket run scene.toml --quiet" + to_a_twentieth);
  std::smatch match;
  ASSERT_TRUE(std::regex_search(ended.out, match, std::regex("guaranteed error  ≤ (.*) %[^]*energy .*± (.*) %")));
  const Json json = report();
  for (const auto& [told, exact] : {std::pair(std::stod(match[2]) / 50, json["relative_width"].get<double>()),
                                    std::pair(std::stod(match[1]) / 100, json["relative_error_bound"].get<double>())}) {
    EXPECT_GE(told, exact * (1 - 1e-14));
    EXPECT_LE(told, exact * 1.1);  // two digits
  }
}

TEST_F(Levels, PhasesAddUpToNoMoreThanTheTimeOfTheirFormulation) {
  ASSERT_EQ(shell("bracket run scene.toml" + to_a_twentieth).status, 0);
  const Json json = report();
  double before = json["seconds"]["read"];
  for (const Json& level : json["levels"]) {
    const Json& seconds = level["seconds"];
    for (const std::string formulation : {"primal", "dual"}) {
      double sum = 0;
      for (const char* phase : {"assemble", "order", "factorise", "contact", "recover"}) {
        EXPECT_GE(seconds[formulation + "_phases"][phase], 0);
        sum += seconds[formulation + "_phases"][phase].get<double>();
      }
      EXPECT_GT(sum, 0);
      EXPECT_LE(sum, 1.01 * seconds[formulation].get<double>() + 1e-3) << formulation;
    }
    EXPECT_GT(seconds["write"], 0);
    // Levels follow one another: what has elapsed holds the level and all that was before.
    EXPECT_GE(seconds["elapsed"], before + 0.9 * seconds["total"].get<double>());
    before = seconds["elapsed"].get<double>() + seconds["write"].get<double>();
  }
}

TEST_F(Levels, AKilledRunLeavesWhatItHad) {
  const Ended ended = signalled(std::string("run scene.toml") + endlessly, "scene.out/history.csv", 4, SIGKILL);
  EXPECT_EQ(ended.status, -SIGKILL);
  const Json json = report();
  EXPECT_EQ(json["status"], "running");
  EXPECT_GE(json["levels"].size(), 2u);  // that of the third level may have been under way
  for (const Json& level : json["levels"]) EXPECT_LT(level["lower"], level["upper"]);
  const std::string history = read("scene.out/history.csv");
  EXPECT_GE(std::ranges::count(history, '\n'), 4);
  EXPECT_EQ(history.back(), '\n');
  EXPECT_TRUE(fs::exists(directory / "scene.out/solution_2.vtu"));
}

TEST_F(Levels, AnInterruptedRunEndsWithAReportOfItsLevels) {
  const Ended ended = signalled(std::string("run scene.toml") + endlessly, "scene.out/history.csv", 4, SIGINT);
  EXPECT_EQ(ended.status, 5) << ended.err;
  EXPECT_NE(ended.err.find("stopping after this level"), std::string::npos) << ended.err;
  EXPECT_LT(told_of("energy", ended.out).first, told_of("energy", ended.out).second);
  const Json json = report();
  EXPECT_EQ(json["status"], "budget_spent");
  EXPECT_NE(json["reason"].get<std::string>().find("stopped on request"), std::string::npos);
  EXPECT_GE(json["levels"].size(), 3u);
  expect_levels(json["levels"].size());
  EXPECT_TRUE(fs::exists(directory / "scene.out/report.html"));
}

TEST_F(Levels, ASecondInterruptEndsAtOnce) {
  // Both arrive while the first, long level is being solved.
  std::string fine = two_blocks;
  for (std::size_t at; (at = fine.find("[4, 4]")) != std::string::npos;) fine.replace(at, 6, "[150, 150]");
  write("scene.toml", fine);
  const Ended ended = shell("env --default-signal=INT '" BRACKET_PROGRAM
                            "' run scene.toml & sleep 0.7; kill -INT $!; sleep 0.3; kill -INT $!; wait $!; echo $?");
  EXPECT_EQ(ended.out, "130\n");
  EXPECT_FALSE(fs::exists(directory / "scene.out/report.json"));
}

}  // namespace
}  // namespace bracket::apps::tests
