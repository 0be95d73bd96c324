// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

using Json = nlohmann::json;

class Extremes : public Command {
 protected:
  Extremes() {
    write("scene.toml", two_blocks);
    write("beam.toml", bending);
  }
  Json json(const std::string& folder) const { return Json::parse(read(folder + "/extremes.json")); }
};

std::map<std::string, std::vector<Json>> by_sweep(const Json& json) {
  std::map<std::string, std::vector<Json>> sweeps;
  for (const Json& row : json["rows"]) sweeps[row["sweep"]].push_back(row);
  return sweeps;
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, at);) parts.push_back(part);
  return parts;
}

const std::set<std::string> names = {
    "unit of length", "unit of force", "load",        "modulus ratio",        "1/2 - nu",          "flat cells",
    "needles",        "thin bodies",   "contact end", "resultant to the end", "resultant to zero", "lift-off"};

TEST_F(Extremes, FollowEverySweepOrSayWhyNot) {
  const Ended ended = shell("bracket extremes scene.toml");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_LE(widest(ended.out), 80u) << ended.out;
  const std::string out = unbroken(ended.out);
  EXPECT_EQ(ended.err, "");
  const Json found = json("scene.extremes");
  auto sweeps = by_sweep(found);
  std::set<std::string> told;
  for (const auto& [name, rows] : sweeps) told.insert(name);
  for (const std::string line : found["left_out"]) {
    const std::string name = line.substr(0, line.find(':'));
    EXPECT_TRUE(told.insert(name).second) << name;
    EXPECT_NE(out.find("left out: " + line), std::string::npos) << line;
  }
  EXPECT_EQ(told, names);
  // The left block of the scene is held sideways: loads tilt as they like.
  EXPECT_EQ(sweeps.count("resultant to the end"), 0u);
  for (const auto& [name, rows] : sweeps) {
    EXPECT_GE(rows.size(), 5u) << name;
    for (const Json& row : rows) {
      SCOPED_TRACE(row.dump());
      EXPECT_NE(row["contains_reference"], Json(false));
      EXPECT_EQ(row["energy"].is_null(), row["status"] != 0);
      EXPECT_EQ(row["reason"] == "", row["status"] == 0);
      EXPECT_NE(ended.out.find(name), std::string::npos);
      if (row["status"] == 0) {
        EXPECT_LE(row["energy"]["lower"], row["energy"]["upper"]);
      } else {
        EXPECT_NE(out.find(row["reason"].get<std::string>()), std::string::npos);
      }
    }
    EXPECT_EQ(rows[0]["status"], 0) << name;  // the first steps of each are mild
  }
}

// Units and loads are changed by powers of two: bit by bit the same problem.
TEST_F(Extremes, UnitsAndLoadsScaleTheInterval) {
  ASSERT_EQ(shell("bracket extremes scene.toml").status, 0);
  const Json found = json("scene.extremes");
  const double width = found["benign"]["relative_width"];
  EXPECT_GT(width, 0);
  auto sweeps = by_sweep(found);
  for (const std::string name : {"unit of length", "unit of force", "load"}) {
    EXPECT_LT(sweeps[name].front()["parameter"], 1e-12) << name;
    EXPECT_GT(sweeps[name].back()["parameter"], 1e12) << name;
    for (const Json& row : sweeps[name]) {
      SCOPED_TRACE(row.dump());
      ASSERT_EQ(row["status"], 0);
      EXPECT_NEAR(row["energy"]["relative_width"], width, 1e-12 * width);
      const double parameter = row["parameter"], factor = name == "unit of force" ? parameter : parameter * parameter;
      EXPECT_NEAR(row["energy"]["upper"], factor * found["benign"]["upper"].get<double>(),
                  1e-12 * factor * std::abs(found["benign"]["upper"].get<double>()));
    }
  }
}

