// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "primal/elasticity.h"
#include "primal/primal.h"
#include "primal/systems.h"
#include "scene/mesh/dissection.h"
#include "scene/offsets.h"
#include "tests/support/problems_in_space.h"

namespace bracket::primal {
namespace {

using scene::Vector;
using tests::Box;

/// Two blocks on each other, base and top sliding, the top lowered by 0.01; inner and contact nodes moved alike.
scene::Problem<3> patch(double poisson, int n, double moved) {
  auto problem = tests::problem_on(tests::mesh_of({{"lower", {{{0, 1}, {-.5, 0}, {0, 1}}}, {n, n, n}},
                                                   {"upper", {{{0, 1}, {0, .5}, {0, 1}}}, {n, n, n}}}),
                                   {scene::isotropic<3>(1e6, poisson, scene::Plane::strain),
                                    scene::isotropic<3>(1e6, poisson, scene::Plane::strain)});
  tests::move(problem, [&](const Vector<3>& x, int) {
    // By a function of the place: vertices that lie on each other stay together.
    const double bump = moved / n * std::sin(7 * x[0] + 3 * x[2]) * x[0] * (1 - x[0]) * x[2] * (1 - x[2]) * 16;
    return Vector<3>(x[0] + bump, x[1] + (std::abs(x[1]) == .5 || x[1] == 0 ? 0 : bump / 2), x[2] - bump);
  });
  tests::slide(problem, "lower.bottom", tests::everywhere(0));
  tests::slide(problem, "upper.top", tests::everywhere(-.01));
  tests::touch(problem, "upper.bottom", "lower.top", tests::everywhere(0));
  return problem;
}

TEST(CellStiffnessInSpace, kernel_is_the_rigid_motions_and_energy_of_uniform_strain_is_exact) {
  const auto problem = patch(.3, 2, .1);
  for (const int degree : {1, 2})
    for_each_cell<3>(problem, 0, degree, [&](int cell, const Eigen::MatrixXd& k) {
      const auto& mesh = problem.mesh;
      const int n = scene::n_bernstein<3>(degree);
      const auto& indices = scene::bernstein_indices<3>(degree);
      Eigen::MatrixXd fields(3 * n, 12);
      for (int i = 0; i < n; ++i) {
        Vector<3> x = Vector<3>::Zero();  // a linear field's coefficients are its values there
        for (int corner = 0; corner < 4; ++corner)
          x += indices[i][corner] * mesh.vertices[mesh.cells[cell][corner]] / degree;
        for (int m = 0; m < 6; ++m) {
          Vector<3> translation = Vector<3>::Zero(), rotation = Vector<3>::Zero();
          (m < 3 ? translation : rotation)[m % 3] = 1;
          fields.col(m).segment<3>(3 * i) = translation + rotation.cross(x);
          const auto& [a, b] = scene::Simplex<3>::voigt[m];
          Vector<3> u = Vector<3>::Zero();
          u[a] += x[b] / 2;
          u[b] += x[a] / 2;
          fields.col(6 + m).segment<3>(3 * i) = u;
        }
      }
      const Eigen::MatrixXd energy = fields.transpose() * k * fields;
      Eigen::MatrixXd exact = Eigen::MatrixXd::Zero(12, 12);
      exact.bottomRightCorner<6, 6>() = scene::volume(mesh, cell) * problem.bodies[0].material.stiffness();
      EXPECT_LT((energy - exact).norm(), 1e-13 * k.norm());
      EXPECT_LT((k - k.transpose()).norm(), 1e-15 * k.norm());
    });
}

TEST(DisplacementsInSpace, patch_is_exact) {
  for (const double poisson : {.3, .49, .4999})
    for (const int degree : {1, 2}) {
      const auto problem = patch(poisson, 2, .2);
      const auto result = solve(problem, degree);
      ASSERT_EQ(result.termination, contact::Termination::solved) << result.reason;
      EXPECT_EQ(result.statistics.rows, degree == 1 ? 9 : 9 + 16);
      for (std::size_t v = 0; v < problem.mesh.vertices.size(); ++v)
        EXPECT_NEAR(result.displacement.vertex[v][1], -.01 * (problem.mesh.vertices[v][1] + .5), 1e-12);
      for (std::size_t e = 0; e < result.displacement.edge.size(); ++e) {
        const auto x = scene::positions(problem.mesh, problem.mesh.edges[e]);
        EXPECT_NEAR(result.displacement.edge[e][1], -.01 * ((x[0][1] + x[1][1]) / 2 + .5), 1e-12);
      }
    }
}

TEST(DisplacementsInSpace, other_degrees_are_refused) {
  const auto problem = patch(.3, 1, 0);
  for (const int degree : {0, 3, 4}) {
    try {
      solve(problem, degree);
      FAIL() << "not refused";
    } catch (const scene::Error& error) {
      EXPECT_EQ(error.status(), scene::Status::input);
    }
  }
}

TEST(DisplacementsInSpace, a_corner_of_three_skew_sliding_planes_has_all_three_displacements) {
  auto problem = tests::problem_on(tests::mesh_of({{"b", {{{0, 1}, {0, 1}, {0, 1}}}, {2, 2, 2}}}),
                                   {scene::isotropic<3>(1, .3, scene::Plane::strain)});
  problem.bodies[0].force = {.1, -.2, .3};
  Eigen::Matrix3d turn;
  turn << 1, .3, -.2, .1, 1.2, .4, .2, -.1, .9;
  tests::move(problem, [&](const Vector<3>& x, int) { return Vector<3>(turn * x); });
  tests::slide(problem, "b.left", [](const Vector<3>& x) { return .01 + .001 * x[1]; });
  tests::slide(problem, "b.bottom", [](const Vector<3>& x) { return -.02 + .003 * x[2]; });
  tests::slide(problem, "b.back", tests::everywhere(.03));
  for (const int degree : {1, 2}) {
    const auto result = solve(problem, degree);
    ASSERT_EQ(result.termination, contact::Termination::solved) << result.reason;
    int places = 0;
    for (std::size_t f = 0; f < problem.facets.size(); ++f) {
      const auto& data = problem.facets[f];
      if (data.support != scene::Support::sliding) continue;
      const auto& vertices = problem.mesh.boundary[f].vertices;
      const auto offset = scene::offsets_on_facet(problem.mesh, result.displacement, static_cast<int>(f));
      for (int i = 0; i < 3; ++i, ++places)
        EXPECT_NEAR(data.normal.dot(result.displacement.vertex[vertices[i]]), data.normal_displacement[i], 1e-15);
      for (std::size_t k = 3; k < offset.size(); ++k) EXPECT_NEAR(data.normal.dot(offset[k]), 0, 1e-15);
    }
    EXPECT_EQ(places, 3 * 3 * 8);
  }
}

/// A block clamped on its left on a wall whose gap is curved: nodes alone would see no contact.
scene::Problem<3> on_wall(int n, const tests::NumberAt& gap) {
  auto problem = tests::problem_on(tests::mesh_of({{"b", {{{0, 1}, {0, 1}, {0, 1}}}, {n, n, n}}}),
                                   {scene::isotropic<3>(1, .3, scene::Plane::strain)});
  tests::fix(problem, "b.top", tests::nowhere());
  tests::touch(problem, "b.bottom", "", gap);
  return problem;
}

TEST(ContactRowsInSpace, rows_bound_a_polynomial_between_the_nodes) {
  const auto problem = on_wall(1, [](const Vector<3>& x) { return -x[0] * (1 - x[0]) - .5 * x[2] * (1 - x[2]); });
  for (const int degree : {1, 2}) {
    const auto result = solve(problem, degree);
    ASSERT_EQ(result.termination, contact::Termination::solved) << result.reason;
    for (const auto& pair : problem.contact) {
      const auto& vertices = problem.mesh.boundary[pair.first].vertices;
      const auto x = scene::positions(problem.mesh, vertices);
      const auto offset = scene::offsets_on_facet(problem.mesh, result.displacement, pair.first);
      for (int a = 0; a <= 10; ++a)
        for (int b = 0; a + b <= 10; ++b) {
          const std::array<double, 3> l = {(10 - a - b) / 10., a / 10., b / 10.};
          Vector<3> u = Vector<3>::Zero(), at = u;
          for (int i = 0; i < 3; ++i) {
            u += l[i] * result.displacement.vertex[vertices[i]];
            at += l[i] * x[i];
          }
          for (std::size_t k = 3; k < offset.size(); ++k) {
            const auto& [i, j] = scene::Simplex<2>::edges[k - 3];
            u += 2 * l[i] * l[j] * offset[k];
          }
          const double gap = -at[0] * (1 - at[0]) - .5 * at[2] * (1 - at[2]);
          EXPECT_LE(-u[1], gap + 1e-13) << "degree " << degree;
        }
    }
  }
}

TEST(ContactRowsInSpace, decided_rows_are_dropped_or_refused) {
  auto problem = on_wall(2, tests::everywhere(.1));
  tests::fix(problem, "b.left", [](const Vector<3>&) { return Vector<3>(0, -.05, 0); });
  tests::slide(problem, "b.right", tests::everywhere(0));
  const auto rows = contact_rows(problem, make_nodes(problem, 2));
  EXPECT_EQ(rows.size(), 9u + 16u - 5u);  // all but those of the clamped side
  EXPECT_EQ(solve(problem, 2).termination, contact::Termination::solved);
  tests::fix(problem, "b.left", [](const Vector<3>&) { return Vector<3>(0, -.2, 0); });  // deeper than the gap
  for (const int degree : {1, 2}) {
    try {
      check_prescribed(problem, degree);
      FAIL() << "not refused";
    } catch (const scene::Error& error) {
      EXPECT_EQ(error.status(), scene::Status::ill_posed);
      EXPECT_NE(std::string(error.what()).find("'b.bottom' close its gap by up to 0.1 more than it has at (0, 0, "),
                std::string::npos)
          << error.what();
    }
  }
}

/// A block held by contact alone, on a floor whose facets have normals of their own, and two walls.
scene::Problem<3> in_wavy_corner(int n) {
  auto problem = tests::problem_on(tests::mesh_of({{"b", {{{0, 1}, {0, 1}, {0, 1}}}, {n, n, n}}}),
                                   {scene::isotropic<3>(1, .3, scene::Plane::strain)});
  problem.bodies[0].force = {-.3, -1, -.2};
  tests::move(problem, [](const Vector<3>& x, int) {
    return Vector<3>(x[0], x[1] + .05 * (1 - x[1]) * std::sin(5 * x[0]) * std::cos(4 * x[2]), x[2]);
  });
  for (const char* part : {"b.bottom", "b.left", "b.back"}) tests::touch(problem, part, "", tests::everywhere(0));
  return problem;
}

TEST(ContactRowsInSpace, rows_that_depend_on_each_other_give_the_same_displacements_as_one_by_one) {
  const auto problem = in_wavy_corner(3);
  const auto nodes = make_nodes(problem, 2);
  const auto rows = contact_rows(problem, nodes);
  std::vector<contact::Solution> solutions;
  for (const bool may_depend : {true, false}) {
    auto systems = assemble(problem, nodes, rows, scene::dissect(problem.mesh));
    Eigen::VectorXd bounds(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) bounds[i] = rows[i].bound;
    solutions.push_back(contact::Bodies(std::move(systems.body), may_depend).solve(loads(problem, nodes), bounds));
    ASSERT_EQ(solutions.back().termination, contact::Termination::solved);
    EXPECT_GE(solutions.back().pressure.minCoeff(), 0);
  }
  const auto& u = solutions[0].displacement[0];
  EXPECT_LE((u - solutions[1].displacement[0]).norm(), 1e-10 * u.norm());
  EXPECT_LE(solutions[0].iterations, 12);
  EXPECT_GE(solutions[1].iterations, 30) << "no rows depended on each other: the test shows nothing";
}

TEST(DisplacementsInSpace, sides_that_keep_together_do_so_along_a_curved_gap) {
  const auto gap = [](const Vector<3>& x) { return .01 * x[0] * x[0] - .02 * x[0] * x[2]; };
  auto problem = tests::problem_on(
      tests::mesh_of(
          {{"lower", {{{0, 1}, {-1, 0}, {0, 1}}}, {2, 2, 2}}, {"upper", {{{0, 1}, {0, 1}, {0, 1}}}, {2, 2, 2}}}),
      {scene::isotropic<3>(1, .3, scene::Plane::strain), scene::isotropic<3>(10, .2, scene::Plane::strain)});
  tests::fix(problem, "lower.bottom", tests::nowhere());
  tests::load(problem, "upper.top", [](const Vector<3>& x) { return Vector<3>(0, .01 * (1 - 2 * x[0]), 0); });
  tests::touch(problem, "upper.bottom", "lower.top", gap, true);
  const auto result = solve(problem, 2);
  ASSERT_EQ(result.termination, contact::Termination::solved) << result.reason;
  for (const auto& pair : problem.contact) {
    const auto &first = problem.mesh.boundary[pair.first].vertices,
               &second = problem.mesh.boundary[pair.second].vertices;
    const auto offset = scene::offsets_on_facet(problem.mesh, result.displacement, pair.first),
               other = scene::offsets_on_facet(problem.mesh, result.displacement, pair.second);
    std::array<double, 6> r;
    for (int i = 0; i < 3; ++i)
      r[i] = -(result.displacement.vertex[first[i]] - result.displacement.vertex[second[pair.meets[i]]])[1];
    for (int e = 0; e < 3; ++e) {
      const auto& [a, b] = scene::Simplex<2>::edges[e];
      const int over = scene::Simplex<2>::edge_between(pair.meets[a], pair.meets[b]);
      r[3 + e] = (r[a] + r[b]) / 2 - (offset[3 + e] - other[3 + over])[1];
    }
    for (int k = 0; k < 6; ++k) EXPECT_NEAR(r[k], pair.lower[k], 1e-13);
  }
  EXPECT_THROW(solve(problem, 1), scene::Error);  // linear ones cannot
}

}  // namespace
}  // namespace bracket::primal
