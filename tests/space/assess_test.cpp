// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// The errors of displacements from elsewhere, in space.
#include "bounds/assess.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "primal/primal.h"
#include "tests/scene/space/boxes.h"
#include "tests/space/random_boxes.h"
#include "tests/space/scenes.h"
#include "tests/support/sanitized.h"

namespace bracket {
namespace {

using namespace tests::space;
using Assessment = bounds::AssessmentOf<3>;
using bounds::ErrorInterval;
using scene::Displacement;
using scene::Vector;

/// A displacement of each body, by its number and place.
using Motion = std::function<Vector<3>(int body, const Vector<3>& x)>;

Displacement<3> displacement(const scene::Mesh<3>& mesh, int degree, const Motion& motion) {
  Displacement<3> result{degree, std::vector<Vector<3>>(mesh.vertices.size()), {}};
  result.edge.resize(degree == 2 ? mesh.edges.size() : 0);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int body = mesh.cell_body[c];
    for (const int v : mesh.cells[c]) result.vertex[v] = motion(body, mesh.vertices[v]);
    for (const int e : mesh.cell_edges[c])
      if (degree == 2)
        result.edge[e] = motion(body, (mesh.vertices[mesh.edges[e][0]] + mesh.vertices[mesh.edges[e][1]]) / 2);
  }
  return result;
}

Displacement<3> sum(Displacement<3> a, const Displacement<3>& b, double factor) {
  for (std::size_t v = 0; v < a.vertex.size(); ++v) a.vertex[v] += factor * b.vertex[v];
  for (std::size_t e = 0; e < a.edge.size(); ++e) a.edge[e] += factor * b.edge[e];
  return a;
}

Displacement<3> quadratic(const scene::Mesh<3>& mesh, Displacement<3> u) {
  u.degree = 2;
  for (const auto& [a, b] : mesh.edges) u.edge.push_back((u.vertex[a] + u.vertex[b]) / 2);
  return u;
}

double norm(const scene::Problem<3>& problem, const Displacement<3>& u) {
  return std::sqrt(2 * bounds::potential_energy(problem, u).strain);
}

scene::Problem<3> problem_of(const scene::Scene<3>& scene) { return scene::fix_data(scene, scene::build_mesh(scene)); }

Assessment assessed(scene::Scene<3> scene, const scene::Problem<3>& problem, const Displacement<3>& u,
                    int max_levels = 1) {
  scene.refine.strategy = max_levels == 1 ? scene::Strategy::none : scene::Strategy::adaptive;
  scene.refine.max_levels = max_levels;
  scene::FieldOnSceneOf<3> field;
  field.problem = problem;
  field.given.displacement = u;
  return bounds::assess(scene, std::move(field));
}

void expect_inside(const ErrorInterval& interval, double known, double rounding) {
  EXPECT_LE(interval.lower, known + rounding);
  EXPECT_GE(interval.upper, known - rounding);
}

void expect_known(const Assessment& found, double known, double rounding) {
  ASSERT_NE(found.guarantee, "none") << found.reason;
  for (const auto& level : found.levels) {
    SCOPED_TRACE(level.cells);
    expect_inside(level.by_stress, known, rounding);
    expect_inside(level.by_energy, known, rounding);
  }
  expect_inside(found.error, known, rounding);
}

/// docs/theory.md §12.6: σ_zz = −q, q = 1 − c x − c′ y, alone: with h = z/E above the base, e = ν/E,
/// u_z = −q h − ½ e (c x² + c y²)… put together so that strains are (e q, e q, −q/E).
Motion exact(double poisson, double softer = 1) {
  return [=](int body, const Vector<3>& x) -> Vector<3> {
    const double c = 0.5, d = 0.25, young = (body == 0 ? 1 : 2) / softer, e = poisson / young;
    const double z = x[2] + 1, below = body == 0 ? 0 : 1;  // the other body's height
    const double q = 1 - c * x[0] - d * x[1];
    // u_z by integration of −q/E from the base, and what bending does across.
    const double h = body == 0 ? z / young : below * softer + (z - below) / young;
    const double of_h =
        body == 0 ? z * z / (2 * young)
                  : below * below * softer / 2 + (z - below) * below * softer + (z - below) * (z - below) / (2 * young);
    // u_x = e (x − c x²/2 − d x y + c y²/2) − c ∫ h, u_y likewise; u_z = −q h.
    return {e * (x[0] - c * x[0] * x[0] / 2 - d * x[0] * x[1] + c * x[1] * x[1] / 2) - c * of_h,
            e * (x[1] - d * x[1] * x[1] / 2 - c * x[0] * x[1] + d * x[0] * x[0] / 2) - d * of_h, -q * h};
  };
}

TEST(SpaceAssess, the_known_solution_is_one) {
  for (const double poisson : {0.3, 0.49}) {
    const auto problem = bounds::balanced(problem_of(linear_pressure(2, poisson)), 2);
    const auto u = displacement(problem.mesh, 2, exact(poisson));
    EXPECT_NEAR(bounds::potential_energy(problem, u).total, linear_pressure_energy, 1e-13);
    EXPECT_NEAR(bounds::potential_energy(problem, u).strain, -linear_pressure_energy, 1e-13);
  }
}

// What is left is the work of the pressures in the last places by which displacements are moved out of contact.
TEST(SpaceAssess, exact_displacements_have_no_error) {
  for (const double poisson : {0.3, 0.49}) {
    const auto scene = linear_pressure(2, poisson);
    const auto problem = problem_of(scene);
    const Assessment found = assessed(scene, problem, displacement(problem.mesh, 2, exact(poisson)), 3);
    EXPECT_EQ(found.status, scene::Status::done) << found.reason;
    EXPECT_EQ(found.error.lower, 0);
    EXPECT_LE(found.relative.upper, 1e-6);
  }
}

TEST(SpaceAssess, linear_elements_where_the_solution_is_known) {
  const auto scene = linear_pressure(2, 0.3);
  const auto problem = bounds::balanced(problem_of(scene), 2);
  const auto u = displacement(problem.mesh, 2, exact(0.3));
  const auto linear = primal::solve(problem, 1);
  ASSERT_EQ(linear.reason, "");
  const double known = norm(problem, sum(quadratic(problem.mesh, linear.displacement), u, -1));
  const Assessment found = assessed(scene, problem, linear.displacement);
  EXPECT_EQ(found.status, scene::Status::done) << found.reason;
  expect_known(found, known, 1e-12);
  EXPECT_LE(found.error.upper - found.error.lower, 1e-6);
  EXPECT_GT(found.error.lower, 0.05);
}

// Loads alone: of twice the modulus the displacement is half of it.
TEST(SpaceAssess, the_wrong_modulus_is_half_of_it) {
  const auto scene = linear_pressure(2, 0.3);
  const auto problem = problem_of(scene);
  const Assessment found = assessed(scene, problem, displacement(problem.mesh, 2, exact(0.3, 0.5)));
  expect_known(found, 0.5 * std::sqrt(-2 * linear_pressure_energy), 1e-12);
  expect_inside(found.relative, 0.5, 1e-12);
  EXPECT_LE(found.relative.upper - found.relative.lower, 1e-6);
}

TEST(SpaceAssess, patch_and_one_percent_more) {
  const auto scene = patch(2, 0.3);
  const auto problem = problem_of(scene);
  const Motion u = [](int, const Vector<3>& x) -> Vector<3> {
    return {0.3 * 0.01 * x[0], 0.3 * 0.01 * x[1], -0.01 * (x[2] + 0.5)};
  };
  const Assessment exactly = assessed(scene, problem, displacement(problem.mesh, 1, u));
  EXPECT_EQ(exactly.error.lower, 0);
  EXPECT_LE(exactly.relative.upper, 1e-6);
  // The displacement does not meet the support at the front; it is judged as it is.
  const Assessment more = assessed(scene, problem, displacement(problem.mesh, 1, [&](int body, const Vector<3>& x) {
                                     return Vector<3>(1.01 * u(body, x));
                                   }));
  EXPECT_NEAR(more.misfit, 1e-4, 1e-15);
  expect_inside(more.relative, 0.01, 1e-13);
  EXPECT_LE(more.relative.upper - more.relative.lower, 1e-6);
}

/// The interval of the displacement's own mesh, and that of finer ones.
void expect_together(const scene::Scene<3>& scene, const scene::Problem<3>& problem, const Displacement<3>& u) {
  const Assessment coarse = assessed(scene, problem, u), fine = assessed(scene, problem, u, 3);
  ASSERT_NE(coarse.guarantee, "none") << coarse.reason;
  ASSERT_NE(fine.guarantee, "none") << fine.reason;
  for (const auto& of : {coarse, fine})
    for (const auto& level : of.levels) {
      EXPECT_LE(level.by_stress.lower, level.by_energy.upper);
      EXPECT_LE(level.by_energy.lower, level.by_stress.upper);
    }
  EXPECT_LE(std::max(coarse.error.lower, fine.error.lower), std::min(coarse.error.upper, fine.error.upper));
}

// As penalties have it: the upper block sinks into the lower one.
TEST(SpaceAssess, penetration_counts) {
  const auto scene = two_blocks(2);
  const auto problem = problem_of(scene);
  const auto linear = primal::solve(problem, 1);
  ASSERT_EQ(linear.reason, "");
  for (const double depth : {1e-3, 1e-6, 0.1}) {
    if (tests::sanitized && depth != 1e-3) break;
    SCOPED_TRACE(depth);
    const Motion down = [&](int body, const auto&) { return Vector<3>(0, body == 1 ? -depth : 0, 0); };
    const auto sunk = sum(linear.displacement, displacement(problem.mesh, 1, down), 1);
    expect_together(scene, problem, sunk);
    EXPECT_NEAR(assessed(scene, problem, sunk).penetration, depth, 1e-12);
  }
}

TEST(SpaceAssess, noise_of_any_size_on_several_scenes) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> uniform(-3, 3);
  for (const auto& scene : {two_blocks(2), everything(1), on_a_wall(2, 0.3)}) {
    const auto problem = problem_of(scene);
    for (const int degree : {1, 2})
      for (const double size : {1e-2, 1.0}) {
        if (tests::sanitized && (degree == 1) != (size == 1)) continue;
        const auto own = primal::solve(bounds::balanced(problem, degree), degree);
        ASSERT_EQ(own.reason, "");
        double largest = 0;
        for (const auto& u : own.displacement.vertex) largest = std::max(largest, u.norm());
        const double a = uniform(random), b = uniform(random), c = uniform(random);
        const auto noise = displacement(problem.mesh, degree, [&](int body, const Vector<3>& x) {
          return Vector<3>(std::sin(a * x[0] + b * x[1] + c * x[2]), std::cos(b * x[0] - c * x[1] + body),
                           std::sin(c * x[0] + a * x[2]));
        });
        expect_together(scene, problem, sum(own.displacement, noise, size * largest));
      }
  }
}