// A contact that ends sooner leaves the displacements more freedom, and a cell cut in three does, too.
TEST_F(Extremes, ChangeTheEnergyTheWayTheyMust) {
  ASSERT_EQ(shell("bracket extremes scene.toml").status, 0);
  const Json found = json("scene.extremes");
  auto sweeps = by_sweep(found);
  const double upper = found["benign"]["upper"], rounding = 1e-9 * std::abs(upper);
  for (const std::string name : {"contact end", "flat cells", "needles"})
    for (const Json& row : sweeps[name]) {
      if (row["status"] == 0) {
        EXPECT_LE(row["energy"]["upper"], upper + rounding) << row.dump();
      }
    }
  // The shorter the piece that is freed, the less so.
  const auto& ends = sweeps["contact end"];
  EXPECT_LT(ends[0]["energy"]["upper"], ends[1]["energy"]["upper"]);
  // A stiffer body stores less energy: L(u) = -½ ∫ σ : ε grows.
  const auto& ratios = sweeps["modulus ratio"];
  for (std::size_t i = 1; i < ratios.size(); ++i)
    EXPECT_GE(ratios[i]["energy"]["upper"], ratios[i - 1]["energy"]["lower"]);
}

// The piece of the contact that is freed is free on both sides: it does not matter which of them is called the first.
TEST_F(Extremes, FreeBothSidesOfTheContact) {
  std::string swapped = two_blocks;
  for (const auto& [from, to] : {std::pair("first = \"upper.bottom\"", "first = \"lower.top\""),
                                 std::pair("second = \"lower.top\"", "second = \"upper.bottom\"")})
    swapped.replace(swapped.find(from), std::string(from).size(), to);
  write("swapped.toml", swapped);
  ASSERT_EQ(shell("bracket extremes scene.toml && bracket extremes swapped.toml").status, 0);
  auto one = by_sweep(json("scene.extremes"))["contact end"], other = by_sweep(json("swapped.extremes"))["contact end"];
  for (int i = 0; i < 4; ++i)  // down to 1e-4, where rounding leaves six digits and more
    for (const char* bound : {"lower", "upper"})
      EXPECT_NEAR(one[i]["energy"][bound], other[i]["energy"][bound],
                  1e-6 * std::abs(other[i]["energy"][bound].get<double>()));
}

TEST_F(Extremes, TablesAgreeAndThePlotHasACurvePerSweep) {
  const Ended ended = shell("bracket extremes scene.toml -o there");
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Json found = json("there");
  const auto lines = split(read("there/extremes.csv"), '\n');
  ASSERT_EQ(lines.size(), found["rows"].size() + 1);
  const auto columns = split(lines[0], ',').size();
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto values = split(lines[i], ',');
    ASSERT_EQ(values.size(), columns) << lines[i];
    const Json& row = found["rows"][i - 1];
    EXPECT_EQ(values[0], row["sweep"]);
    EXPECT_EQ(std::stod(values[1]), row["parameter"]);
    EXPECT_EQ(values[2].empty(), row["energy"].is_null());
    if (!values[2].empty()) {
      EXPECT_EQ(std::stod(values[2]), row["energy"]["lower"]);
    }
  }
  const std::string plot = read("there/extremes.svg");
  for (const auto& [name, rows] : by_sweep(found)) EXPECT_NE(plot.find(name), std::string::npos) << name;
}

TEST_F(Extremes, ASceneOfOneBodyWithoutContactLeavesOutWhatNeedsThem) {
  const Ended ended = shell("bracket extremes beam.toml");
  ASSERT_EQ(ended.status, 0) << ended.err;
  const auto sweeps = by_sweep(json("beam.extremes"));
  for (const char* name : {"modulus ratio", "contact end", "lift-off", "resultant to the end", "resultant to zero"}) {
    EXPECT_EQ(sweeps.count(name), 0u) << name;
    EXPECT_NE(ended.out.find(std::string("left out: ") + name), std::string::npos) << name;
  }
  EXPECT_EQ(sweeps.count("1/2 - nu"), 1u);
}

TEST_F(Extremes, AnIllPosedSceneIsRefusedAsByRun) {
  const Ended ended = shell("bracket extremes scene.toml --set 'boundary.\"upper.top\".traction=[0.0, 1.0]'");
  EXPECT_EQ(ended.status, 4);
  EXPECT_NE(ended.err.find("'upper'"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace bracket::apps::tests
