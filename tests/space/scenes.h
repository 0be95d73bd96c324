// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "scene/scene.h"

/// Scenes in space with known answers.
namespace bracket::tests::space {

using scene::ConditionKind;
using Function = scene::Function<3>;

inline scene::Condition<3> fixed() { return {ConditionKind::fixed, {0.0, 0.0, 0.0}, ""}; }
inline scene::Condition<3> sliding(double normal = 0) { return {ConditionKind::sliding, {normal}, ""}; }
inline scene::Condition<3> traction(Function x, Function y, Function z) {
  return {ConditionKind::traction, {std::move(x), std::move(y), std::move(z)}, ""};
}

using Range = std::array<double, 2>;
inline scene::Block<3> block(const std::string& body, Range x, Range y, Range z, std::array<int, 3> cells) {
  return {body, {x, y, z}, cells};
}
inline scene::Body<3> isotropic(double young, double poisson) {
  return {scene::isotropic<3>(young, poisson, scene::Plane::strain)};
}

/// docs/theory.md §9.2 extruded by ½ between sliding ends: half the energy of the plane.
inline scene::Scene<3> two_blocks(int n, double pull = 0.09, double poisson = 0.3) {
  scene::Scene<3> s;
  s.blocks = {block("lower", {0, 1}, {0, 1}, {0, 0.5}, {n, n, n / 2}),
              block("upper", {0, 1}, {1, 2}, {0, 0.5}, {n, n, n / 2})};
  s.bodies = {{"lower", isotropic(1, poisson)}, {"upper", isotropic(2, poisson)}};
  s.boundary = {
      {"lower.bottom", fixed()},
      {"upper.left", sliding()},
      {"upper.top",
       traction(0.0, scene::enclosed<3>([pull](const auto& x) { return scene::choose(x[0] < 0.5, -0.1, pull); }),
                0.0)}};
  for (const char* end : {"lower.back", "lower.front", "upper.back", "upper.front"}) s.boundary[end] = sliding();
  s.contact = {{"upper.bottom", "lower.top", 0.0, ""}};
  return s;
}
inline constexpr double two_blocks_least = -0.00156588569415 / 2, two_blocks_most = -0.00156588566432 / 2;

/// docs/theory.md §12.6: uniaxial, σ_zz = −(1 − c x − c′ y); each body keeps three motions. L = −3.3125.
inline scene::Scene<3> linear_pressure(int n, double poisson) {
  scene::Scene<3> s;
  s.blocks = {block("lower", {-1, 1}, {-1, 1}, {-1, 0}, {n, n, n / 2}),
              block("upper", {-1, 1}, {-1, 1}, {0, 1}, {n, n, n / 2})};
  s.bodies = {{"lower", isotropic(1, poisson)}, {"upper", isotropic(2, poisson)}};
  s.boundary = {{"lower.back", sliding()}, {"upper.front", traction(0.0, 0.0, scene::enclosed<3>([](const auto& x) {
                                                                      return -(1 - 0.5 * x[0] - 0.25 * x[1]);
                                                                    }))}};
  s.contact = {{"upper.back", "lower.front", 0.0, ""}};
  return s;
}
inline constexpr double linear_pressure_energy = -3.3125;

/// Two blocks of 1 × 1 × ½, the upper one's top lowered by 0.01: p = 1e4, L = 50 whatever ν is.
inline scene::Scene<3> patch(int n, double poisson) {
  scene::Scene<3> s;
  s.blocks = {block("lower", {0, 1}, {0, 1}, {-0.5, 0}, {n, n, n / 2}),
              block("upper", {0, 1}, {0, 1}, {0, 0.5}, {n, n, n / 2})};
  s.bodies = {{"lower", isotropic(1e6, poisson)}, {"upper", isotropic(1e6, poisson)}};
  s.boundary = {{"lower.back", sliding()}, {"upper.front", sliding(-0.01)}};
  s.contact = {{"upper.back", "lower.front", 0.0, ""}};
  return s;
}
inline constexpr double patch_energy = 50;

/// A block on a rigid wall, clamped at a side, its top pressed and pulled: it lifts off in part.
inline scene::Scene<3> on_a_wall(int n, double poisson) {
  scene::Scene<3> s;
  s.blocks = {block("b", {0, 1}, {0, 1}, {0, 1}, {n, n, n})};
  s.bodies = {{"b", isotropic(1, poisson)}};
  s.boundary = {{"b.left", fixed()},
                {"b.front", traction(0.0, 0.0, scene::enclosed<3>([](const auto& x) { return 0.2 * x[1] - 0.1; }))}};
  s.contact = {{"b.back", "rigid", 0.0, ""}};
  return s;
}

/// Everything that has a term of its own: weight, prescribed displacements, sliding supports, tractions, pressure, a
/// gap that opens, one that overlaps and is curved, a wall and a second body, moduli 1 : 5.
inline scene::Scene<3> everything(int n) {
  scene::Scene<3> s;
  s.blocks = {block("lower", {0, 1}, {0, 1}, {0, 1}, {n, n, n}), block("upper", {0, 1}, {1, 2}, {0, 1}, {n, n, n})};
  s.bodies = {{"lower", isotropic(1, 0.3)}, {"upper", isotropic(5, 0.4)}};
  s.bodies.at("lower").force = {0.01, -0.05, 0.02};
  s.boundary = {
      {"lower.left", sliding(-0.02)},
      {"upper.right", {ConditionKind::fixed, {0.01, -0.03, 0.005}, ""}},
      {"lower.front", {ConditionKind::pressure, {scene::enclosed<3>([](const auto& x) { return 0.02 * x[1]; })}, ""}},
      {"lower.back", sliding()},
      {"upper.top", traction(scene::enclosed<3>([](const auto& x) { return 0.01 * x[2]; }), -0.05, 0.01)}};
  s.contact = {{"upper.bottom", "lower.top",
                scene::enclosed<3>([](const auto& x) { return 0.02 * (x[0] - 0.6) * x[0] + 0.01 * x[2] * x[2]; }), ""},
               {"lower.bottom", "rigid", scene::enclosed<3>([](const auto& x) { return 0.01 * x[0] * x[0]; }), ""}};
  return s;
}

}  // namespace bracket::tests::space
