// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// The errors of displacements from elsewhere.
#include "bounds/assess.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "primal/primal.h"
#include "tests/support/random_grid.h"
#include "tests/support/scenes.h"

namespace bracket::tests {
namespace {

using bounds::Assessment;
using bounds::ErrorInterval;
using scene::Displacement;

/// A displacement of each body, by its number and place.
using Motion = std::function<Vector<2>(int body, const Vector<2>& x)>;

Displacement<2> displacement(const scene::Mesh<2>& mesh, int degree, const Motion& motion) {
  Displacement<2> result{degree, std::vector<Vector<2>>(mesh.vertices.size()), {}};
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

Displacement<2> sum(Displacement<2> a, const Displacement<2>& b, double factor) {
  for (std::size_t v = 0; v < a.vertex.size(); ++v) a.vertex[v] += factor * b.vertex[v];
  for (std::size_t e = 0; e < a.edge.size(); ++e) a.edge[e] += factor * b.edge[e];
  return a;
}

Displacement<2> quadratic(const scene::Mesh<2>& mesh, Displacement<2> u) {
  u.degree = 2;
  for (const auto& [a, b] : mesh.edges) u.edge.push_back((u.vertex[a] + u.vertex[b]) / 2);
  return u;
}

double norm(const scene::Problem<2>& problem, const Displacement<2>& u) {
  return std::sqrt(2 * bounds::potential_energy(problem, u).strain);
}

scene::FieldOnScene given(scene::Problem<2> problem, Displacement<2> u) {
  scene::FieldOnScene result;
  result.problem = std::move(problem);
  result.given.displacement = std::move(u);
  return result;
}

const scene::Refine adaptive = {.strategy = scene::Strategy::adaptive};

Assessment assessed(scene::Scene<2> scene, const scene::Problem<2>& problem, const Displacement<2>& u,
                    const scene::Refine& refine = adaptive) {
  scene.refine = refine;
  return bounds::assess(scene, given(problem, u));
}

void expect_inside(const ErrorInterval& interval, double known, double rounding) {
  EXPECT_LE(interval.lower, known + rounding);
  EXPECT_GE(interval.upper, known - rounding);
}

/// Each level's interval has `known` in it, and none excludes another.
void expect_known(const Assessment& found, double known, double rounding) {
  ASSERT_NE(found.guarantee, "none") << found.reason;
  for (const auto& level : found.levels) {
    SCOPED_TRACE(level.cells);
    expect_inside(level.by_stress, known, rounding);
    expect_inside(level.by_energy, known, rounding);
  }
  expect_inside(found.error, known, rounding);
}

/// docs/theory.md §9.3: σ_yy = −p₀ (1 − c x) alone; with h the thickness over E' below x, u_y = −p₀ (1 − c x) h and
/// u_x = ν/(1 − ν) p₀ (x − c x²/2)/E' − p₀ c ∫ h.
Motion exact(const LinearPressure& p) {
  return [p](int body, const Vector<2>& x) -> Vector<2> {
    const double side = p.poisson / (1 - p.poisson), of_plane = 1 / (1 - p.poisson * p.poisson);
    const double lower = p.young_lower * of_plane, upper = p.young_upper * of_plane;
    const double modulus = body == 0 ? lower : upper, y = x[1] + p.t_lower;
    const double h = body == 0 ? y / lower : p.t_lower / lower + x[1] / upper;
    const double of_h = body == 0 ? y * y / (2 * lower) : x[1] * p.t_lower / lower + x[1] * x[1] / (2 * upper);
    return {side * p.p0 * (x[0] - p.c * x[0] * x[0] / 2) / modulus - p.p0 * p.c * of_h, -p.p0 * (1 - p.c * x[0]) * h};
  };
}

TEST(Assess, linear_elements_where_the_solution_is_known) {
  const LinearPressure p;
  const scene::Scene<2> scene = linear_pressure(p, 4, 2);
  const scene::Problem<2> problem = bounds::balanced(tests::problem(scene), 2);
  const Displacement<2> u = displacement(problem.mesh, 2, exact(p));
  EXPECT_NEAR(bounds::potential_energy(problem, u).total, -bounds::potential_energy(problem, u).strain, 1e-13);
  const auto linear = primal::solve(problem, 1);
  ASSERT_EQ(linear.reason, "");
  const double known = norm(problem, sum(quadratic(problem.mesh, linear.displacement), u, -1));
  const Assessment found = assessed(scene, problem, linear.displacement);
  EXPECT_EQ(found.status, scene::Status::done) << found.reason;
  expect_known(found, known, 1e-14);
  EXPECT_LE(found.error.upper - found.error.lower, 1e-9);
  EXPECT_GT(found.error.lower, 0.05);  // of displacements of about 1: there is something to be found
}

// What is left is the work of the pressures in the last places by which displacements are moved out of contact.
TEST(Assess, exact_displacements_have_no_error) {
  const LinearPressure p;
  const scene::Scene<2> scene = linear_pressure(p, 4, 2);
  const scene::Problem<2> problem = tests::problem(scene);
  const Assessment found = assessed(scene, problem, displacement(problem.mesh, 2, exact(p)));
  EXPECT_EQ(found.status, scene::Status::done) << found.reason;
  EXPECT_EQ(found.error.lower, 0);
  EXPECT_LE(found.relative.upper, 5e-8);
}

// docs/theory.md §9.1: u_y = −Δ y over the height 1 from y = −½; sideways it may be moved as it likes.
TEST(Assess, patch_and_one_percent_more) {
  const scene::Scene<2> scene = patch(1e6, 0.3, 0.01, 2);
  const scene::Problem<2> problem = tests::problem(scene);
  const Motion u = [](int, const Vector<2>& x) -> Vector<2> { return {0.3 / 0.7 * 0.01 * x[0], -0.01 * (x[1] + 0.5)}; };
  const Assessment exactly = assessed(scene, problem, displacement(problem.mesh, 1, u));
  EXPECT_EQ(exactly.error.lower, 0);
  EXPECT_LE(exactly.relative.upper, 2e-8);
  // The displacement does not meet the support at the top; it is judged as it is.
  const Assessment more = assessed(scene, problem, displacement(problem.mesh, 1, [&](int body, const Vector<2>& x) {
                                     return Vector<2>(1.01 * u(body, x));
                                   }));
  EXPECT_NEAR(more.misfit, 1e-4, 1e-15);
  expect_inside(more.relative, 0.01, 1e-14);
  EXPECT_LE(more.relative.upper - more.relative.lower, 4e-8);
}

TEST(Assess, lift_off_to_a_seventh_of_a_percent_point) {
  const scene::Scene<2> scene = two_blocks(9);
  const scene::Problem<2> problem = tests::problem(scene);
  const auto linear = primal::solve(problem, 1);
  const Assessment found = assessed(scene, problem, linear.displacement);
  EXPECT_EQ(found.status, scene::Status::done) << found.reason;
  EXPECT_LE(found.relative.upper - found.relative.lower, 0.0015);
  EXPECT_LE(found.levels.back().cells, 728);
}

/// The interval of the displacement's own mesh, and that of up to twenty times as many cells.
void expect_together(const scene::Scene<2>& scene, const scene::Problem<2>& problem, const Displacement<2>& u) {
  const Assessment coarse = assessed(scene, problem, u, {.strategy = scene::Strategy::none});
  scene::Refine refine = adaptive;
  refine.max_cells = 20 * static_cast<int>(problem.mesh.cells.size());
  const Assessment fine = assessed(scene, problem, u, refine);
  ASSERT_NE(coarse.guarantee, "none") << coarse.reason;
  ASSERT_NE(fine.guarantee, "none") << fine.reason;
  EXPECT_LE(std::max(coarse.error.lower, fine.error.lower), std::min(coarse.error.upper, fine.error.upper));
}

// As penalties have it: the upper block sinks into the lower one.
TEST(Assess, penetration_counts) {
  const scene::Scene<2> scene = two_blocks(3);
  const scene::Problem<2> problem = tests::problem(scene);
  const auto linear = primal::solve(problem, 1);
  for (const double depth : {1e-6, 1e-4, 1e-3, 1e-2, 0.1}) {
    SCOPED_TRACE(depth);
    const Displacement<2> sunk = sum(
        linear.displacement,
        displacement(problem.mesh, 1, [&](int body, const auto&) { return Vector<2>(0, body == 1 ? -depth : 0); }), 1);
    expect_together(scene, problem, sunk);
    const Assessment found = assessed(scene, problem, sunk, {.strategy = scene::Strategy::none});
    EXPECT_NEAR(found.penetration, depth, 1e-12);
  }
}

TEST(Assess, noise_of_any_size_on_several_scenes) {
  Random random(12);
  for (const auto& scene : {two_blocks(2), everything(2, 2, 2), smooth(3), linear_pressure({}, 2, 1)}) {
    const scene::Problem<2> problem = tests::problem(scene);
    for (const int degree : {1, 2})
      for (const double size : {1e-4, 1e-2, 1.0}) {
        const auto own = primal::solve(bounds::balanced(problem, degree), degree);
        ASSERT_EQ(own.reason, "");
        double largest = 0;
        for (const auto& u : own.displacement.vertex) largest = std::max(largest, u.norm());
        const double a = random.uniform(-3, 3), b = random.uniform(-3, 3), c = random.uniform(0, 6);
        const auto noise = displacement(problem.mesh, degree, [&](int body, const Vector<2>& x) {
          return Vector<2>(std::sin(a * x[0] + b * x[1] + c), std::cos(b * x[0] - a * x[1] + c + body));
        });
        expect_together(scene, problem, sum(own.displacement, noise, size * largest));
      }
  }
}

TEST(Assess, budget_and_requests_end_it) {
  const scene::Scene<2> scene = two_blocks(2);
  const scene::Problem<2> problem = tests::problem(scene);
  const auto own = primal::solve(problem, 2);
  const Assessment spent = assessed(scene, problem, own.displacement, {.strategy = scene::Strategy::none});
  EXPECT_EQ(spent.status, scene::Status::budget);
  EXPECT_EQ(spent.reason.find("the mesh is not refined"), 0u);
  EXPECT_EQ(spent.levels.size(), 1u);
  EXPECT_GT(spent.error.upper, 0);
  double shares = 0;
  for (const double share : spent.cell) shares += share;
  EXPECT_EQ(spent.cell.size(), problem.mesh.cells.size());
  expect_inside({spent.error.lower - spent.levels[0].stress_error, spent.error.upper + spent.levels[0].stress_error},
                std::sqrt(shares), 0);
  std::stop_source stop;
  stop.request_stop();
  scene::Scene<2> refined = scene;
  refined.refine = adaptive;
  const Assessment stopped = bounds::assess(refined, given(problem, own.displacement), {{}, {}, stop.get_token()});
  EXPECT_EQ(stopped.status, scene::Status::budget);
  EXPECT_EQ(stopped.reason.find("stopped on request"), 0u);
}

}  // namespace
}  // namespace bracket::tests
