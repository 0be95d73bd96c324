// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>
#include <tuple>

#include "primal/elasticity.h"
#include "primal/nodes.h"
#include "primal/primal.h"
#include "scene/on_facet.h"
#include "tests/support/problems_in_space.h"
#include "tests/support/scenes.h"

namespace bracket::primal {
namespace {

using scene::Vector;

/// theory E5 (c): the pressure is linear, L = −3.3125.
scene::Problem<3> exact_dual(double poisson, std::array<int, 3> cells) {
  auto problem = tests::problem_on(
      tests::mesh_of({{"lower", {{{-1, 1}, {-1, 0}, {-1, 1}}}, cells}, {"upper", {{{-1, 1}, {0, 1}, {-1, 1}}}, cells}}),
      {scene::isotropic<3>(1, poisson, scene::Plane::strain), scene::isotropic<3>(2, poisson, scene::Plane::strain)});
  tests::slide(problem, "lower.bottom", tests::everywhere(0));
  tests::load(problem, "upper.top", [](const Vector<3>& x) { return Vector<3>(0, -(1 - .5 * x[0] - .25 * x[2]), 0); });
  tests::touch(problem, "upper.bottom", "lower.top", tests::everywhere(0));
  return problem;
}

TEST(Pressure, linear_pressure_is_exact_in_space) {
  for (const double poisson : {.3, .49, .4999}) {
    const auto problem = exact_dual(poisson, {2, 2, 2});
    const Solver<3> solver(problem, 2);
    const auto result = solver.solve_with_pressure(problem);
    ASSERT_EQ(result.termination, contact::Termination::solved) << result.reason;
    for (std::size_t j = 0; j < problem.contact.size(); ++j)
      for (int i = 0; i < 3; ++i) {
        const auto& x = problem.mesh.vertices[problem.mesh.boundary[problem.contact[j].first].vertices[i]];
        EXPECT_NEAR(result.pressure[j][i], 1 - .5 * x[0] - .25 * x[2], 1e-9);
      }
  }
}

TEST(Pressure, linear_pressure_is_exact_in_the_plane) {
  const tests::LinearPressure linear;
  const auto problem = tests::problem(tests::linear_pressure(linear, 4, 3));
  const auto result = Solver<2>(problem, 2).solve_with_pressure(problem);
  ASSERT_EQ(result.termination, contact::Termination::solved) << result.reason;
  for (std::size_t j = 0; j < problem.contact.size(); ++j)
    for (int i = 0; i < 2; ++i) {
      const auto& x = problem.mesh.vertices[problem.mesh.boundary[problem.contact[j].first].vertices[i]];
      EXPECT_NEAR(result.pressure[j][i], linear.p0 * (1 - linear.c * x[0]), 1e-10);
    }
}

/// A(u,v) − ℓ(v) + ∫ p r(v) by |A|(|u|,|v|) for random v that keep the supports at zero.
template <int dim> double misfit(const scene::Problem<dim>& problem, int degree, const PressureResult<dim>& found) {
  const auto& mesh = problem.mesh;
  const auto nodes = make_nodes(problem, degree);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Vector<dim>> v(nodes.node.size(), Vector<dim>::Zero()), u = v;
  for (std::size_t n = 0; n < v.size(); ++n)
    for (int k = 0; k < nodes.node[n].free; ++k) v[n] += number(random) * nodes.node[n].directions.col(k);
  for (std::size_t n = 0; n < mesh.vertices.size(); ++n) u[n] = found.displacement.vertex[n];
  for (std::size_t e = 0; e < mesh.edges.size() && degree == 2; ++e) {
    const auto& [a, b] = mesh.edges[e];
    u[mesh.vertices.size() + e] = 2 * found.displacement.edge[e] - (u[a] + u[b]) / 2;
  }
  double sum = 0, size = 0;
  for (std::size_t b = 0; b < mesh.components.size(); ++b)
    for_each_cell<dim>(problem, static_cast<int>(b), degree, [&](int cell, const Eigen::MatrixXd& k) {
      const auto list = cell_nodes(mesh, nodes, cell);
      Eigen::VectorXd of_u(dim * list.size()), of_v(dim * list.size());
      for (std::size_t i = 0; i < list.size(); ++i) {
        of_u.template segment<dim>(dim * i) = u[list[i]];
        of_v.template segment<dim>(dim * i) = v[list[i]];
        const auto& body = problem.bodies[mesh.cell_body[cell]];
        sum -= body.force.dot(v[list[i]]) * scene::volume(mesh, cell) / static_cast<double>(list.size());
      }
      sum += of_v.dot(k * of_u);
      size += of_v.cwiseAbs().dot(k.cwiseAbs() * of_u.cwiseAbs());
    });
  const auto work = [&](int facet, const std::array<Vector<dim>, dim>& force) {
    const auto list = facet_nodes(mesh, nodes, facet);
    for (std::size_t k = 0; k < list.size(); ++k)
      for (int i = 0; i < dim; ++i)
        sum -= scene::number<double>(scene::hat_mean<dim>(degree, static_cast<int>(k), i)) * force[i].dot(v[list[k]]);
  };
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (scene::is_loaded(problem.facets[f])) work(static_cast<int>(f), scene::load(problem, static_cast<int>(f)));
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const auto& pair = problem.contact[j];
    std::array<Vector<dim>, dim> force, opposite;
    for (int i = 0; i < dim; ++i) {
      force[i] = -found.pressure[j][i] * scene::length(mesh, pair.first) * problem.facets[pair.first].normal;
      opposite[pair.meets[i]] = -force[i];
    }
    work(pair.first, force);
    if (pair.second >= 0) work(pair.second, opposite);
  }
  return std::abs(sum) / size;
}

/// A block that clamped and sliding sides hold, on another one, with weight, an interference and a load that lifts it;
/// the contact surface is wavy: every facet has a normal of its own.
scene::Problem<3> wavy(double ratio) {
  auto problem = tests::problem_on(
      tests::mesh_of(
          {{"lower", {{{0, 1}, {-1, 0}, {0, 1}}}, {3, 2, 3}}, {"upper", {{{0, 1}, {0, 1}, {0, 1}}}, {3, 2, 3}}}),
      {scene::isotropic<3>(1, .3, scene::Plane::strain), scene::isotropic<3>(ratio, .4, scene::Plane::strain)});
  problem.bodies[1].force = {.01, -.02, 0};
  tests::move(problem, [](const Vector<3>& x, int) {
    return Vector<3>(x[0], x[1] + .05 * (1 - std::abs(x[1])) * std::sin(5 * x[0]) * std::cos(4 * x[2]), x[2]);
  });
  tests::fix(problem, "lower.bottom", tests::nowhere());
  tests::fix(problem, "upper.left", [](const Vector<3>&) { return Vector<3>(0, -.01, 0); });
  tests::slide(problem, "upper.back", tests::everywhere(.001));
  tests::load(problem, "upper.top", [](const Vector<3>& x) { return Vector<3>(0, .1 * x[0] - .06, .01); });
  tests::touch(problem, "upper.bottom", "lower.top", tests::everywhere(-.003));
  return problem;
}

TEST(Pressure, displacements_are_in_balance_with_it) {
  for (const double ratio : {1.0, 1000.0})
    for (const int degree : {1, 2}) {
      const auto problem = wavy(ratio);
      const Solver<3> solver(problem, degree);
      const auto result = solver.solve_with_pressure(problem);
      ASSERT_EQ(result.termination, contact::Termination::solved) << result.reason;
      double least = 0, largest = 0;
      for (const auto& p : result.pressure)
        for (int i = 0; i < 3; ++i) {
          least = std::min(least, p[i]);
          largest = std::max(largest, p[i]);
        }
      EXPECT_EQ(least, 0);
      EXPECT_GT(largest, 0);
      EXPECT_LE(misfit<3>(problem, degree, result), 1e-14) << "ratio " << ratio << ", degree " << degree;
    }
  const auto plane = tests::problem(tests::linear_pressure({}, 4, 3));
  EXPECT_LE(misfit<2>(plane, 2, Solver<2>(plane, 2).solve_with_pressure(plane)), 1e-14);
}

TEST(Pressure, is_the_same_whatever_is_expected_to_be_closed) {
  const auto problem = tests::problem(tests::two_blocks(6));
  const Solver<2> solver(problem, 2);
  const auto any = solver.solve_with_pressure(problem);
  ASSERT_EQ(any.termination, contact::Termination::solved) << any.reason;
  const std::vector<char> none(problem.contact.size(), 0);
  for (const auto& closed : {solver.solve(problem).closed, none}) {
    const auto found = solver.solve_with_pressure(problem, closed);
    ASSERT_EQ(found.termination, contact::Termination::solved) << found.reason;
    for (std::size_t j = 0; j < problem.contact.size(); ++j)
      for (int i = 0; i < 2; ++i) EXPECT_NEAR(found.pressure[j][i], any.pressure[j][i], 1e-10);
  }
}

TEST(Pressure, is_that_of_the_problems_own_data_by_what_was_made_for_others) {
  const auto made_for = wavy(1);
  auto problem = made_for;
  for (auto& data : problem.facets)
    for (auto& traction : data.traction) traction *= -2.5;
  for (auto& body : problem.bodies) body.force *= 3;
  for (auto& pair : problem.contact)
    for (double& gap : pair.upper) gap = .001 - 2 * gap;
  const Solver<3> solver(made_for, 2);
  const auto found = PressureSolver<3>(solver, made_for).solve(problem), own = solver.solve_with_pressure(problem);
  ASSERT_EQ(found.reason + own.reason, "");
  double most = 0;
  for (std::size_t j = 0; j < problem.contact.size(); ++j)
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(found.pressure[j][i], own.pressure[j][i], 1e-12);
      most = std::max(most, found.pressure[j][i]);
    }
  EXPECT_GT(most, 1e-3);
  EXPECT_LE(misfit<3>(problem, 2, found), 1e-14);
}

