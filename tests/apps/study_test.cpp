// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <signal.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

using Json = nlohmann::json;

class Study : public Command {
 protected:
  Study() { write("scene.toml", two_blocks); }
  Json study() const { return Json::parse(read("scene.study/study.json")); }
};

TEST_F(Study, ComparesEightWaysOfRefining) {
  // The target does not end it: each goes on to its budget.
  const Ended ended = shell("bracket study scene.toml --set refine.max_cells=1100 --set refine.target=0.5");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  EXPECT_LE(widest(ended.out), 80u) << ended.out;
  const Json json = study();
  ASSERT_EQ(json["series"].size(), 8u);
  std::size_t levels = 0;
  double lowest_upper = INFINITY, highest_lower = -INFINITY;
  for (const Json& series : json["series"]) {
    levels += series["levels"].size();
    EXPECT_GT(series["levels"].back()["cells"].get<int>(), 275);
    for (const Json& level : series["levels"]) {
      EXPECT_LE(level["cells"], 1100);
      lowest_upper = std::min(lowest_upper, level["upper"].get<double>());
      highest_lower = std::max(highest_lower, level["lower"].get<double>());
    }
    EXPECT_TRUE(std::ranges::is_sorted(series["levels"], {},
                                       [](const Json& l) { return l["seconds"]["elapsed"].get<double>(); }));
  }
  EXPECT_LT(highest_lower, lowest_upper);  // all enclose one energy
  // 64, 256 and 1024 cells: the order over the last half is that of the last two.
  const Json& uniform = json["series"][1];
  EXPECT_EQ(uniform["strategy"], "uniform");
  EXPECT_EQ(uniform["degree"], 2);
  ASSERT_EQ(uniform["levels"].size(), 3u);
  const auto error = [&](int level) { return uniform["levels"][level]["relative_error_bound"].get<double>(); };
  EXPECT_NEAR(uniform["order"], std::log(error(2) / error(1)) / std::log(4), 1e-12);
  // What refinement is for (with quadratics: the order of linears is the same in the energy, but not the constant).
  EXPECT_LT(json["series"][5]["order"], uniform["order"]);

  const std::string table = read("scene.study/study.csv"), plot = read("scene.study/study.svg");
  EXPECT_EQ(std::ranges::count(table, '\n'), static_cast<std::ptrdiff_t>(levels + 1));
  for (const char* name : {"uniform, degree 1", "uniform, degree 4", "adaptive, degree 2", "adaptive, degree 3"}) {
    EXPECT_NE(plot.find(name), std::string::npos) << name;
    EXPECT_NE(ended.out.find(name), std::string::npos) << name;
  }
}

TEST_F(Study, SaysSoWhereLevelsAreTooFewForAnOrder) {
  const Ended ended = shell("bracket study scene.toml --set refine.max_levels=1");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("too few levels"), std::string::npos);
  EXPECT_TRUE(study()["series"][0]["order"].is_null());
}

TEST_F(Study, ATargetThatNothingReachesIsStatus5) {
  const Ended ended = shell("bracket study scene.toml --set refine.max_levels=2 --set refine.target=1e-9");
  EXPECT_EQ(ended.status, 5) << ended.err;
  EXPECT_NE(ended.err.find("no way of refining reaches the target 1e-09"), std::string::npos) << ended.err;
  EXPECT_NE(ended.out.find("too few levels"), std::string::npos) << "two levels have no order: " << ended.out;
}

TEST_F(Study, FollowsTheRulesOfFolders) {
  shell("mkdir full && echo mine > full/study.csv");
  const Ended ended = shell("bracket study scene.toml -o full");
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(read("full/study.csv"), "mine\n");
}

TEST_F(Study, AnInterruptedOneTellsWhatItHas) {
  const Ended ended = signalled(std::string("study scene.toml") + endlessly, "scene.study/study.csv", 3, SIGINT);
  EXPECT_EQ(ended.status, 5) << ended.err;
  const Json json = study();
  ASSERT_EQ(json["series"].size(), 1u);
  EXPECT_NE(json["series"][0]["end"].get<std::string>().find("stopped on request"), std::string::npos);
  EXPECT_GE(json["series"][0]["levels"].size(), 2u);
  EXPECT_NE(ended.out.find("uniform, degree 1"), std::string::npos);
}

}  // namespace
}  // namespace bracket::apps::tests
