// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <utility>
#include <vector>

#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

using Json = nlohmann::json;

class Report : public Command {
 protected:
  Report() {
    write("contact.toml", two_blocks);
    write("bending.toml", bending);
  }
};

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream in(line);
  for (std::string word; std::getline(in, word, ',');) words.push_back(word);
  return words;
}

// What the data as the first mesh has them leave out is bounded: here a load of 1000 on a width of 0.001.
TEST_F(Report, TheFirstLineNamesDataThatTheMeshDoesNotCarry) {
  write("spike.toml", R"(schema = 1
[[mesh.block]]
body = "b"
x = [0, 1]
y = [0, 1]
cells = [4, 4]
[bodies.b]
E = 1
nu = 0.3
[boundary]
"b.bottom" = { sliding = 0 }
"b.left" = { sliding = 0 }
"b.right" = { sliding = 0 }
"b.top" = { traction = ["0", "-1-(abs(x-0.2505)<0.0005)*1e6"] }
)");
  const Ended named = shell("bracket run spike.toml --no-report");
  EXPECT_EQ(named.status, 0) << named.err;
  EXPECT_LT(named.out.find("\n! for the data of 'b.top' as the first mesh has them"), named.out.find("● "))
      << named.out;
  const Ended resolved =
      shell("bracket run spike.toml --no-report --set refine.strategy=adaptive --set refine.target=0.05");
  EXPECT_EQ(resolved.status, 0) << resolved.err;
  EXPECT_EQ(resolved.out.find("\n! "), std::string::npos) << resolved.out;
  EXPECT_NE(resolved.err.find("the first mesh was refined"), std::string::npos) << resolved.err;
}

TEST_F(Report, ARigidTurnHasNoErrorToTell) {
  write("turned.toml", R"(schema = 1
mesh.block = [{ body = "a", x = [0, 1], y = [0, 1], cells = [4, 4] }]
bodies.a = { E = 210e3, nu = 0.3 }
boundary."a.left" = { fixed = ["0.1 - 0.3*y", "0.7 + 0.3*x"] }
refine = { strategy = "adaptive", target = 0.01 }
)");
  const Ended ended = shell("bracket run turned.toml");
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("● guaranteed error  nothing is strained"), std::string::npos) << ended.out;
  EXPECT_EQ(ended.out.find('%'), std::string::npos) << ended.out;
  EXPECT_TRUE(Json::parse(read("turned.out/report.json"))["relative_error_bound"].is_null());
}

TEST_F(Report, JsonAndTableTellTheSameDoublesTheTextRoundsThemOutward) {
  const Ended ended = shell("bracket run contact.toml");
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Json json = Json::parse(read("contact.out/report.json"));
  const double lower = json["energy"]["lower"], upper = json["energy"]["upper"];
  EXPECT_LT(lower, upper);
  const auto told = told_of("energy", ended.out);
  EXPECT_LE(told.first, lower);
  EXPECT_GE(told.second, upper);
  EXPECT_LT(told.second - told.first, 1.2 * (upper - lower));

  std::istringstream table(read("contact.out/history.csv"));
  std::string names, values, more;
  std::getline(table, names);
  std::getline(table, values);
  EXPECT_FALSE(std::getline(table, more)) << "one level only";
  const std::vector<std::string> name = split(names), value = split(values);
  ASSERT_EQ(name.size(), value.size());
  int compared = 0;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const Json& level = json["levels"][0];
    if (!level.contains(name[i])) continue;  // the table is flat: it has contact_rows for contact.rows
    ++compared;
    EXPECT_EQ(level[name[i]].get<double>(), std::stod(value[i])) << name[i];
  }
  EXPECT_GT(compared, 3);
}

TEST_F(Report, JsonHasItsFields) {
  ASSERT_EQ(shell("bracket run contact.toml").status, 0);
  const Json json = Json::parse(read("contact.out/report.json"));
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["title"], "Two blocks");
  EXPECT_EQ(json["units"], "N, mm, MPa");
  EXPECT_EQ(json["guarantee"], "rounding-safe");
  EXPECT_EQ(json["status"], "done");
  EXPECT_EQ(json["notes"], Json::array());
  EXPECT_TRUE(json["version"].is_string());
  ASSERT_EQ(json["levels"].size(), 1u);
  const Json& level = json["levels"][0];
  EXPECT_EQ(level["cells"], 64);
  EXPECT_EQ(level["lower"], json["energy"]["lower"]);
  EXPECT_EQ(level["upper"], json["energy"]["upper"]);
  EXPECT_EQ(level["relative_error_bound"], json["relative_error_bound"]);
  for (const char* phase : {"mesh", "primal", "dual", "estimate", "total"})
    EXPECT_TRUE(level["seconds"][phase].is_number()) << phase;
  EXPECT_GE(level["contact"]["rows"], level["contact"]["active"]);
  EXPECT_GT(level["contact"]["active"], 0);
  EXPECT_GE(level["contact"]["iterations"], 1);
  for (const char* check :
       {"penetration", "equilibrium", "interface_jump", "boundary_traction", "tension", "gap_identity"}) {
    ASSERT_TRUE(json["checks"][check].is_number()) << check;
    EXPECT_LE(json["checks"][check], json["checks"]["tolerance"]) << check;
  }
  EXPECT_TRUE(json["checks"]["data_oscillation"]["traction"].is_number());
  EXPECT_TRUE(json["skipped"].is_array());
}

