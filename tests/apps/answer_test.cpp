// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "apps/report/report.h"
#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class Answer : public Command {
 protected:
  Answer() { write("scene.toml", two_blocks); }

  Json report_json() const { return Json::parse(read("scene.out/report.json")); }
};

/// The fields of the lines of a CSV file, without their quotes.
std::vector<std::vector<std::string>> table(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  const std::regex field("(?:\"([^\"]*)\"|([^,]*)),");
  for (std::string line; std::getline(lines, line);) {
    auto& row = rows.emplace_back();
    line += ",";
    for (std::sregex_iterator found(line.begin(), line.end(), field), none; found != none; ++found)
      row.push_back((*found)[1].str() + (*found)[2].str());
  }
  return rows;
}

TEST_F(Answer, FitsATerminalOnEveryScene) {
  int scenes = 0;
  for (const auto& entry : fs::directory_iterator(BRACKET_SCENES)) {
    if (entry.path().extension() != ".toml") continue;
    ++scenes;
    const std::string scene = "'" + entry.path().string() + "'";
    const Ended run = shell("bracket " + scene + " --no-report -o out --set refine.max_cells=1500");
    EXPECT_NE(run.out.find("\n● energy"), std::string::npos) << scene << run.err;
    EXPECT_LE(widest(run.out), 80u) << run.out;
    const Ended check = shell("bracket check " + scene);
    EXPECT_LE(widest(check.out), 80u) << check.out;
    EXPECT_EQ(run.out.find(" 1 iterations"), std::string::npos) << run.out;
  }
  EXPECT_GT(scenes, 15);
}

TEST_F(Answer, HasARowOfEachLevelBeforeIt) {
  const Ended ended =
      shell("bracket run scene.toml --no-report --set refine.strategy=uniform --set refine.max_levels=3");
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Json levels = report_json()["levels"];
  const std::regex row("\n +(\\d+) +(\\d+) +([^%]*) %  (\\S+) … (\\S+) +(\\S+)(?=\n)");
  std::sregex_iterator found(ended.out.begin(), ended.out.end(), row);
  double lower = -INFINITY, upper = INFINITY;
  for (std::size_t i = 0; i < 3; ++i, ++found) {
    ASSERT_NE(found, std::sregex_iterator()) << ended.out;
    EXPECT_EQ((*found)[1], std::to_string(i));
    EXPECT_EQ(std::stoi((*found)[2]), levels[i]["cells"]);
    lower = std::max(lower, levels[i]["lower"].get<double>());
    upper = std::min(upper, levels[i]["upper"].get<double>());
    EXPECT_LE(std::stod((*found)[4]), lower);
    EXPECT_GE(std::stod((*found)[5]), upper);
    EXPECT_LT(static_cast<std::size_t>(found->position()), ended.out.find("● guaranteed error"));
  }
  EXPECT_EQ(found, std::sregex_iterator());
}

TEST_F(Answer, RowsAreThereAsSoonAsTheirLevelIs) {
  const Ended killed =
      signalled(std::string("run scene.toml --no-report") + endlessly, "scene.out/history.csv", 4, SIGKILL);
  EXPECT_EQ(killed.status, -SIGKILL);
  EXPECT_GE(std::ranges::count(killed.out, '\n'), 5) << killed.out;  // title, scene, blank, names, …
  EXPECT_EQ(killed.out.find("●"), std::string::npos) << killed.out;
}

TEST_F(Answer, TextTableAndJsonHaveTheSameRows) {
  const Ended ended = shell(
      "bracket run scene.toml --set quantity='[{force = \"upper.bottom\"}, {reaction = \"lower.bottom\", "
      "direction = [0, 2]}]' --set refine.strategy=uniform --set refine.max_levels=3");
  ASSERT_EQ(ended.status, 0) << ended.err;
  const auto rows = table(read("scene.out/contact.csv"));
  const Json json = report_json();
  const std::string html = read("scene.out/report.html"), text = unbroken(ended.out);
  ASSERT_GT(rows.size(), 10u);
  std::vector<std::string> guaranteed;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto& row = rows[i];
    ASSERT_EQ(row.size(), rows[0].size());
    const std::string &of = row[0], &key = row[1], &standing = row[2];
    std::string words = std::regex_replace(key, std::regex("_"), " ");
    words = std::regex_replace(words, std::regex(" mises"), " Mises");
    const std::string mark = standing == "guaranteed" ? "●" : "○";
    EXPECT_TRUE(std::regex_search(text, std::regex(mark + " " + standing + " +" + words + " +[-0-9]")))
        << words << text;
    EXPECT_NE(html.find(words), std::string::npos) << words;
    EXPECT_NE(html.find(mark + " " + standing), std::string::npos);
    if (standing == "guaranteed") guaranteed.push_back(key);
    const Json& subject =
        of.starts_with("contact") ? json["contact"][0]
        : of.starts_with("support")
            ? *std::ranges::find_if(json["supports"],
                                    [&](const Json& one) { return "support " + one["part"].get<std::string>() == of; })
            : json["bodies"];
    if (row[3].empty()) continue;  // nothing was computed
    ASSERT_TRUE(subject.contains(key)) << key;
    EXPECT_EQ(subject[key], std::stod(row[3])) << key;
    EXPECT_EQ(subject.contains(key + "_bounds"), standing == "guaranteed") << key;
    if (standing == "guaranteed") {
      // By statics forces are the exact ones on every mesh, but for rounding.
      EXPECT_LE(subject[key + "_bounds"]["lower"].get<double>(), std::stod(row[3]) + 1e-15);
      EXPECT_GE(subject[key + "_bounds"]["upper"].get<double>(), std::stod(row[3]) - 1e-15);
      EXPECT_EQ(subject[key + "_bounds"]["lower"], std::stod(row[4]));
    }
  }
  for (const char* key : {"force", "largest_penetration", "reaction_y"})
    EXPECT_EQ(std::ranges::count(guaranteed, key), 1) << key;
  EXPECT_EQ(std::ranges::count(guaranteed, "reaction_x"), 0);
}