// What the axes have no part in.
TEST(SpaceAssess, turned_with_its_scene_it_is_as_wrong) {
  std::mt19937 random(5);
  RandomBoxes boxes = solvable_boxes(random);
  const scene::Mesh<3> mesh = refined_once(boxes, 2, random);
  const Motion wrong = [](int body, const Vector<3>& x) {
    return Vector<3>(0.01 * x[0] * x[1], -0.02 * x[2] + 0.005 * body, 0.01 * x[0] * x[0]);
  };
  const auto judged = [&](const RandomBoxes& of) {
    const scene::Scene<3> scene = of.on(mesh);
    const auto problem = problem_of(scene);
    // The motion of the straight boxes, turned.
    const Motion turned = [&](int body, const Vector<3>& x) {
      return Vector<3>(of.rotation * wrong(body, of.rotation.transpose() * x));
    };
    return assessed(scene, problem, displacement(problem.mesh, 2, turned));
  };
  const Assessment straight = judged(boxes);
  ASSERT_NE(straight.guarantee, "none") << straight.reason;
  for (int round = 0; round < 2; ++round) {
    RandomBoxes turned = boxes;
    turned.rotation = scene::test::random_rotation(random);
    const Assessment other = judged(turned);
    EXPECT_NEAR(other.error.lower, straight.error.lower, 1e-7 * straight.error.upper);
    EXPECT_NEAR(other.error.upper, straight.error.upper, 1e-7 * straight.error.upper);
  }
}

TEST(SpaceAssess, budget_and_requests_end_it) {
  auto scene = two_blocks(2);
  const auto problem = problem_of(scene);
  const auto own = primal::solve(problem, 2);
  const Assessment spent = assessed(scene, problem, own.displacement);
  EXPECT_EQ(spent.status, scene::Status::budget);
  EXPECT_EQ(spent.reason.find("the mesh is not refined"), 0u) << spent.reason;
  EXPECT_EQ(spent.cell.size(), problem.mesh.cells.size());
  std::stop_source stop;
  stop.request_stop();
  scene.refine.strategy = scene::Strategy::adaptive;
  scene::FieldOnSceneOf<3> field;
  field.problem = problem;
  field.given.displacement = own.displacement;
  const Assessment stopped = bounds::assess<3>(scene, std::move(field), {{}, {}, stop.get_token()});
  EXPECT_EQ(stopped.status, scene::Status::budget);
  EXPECT_EQ(stopped.reason.find("stopped on request"), 0u) << stopped.reason;
}

}  // namespace
}  // namespace bracket
