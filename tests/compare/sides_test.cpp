// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Contact lines as they are meshed: sides that do not match, do not coincide, are not equally long.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numbers>

#include "bounds/bounds.h"
#include "tests/compare/same_levels.h"
#include "tests/scene/inputs.h"
#include "tests/support/random_sides.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

namespace bracket::tests {
namespace {

using scene::Mesh;
using scene::Scene;

/// The scene's mesh, turned about the origin.
bounds::Outcome<2> run_turned(const Scene<2>& scene, double degrees) {
  Mesh<2> mesh = scene::build_mesh(scene);
  for (Vector<2>& x : mesh.vertices) x = Eigen::Rotation2Dd(degrees * std::numbers::pi / 180) * x;
  return bounds::run(scene, scene::fix_data(scene, std::move(mesh)));
}

/// Blocks of width 1, `edges` wide each, on top of each other from y = 0 on, the top lowered; they float sideways.
Scene<2> pile(const std::vector<int>& edges, double height, double lowering, double poisson) {
  Scene<2> s;
  const double each = height / static_cast<double>(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::string name = std::to_string(i);
    s.blocks.push_back(block(name, 0, 1, static_cast<double>(i) * each, static_cast<double>(i + 1) * each, edges[i],
                             std::max(1, edges[i] / 4)));
    s.bodies.emplace(name, scene::isotropic<2>(2e6, poisson, scene::Plane::strain));
    if (i > 0) s.contact.push_back({name + ".bottom", std::to_string(i - 1) + ".top", {}, ""});
  }
  s.boundary = {{"0.bottom", sliding(0)}, {std::to_string(edges.size() - 1) + ".top", sliding(-lowering)}};
  return s;
}

/// The energy of a pile of height 2, lowered by 0.1.
double energy_of_pile(double poisson) { return 0.5 * 2e6 / (1 - poisson * poisson) * 0.1 * 0.1 / 2; }

double relative_width(const std::vector<int>& edges, double poisson, double degrees) {
  const auto outcome = run_turned(pile(edges, 2, 0.1, poisson), degrees);
  EXPECT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
  // Turned, the exact energy is that of coordinates before they were rounded.
  const double energy = energy_of_pile(poisson), slack = degrees == 0 ? 0 : 1e-13 * energy;
  EXPECT_LE(outcome.lower, energy + slack);
  EXPECT_GE(outcome.upper, energy - slack);
  return (outcome.upper - outcome.lower) / energy;
}

// One stress everywhere is in both spaces, on every mesh: the bounds are the energy. SSNP121 is the one of height 2,
// lowered by 0.1, with ν = 0: there p = 1e5.
TEST(Sides, PatchesOfAnyEdgesAreExact) {
  for (const auto& edges : {std::vector{4, 6}, {6, 4}, {67, 4}, {4, 67}, {3, 8, 5}})
    for (const double degrees : {0.0, 37.0}) {
      if (tests::sanitized && std::ranges::max(edges) > 10) continue;
      SCOPED_TRACE(testing::Message() << edges[0] << " below " << edges[1] << ", turned " << degrees);
      // What rounding of turned coordinates does to edges as short as these, it does to sides that match; how much for
      // one material is luck.
      const std::vector<int> finest(edges.size(), std::ranges::max(edges));
      const double matching = std::max(relative_width(finest, 0, degrees), relative_width(finest, 0.3, degrees));
      for (const double poisson : {0.0, 0.3})
        EXPECT_LE(relative_width(edges, poisson, degrees), std::max(1e-12, 2 * matching));  // two draws
    }
}

/// A short block on a long one, with an eccentric load: part of the contact opens.
struct Overhang {
  int edges_below = 10, edges_above = 6;
  double gap = 0;
  bool swapped = false;
};
Scene<2> overhang(const Overhang& of) {
  Scene<2> s;
  s.blocks = {block("lower", 0, 1, -0.5, 0, of.edges_below, of.edges_below / 2),
              block("upper", 0.2, 0.8, of.gap, of.gap + 0.4, of.edges_above, 4)};
  s.bodies = {{"lower", scene::isotropic<2>(1, 0.3, scene::Plane::strain)},
              {"upper", scene::isotropic<2>(2, 0.3, scene::Plane::strain)}};
  s.boundary = {{"lower.bottom", fixed(0, 0)},
                {"upper.left", sliding(0)},
                {"upper.top",
                 traction(0, scene::enclosed<2>([](const auto& x) { return scene::choose(x[0] < 0.5, -0.1, 0.02); }))}};
  const scene::Side above = "upper.bottom", below = "lower.top";
  s.contact = {{of.swapped ? below : above, of.swapped ? above : below, {}, ""}};
  s.refine.strategy = scene::Strategy::uniform;
  s.refine.max_levels = 3;
  return s;
}

void expect_meet(const bounds::Outcome<2>& one, const bounds::Outcome<2>& other) {
  EXPECT_LE(one.lower, other.upper);
  EXPECT_LE(other.lower, one.upper);
}

// However the sides are cut, the problem is one: its intervals meet, and all close. The third matches by itself.
TEST(Sides, IntervalsOfDifferentMeshesMeet) {
  std::vector<bounds::Outcome<2>> outcomes;
  for (const auto& [below, above] : {std::pair(10, 6), {7, 4}, {20, 12}, {12, 2}}) {
    outcomes.push_back(bounds::run(overhang({below, above})));
    const auto& outcome = outcomes.back();
    ASSERT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
    ASSERT_EQ(outcome.levels.size(), 3u);
    const auto width = [&](std::size_t level) {
      return outcome.levels[level].bracket.upper - outcome.levels[level].bracket.lower;
    };
    EXPECT_LE(width(2), 0.25 * width(0));
  }
  for (const auto& one : outcomes)
    for (const auto& other : outcomes) expect_meet(one, other);
}

// At a distance that a gap of zero denies, the energies are those of sides that touch: no equation sees the distance
// but the balance of moments, to which pressures along d add nothing.
TEST(Sides, ADistanceIsNoGapWhereItIsSaidToBeNone) {
  Scene<2> touching = overhang({7, 5}), apart = overhang({7, 5, 3.0});
  touching.contact[0].gap = apart.contact[0].gap = constant(0);
  const auto one = bounds::run(touching), other = bounds::run(apart);
  expect_same_levels(one, other, 1e-12);
}

TEST(Sides, SwappedAreTheSame) {
  for (const double gap : {0.0, 1e-3}) {
    const auto one = bounds::run(overhang({7, 5, gap, false})), other = bounds::run(overhang({7, 5, gap, true}));
    expect_same_levels(one, other, 1e-12);
    for (std::size_t i = 0; i < one.levels.size(); ++i) EXPECT_EQ(one.levels[i].cells, other.levels[i].cells);
  }
}

// A gap that is drawn is the one that is written: cases/drawn_gap.
TEST(Sides, AGapAsDrawnIsTheGapAsWritten) {
  Scene<2> drawn = overhang({10, 6, 0.125}), written = overhang({10, 6});
  written.contact[0].gap = constant(0.125);
  for (Scene<2>* s : {&drawn, &written}) s->boundary.at("upper.top") = fixed(0, -0.14);
  const auto one = bounds::run(drawn), other = bounds::run(written);
  expect_same_levels(one, other, 1e-12);
}

/// A unit square, sliding on its bottom, with a slit from the left to its middle, both faces of the part "crack".
Scene<2> cracked(const Folder& folder, double pressure_on_top) {
  constexpr int n = 4;
  scene::test::GmshContent content;
  content.names = "1 1 \"bottom\"\n1 2 \"top\"\n1 3 \"crack\"\n2 1 \"body\"\n";
  std::map<std::array<int, 3>, int> nodes;  // column, row, above the slit
  const auto node = [&](int i, int j, bool above) {
    const bool split = j == n / 2 && i < n / 2;
    const auto [at, is_new] = nodes.try_emplace({i, j, split && above ? 1 : 0}, static_cast<int>(content.nodes.size()));
    if (is_new) content.nodes.push_back({static_cast<double>(i) / n, static_cast<double>(j) / n});
    return at->second;
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const bool above = j >= n / 2;
      const int a = node(i, j, above), c = node(i + 1, j + 1, above);
      content.triangles.push_back({1, {a, node(i + 1, j, above), c}});
      content.triangles.push_back({1, {a, c, node(i, j + 1, above)}});
    }
  for (int i = 0; i < n; ++i) {
    content.lines.push_back({1, {node(i, 0, false), node(i + 1, 0, false)}});
    content.lines.push_back({2, {node(i, n, true), node(i + 1, n, true)}});
    for (const bool above : {false, true})
      if (i < n / 2) content.lines.push_back({3, {node(i, n / 2, above), node(i + 1, n / 2, above)}});
  }
  Scene<2> s;
  s.mesh_file = folder.write("cracked.msh", scene::test::gmsh_2(content));
  s.bodies = {{"body", scene::isotropic<2>(10, 0.3, scene::Plane::strain)}};
  s.boundary = {{"bottom", sliding(0)}, {"top", pressure(constant(pressure_on_top))}};
  s.contact = {{"crack", "crack", {}, ""}};
  s.refine.strategy = scene::Strategy::uniform;
  s.refine.max_levels = 2;
  return s;
}

// Pressed, it is as if it were whole; pulled, as if its faces had nothing to do with each other.
TEST(Sides, ACrackHasItsTwoFacesInContact) {
  const Folder folder;
  const auto pressed = bounds::run(cracked(folder, 0.5));
  ASSERT_EQ(pressed.guarantee, "rounding-safe") << pressed.reason;
  const double whole = -0.5 * 0.5 * 0.5 * (1 - 0.3 * 0.3) / 10;
  EXPECT_LE(pressed.lower, whole);
  EXPECT_GE(pressed.upper, whole);
  EXPECT_LE(pressed.upper - pressed.lower, 1e-12 * std::abs(whole));
  Scene<2> contact = cracked(folder, -0.5), open = contact;
  open.contact.clear();
  const auto one = bounds::run(contact), other = bounds::run(open);
  ASSERT_EQ(one.guarantee, "rounding-safe") << one.reason;
  EXPECT_NEAR(one.lower, other.lower, 1e-12 * std::abs(one.lower));
  EXPECT_NEAR(one.upper, other.upper, 1e-12 * std::abs(one.lower));
  EXPECT_LT(one.upper, 1.01 * whole);  // softer than the whole
}

// The first of those that bracket_random_sides judges.
TEST(Sides, OfRandomProblemsHaveIntervalsThatMeet) {
  int bracketed = 0;
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    const SidesVerdict verdict = judge_random_sides(seed);
    for (const std::string& fault : verdict.faults) ADD_FAILURE() << fault;
    bracketed += verdict.bracketed;
  }
  EXPECT_GE(bracketed, 40);  // or nothing would have been tested
}

}  // namespace
}  // namespace bracket::tests