TEST(Pressure, where_none_balances_the_loads_there_may_be_displacements) {
  // A block of one cell across on a wall that may turn: linear pressures on the two triangles have resultants in
  // (¼, ¾), those of the rows of quadratic displacements up to the rim.
  auto problem = tests::problem_on(tests::mesh_of({{"b", {{{0, 1}, {0, 1}, {0, 1}}}, {1, 2, 1}}}),
                                   {scene::isotropic<3>(1, .3, scene::Plane::strain)});
  tests::slide(problem, "b.back", tests::everywhere(0));
  tests::slide(problem, "b.front", tests::everywhere(0));
  tests::touch(problem, "b.bottom", "", tests::everywhere(0));
  using contact::Termination;
  for (const auto& [at, displacements, pressures] :
       {std::tuple(.5, Termination::solved, Termination::solved),
        {.74, Termination::solved, Termination::solved},
        {.76, Termination::solved, Termination::no_equilibrium},
        {.99, Termination::solved, Termination::no_equilibrium},
        {1.01, Termination::no_equilibrium, Termination::no_equilibrium}}) {
    tests::load(problem, "b.top", [at = at](const Vector<3>& x) {  // with its resultant there
      return Vector<3>(0, -1 - 12 * (at - .5) * (x[0] - .5), 0);
    });
    const Solver<3> solver(problem, 2);
    EXPECT_EQ(solver.solve(problem).termination, displacements) << at;
    const auto found = solver.solve_with_pressure(problem);
    EXPECT_EQ(found.termination, pressures) << at;
    EXPECT_EQ(found.reason.empty(), pressures == Termination::solved) << found.reason;
  }
}

}  // namespace
}  // namespace bracket::primal