// σ_xx = y up to ½, so that with σ_zz = ν σ_xx the stress is ½ √(1 − ν + ν²), in plane stress ½.
TEST_F(Answer, VonMisesStressKnowsTheStressAcrossThePlane) {
  write("beam.toml", bending);
  ASSERT_EQ(shell("bracket run beam.toml --no-report").status, 0);
  const auto largest = [&] { return Json::parse(read("beam.out/report.json"))["bodies"]; };
  const double nu = 0.25;
  EXPECT_NEAR(largest()["largest_von_mises_stress"], 0.5 * std::sqrt(1 - nu + nu * nu), 1e-11);
  EXPECT_NEAR(std::abs(largest()["largest_von_mises_stress_at"][1].get<double>()), 0.5, 1e-12);
  ASSERT_EQ(shell("bracket run beam.toml --no-report --set plane=stress").status, 0);
  EXPECT_NEAR(largest()["largest_von_mises_stress"], 0.5, 1e-11);
  // A stiffness of the plane alone does not tell it.
  std::string unknown = bending;
  unknown.replace(unknown.find("E = 3.0\nnu = 0.25"), 17, "stiffness = [[4, 1, 0], [1, 4, 0], [0, 0, 1]]");
  write("beam.toml", unknown);
  ASSERT_EQ(shell("bracket run beam.toml --no-report").status, 0);
  EXPECT_FALSE(largest().contains("largest_von_mises_stress"));
}

TEST_F(Answer, UnitsStandBehindEveryNumberOfIt) {
  const Ended known = shell("bracket run scene.toml --no-report");
  EXPECT_TRUE(std::regex_search(known.out, std::regex("● energy .* N mm/mm   ±"))) << known.out;
  EXPECT_TRUE(std::regex_search(known.out, std::regex("largest pressure +\\S+ MPa at \\(\\S+, \\S+\\) mm")))
      << known.out;
  const Ended unknown = shell("bracket run scene.toml --no-report --set 'units=\"of my own\"'");
  EXPECT_NE(unknown.out.find("; units of my own\n"), std::string::npos) << unknown.out;
  EXPECT_EQ(unknown.out.find(" MPa"), std::string::npos) << unknown.out;
}

TEST_F(Answer, LastLevelAloneHasItsFieldsWritten) {
  const Ended ended =
      shell("bracket run scene.toml --no-report --last-level --set refine.strategy=uniform --set refine.max_levels=3");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(shell("ls scene.out/*.vtu").out, "scene.out/contact_2.vtu\nscene.out/solution_2.vtu\n");
  const std::string collection = read("scene.out/solution.pvd");
  EXPECT_NE(collection.find("solution_2.vtu"), std::string::npos);
  EXPECT_EQ(collection.find("solution_1.vtu"), std::string::npos);
}

TEST_F(Answer, ManyStepsOfTheActiveSetAreTold) {
  const scene::Scene<2> scene = scene::read_scene<2>(directory / "scene.toml");
  bounds::Outcome<2> outcome = bounds::run(scene);
  const auto told = [&] { return report_text(apps::report(scene, outcome)); };
  EXPECT_EQ(told().find("which is many"), std::string::npos);
  outcome.levels.back().dual.iterations = 31;
  EXPECT_NE(told().find("took 31 steps on one level, which is many"), std::string::npos) << told();
  outcome.levels.back().primal.iterations = 1;
  EXPECT_NE(told().find("found in one step\n"), std::string::npos) << told();
}

TEST_F(Answer, NothingIsSaidOfAnOpenPartThatMightCarryAll) {
  // Closed all along: gaps are those between nodes.
  const Ended closed = shell("bracket run scene.toml --no-report --set 'boundary.\"upper.top\".traction=[0, -0.1]'");
  EXPECT_EQ(closed.out.find("open part"), std::string::npos) << closed.out;
  const Ended lifted =
      shell("bracket run scene.toml --no-report --set refine.strategy=uniform --set refine.max_levels=4");
  EXPECT_NE(lifted.out.find("● guaranteed  force of the open part"), std::string::npos) << lifted.out;
}

}  // namespace
}  // namespace bracket::apps::tests
