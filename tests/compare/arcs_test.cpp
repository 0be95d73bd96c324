// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Arcs and obstacles, against known answers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bounds/bounds.h"
#include "bounds/results.h"
#include "tests/compare/same_levels.h"
#include "tests/scene/inputs.h"
#include "tests/support/scenes.h"

namespace bracket::tests {
namespace {

using scene::Scene;
using scene::test::GmshContent;

/// A sector of a ring, of rows × columns quadrilaterals; boundary parts and body by their numbers.
struct Sector {
  double inner, outer, from, to;
  int rows, columns;
  Vector<2> center = {0, 0};
  int body = 1;
  std::array<int, 4> parts = {};  ///< inside, outside, at `from`, at `to`
};
void add(GmshContent& content, const Sector& s) {
  const int base = static_cast<int>(content.nodes.size());
  const auto node = [&](int i, int j) { return base + i * (s.columns + 1) + j; };
  for (int i = 0; i <= s.rows; ++i)
    for (int j = 0; j <= s.columns; ++j) {
      const double radius = s.inner + (s.outer - s.inner) * i / s.rows,
                   angle = s.from + (s.to - s.from) * j / s.columns;
      const double x = radius * std::cos(angle), y = radius * std::sin(angle);
      const auto exact = [&](double value) { return std::abs(value) < 1e-12 * radius ? 0 : value; };  // on the axes
      content.nodes.push_back({s.center[0] + exact(x), s.center[1] + exact(y)});
    }
  for (int i = 0; i < s.rows; ++i)
    for (int j = 0; j < s.columns; ++j) {
      content.triangles.push_back({s.body, {node(i, j), node(i + 1, j), node(i + 1, j + 1)}});
      content.triangles.push_back({s.body, {node(i, j), node(i + 1, j + 1), node(i, j + 1)}});
    }
  for (int j = 0; j < s.columns; ++j) {
    content.lines.push_back({s.parts[0], {node(0, j), node(0, j + 1)}});
    content.lines.push_back({s.parts[1], {node(s.rows, j), node(s.rows, j + 1)}});
  }
  for (int i = 0; i < s.rows; ++i) {
    content.lines.push_back({s.parts[2], {node(i, 0), node(i + 1, 0)}});
    content.lines.push_back({s.parts[3], {node(i, s.columns), node(i + 1, s.columns)}});
  }
}

const char* const names =
    "1 1 \"one.in\"\n1 2 \"one.out\"\n1 3 \"one.start\"\n1 4 \"one.end\"\n"
    "1 5 \"two.in\"\n1 6 \"two.out\"\n1 7 \"two.start\"\n1 8 \"two.end\"\n2 1 \"one\"\n2 2 \"two\"\n";

Scene<2> two_sectors(const scene::test::Folder& folder, Sector one, Sector two, scene::Plane plane) {
  GmshContent content;
  content.names = names;
  one.parts = {1, 2, 3, 4};
  two.parts = {5, 6, 7, 8};
  two.body = 2;
  add(content, one);
  add(content, two);
  Scene<2> s;
  s.mesh_file = folder.write("sectors.msh", scene::test::gmsh_2(content));
  s.plane = plane;
  for (const char* body : {"one", "two"}) s.bodies.emplace(body, scene::isotropic<2>(210e3, 0.3, plane));
  for (const char* part : {"one.start", "one.end", "two.start", "two.end"}) s.boundary.emplace(part, sliding(0));
  for (const char* part : {"one.in", "one.out", "two.in", "two.out"}) s.curves.emplace(part, scene::Curve{});
  s.contact = {{"one.out", "two.in", {}, ""}};
  return s;
}

double largest_pressure(const bounds::Outcome<2>& outcome) {
  double largest = 0;
  for (const auto& ends : bounds::contact_pressure(outcome.problem, outcome.stress))
    largest = std::max({largest, ends[0], ends[1]});
  return largest;
}

// Rings of radii 10, 20, 30 with an interference of 0.0025, in plane stress: p = 6.15234375, and the energy of the
// whole is 0.96640790. Both as a gap between sides that coincide and as it is drawn, with sides in different edges.
TEST(Arcs, PressFit) {
  const scene::test::Folder folder;
  const double quarter = std::numbers::pi / 2, energy = 0.96640790 / 4, pressure = 6.15234375;
  for (const bool drawn : {false, true}) {
    Scene<2> s = two_sectors(folder, {10, drawn ? 20.0025 : 20, 0, quarter, 2, 6},
                             {20, 30, 0, quarter, 2, drawn ? 8 : 6}, scene::Plane::stress);
    if (!drawn) s.contact[0].gap = constant(-0.0025);
    s.refine.strategy = scene::Strategy::uniform;
    s.refine.max_levels = 4;
    const auto outcome = bounds::run(s);
    ASSERT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
    ASSERT_EQ(outcome.levels.size(), 4u);
    std::vector<double> off;
    for (const auto& level : outcome.levels) {
      EXPECT_LE(level.bracket.lower, level.bracket.upper);
      off.push_back(std::abs((level.bracket.lower + level.bracket.upper) / 2 - energy));
    }
    for (std::size_t i = 2; i < off.size(); ++i) EXPECT_LT(off[i], 0.5 * off[i - 1]) << i;
    EXPECT_LT(off.back(), 1e-3 * energy);
    EXPECT_LT(
        std::abs(outcome.moved - std::abs((outcome.lower + outcome.upper) / 2 -
                                          (outcome.levels[2].bracket.lower + outcome.levels[2].bracket.upper) / 2)),
        1e-12);
    EXPECT_EQ(outcome.lower, outcome.levels.back().bracket.lower);
    EXPECT_EQ(outcome.upper, outcome.levels.back().bracket.upper);
    EXPECT_NEAR(largest_pressure(outcome), pressure, 0.03 * pressure);
    // New vertices lie on their arcs.
    const auto& mesh = outcome.problem.mesh;
    for (const auto& facet : mesh.boundary) {
      if (mesh.parts[facet.part] != "two.out") continue;
      for (const int vertex : facet.vertices) EXPECT_NEAR(mesh.vertices[vertex].norm(), 30, 1e-12);
    }
  }
}

// Hertz: half a disc of radius 8 on a rigid plane, pressed by 3.2032: half-width 0.385299, largest pressure 5.292567.
TEST(Arcs, HalfADiscOnAPlane) {
  const scene::test::Folder folder;
  const double pi = std::numbers::pi;
  GmshContent content;
  content.names = "1 1 \"hole\"\n1 2 \"arc\"\n1 3 \"left\"\n1 4 \"right\"\n2 1 \"disc\"\n";
  Sector sector{2, 8, pi, 2 * pi, 5, 16, {0, 0}, 1, {1, 2, 3, 4}};
  add(content, sector);
  // The half disc inside of radius 2: a fan.
  content.nodes.push_back({0, 0});
  const int middle = static_cast<int>(content.nodes.size()) - 1;
  content.lines.clear();
  for (int j = 0; j < sector.columns; ++j) {
    content.triangles.push_back({1, {middle, j, j + 1}});
    const int outer = sector.rows * (sector.columns + 1);
    content.lines.push_back({2, {outer + j, outer + j + 1}});
  }
  for (const int column : {0, sector.columns}) {
    content.lines.push_back({3, {middle, column}});
    for (int i = 0; i < sector.rows; ++i)
      content.lines.push_back({3, {i * (sector.columns + 1) + column, (i + 1) * (sector.columns + 1) + column}});
  }
  Scene<2> s;
  s.mesh_file = folder.write("disc.msh", scene::test::gmsh_2(content));
  s.bodies = {{"disc", scene::isotropic<2>(200, 0.3, scene::Plane::strain)}};
  s.boundary = {{"left", pressure(constant(3.2032 / 16))}};
  s.curves = {{"arc", scene::Curve{scene::Circle{{0, 0}, 8}}}};
  s.contact = {{"arc", scene::LineObstacle{{0, -8}, {0, 2}}, {}, ""}};
  s.refine.strategy = scene::Strategy::adaptive;
  for (const auto& [target, within] : {std::pair(0.02, 0.03), {0.005, 0.01}}) {
    s.refine.target = target;
    const auto outcome = bounds::run(s);
    ASSERT_EQ(outcome.status, scene::Status::done) << outcome.reason;
    EXPECT_NEAR(largest_pressure(outcome), 5.292567, within * 5.292567);
    double pressed = 0, longest = 0;
    const auto pressures = bounds::contact_pressure(outcome.problem, outcome.stress);
    for (std::size_t j = 0; j < pressures.size(); ++j) {
      if (pressures[j][0] <= 0 && pressures[j][1] <= 0) continue;
      const double length = scene::length(outcome.problem.mesh, outcome.problem.contact[j].first);
      pressed += length;
      longest = std::max(longest, length);
    }
    EXPECT_NEAR(pressed / 2, 0.385299, longest);
  }
}

// A pin in a hole that is a little larger: the pressure falls from the middle to the ends of the contact without peaks
// at the vertices.
TEST(Arcs, PinInALargerHole) {
  const scene::test::Folder folder;
  const double half = std::numbers::pi / 2;
  Scene<2> s = two_sectors(folder, {4, 9.95, -half, half, 4, 24, {0, -0.05}}, {10, 20, -half, half, 4, 20},
                           scene::Plane::strain);
  s.boundary.emplace("two.out", fixed(0, 0));
  s.boundary.emplace("one.in", traction(constant(0), constant(-10)));
  s.refine.strategy = scene::Strategy::adaptive;
  s.refine.target = 0.03;
  const auto outcome = bounds::run(s);
  ASSERT_EQ(outcome.status, scene::Status::done) << outcome.reason;
  const auto pressures = bounds::contact_pressure(outcome.problem, outcome.stress);
  std::vector<std::pair<double, double>> by_angle;  // mean pressures of the edges
  for (std::size_t j = 0; j < pressures.size(); ++j) {
    const auto& [a, b] = outcome.problem.mesh.boundary[outcome.problem.contact[j].first].vertices;
    const Vector<2> x = (outcome.problem.mesh.vertices[a] + outcome.problem.mesh.vertices[b]) / 2;
    by_angle.emplace_back(std::atan2(x[0], -x[1]), (pressures[j][0] + pressures[j][1]) / 2);
  }
  std::ranges::sort(by_angle);
  const double largest = largest_pressure(outcome);
  ASSERT_GT(largest, 0);
  EXPECT_GT(by_angle.front().second, 0.95 * largest);
  for (std::size_t j = 1; j < by_angle.size(); ++j)
    EXPECT_LE(by_angle[j].second, by_angle[j - 1].second + 0.02 * largest) << by_angle[j].first;
}

/// A block above an obstacle, pressed down.
Scene<2> block_above(scene::Side obstacle, scene::Function<2> gap) {
  Scene<2> s;
  s.blocks = {block("b", -1, 1, 0, 1, 8, 4)};
  s.bodies = {{"b", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
  s.boundary = {{"b.left", sliding(0)}, {"b.top", fixed(0, -0.03)}};
  std::optional<scene::Function<2>> given;
  if (gap) given = gap;
  s.contact = {{"b.bottom", std::move(obstacle), given, ""}};
  s.refine.strategy = scene::Strategy::uniform;
  s.refine.max_levels = 3;
  return s;
}

void expect_same(const Scene<2>& one, const Scene<2>& other) {
  const auto a = bounds::run(one), b = bounds::run(other);
  expect_same_levels(a, b, 1e-11);
  for (const bounds::Level& level : a.levels) EXPECT_LE(level.bracket.lower, level.bracket.upper);
}

// The distance to an obstacle is the gap that it makes.
TEST(Obstacles, AreTheGapsThatTheyMake) {
  expect_same(block_above(scene::LineObstacle{{5, -0.01}, {0, 3}}, {}), block_above("rigid", constant(0.01)));
  const auto circle = scene::enclosed<2>([](const auto& x) {
    using std::sqrt;
    return 50 - sqrt(2500 - x[0] * x[0]);
  });
  expect_same(block_above(scene::CircleObstacle{{{0, -50}, 50}}, {}), block_above("rigid", circle));
  const auto bowl = scene::enclosed<2>([](const auto& x) {
    using std::sqrt;
    return sqrt(2500 - x[0] * x[0]) - 50 + 0.02;
  });
  expect_same(block_above(scene::CircleObstacle{{{0, 49.98}, 50}, true}, {}), block_above("rigid", bowl));
}

// A line that is inclined acts against its normal, not along the block's.
TEST(Obstacles, OfALineActAgainstItsNormal) {
  const double slope = 0.1;
  Scene<2> s = block_above(scene::LineObstacle{{0, -0.02}, {-slope, 1}}, {});
  const scene::Problem<2> problem = scene::fix_data(s, scene::build_mesh(s));
  ASSERT_EQ(problem.contact.size(), 8u);
  const Vector<2> d = Vector<2>(slope, -1).normalized();
  for (const auto& pair : problem.contact) {
    EXPECT_LT((problem.facets[pair.first].normal - d).norm(), 1e-15);
    for (int i = 0; i < 2; ++i) {
      const Vector<2>& x = problem.mesh.vertices[problem.mesh.boundary[pair.first].vertices[i]];
      EXPECT_NEAR(pair.lower[2 * i], (x[1] + 0.02 - slope * x[0]) / std::hypot(1, slope), 1e-15);
    }
  }
  const auto outcome = bounds::run(s);
  EXPECT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
  s.contact[0].second = scene::LineObstacle{{0, -0.02}, {-1, 1}};  // more than 25 degrees off
  EXPECT_THROW(scene::fix_data(s, scene::build_mesh(s)), scene::Error);
}

}  // namespace
}  // namespace bracket::tests
