// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "scene/scene.h"

/// Scenes built in code, with parameters, for tests of several folders.
namespace bracket::tests {

using scene::ConditionKind;
using scene::Vector;

inline scene::Function<2> constant(double value) { return value; }

inline scene::Condition<2> fixed(double x, double y) { return {ConditionKind::fixed, {constant(x), constant(y)}, ""}; }
inline scene::Condition<2> sliding(double normal) { return {ConditionKind::sliding, {constant(normal)}, ""}; }
inline scene::Condition<2> pressure(scene::Function<2> p) { return {ConditionKind::pressure, {std::move(p)}, ""}; }
inline scene::Condition<2> traction(scene::Function<2> x, scene::Function<2> y) {
  return {ConditionKind::traction, {std::move(x), std::move(y)}, ""};
}

inline scene::Block<2> block(const std::string& body, double x0, double x1, double y0, double y1, int nx, int ny) {
  return {body, {{{x0, x1}, {y0, y1}}}, {nx, ny}, ""};
}

/// Two blocks, `upper` on `lower`, in contact over (x0, x1) at y = 0.
inline scene::Scene<2> two_bodies(double x0, double x1, double t_lower, double t_upper, int nx, int ny) {
  scene::Scene<2> s;
  s.blocks = {block("lower", x0, x1, -t_lower, 0, nx, ny), block("upper", x0, x1, 0, t_upper, nx, ny)};
  s.contact = {{"upper.bottom", "lower.top", constant(0), ""}};
  return s;
}

/// docs/theory.md §9.1: any ν with free sides and sliding base and top, the top lowered by `lowering`.
inline scene::Scene<2> patch(double young, double poisson, double lowering, int n) {
  scene::Scene<2> s = two_bodies(0, 1, 0.5, 0.5, n, n);
  s.bodies = {{"lower", scene::isotropic<2>(young, poisson, scene::Plane::strain)},
              {"upper", scene::isotropic<2>(young, poisson, scene::Plane::strain)}};
  s.boundary = {{"lower.bottom", sliding(0)}, {"upper.top", sliding(-lowering)}};
  return s;
}

/// docs/theory.md §9.3. Both bodies float sideways.
struct LinearPressure {
  double p0 = 1, c = 0.5;
  double t_lower = 1, t_upper = 0.5;
  double young_lower = 1, young_upper = 2;
  double poisson = 0.3;
};
inline scene::Scene<2> linear_pressure(const LinearPressure& p, int nx, int ny) {
  scene::Scene<2> s = two_bodies(-1, 1, p.t_lower, p.t_upper, nx, ny);
  s.bodies = {{"lower", scene::isotropic<2>(p.young_lower, p.poisson, scene::Plane::strain)},
              {"upper", scene::isotropic<2>(p.young_upper, p.poisson, scene::Plane::strain)}};
  s.boundary = {{"lower.bottom", sliding(0)},
                {"upper.top", pressure(scene::enclosed<2>([p](const auto& x) { return p.p0 * (1 - p.c * x[0]); }))}};
  return s;
}

/// docs/theory.md §9.2: partial lift-off, or closed contact with +0.02 for +0.09.
inline scene::Scene<2> two_blocks(int n, double pull = 0.09) {
  scene::Scene<2> s;
  s.blocks = {block("lower", 0, 1, 0, 1, n, n), block("upper", 0, 1, 1, 2, n, n)};
  s.bodies = {{"lower", scene::isotropic<2>(1, 0.3, scene::Plane::strain)},
              {"upper", scene::isotropic<2>(2, 0.3, scene::Plane::strain)}};
  s.boundary = {{"lower.bottom", fixed(0, 0)},
                {"upper.left", sliding(0)},
                {"upper.top", traction(constant(0), scene::enclosed<2>([pull](const auto& x) {
                                         return scene::choose(x[0] < 0.5, -0.1, pull);
                                       }))}};
  s.contact = {{"upper.bottom", "lower.top", constant(0), ""}};
  return s;
}

/// A scene with everything that has a term of its own in the energies: body force, prescribed displacements, sliding
/// supports, tractions, a gap that opens and one that overlaps, a wall and a second body.
inline scene::Scene<2> everything(int nx, int ny_lower, int ny_upper) {
  scene::Scene<2> s;
  s.blocks = {block("lower", 0, 1, 0, 1, nx, ny_lower), block("upper", 0, 1, 1, 2, nx, ny_upper)};
  s.bodies = {{"lower", scene::isotropic<2>(1, 0.3, scene::Plane::strain)},
              {"upper", scene::isotropic<2>(5, 0.4, scene::Plane::strain)}};
  s.bodies.at("lower").force = {0.01, -0.05};
  s.boundary = {
      {"lower.left", sliding(-0.02)},
      {"upper.right", fixed(0.01, -0.03)},
      {"upper.top", traction(scene::enclosed<2>([](const auto& x) { return 0.01 * x[0]; }), constant(-0.05))}};
  s.contact = {
      {"upper.bottom", "lower.top", scene::enclosed<2>([](const auto& x) { return 0.02 * (x[0] - 0.6) * x[0]; }), ""},
      {"lower.bottom", "rigid", scene::enclosed<2>([](const auto& x) { return 0.01 * x[0] * x[0]; }), ""}};
  return s;
}

/// The Airy stress x² y², i.e. σ = (2x², 2y², −4xy), on the unit square: its tractions are linear on each side, and it
/// is compatible in an orthotropic material with S66 = −2 S12. Quadratic stress, cubic displacement: in neither space,
/// with data that every mesh carries exactly. L(u) = −½ ∫ σ : C⁻¹ σ = −½ (8/5 + (8 S12 + 16 S66)/9) = −1.2.
inline scene::Scene<2> smooth(int n) {
  scene::Scene<2> s;
  s.blocks = {block("b", 0, 1, 0, 1, n, n)};
  scene::Elasticity<2> compliance;
  compliance << 1, -0.3, 0, -0.3, 1, 0, 0, 0, 0.6;
  s.bodies = {{"b", scene::anisotropic<2>(compliance.inverse())}};
  s.boundary = {
      {"b.right", traction(constant(2), scene::enclosed<2>([](const auto& x) { return -4 * x[1]; }))},
      {"b.top", traction(scene::enclosed<2>([](const auto& x) { return -4 * x[0]; }), constant(2))},
  };
  return s;
}
inline constexpr double smooth_energy = -1.2;

inline scene::Problem<2> problem(const scene::Scene<2>& s) { return scene::fix_data(s, scene::build_mesh(s)); }

}  // namespace bracket::tests
