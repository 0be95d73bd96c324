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
    if (key != "plane") {
      EXPECT_TRUE(space.contains(key)) << key;
    }
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

TEST_F(RunInSpace, LeavesASheet) {
  const Ended ended = shell("bracket run boxes.toml --set refine.strategy=adaptive --set refine.max_levels=3 --json");
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Json report = Json::parse(ended.out), sheet = Json::parse(read("boxes.out/sheet.json"));
  EXPECT_EQ(sheet["dim"], 3);
  EXPECT_FALSE(sheet["problem"].contains("plane"));
  EXPECT_NE(sheet["problem"]["mathematical_model"].get<std::string>().find("three dimensions"), std::string::npos);
  const Json& verification = sheet["verification_of_the_calculation"];
  EXPECT_EQ(verification["levels"].size(), 3u);
  EXPECT_EQ(verification["guarantee"], "rounding-safe");
  const double by_cells = verification["observed_order"]["by_cells"];
  EXPECT_NEAR(verification["observed_order"]["by_size"], -3 * by_cells, 1e-12);  // h³ = 1/cells
  EXPECT_EQ(sheet["intervals"].back()["unit"], "N mm");
  EXPECT_EQ(sheet["intervals"].back()["lower"], report["energy"]["lower"]);
  EXPECT_NE(sheet["data_and_geometry"]["said"].dump().find("tetrahedra"), std::string::npos);
  EXPECT_EQ(sheet.dump().find("across the plane"), std::string::npos);
  for (const Json& found : sheet["findings"])
    if (!found["at"].is_null()) {
      EXPECT_EQ(found["at"].size(), 3u);
    }
  const std::string html = read("boxes.out/sheet.html");
  EXPECT_NE(html.find("Numerical uncertainty"), std::string::npos);
  EXPECT_NE(html.find("three dimensions"), std::string::npos);
}

// The half that is pulled apart opens, and carries no more than the width of the interval by the gap.
TEST_F(RunInSpace, TellsWhatTheOpenPartCarriesAtMost) {
  const Json json = report("--set refine.strategy=adaptive --set refine.max_levels=4");
  const Json& pair = json["contact"][0];
  EXPECT_GT(pair["open"]["area"], 0);
  EXPECT_LT(pair["open"]["area"], 0.5);
  EXPECT_GT(pair["open"]["gap"], 0);
  const Json& certificate = json["levels"].back();
  const double width = certificate["upper"].get<double>() - certificate["lower"].get<double>();
  const double at_most = pair["open"]["force_at_most"], gap = pair["open"]["gap"];
  EXPECT_GE(at_most * gap, width / 2 * (1 - 1e-12));  // T = ½ (w + κ), 0 ≤ κ ≤ w
  EXPECT_LE(at_most * gap, width * (1 + 1e-9));
}

// The fields that a run leaves are those of another program, on cells of their own: on the nodes of the scene's mesh
// they are the run's displacement.
TEST_F(RunInSpace, AssessJudgesADisplacement) {
  ASSERT_EQ(shell("bracket run boxes.toml --no-report").status, 0);
  const std::string budget = " --set refine.strategy=adaptive --set refine.max_cells=3000";
  const Ended ended = shell("bracket assess boxes.toml boxes.out/solution_0.vtu" + budget);
  ASSERT_EQ(ended.status, 5) << ended.err;  // the mesh that it would take is larger
  EXPECT_EQ(ended.out.find("● guaranteed error of the displacement  "), 0u) << ended.out;
  EXPECT_LE(widest(ended.out), 80u) << ended.out;
  const std::string out = unbroken(ended.out);
  EXPECT_NE(out.find("interpolated: boxes.out/solution_0.vtu is of another mesh"), std::string::npos) << out;
  EXPECT_NE(out.find("quadratic tetrahedra of the scene's mesh"), std::string::npos) << out;
  EXPECT_NE(out.find("three dimensions"), std::string::npos) << out;
  EXPECT_NE(out.find(" √(N mm). Guarantee: rounding-safe."), std::string::npos) << out;
  for (const char* name : {"assess.json", "assess.vtu", "error.svg", "error_behind.svg"})
    EXPECT_TRUE(std::filesystem::exists(directory / "boxes.assess" / name)) << name;
  const Json of_assess = Json::parse(read("boxes.assess/assess.json")), of_run = report();
  EXPECT_EQ(of_assess["dim"], 3);
  EXPECT_EQ(of_assess["displacement"]["degree"], 2);
  EXPECT_LT(of_assess["displacement"]["penetration"], 1e-15);
  // |u_h − u|² ≤ 2 (L(u_h) − L(u)), and of the run's own mesh the bound is 2 w.
  const double upper = of_run["energy"]["upper"], lower = of_run["energy"]["lower"];
  EXPECT_GT(of_assess["error"]["lower"], 0);
  EXPECT_LE(of_assess["error"]["lower"], std::sqrt(2 * (upper - lower)));
  EXPECT_LE(of_assess["error"]["upper"], std::sqrt(2 * (upper - lower)));
}

TEST_F(RunInSpace, AssessTellsThatNothingIsOneHundredPercent) {
  std::string none = "x,y,z,ux,uy,uz\n";
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 5; ++j)
      for (int k = 0; k < 2; ++k)
        none += std::to_string(0.5 * i) + "," + std::to_string(0.5 * j) + "," + std::to_string(0.5 * k) + ",0,0,0\n";
  write("none.csv", none);
  const Ended ended = shell("bracket assess boxes.toml none.csv --json");
  const Json relative = Json::parse(ended.out)["relative_error"];
  EXPECT_LT(relative["lower"], 1);
  EXPECT_GT(relative["upper"], 1);
  write("part.csv", none.substr(0, none.size() / 2) + "0,0,0,0,0,0\n");
  for (const std::string file : {"part.csv", "boxes.toml", "missing.csv"}) {
    const Ended refused = shell("bracket assess boxes.toml " + file);
    EXPECT_EQ(refused.status, 2) << refused.err;
    EXPECT_EQ(std::ranges::count(refused.err, '\n'), 1) << refused.err;
  }
}

TEST_F(RunInSpace, WhatSpaceDoesNotHaveIsRefusedInOneLine) {
  write("quantity.toml", std::string(two_boxes) + "[[quantity]]\nslip = \"upper.bottom\"\n");
  for (const std::string command : {"study boxes.toml", "extremes boxes.toml", "run quantity.toml",
                                    "check quantity.toml", "run boxes.toml --set contact.0.zones=4",
                                    "run boxes.toml --set solve.degree=3", "run boxes.toml --set solve.dual=uzawa"}) {
    const Ended ended = shell("bracket " + command);
    EXPECT_EQ(ended.status, 2) << command;
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << command << ": " << ended.err;
    EXPECT_TRUE(ended.out.empty()) << command;
  }
  EXPECT_EQ(shell("ls -d *.out *.study *.extremes *.assess").out, "");
}

}  // namespace
}  // namespace bracket::apps::tests
