// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "dual/dual.h"
#include "tests/support/scenes.h"

namespace bracket::dual {
namespace {

using scene::Vector;
using scene::Voigt;

/// Moves the inner vertices by up to a quarter of a cell, so that no cell is like another.
scene::Mesh<2> distorted(scene::Mesh<2> mesh, double cell, unsigned seed) {
  std::vector<bool> inner(mesh.vertices.size(), true);
  for (const auto& facet : mesh.boundary)
    for (const int v : facet.vertices) inner[v] = false;
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> shift(-cell / 4, cell / 4);
  for (std::size_t v = 0; v < inner.size(); ++v)
    if (inner[v]) mesh.vertices[v] += Vector<2>(shift(generator), shift(generator));
  return mesh;
}

/// Largest difference to a stress field that is linear in x, at all corners.
double misfit(const scene::Mesh<2>& mesh, const scene::Stress<2>& stress,
              const std::function<Voigt<2>(const Vector<2>&)>& exact) {
  double worst = 0;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto& v = mesh.cells[c];
    const Vector<2> centroid = (mesh.vertices[v[0]] + mesh.vertices[v[1]] + mesh.vertices[v[2]]) / 3;
    for (int k = 0; k < 3; ++k) {
      const std::array<Vector<2>, 3> part = {mesh.vertices[v[(k + 1) % 3]], mesh.vertices[v[(k + 2) % 3]], centroid};
      for (int i = 0; i < 3; ++i)
        worst = std::max(worst, (stress.cell[c][3 * k + i] - exact(part[i])).cwiseAbs().maxCoeff());
    }
  }
  return worst;
}

TEST(Hybrid, a_body_that_is_not_held_in_floating_point_is_named) {
  scene::Scene<2> scene;
  scene.blocks = {tests::block("slab", 0, 1, 0, 1, 2, 2)};
  scene.bodies = {{"slab", scene::anisotropic<2>(Eigen::Vector3d(1, 1e-17, 1e-17).asDiagonal())}};
  scene.boundary = {{"slab.left", tests::fixed(0, 0)}};
  const auto result = solve(tests::problem(scene), 1);
  EXPECT_EQ(result.termination, contact::Termination::not_definite);
  EXPECT_NE(result.reason.find("'slab'"), std::string::npos) << result.reason;
}

/// A stress field of zeros.
scene::Stress<2> none(const scene::Mesh<2>& mesh) {
  return {1, {mesh.cells.size(), std::vector<Voigt<2>>(9, Voigt<2>::Zero())}};
}

TEST(Uzawa, constant_stress_through_a_contact_is_found) {
  const auto scene = tests::patch(1e6, 0.3, 0.01, 1);
  const auto problem = scene::fix_data(scene, scene::build_mesh(scene));
  const auto result = uzawa(problem, none(problem.mesh));  // neither loads nor weight
  ASSERT_EQ(result.termination, contact::Termination::solved) << result.reason;
  const double p = 1e6 / (1 - 0.09) * 0.01;
  // The iteration ends where the estimated error is 1e-9 of the stress; the estimate is given a factor of ten.
  EXPECT_LT(misfit(problem.mesh, result.stress, [&](const auto&) { return Voigt<2>(0, -p, 0); }), 1e-8 * p);
}

TEST(Hybrid, constant_stress_through_a_contact_is_exact) {
  const auto scene = tests::patch(1e6, 0.3, 0.01, 5);
  const auto problem = scene::fix_data(scene, distorted(scene::build_mesh(scene), 0.1, 1));
  const auto result = solve(problem, 1);
  ASSERT_EQ(result.termination, contact::Termination::solved) << result.reason;
  EXPECT_EQ(result.statistics.active_rows, result.statistics.rows);
  const double p = 1e6 / (1 - 0.09) * 0.01;
  EXPECT_LT(misfit(problem.mesh, result.stress, [&](const auto&) { return Voigt<2>(0, -p, 0); }), 1e-10 * p);
}

TEST(Hybrid, linear_pressure_between_floating_bodies_is_exact) {
  const tests::LinearPressure p{.p0 = 2, .c = 0.9};
  const auto scene = tests::linear_pressure(p, 4, 3);
  const auto problem = scene::fix_data(scene, distorted(scene::build_mesh(scene), 0.15, 2));
  const auto result = solve(problem, 1);
  ASSERT_EQ(result.termination, contact::Termination::solved) << result.reason;
  const auto exact = [&](const Vector<2>& x) { return Voigt<2>(0, -p.p0 * (1 - p.c * x[0]), 0); };
  EXPECT_LT(misfit(problem.mesh, result.stress, exact), 1e-10 * p.p0);
}

TEST(Hybrid, weight_on_a_wall_is_exact_without_lateral_strain) {
  scene::Scene<2> scene;
  scene.blocks = {tests::block("block", 0, 2, 0, 1, 4, 3)};
  scene.bodies = {{"block", scene::isotropic<2>(3, 0, scene::Plane::strain)}};
  scene.bodies.at("block").force = {0, -0.5};
  scene.boundary = {{"block.left", tests::sliding(0)}};
  scene.contact = {{"block.bottom", "rigid", tests::constant(0), ""}};
  const auto problem = scene::fix_data(scene, distorted(scene::build_mesh(scene), 0.3, 3));
  const auto result = solve(problem, 1);
  ASSERT_EQ(result.termination, contact::Termination::solved) << result.reason;
  EXPECT_LT(misfit(problem.mesh, result.stress, [](const auto& x) { return Voigt<2>(0, -0.5 * (1 - x[1]), 0); }),
            1e-11);
}

TEST(Hybrid, tension_never_crosses_the_contact) {
  // A strong pull opens the contact; the pressure at the ends of each edge is what bounds it from below.
  const auto problem = tests::problem(tests::two_blocks(6));
  const auto result = solve(problem, 1);
  ASSERT_EQ(result.termination, contact::Termination::solved) << result.reason;
  EXPECT_GT(result.statistics.active_rows, 0);
  EXPECT_LT(result.statistics.active_rows, result.statistics.rows);
  for (const auto& pair : problem.contact) {
    const auto& facet = problem.mesh.boundary[pair.first];
    for (int i = 0; i < 2; ++i) EXPECT_LT(result.stress.cell[facet.cell][3 * facet.local + i][1], 1e-12);
  }
}

TEST(Hybrid, prescribed_displacements_enter_exactly) {
  // A uniform strain prescribed on the whole boundary: constant stress, whatever the mesh.
  scene::Scene<2> scene;
  scene.plane = scene::Plane::stress;
  scene.blocks = {tests::block("b", 0, 1, 0, 1, 3, 3)};
  scene.bodies = {{"b", scene::isotropic<2>(1, 0.25, scene::Plane::stress)}};
  const Eigen::Matrix2d gradient = (Eigen::Matrix2d() << 0.1, 0.3, -0.2, 0.05).finished();
  const scene::Condition<2> linear = {scene::ConditionKind::fixed,
                                      {[&](const Vector<2>& x) { return gradient.row(0).dot(x); },
                                       [&](const Vector<2>& x) { return gradient.row(1).dot(x); }},
                                      ""};
  for (const char* side : {"b.left", "b.right", "b.bottom", "b.top"}) scene.boundary[side] = linear;
  const auto problem = scene::fix_data(scene, distorted(scene::build_mesh(scene), 0.3, 4));
  const auto result = solve(problem, 1);
  ASSERT_EQ(result.termination, contact::Termination::solved) << result.reason;
  const Voigt<2> strain(gradient(0, 0), gradient(1, 1), gradient(0, 1) + gradient(1, 0));
  const Voigt<2> exact = scene.bodies.at("b").material.stiffness() * strain;
  EXPECT_LT(misfit(problem.mesh, result.stress, [&](const auto&) { return exact; }), 1e-12);
}

}  // namespace
}  // namespace bracket::dual
