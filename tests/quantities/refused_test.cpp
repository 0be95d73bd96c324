// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/quantities/asked.h"

namespace bracket::tests {
namespace {

std::string refusal(const scene::Scene<2>& scene, const Quantity<2>& quantity) {
  try {
    outcome_of(scene, {quantity}, {});
  } catch (const scene::Error& error) {
    EXPECT_EQ(error.status(), scene::Status::input) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "";
}

void expect_refusal(const Quantity<2>& quantity, const std::string& part,
                    const scene::Scene<2>& scene = two_blocks(4)) {
  const std::string line = refusal(scene, quantity);
  EXPECT_NE(line.find(part), std::string::npos) << "'" << line << "' lacks '" << part << "'";
}

TEST(RefusedQuantities, one_clear_line) {
  const auto top = quantity(QuantityKind::displacement, "upper.top"),
             force = quantity(QuantityKind::force, "upper.bottom");
  expect_refusal(along(quantity(QuantityKind::displacement, "upper.tip"), 0, 1), "did you mean 'upper.top'");
  expect_refusal(along(quantity(QuantityKind::body, "uper"), 0, 1), "did you mean 'upper'");
  expect_refusal(quantity(QuantityKind::force, "lower.top"), "there is no contact 'lower.top'");
  expect_refusal(along(top, 0, 0), "direction must not be zero");
  expect_refusal(quantity(QuantityKind::body, "upper"), "a body has no normal");
  expect_refusal(along(quantity(QuantityKind::displacement, "lower.bottom"), 0, 1), "the part is fixed");
  expect_refusal(along(quantity(QuantityKind::displacement, "upper.left"), 2, 0),
                 "its displacement along its normal is given");
  expect_refusal(quantity(QuantityKind::rotation, "upper.left"), "its displacement along its normal is given");
  expect_refusal(quantity(QuantityKind::displacement, "upper.left"), "its displacement along its normal is given");
  expect_refusal(along(quantity(QuantityKind::reaction, "upper.top"), 0, 1), "neither fixed nor sliding");
  auto off = force;
  off.stretch = scene::LineStretch{0.5, 1.5};
  expect_refusal(off, "which goes from 0 to 1");
  auto narrow = force;
  narrow.stretch = scene::LineStretch{0.1, 0.3};
  expect_refusal(narrow, "too short for the edges of the first mesh");
  auto negative = force;
  negative.target = -1;
  expect_refusal(negative, "target must not be negative");
  expect_refusal(weighted(force, scene::enclosed<2>([](const auto& x) { return x[0] * x[0] * x[0]; })),
                 "not one quadratic on the edge");
  expect_refusal(weighted(force, scene::enclosed<2>([](const auto& x) { return scene::choose(x[0] < 0.5, 1.0, 0.0); })),
                 "jumps at (0.5, 1)");
  expect_refusal(weighted(quantity(QuantityKind::opening, "upper.bottom"),
                          scene::enclosed<2>([](const auto& x) { return x[0] * x[0]; })),
                 "must be linear on each edge");
}

TEST(RefusedQuantities, of_a_contact_with_a_name_by_its_part) {
  auto scene = two_blocks(4);
  scene.contact[0].name = "joint";
  expect_refusal(quantity(QuantityKind::force, "upper.bottom"),
                 "there is no contact 'upper.bottom'; did you mean 'joint'? Known: joint", scene);
}

TEST(RefusedQuantities, names_are_their_own) {
  auto scene = two_blocks(2);
  auto one = quantity(QuantityKind::force, "upper.bottom");
  scene.quantities = {one, one};
  EXPECT_THROW(scene::check(scene), scene::Error);
  scene.quantities = {one};
  EXPECT_NO_THROW(scene::check(scene));
  scene.refine.goal = "fource";
  EXPECT_THROW(scene::check(scene), scene::Error);
}

}  // namespace
}  // namespace bracket::tests
