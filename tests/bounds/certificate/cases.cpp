// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bounds/certificate/cases.h"

#include <algorithm>
#include <random>

#include "bounds/bounds.h"

namespace bracket::tests {

namespace {

/// A block that nothing but a wall holds in the middle of its load, and that only the data balance sideways.
scene::Scene<2> on_a_wall() {
  scene::Scene<2> s;
  s.blocks = {block("block", -1, 1, 0, 1, 3, 2)};
  s.bodies = {{"block", scene::isotropic<2>(3, 0.45, scene::Plane::strain)}};
  s.bodies.at("block").force = {0, -0.3};
  s.contact = {{"block.bottom", "rigid", constant(0), ""}};
  s.boundary = {{"block.top", pressure([](const auto& x) { return 1 - 0.7 * x[0]; })}};
  return s;
}

/// Full anisotropy, sliding along two sides, squeezed by an interference.
scene::Scene<2> interference() {
  scene::Scene<2> s = two_bodies(0, 2, 1, 0.5, 3, 1);
  scene::Elasticity<2> stiffness;
  stiffness << 4, 1.3, 0.7, 1.3, 2, -0.4, 0.7, -0.4, 1.1;
  s.bodies = {{"lower", scene::anisotropic<2>(stiffness)},
              {"upper", scene::isotropic<2>(1e3, 0.4999, scene::Plane::strain)}};
  s.boundary = {{"lower.bottom", sliding(0.01)}, {"lower.left", sliding(-0.02)}, {"upper.top", fixed(0, 0)}};
  s.contact[0].gap = [](const auto& x) { return -0.07 + 0.03 * x[0]; };
  return s;
}

scene::Scene<2> negative_poisson() {
  scene::Scene<2> s = two_blocks(2);
  s.plane = scene::Plane::stress;
  s.bodies = {{"lower", scene::isotropic<2>(1, -0.9, s.plane)}, {"upper", scene::isotropic<2>(1e-6, 0.5, s.plane)}};
  return s;
}

/// Two bodies whose common end is carried away and turned: their displacements are prescribed where the contact ends.
scene::Scene<2> turned_end() {
  scene::Scene<2> s = two_blocks(2);
  const scene::Condition<2> turn = {
      ConditionKind::fixed,
      {[](const auto& x) { return 0.1 - 0.01 * x[1]; }, [](const auto& x) { return 0.3 + 0.01 * x[0]; }},
      ""};
  s.boundary = {{"lower.left", turn}, {"upper.left", turn}, {"upper.top", pressure(constant(0.1))}};
  return s;
}

/// Turned by the angle of the triangle 3-4-5 and stretched by 5/4. Coordinates that are multiples of a power of two
/// stay so, and sides along axes become sides of rational length.
Vector<2> map(const Vector<2>& x) { return {x[0] - 0.75 * x[1], 0.75 * x[0] + x[1]}; }

}  // namespace

scene::Scene<2> touching_end(double down) {
  scene::Scene<2> s;
  s.blocks = {block("block", 0, 1, 0, 1, 2, 2)};
  s.bodies = {{"block", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
  s.boundary = {{"block.left", fixed(0.5 * down, -down)}, {"block.top", pressure(constant(0.1))}};
  s.contact = {{"block.bottom", "rigid", constant(down), ""}};
  return s;
}

std::vector<Case> cases() {
  std::vector<Case> result = {{"everything", everything(2, 2, 2)},
                              {"on_a_wall", on_a_wall()},
                              {"interference", interference()},
                              {"negative_poisson", negative_poisson()},
                              {"lift_off", two_blocks(2)},
                              {"linear_pressure", linear_pressure({}, 3, 2)},
                              {"nearly_incompressible", linear_pressure({.poisson = 0.4999}, 2, 2)},
                              {"contrast", linear_pressure({.young_lower = 1e6}, 2, 2)},
                              {"patch", patch(1e6, 0, 0.01, 2)},
                              {"turned_end", turned_end()},
                              {"touching_end", touching_end(0.1)},
                              {"touching_at_rest", touching_end(0)},
                              {"nothing_held", smooth(2)}};
  const std::vector<Case> plain = result;
  const auto add = [&](const std::string& name, bool inclined, double disturb) {
    const auto found = std::find_if(plain.begin(), plain.end(), [&](const Case& c) { return c.name == name; });
    result.push_back({name + (inclined ? "_inclined" : "_disturbed"), found->scene, inclined, disturb});
  };
  for (const char* name : {"everything", "interference", "on_a_wall", "nearly_incompressible", "contrast"})
    add(name, false, 0.05);
  for (const char* name : {"everything", "interference", "lift_off", "patch", "turned_end", "touching_at_rest"})
    add(name, true, 0);
  return result;
}

scene::Problem<2> problem_of(const Case& c) {
  auto mesh = scene::build_mesh(c.scene);
  std::vector<char> on_boundary(mesh.vertices.size(), 0);
  for (const auto& facet : mesh.boundary)
    for (const int v : facet.vertices) on_boundary[v] = 1;
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> noise(-c.disturb, c.disturb);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (!on_boundary[v] && c.disturb > 0) mesh.vertices[v] += Vector<2>(noise(generator), noise(generator));
  if (c.inclined)
    for (Vector<2>& x : mesh.vertices) x = map(x);
  return bounds::balanced(scene::fix_data(c.scene, mesh), 2);
}

}  // namespace bracket::tests
