// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bounds/bounds.h"
#include "tests/compare/admissible.h"
#include "tests/scene/inputs.h"
#include "tests/support/scenes.h"

namespace bracket::tests {
namespace {

using scene::Plane;
using scene::Scene;

/// Two blocks, `upper` on `lower`, bonded, held below, pulled and sheared above.
Scene<2> bimaterial(double young_lower, double young_upper, int n) {
  Scene<2> s;
  s.blocks = {block("lower", 0, 1, 0, 1, n, n), block("upper", 0, 1, 1, 2, n, n)};
  s.bodies = {{"lower", scene::isotropic<2>(young_lower, 0.3, Plane::strain)},
              {"upper", scene::isotropic<2>(young_upper, 0.3, Plane::strain)}};
  s.boundary = {{"lower.bottom", fixed(0, 0)}, {"upper.top", traction(constant(0.1), constant(0.2))}};
  s.bonds = {{"upper.bottom", "lower.top", ""}};
  s.refine = {.strategy = scene::Strategy::adaptive, .max_levels = 3};
  return s;
}

TEST(Bonds, EqualTheBodyInOnePiece) {
  for (const int degree : {1, 2, 4}) {
    Scene<2> two = bimaterial(3, 3, 3), one = two;
    two.solve.degree = one.solve.degree = degree;
    one.bonds.clear();
    for (auto& of : one.blocks) of.body = "body";
    one.blocks[0].name = "lower";
    one.blocks[1].name = "upper";
    one.bodies = {{"body", scene::isotropic<2>(3, 0.3, Plane::strain)}};
    one.boundary = {{"body.lower.bottom", two.boundary.at("lower.bottom")},
                    {"body.upper.top", two.boundary.at("upper.top")}};
    const auto bonded = bounds::run(two), whole = bounds::run(one);
    ASSERT_EQ(bonded.levels.size(), whole.levels.size()) << bonded.reason;
    expect_admissible(bonded);
    for (std::size_t i = 0; i < whole.levels.size(); ++i) {
      EXPECT_NEAR(bonded.levels[i].bracket.lower, whole.levels[i].bracket.lower, 1e-12 * std::abs(whole.lower));
      EXPECT_NEAR(bonded.levels[i].bracket.upper, whole.levels[i].bracket.upper, 1e-12 * std::abs(whole.lower));
    }
  }
}

// Without strain across, ν = 0: two bars in series, pulled apart, far from the origin, of moduli as unlike as may be.
TEST(Bonds, CarryTension) {
  for (const double unlike : {2.0, 1e6})
    for (const double far : {0.0, 1e5}) {
      Scene<2> s = bimaterial(1, unlike, 2);
      s.blocks = {block("lower", far, far + 1, 0, 1, 2, 2), block("upper", far, far + 1, 1, 2, 2, 2)};
      for (auto& [name, body] : s.bodies)
        body.material = scene::isotropic<2>(name == "lower" ? 1 : unlike, 0, Plane::strain);
      s.boundary = {{"lower.bottom", sliding(0)},
                    {"lower.left", sliding(0)},
                    {"upper.top", traction(constant(0), constant(0.5))}};
      const double exact = -0.125 * (1 + 1 / unlike);
      const auto outcome = bounds::run(s);
      expect_admissible(outcome);
      for (const auto& level : outcome.levels) {
        EXPECT_LE(level.bracket.lower, exact);
        EXPECT_GE(level.bracket.upper, exact);
        EXPECT_LE(level.bracket.upper - level.bracket.lower, 1e-10 * std::abs(exact));
      }
    }
}

// A crack is what of the line is not bonded: each bound lies where those of the wholly bonded and the parted body let
// it.
TEST(Bonds, LeaveACrackWhereTheLineIsInContact) {
  Scene<2> s = bimaterial(1, 5, 2);
  s.blocks = {block("lower", 0, 1, 0, 1, 2, 2), block("lower", 1, 2, 0, 1, 2, 2), block("upper", 0, 1, 1, 2, 2, 2),
              block("upper", 1, 2, 1, 2, 2, 2)};
  s.blocks[0].name = s.blocks[2].name = "left";
  s.blocks[1].name = s.blocks[3].name = "right";
  s.boundary = {{"lower.left.bottom", fixed(0, 0)},
                {"lower.right.bottom", fixed(0, 0)},
                {"upper.left.top", traction(constant(0), constant(-0.1))},
                {"upper.right.top", traction(constant(0), constant(0.2))}};
  Scene<2> cracked = s, whole = s;
  cracked.bonds = {{"upper.right.bottom", "lower.right.top", ""}};
  cracked.contact = {{"upper.left.bottom", "lower.left.top", constant(0), ""}};
  using Parts = std::vector<std::string>;
  whole.bonds = {{Parts{"upper.left.bottom", "upper.right.bottom"}, Parts{"lower.left.top", "lower.right.top"}, ""}};
  const auto with = bounds::run(cracked), without = bounds::run(whole);
  expect_admissible(with);
  expect_admissible(without);
  EXPECT_EQ(with.problem.mesh.components, std::vector<std::string>{"lower + upper"});
  EXPECT_LE(with.lower, without.upper);  // more displacements are admissible
}

TEST(Bonds, RefuseSidesThatAreNotOne) {
  using scene::Status;
  const auto refused = [](const Scene<2>& s, Status status, const std::vector<std::string>& named) {
    scene::test::expect_error([&] { scene::fix_data(s, scene::build_mesh(s)); }, status, named);
  };
  Scene<2> s = bimaterial(1, 2, 2);
  s.bonds = {{"upper.bottom", "lower.topp", "here"}};
  refused(s, Status::input, {"here", "'lower.topp'", "'lower.top'"});
  s.bonds = {{"upper.bottom", "rigid", "here"}};
  refused(s, Status::input, {"here", "fixed = [0, 0]"});
  s.bonds = {{"upper.top", "lower.top", "here"}};
  refused(s, Status::input, {"here", "'upper.top'", "condition"});
  s = bimaterial(1, 2, 2);
  s.contact = {{"upper.bottom", "rigid", constant(0), ""}};
  refused(s, Status::input, {"upper.bottom", "in contact too"});
  s = bimaterial(1, 2, 2);
  s.blocks[1].cells = {3, 2};  // other nodes
  refused(s, Status::mesh, {"node by node", "has no partner", "nearest"});
  s = bimaterial(1, 2, 2);
  s.blocks[1].range[1] = {1.01, 2};
  refused(s, Status::mesh, {"node by node", "0.01 away"});
  s = bimaterial(1, 2, 2);
  Scene<2> apart = s;
  apart.bonds.clear();
  scene::test::expect_error([&] { scene::fix_data(s, scene::build_mesh(apart)); }, Status::mesh,
                            {"build_mesh() joins"});
}

TEST(Bonds, AreReadFromFiles) {
  const scene::test::Folder folder;
  std::string text = scene::test::two_blocks();
  const std::string gap = "gap = \"0.01*x^2\"";
  const auto with = [&](const std::string& law) { return std::string(text).replace(text.find(gap), gap.size(), law); };
  const Scene<2> s = scene::read_scene<2>(folder.write("a.toml", with("law = \"bonded\"")));
  EXPECT_TRUE(s.contact.empty());
  ASSERT_EQ(s.bonds.size(), 1u);
  EXPECT_EQ(scene::build_mesh(s).components.size(), 1u);
  EXPECT_EQ(scene::read_scene<2>(folder.write("b.toml", with("law = \"frictionless\""))).contact.size(), 1u);
  const auto refused = [&](const std::string& law, const std::vector<std::string>& named) {
    scene::test::expect_error([&] { scene::read_scene<2>(folder.write("c.toml", with(law))); }, scene::Status::input,
                              named);
  };
  refused("law = \"bond\"", {"c.toml:30", "'bonded'"});
  refused("law = \"bonded\"\ngap = 0", {"c.toml:31", "no gap"});
  refused("law = \"bonded\"\n[[contact]]\nfirst = \"rigid\"\nsecond = \"lower.top\"\nlaw = \"bonded\"",
          {"c.toml:32", "fixed = [0, 0]"});
}

}  // namespace
}  // namespace bracket::tests
