// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// bracket assess: the error of another program's displacement.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "scene/scene.h"
#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

namespace fs = std::filesystem;

const std::string refined = [] {
  std::string scene = two_blocks;
  const std::string none = "strategy = \"none\"";
  return scene.replace(scene.find(none), none.size(), "strategy = \"adaptive\"\nmax_cells = 20000");
}();

/// On the mesh of the scene two_blocks, refined `times`: u(x) of each body at the nodes of triangles of a degree.
class AssessCommand : public Command {
 protected:
  AssessCommand() { write("scene.toml", refined); }

  std::string csv(int times, int degree, const std::function<std::array<double, 2>(int, double, double)>& u) const {
    const auto scene = scene::read_scene<2>(directory / "scene.toml", {});
    scene::Problem<2> problem = scene::fix_data(scene, scene::build_mesh(scene));
    for (int i = 0; i < times; ++i)
      problem = scene::refine(problem, std::vector<char>(problem.mesh.cells.size(), 1)).problem;
    std::string text = "x,y,ux,uy,body\n";
    const auto add = [&](const scene::Vector<2>& x, int body) {
      const auto [ux, uy] = u(body, x[0], x[1]);
      text += fmt::format("{},{},{},{},{}\n", x[0], x[1], ux, uy, problem.mesh.bodies[body]);
    };
    const auto& mesh = problem.mesh;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
      for (const int v : mesh.cells[c]) add(mesh.vertices[v], mesh.cell_body[c]);
      for (const int e : mesh.cell_edges[c])
        if (degree == 2)
          add((mesh.vertices[mesh.edges[e][0]] + mesh.vertices[mesh.edges[e][1]]) / 2, mesh.cell_body[c]);
    }
    return text;
  }
  nlohmann::json json(const std::string& arguments) const {
    const Ended ended = shell("bracket assess scene.toml " + arguments + " --json");
    EXPECT_EQ(ended.status, 0) << ended.err;
    return nlohmann::json::parse(ended.out);
  }
};

std::array<double, 2> nothing(int, double, double) { return {0, 0}; }
/// Off the support at y = 0, and with the upper body in the lower one.
std::array<double, 2> pressed(int body, double x, double y) { return {0, 1e-4 - 0.002 * y - 0.001 * body * (1 - x)}; }

TEST_F(AssessCommand, SaysTheIntervalAndLeavesWhatShowsWhere) {
  write("u.csv", csv(1, 1, pressed));
  const Ended ended = shell("bracket assess scene.toml u.csv --set solve.degree=1");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.out.find("● guaranteed error of the displacement  "), 0u) << ended.out;
  EXPECT_LE(widest(ended.out), 80u) << ended.out;
  const std::string out = unbroken(ended.out);
  EXPECT_NE(out.find("\nnot admissible: it misses what supports prescribe by up to "), std::string::npos) << out;
  EXPECT_NE(out.find(", and penetrates the contact by up to "), std::string::npos) << out;
  EXPECT_NE(out.find("linear triangles of the scene's mesh, refined 1 time\n"), std::string::npos) << out;
  EXPECT_NE(out.find(" √(N mm/mm). Guarantee: rounding-safe."), std::string::npos) << out;
  EXPECT_NE(out.find("at most the fourth number, in √(N mm/mm))"), std::string::npos) << out;
  for (const char* name : {"assess.json", "assess.vtu", "error.svg"})
    EXPECT_TRUE(fs::exists(directory / "scene.assess" / name)) << name;
  const auto report = nlohmann::json::parse(read("scene.assess/assess.json"));
  EXPECT_EQ(report["displacement"]["degree"], 1);
  EXPECT_EQ(report["displacement"]["refinements"], 1);
  EXPECT_EQ(report["displacement"]["interpolated"], false);
  EXPECT_GT(report["displacement"]["penetration"], 0);
  EXPECT_LT(report["relative_error"]["lower"], report["relative_error"]["upper"]);
  EXPECT_EQ(report["levels"][0]["cells"], report["displacement"]["cells"]);
  const Ended quiet = shell("bracket assess scene.toml u.csv --quiet -o other --set solve.degree=1");
  EXPECT_EQ(std::ranges::count(unbroken(quiet.out), '\n'), 2) << quiet.out;
  EXPECT_EQ(ended.out.find(quiet.out), 0u);
  EXPECT_EQ(quiet.err, "");
}