TEST_F(Report, RoundingDoesNotPress) {
  const Ended ended =
      shell("bracket run contact.toml --set contact.0.gap=1 --set 'boundary.\"upper.right\".fixed=[0,0]'");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_TRUE(std::regex_search(ended.out, std::regex("computed +pressed length +0 mm\n"))) << ended.out;
}

TEST_F(Report, TheErrorBoundFollowsFromTheInterval) {
  ASSERT_EQ(shell("bracket run contact.toml").status, 0);
  const Json json = Json::parse(read("contact.out/report.json"));
  const double upper = json["energy"]["upper"], width = upper - json["energy"]["lower"].get<double>();
  // Without prescribed displacements or gaps L(u_h) = -½ ‖u_h‖²_A at the minimum over a cone.
  EXPECT_NEAR(json["relative_error_bound"], std::sqrt(2 * width / (-2 * upper)), 1e-8);
  EXPECT_NEAR(json["error_bound"], std::sqrt(2 * width), 1e-12);
}

TEST_F(Report, JsonAloneOnStandardOutputIsTheFile) {
  const Ended ended = shell("bracket run contact.toml --json");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  EXPECT_EQ(ended.out, read("contact.out/report.json"));
}

TEST_F(Report, QuietLeavesTheAnswer) {
  const Ended loud = shell("bracket run contact.toml");
  const Ended quiet = shell("bracket run contact.toml --quiet");
  EXPECT_EQ(quiet.status, 0);
  EXPECT_EQ(quiet.err, "");
  EXPECT_EQ(quiet.out.find("● guaranteed error"), 0u);
  EXPECT_NE(loud.out.find("\n" + quiet.out + "\n"), std::string::npos) << loud.out;
}

TEST_F(Report, AnExactSolutionHasAnErrorOfRoundingSize) {
  ASSERT_EQ(shell("bracket run bending.toml").status, 0);
  const Json json = Json::parse(read("bending.out/report.json"));
  // L(u) = -½ ∫ σ : ε = -½ (1 - ν²)/E ∫ y² = -½ · 0.9375/3 · 2/12, in plane strain.
  const double exact = -0.5 * 0.9375 / 3 / 6;
  EXPECT_NEAR(json["energy"]["lower"], exact, 1e-12 * std::abs(exact));
  EXPECT_NEAR(json["energy"]["upper"], exact, 1e-12 * std::abs(exact));
  EXPECT_EQ(json["levels"][0]["contact"]["rows"], 0);
}

// A punch has its largest pressure at its corners, where no mesh ends: unless its end is an axis of symmetry.
TEST_F(Report, LargestPressuresThatGrowAreTold) {
  write("punch.toml", R"(schema = 1
[[mesh.block]]
body = "base"
x = [0, 2]
y = [0, 1]
cells = [8, 4]
[[mesh.block]]
body = "punch"
x = [0, 1]
y = [1, 1.5]
cells = [4, 2]
[bodies.base]
E = 1
nu = 0.3
[bodies.punch]
E = 1e4
nu = 0.3
[boundary]
"base.bottom" = { fixed = [0, 0] }
"base.left" = { sliding = 0 }
"punch.left" = { sliding = 0 }
"punch.top" = { pressure = 0.1 }
[[contact]]
first = "punch.bottom"
second = "base.top"
)");
  const Ended corner = shell("bracket run punch.toml");
  ASSERT_EQ(corner.status, 0) << corner.err;
  Json pair = Json::parse(read("punch.out/report.json"))["contact"][0];
  EXPECT_EQ(pair["first"], "punch.bottom");
  EXPECT_EQ(pair["at"][0], 1);  // the corner
  EXPECT_EQ(pair["grows"], "an end of the contact line");
  EXPECT_NEAR(pair["force"].get<double>(), 0.1, 1e-12);  // statics
  EXPECT_NE(unbroken(corner.out).find(", grows with refinement: an end of the contact line"), std::string::npos)
      << corner.out;
  // Bulging on its axis, the largest pressure is there.
  const Ended axis = shell(
      "bracket run punch.toml -o axis --set refine.strategy=uniform --set refine.max_levels=4 --set "
      "'contact.0.gap=5*x^2' --set bodies.punch.E=1");
  ASSERT_EQ(axis.status, 0) << axis.err;
  pair = Json::parse(read("axis/report.json"))["contact"][0];
  EXPECT_EQ(pair["at"][0], 0);
  EXPECT_EQ(pair["grows"], "");
}

TEST_F(Report, NamesWithAnyCharactersLeaveTheJsonReadable) {
  ASSERT_EQ(shell("bracket run bending.toml --set 'title=\"quote \\\" and umlaut \xc3\xbc\"'").status, 0);
  EXPECT_EQ(Json::parse(read("bending.out/report.json"))["title"], "quote \" and umlaut \xc3\xbc");
}

}  // namespace
}  // namespace bracket::apps::tests
