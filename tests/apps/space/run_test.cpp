// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Commands on scenes of space: what they find, and what they refuse.
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/apps/command.h"
#include "tests/apps/space/scenes.h"

namespace bracket::apps::tests {
namespace {

using Json = nlohmann::json;

class RunInSpace : public Command {
 protected:
  RunInSpace() {
    write("boxes.toml", two_boxes);
    write("blocks.toml", two_blocks);
  }
  Json report(const std::string& arguments = "") const {
    const Ended ended = shell("bracket run boxes.toml --json --no-report " + arguments);
    EXPECT_EQ(ended.status, 0) << ended.err;
    return Json::parse(ended.out);
  }
};

// The plane's interval holds the energy by thickness, on whatever mesh.
TEST_F(RunInSpace, AnExtrudedSceneMeetsThePlanesInterval) {
  const Json space = report();
  const Json plane = Json::parse(shell("bracket run blocks.toml --json --no-report").out);
  EXPECT_EQ(space["guarantee"], "rounding-safe");
  EXPECT_LE(space["energy"]["lower"].get<double>(), plane["energy"]["upper"].get<double>() / 2);
  EXPECT_GE(space["energy"]["upper"].get<double>(), plane["energy"]["lower"].get<double>() / 2);
}

TEST_F(RunInSpace, TheReportHasThePlanesKeys) {
  const Json space = report();
  const Json plane = Json::parse(shell("bracket run blocks.toml --json --no-report").out);
  EXPECT_EQ(space["dim"], 3);
  EXPECT_FALSE(plane.contains("dim"));
  for (const auto& [key, value] : plane.items())
    if (key != "plane") EXPECT_TRUE(space.contains(key)) << key;
  for (const auto& [key, value] : plane["levels"][0].items()) EXPECT_TRUE(space["levels"][0].contains(key)) << key;
  for (const auto& [key, value] : plane["checks"].items()) EXPECT_TRUE(space["checks"].contains(key)) << key;
  for (const char* key : {"force", "pressed_area", "largest_pressure", "largest_gap", "resultant_y", "at", "grows"})
    EXPECT_TRUE(space["contact"][0].contains(key)) << key;
  EXPECT_EQ(space["contact"][0]["largest_pressure_at"].size(), 3u);
}

// λ_h is in equilibrium: on each body reactions, contact and loads add up to zero.
TEST_F(RunInSpace, ForcesBalance) {
  const Json json = report();
  const double load = 0.25 * (-0.1 + 0.09);  // N: each half of the top has a quarter
  std::array<double, 3> of_lower = {}, of_upper = {0, load, 0};
  const std::array<const char*, 3> axes = {"x", "y", "z"};
  for (int k = 0; k < 3; ++k) {
    const double on_upper = json["contact"][0][std::string("resultant_") + axes[k]];
    of_upper[k] += on_upper;
    of_lower[k] -= on_upper;
    for (const Json& support : json["supports"])
      (support["part"].get<std::string>().starts_with("lower") ? of_lower : of_upper)[k] +=
          support[std::string("reaction_") + axes[k]].get<double>();
    EXPECT_NEAR(of_lower[k], 0, 1e-9) << axes[k];
    EXPECT_NEAR(of_upper[k], 0, 1e-9) << axes[k];
  }
  EXPECT_NEAR(json["contact"][0]["area"], 0.5, 1e-12);
  EXPECT_NEAR(json["contact"][0]["force"], json["contact"][0]["resultant_y"], 1e-12);  // a level contact
}

TEST_F(RunInSpace, ForcesAndEnergiesAreNotByThickness) {
  const Ended ended = shell("bracket run boxes.toml --no-report");
  ASSERT_EQ(ended.status, 0) << ended.err;
  for (const char* told : {"three dimensions", "pressed area", "mm²", "resultant y", "N mm "})
    EXPECT_NE(ended.out.find(told), std::string::npos) << told;
  for (const char* of_the_plane : {"N/mm", "plane strain", "pressed length"})
    EXPECT_EQ(ended.out.find(of_the_plane), std::string::npos) << of_the_plane;
  EXPECT_LE(widest(ended.out), 80u);
}

TEST_F(RunInSpace, TablesHaveAllNumbers) {
  const Json json = report("--set refine.strategy=uniform --set refine.max_levels=2");
  std::istringstream history(read("boxes.out/history.csv")), contact(read("boxes.out/contact.csv"));
  std::string line;
  int lines = 0;
  while (std::getline(history, line)) ++lines;
  EXPECT_EQ(lines, 3);
  std::getline(contact, line);
  EXPECT_EQ(line, "of,what,standing,computed,lower,upper,unit,x,y,z,note");
  EXPECT_EQ(read("boxes.out/solution.pvd").find("timestep=\"2\""), std::string::npos);
}

TEST_F(RunInSpace, CheckTellsFacesVolumesAndMotions) {
  const Ended ended = shell("bracket check boxes.toml");
  ASSERT_EQ(ended.status, 0) << ended.err;
  for (const char* told : {"24 cells, volume 0.5 mm³", "lower.bottom: 4 faces, area 0.5 mm²: fixed", "shape 0.756",
                           "4 faces; gap 0 to 0 mm", "lower: 0 of 6", "upper: ", "solvable"})
    EXPECT_NE(ended.out.find(told), std::string::npos) << told << "\n" << ended.out;
  const Json json = Json::parse(shell("bracket check boxes.toml --json").out);
  EXPECT_EQ(json["dim"], 3);
  EXPECT_NEAR(json["bodies"][0]["volume"], 0.5, 1e-15);
  EXPECT_EQ(json["motions"][0]["free"].size(), 0u);
}

// Held by a plane of symmetry at the left and at both ends, a block can move upwards alone.
TEST_F(RunInSpace, CheckNamesTheMotionsThatAreFree) {
  const Json json = Json::parse(shell("bracket check boxes.toml --json").out);
  ASSERT_EQ(json["motions"][1]["free"].size(), 1u);
  EXPECT_NE(json["motions"][1]["free"][0].get<std::string>().find("moving it by (0, 1, 0)"), std::string::npos);
}

// Forces are half of the plane's, displacements, rotations and stresses the same.
TEST_F(RunInSpace, QuantitiesHaveThePlanesKeysAndMeetItsIntervals) {
  const std::string in_both = R"([[quantity]]
name = "push"
force = "upper.bottom"
[[quantity]]
stress = "lower"
component = "yy"
)";
  write("asked.toml", std::string(two_boxes) + in_both +
                          "[[quantity]]\nname = \"lift\"\ndisplacement = \"upper.top\"\ndirection = [0, 1, 0]\n" +
                          "[[quantity]]\nname = \"turn\"\nrotation = \"upper.right\"\ndirection = [0, 0, 1]\n");
  write("plane.toml", std::string(two_blocks) + in_both +
                          "[[quantity]]\nname = \"lift\"\ndisplacement = \"upper.top\"\ndirection = [0, 1]\n" +
                          "[[quantity]]\nname = \"turn\"\nrotation = \"upper.right\"\n");
  const Json space = Json::parse(shell("bracket run asked.toml --json --no-report").out);
  const Json plane = Json::parse(shell("bracket run plane.toml --json --no-report").out);
  ASSERT_EQ(space["quantities"].size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const Json &one = space["quantities"][i], &other = plane["quantities"][i];
    for (const auto& [key, value] : other.items()) EXPECT_TRUE(one.contains(key)) << key;
    const double factor = i == 0 ? 0.5 : 1;
    EXPECT_LE(one["lower"].get<double>(), factor * other["upper"].get<double>()) << one["name"];
    EXPECT_GE(one["upper"].get<double>(), factor * other["lower"].get<double>()) << one["name"];
  }
  EXPECT_EQ(std::ranges::count(read("asked.out/quantities.csv"), '\n'), 5);
  const Ended told = shell("bracket run asked.toml --no-report");
  for (const char* line : {"● push", " N ", "● turn", " rad ", "● stress yy of lower", " MPa "})
    EXPECT_NE(told.out.find(line), std::string::npos) << line << "\n" << told.out;
  const Ended checked = shell("bracket check asked.toml");
  EXPECT_EQ(checked.status, 0) << checked.err;
  EXPECT_NE(checked.out.find("quantity: lift\n"), std::string::npos) << checked.out;
}

TEST_F(RunInSpace, WhatSpaceDoesNotHaveIsRefusedInOneLine) {
  write("quantity.toml", std::string(two_boxes) + "[[quantity]]\nslip = \"upper.bottom\"\n");
  write("field.csv", "x,y,z,ux,uy,uz\n");
  for (const std::string command :
       {"study boxes.toml", "extremes boxes.toml", "assess boxes.toml field.csv", "run quantity.toml",
        "check quantity.toml", "run boxes.toml --set contact.0.zones=4", "run boxes.toml --set solve.degree=3",
        "run boxes.toml --set solve.dual=uzawa"}) {
    const Ended ended = shell("bracket " + command);
    EXPECT_EQ(ended.status, 2) << command;
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << command << ": " << ended.err;
    EXPECT_TRUE(ended.out.empty()) << command;
  }
  EXPECT_EQ(shell("ls -d *.out *.study *.extremes *.assess").out, "");
}

}  // namespace
}  // namespace bracket::apps::tests