// Vertices of a mesh and midpoints of its edges are the vertices of the next.
TEST_F(AssessCommand, PointsAreTakenByTheDegreeOfTheScene) {
  write("u.csv", csv(2, 1, pressed));
  const auto quadratic = json("u.csv"), linear = json("u.csv --set solve.degree=1");
  EXPECT_EQ(quadratic["displacement"]["degree"], 2);
  EXPECT_EQ(quadratic["displacement"]["refinements"], 1);
  EXPECT_EQ(linear["displacement"]["degree"], 1);
  EXPECT_EQ(linear["displacement"]["refinements"], 2);
  const Ended ended = shell("bracket assess scene.toml u.csv");
  EXPECT_NE(ended.err.find("--set solve.degree=1 takes them so"), std::string::npos) << ended.err;
}

TEST_F(AssessCommand, NoDisplacementIsOneHundredPercentAndWorseGetsANote) {
  write("none.csv", csv(1, 2, nothing));
  const auto none = json("none.csv")["relative_error"];
  EXPECT_LT(none["lower"], 1.01);
  EXPECT_GT(none["upper"], 0.99);
  write("wrong.csv", csv(1, 2, [](int body, double x, double y) {
          const auto [a, b] = pressed(body, x, y);
          return std::array<double, 2>{-1e3 * a, -1e3 * b};
        }));
  const Ended ended = shell("bracket assess scene.toml wrong.csv --quiet");
  EXPECT_NE(ended.out.find("\nnote: above 100 %"), std::string::npos) << ended.out;
}

// docs/other-programs.md: linear elements and a penalty, on the scene's mesh refined twice; the error is that of the
// mesh.
TEST_F(AssessCommand, WhatOtherProgramsComputed) {
  std::string coarser = refined;
  for (std::size_t at; (at = coarser.find("[4, 4]")) != std::string::npos;) coarser.replace(at, 6, "[5, 5]");
  write("coarser.toml", coarser);
  for (const std::string name : {"calculix.frd", "freefem.vtu"}) {
    const auto report = json("'" BRACKET_FIELDS "/" + name + "'");
    EXPECT_EQ(report["displacement"]["degree"], 1);
    EXPECT_EQ(report["displacement"]["refinements"], 2);
    EXPECT_LT(report["displacement"]["penetration"], 1e-5);
    const double lower = report["relative_error"]["lower"], upper = report["relative_error"]["upper"];
    EXPECT_LT(0.1296, lower);
    EXPECT_LT(lower, upper);
    EXPECT_LT(upper, 0.1308);
    const Ended ended = shell("bracket assess coarser.toml '" BRACKET_FIELDS "/" + name + "' --quiet");
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find("\ninterpolated: "), std::string::npos) << ended.out;
  }
}

TEST_F(AssessCommand, WhatCannotBeJudgedIsOneLine) {
  const std::string u = csv(1, 2, pressed);
  write("half.csv", u.substr(0, u.find('\n', u.size() / 2) + 1));
  write("nan.csv", "x,y,ux,uy\n0,0,nan,0\n");
  write("elsewhere.csv", "x,y,ux,uy\n7,7,0,0\n8,7,0,0\n7,8,0,0\n");
  write("u.csv", u);
  for (const std::string arguments :
       {"half.csv", "nan.csv", "elsewhere.csv", "missing.csv", "", "u.csv --degree 2", "u.csv --set refine.max_cells=0",
        "u.csv --set 'curves.\"lower.top\".circle=\"detect\"'"}) {
    const Ended ended = shell("bracket assess scene.toml " + arguments);
    EXPECT_EQ(ended.status, 2) << arguments << ended.out;
    EXPECT_EQ(ended.out, "") << arguments;
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << arguments << ended.err;
  }
  const Ended spent = shell("bracket assess scene.toml '" BRACKET_FIELDS "/calculix.frd' --set refine.strategy=none");
  EXPECT_EQ(spent.status, 5) << spent.err;
  EXPECT_EQ(spent.out.find("● guaranteed error of the displacement  "), 0u);
}

}  // namespace
}  // namespace bracket::apps::tests
