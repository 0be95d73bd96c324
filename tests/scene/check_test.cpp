// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>

#include "tests/scene/inputs.h"

namespace bracket::scene {
namespace {

using namespace test;

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

struct Wrong {
  std::function<void(Scene<2>&)> change;
  std::vector<std::string> named;
};

Scene<2> right() {
  Scene<2> scene = stacked(2, {{"a.bottom", {ConditionKind::fixed, {constant(0), constant(0)}}},
                               {"b.top", {ConditionKind::pressure, {constant(1)}}}});
  scene.file = "the scene";
  return scene;
}

std::vector<Wrong> of_mesh() {
  return {
      {[](auto& s) { s.blocks.clear(); }, {"either a file or blocks"}},
      {[](auto& s) { s.mesh_file = "a.msh"; }, {"either a file or blocks"}},
      {[](auto& s) { s.blocks[1].body = ""; }, {"body must not be empty"}},
      {[](auto& s) { s.blocks[1].body = "a", ++s.blocks[1].cells[0]; }, {"two blocks of the body 'a'", "whole side"}},
      {[](auto& s) { s.blocks[1].body = "a", s.blocks[1].range[0][1] += 1; }, {"two blocks of the body 'a'"}},
      {[](auto& s) { s.blocks[1].body = "a", s.blocks[1].range = s.blocks[0].range; }, {"overlap"}},
      {[](auto& s) {
         s.blocks[1].range[1] = {2, 1};
       },
       {"the block of 'b'", "mesh.block.y = [2, 1]"}},
      {[](auto& s) {
         s.blocks[1].range[0] = {1, 1};
       },
       {"mesh.block.x"}},
      {[](auto& s) { s.blocks[1].range[0][1] = nan; }, {"mesh.block.x must be finite"}},
      {[](auto& s) { s.blocks[1].range[0][1] = 1e60; }, {"mesh.block.x", "1e+60"}},
      {[](auto& s) { s.blocks[0].cells[1] = 0; }, {"mesh.block.cells must be at least 1, is 0"}},
      {[](auto& s) { s.blocks[0].cells[0] = -4; }, {"mesh.block.cells", "-4"}},
      {[](auto& s) {
         s.blocks[0].cells = {2000000000, 2000000000};
       },
       {"20000000 cells"}},
      {[](auto& s) { s.bodies.emplace("bb", s.bodies.at("b")); }, {"no block makes the body 'bb'", "mean 'b'"}},
  };
}

std::vector<Wrong> of_the_rest() {
  return {
      {[](auto& s) { s.plane = Plane::stress; }, {"'a' is one of plane strain, the scene of plane stress"}},
      {[](auto& s) { s.bodies.at("b").material = isotropic<2>(1, 0.5, Plane::stress); },
       {"'b' is one of plane stress"}},
      {[](auto& s) { s.bodies.at("b").material = isotropic<2>(1e60, 0, Plane::strain); }, {"bodies.b.E", "1e+60"}},
      {[](auto& s) { s.bodies.at("b").material = anisotropic<2>(Elasticity<2>::Identity() * 1e-60); },
       {"bodies.b.stiffness", "1e-60"}},
      {[](auto& s) { s.bodies.at("b").force[1] = nan; }, {"bodies.b.body_force must be finite"}},
      {[](auto& s) { s.bodies.at("b").force[0] = -1e200; }, {"bodies.b.body_force", "-1e+200"}},
      {[](auto& s) { s.boundary.at("a.bottom").value.pop_back(); },
       {"\"a.bottom\".fixed must have 2 functions, has 1"}},
      {[](auto& s) { s.boundary.at("a.bottom").kind = ConditionKind::sliding; },
       {"\"a.bottom\".sliding", "1 function,"}},
      {[](auto& s) { s.boundary.at("b.top").kind = ConditionKind::traction; }, {"\"b.top\".traction", "has 1"}},
      {[](auto& s) { s.boundary.at("b.top").value.push_back(constant(0)); }, {"\"b.top\".pressure", "has 2"}},
      {[](auto& s) { s.boundary.at("b.top").value[0] = {}; }, {"\"b.top\".pressure", "empty"}},
      {[](auto& s) { s.contact[0].gap = Function<2>(); }, {"the gap of 'a.top'", "empty"}},
      {[](auto& s) { s.contact[0].first = "rigid"; }, {"contact.first", "second side"}},
      {[](auto& s) { s.contact[0].first = ""; }, {"contact.first must not be empty"}},
      {[](auto& s) { s.contact[0].second = ""; }, {"contact.second must not be empty"}},
      {[](auto& s) { s.contact[0].first = std::vector<std::string>{}; }, {"contact.first must name a boundary part"}},
      {[](auto& s) {
         s.contact[0].first = std::vector<std::string>{"a.top", "a.top"};
       },
       {"'a.top' is named twice"}},
      {[](auto& s) {
         s.contact[0].second = std::vector<std::string>{"b.bottom", "a.top"};
       },
       {"'a.top' is named twice"}},
      {[](auto& s) {
         s.contact[0].second = std::vector<std::string>{"b.bottom", "rigid"};
       },
       {"'rigid' alone"}},
      {[](auto& s) {
         s.contact.push_back({"b.top", "rigid", constant(0)});
       },
       {"'b.top'", "condition", "(pressure)"}},
  };
}

std::vector<Wrong> of_settings() {
  return {
      {[](auto& s) { s.solve.degree = 5; }, {"solve.degree must be from 1 to 4, is 5"}},
      {[](auto& s) {
         s.solve.degree = 3;
         s.solve.dual = Dual::uzawa;
       },
       {"solve.dual = \"uzawa\"", "solve.degree is 3", "\"hybrid\""}},
      {[](auto& s) {
         s.solve.degree = 3;
         s.solve.dual = Dual::local;
       },
       {"solve.dual = \"local\"", "degree 2", "solve.degree is 3", "\"hybrid\""}},
      {[](auto& s) { s.solve.sweeps = 1; }, {"solve.sweeps", "\"local\"", "\"hybrid\"", "leave them out"}},
      {[](auto& s) {
         s.solve.dual = Dual::local;
         s.solve.sweeps = 0;
       },
       {"solve.sweeps must be from 1 to 100, is 0"}},
      {[](auto& s) { s.solve.degree = 0; }, {"solve.degree"}},
      {[](auto& s) { s.refine.bulk = -3; }, {"refine.bulk must lie in (0, 1], is -3"}},
      {[](auto& s) { s.refine.bulk = 0; }, {"refine.bulk"}},
      {[](auto& s) { s.refine.bulk = 1.5; }, {"refine.bulk"}},
      {[](auto& s) { s.refine.bulk = nan; }, {"refine.bulk must be finite"}},
      {[](auto& s) { s.refine.target = -1; }, {"refine.target must not be negative"}},
      {[](auto& s) { s.refine.target = infinity; }, {"refine.target must be finite"}},
      {[](auto& s) { s.refine.max_levels = 0; }, {"refine.max_levels must be at least 1, is 0"}},
      {[](auto& s) { s.refine.max_cells = -1; }, {"refine.max_cells"}},
      {[](auto& s) { s.refine.max_seconds = 0; }, {"refine.max_seconds"}},
      {[](auto& s) { s.refine.max_seconds = nan; }, {"refine.max_seconds"}},
  };
}

void expect_fault(const std::function<void()>& action, const std::vector<std::string>& named) {
  const auto error = error_of(action);
  ASSERT_TRUE(error.has_value()) << named[0] << ": accepted";
  EXPECT_EQ(error->status(), Status::input) << error->what();
  EXPECT_EQ(std::string(error->what()).find('\n'), std::string::npos) << error->what();
  for (const std::string& part : named)
    EXPECT_NE(std::string(error->what()).find(part), std::string::npos) << part << ": " << error->what();
}

TEST(Check, StressesBuiltLocallyHaveNoQuantities) {
  Scene<2> scene = right();
  scene.solve.dual = Dual::local;
  EXPECT_NO_THROW(check(scene));
  Scene<2> asks = scene, zones = scene;
  asks.quantities.emplace_back();
  asks.quantities[0].name = "e";
  asks.quantities[0].kind = QuantityKind::energy;
  expect_fault([&] { check(asks); }, {"[[quantity]]", "solve.dual = \"hybrid\""});
  zones.contact.push_back({"b.bottom", "a.top", constant(0)});
  zones.contact.back().zones = 2;
  expect_fault([&] { check(zones); }, {"contact.zones", "solve.dual = \"hybrid\""});
}

// By check(), and by whatever would otherwise go on with it: build_mesh() with all of them, fix_data(), which is given
// a mesh, with what is not of the mesh.
TEST(Check, WhatAProgramGetsWrongIsRefused) {
  EXPECT_NO_THROW(check(right()));
  const Mesh<2> mesh = build_mesh(right());
  for (const bool mesh_matters : {true, false}) {
    std::vector<Wrong> all = mesh_matters ? of_mesh() : of_the_rest();
    if (!mesh_matters)
      for (const Wrong& wrong : of_settings()) all.push_back(wrong);
    for (const auto& [change, named] : all) {
      Scene<2> scene = right();
      change(scene);
      expect_fault([&] { check(scene); }, named);
      expect_fault([&] { build_mesh(scene); }, named);
      if (!mesh_matters) expect_fault([&] { fix_data(scene, mesh); }, named);
    }
  }
}

TEST(Check, SettingsAreCheckedAlone) {
  EXPECT_NO_THROW(check_settings({}, {}));
  for (const auto& [change, named] : of_settings()) {
    Scene<2> scene;
    change(scene);
    expect_fault([&, s = scene] { check_settings(s.refine, s.solve); }, named);
  }
}

TEST(Check, AMeshThatIsGivenNeedsNoBlocks) {
  Scene<2> scene = right();
  const Mesh<2> mesh = build_mesh(scene);
  scene.blocks.clear();
  EXPECT_NO_THROW(fix_data(scene, mesh));
}

TEST(Check, NamesThePlace) {
  Scene<2> scene = right();
  scene.blocks[1].where = "here";
  scene.blocks[1].cells[0] = 0;
  expect_fault([&] { check(scene); }, {"here: mesh.block.cells"});
  scene = right();
  scene.solve.degree = 5;
  expect_fault([&] { check(scene); }, {"the scene: solve.degree"});
}

}  // namespace
}  // namespace bracket::scene
