// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "primal/primal.h"

#include <gtest/gtest.h>

#include "primal/elasticity.h"
#include "primal/rows.h"
#include "scene/offsets.h"
#include "tests/support/scenes.h"

namespace bracket::primal {
namespace {

using scene::Vector;

TEST(CellStiffness, kernel_is_the_rigid_motions_and_energy_of_uniform_strain_is_exact) {
  const auto problem = tests::problem(tests::patch(3, 0.3, 0.01, 2));
  for (const int degree : {1, 2, 3, 4})
    for_each_cell<2>(problem, 0, degree, [&](int cell, const Eigen::MatrixXd& k) {
      const auto& mesh = problem.mesh;
      const auto& v = mesh.cells[cell];
      const int n = scene::n_bernstein(degree);
      const auto& indices = scene::bernstein_indices(degree);
      Eigen::MatrixXd fields(2 * n, 6);  // 1, 1, turn, and three uniform strains
      for (int i = 0; i < n; ++i) {
        Vector<2> x = Vector<2>::Zero();  // a linear field's coefficients are its values there
        for (int corner = 0; corner < 3; ++corner) x += indices[i][corner] * mesh.vertices[v[corner]] / degree;
        fields.middleRows<2>(2 * i) << 1, 0, -x[1], x[0], 0, x[1] / 2, 0, 1, x[0], 0, x[1], x[0] / 2;
      }
      const Eigen::MatrixXd energy = fields.transpose() * k * fields;
      Eigen::MatrixXd exact = Eigen::MatrixXd::Zero(6, 6);
      exact.bottomRightCorner<3, 3>() = scene::volume(mesh, cell) * problem.bodies[0].material.stiffness();
      EXPECT_LT((energy - exact).norm(), 1e-13 * k.norm());
      EXPECT_LT((k - k.transpose()).norm(), 1e-15 * k.norm());
    });
}

TEST(Displacements, patch_is_exact_for_all_degrees) {
  const auto problem = tests::problem(tests::patch(1e6, 0.3, 0.01, 3));
  for (const int degree : {1, 2, 3, 4}) {
    const auto result = solve(problem, degree);
    ASSERT_EQ(result.termination, contact::Termination::solved) << result.reason;
    for (std::size_t v = 0; v < problem.mesh.vertices.size(); ++v)
      EXPECT_NEAR(result.displacement.vertex[v][1], -0.01 * (problem.mesh.vertices[v][1] + 0.5), 1e-14);
  }
}

TEST(Displacements, vertex_with_two_sliding_normals_has_both_displacements) {
  scene::Scene<2> scene;
  scene.blocks = {tests::block("b", 0, 1, 0, 1, 3, 4)};
  scene.bodies = {{"b", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
  scene.bodies.at("b").force = {0.1, -0.2};
  scene.boundary = {{"b.bottom", tests::sliding(0.01)}, {"b.left", tests::sliding(-0.02)}};
  auto mesh = scene::build_mesh(scene);
  for (Vector<2>& x : mesh.vertices) x[0] += 0.6 * x[1];
  const auto problem = scene::fix_data(scene, mesh);
  for (const int degree : {1, 2, 3, 4}) {
    const auto result = solve(problem, degree);
    ASSERT_EQ(result.termination, contact::Termination::solved) << result.reason;
    int ends = 0;
    for (std::size_t f = 0; f < problem.facets.size(); ++f) {
      const auto& facet = problem.facets[f];
      if (facet.support != scene::Support::sliding) continue;
      for (int end = 0; end < 2; ++end, ++ends)
        EXPECT_NEAR(facet.normal.dot(result.displacement.vertex[problem.mesh.boundary[f].vertices[end]]),
                    facet.normal_displacement[end], 1e-15);
    }
    EXPECT_EQ(ends, 2 * (3 + 4));
  }
}

/// A rectangle on a V-shaped rigid wall: its lowest vertex has two contact normals.
scene::Problem<2> wedge(double half_angle) {
  scene::Problem<2> problem;
  scene::Scene<2> scene;
  scene.blocks = {tests::block("b", 0, 1, 0, 1, 4, 4)};
  scene.bodies = {{"b", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
  scene.bodies.at("b").force = {-std::cos(half_angle), -std::sin(half_angle)};
  scene.contact = {{"b.bottom", "rigid", tests::constant(0), ""}, {"b.left", "rigid", tests::constant(0), ""}};
  return tests::problem(scene);
}

TEST(Displacements, vertex_with_two_contact_normals_keeps_both_rows) {
  const auto problem = wedge(0.7);
  const auto result = solve(problem, 2);
  ASSERT_EQ(result.termination, contact::Termination::solved) << result.reason;
  EXPECT_EQ(result.statistics.rows, 2 * (4 + 5));  // middles and ends of both sides; the corner has one row of each
  for (std::size_t v = 0; v < problem.mesh.vertices.size(); ++v) {
    const auto& x = problem.mesh.vertices[v];
    if (x[0] == 0) {
      EXPECT_GE(result.displacement.vertex[v][0], -1e-13);
    }
    if (x[1] == 0) {
      EXPECT_GE(result.displacement.vertex[v][1], -1e-13);
    }
  }
}

TEST(ContactRows, decided_rows_are_dropped_or_refused) {
  scene::Scene<2> scene;
  scene.blocks = {tests::block("b", 0, 1, 0, 1, 2, 2)};
  scene.bodies = {{"b", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
  scene.contact = {{"b.bottom", "rigid", tests::constant(0.1), ""}};
  scene.boundary = {{"b.left", tests::fixed(0, -0.05)}, {"b.right", tests::sliding(0)}};
  {
    const auto problem = tests::problem(scene);
    const auto rows = contact_rows(problem, make_nodes(problem, 2));
    EXPECT_EQ(rows.size(), 2u + 2u);  // two middles, the inner and the right end: the left end is clamped
    EXPECT_EQ(solve(problem, 2).termination, contact::Termination::solved);
  }
  scene.boundary["b.left"] = tests::fixed(0, -0.2);  // deeper than the gap
  try {
    solve(tests::problem(scene), 2);
    FAIL() << "not refused";
  } catch (const scene::Error& error) {
    EXPECT_EQ(error.status(), scene::Status::ill_posed);
    EXPECT_NE(std::string(error.what()).find("b.bottom"), std::string::npos);
  }
}

TEST(ContactRows, what_is_prescribed_is_refused_at_its_place_without_a_solve) {
  // A side that rises by 0.01 while the other stays: only there the gap of 0.005 closes.
  scene::Scene<2> scene;
  scene.blocks = {tests::block("b", 0, 1, 0, 1, 2, 2)};
  scene.bodies = {{"b", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
  scene.contact = {{"b.bottom", "rigid", tests::constant(0.005), ""}};
  scene.boundary = {{"b.left", tests::fixed(0, 0)}, {"b.right", tests::fixed(0, -0.01)}};
  const auto refusal = [&](int degree) -> std::string {
    try {
      check_prescribed(tests::problem(scene), degree);
    } catch (const scene::Error& error) {
      EXPECT_EQ(error.status(), scene::Status::ill_posed);
      return error.what();
    }
    return "";
  };
  for (const int degree : {1, 2, 3, 4}) {
    EXPECT_NE(refusal(degree).find("by up to 0.005 more than it has at (1, 0)"), std::string::npos) << refusal(degree);
  }
  scene.contact[0].gap = tests::constant(0.01);
  for (const int degree : {1, 2, 3, 4}) EXPECT_EQ(refusal(degree), "");
  // Both ends of a facet held: a line between them meets the wall in the middle, a parabola need not.
  scene.blocks = {tests::block("b", 0, 1, 0, 1, 1, 1)};
  scene.contact[0].gap = scene::enclosed<2>([](const auto& x) { return 0.01 - x[0] * (1 - x[0]); });
  EXPECT_NE(refusal(1).find("at (0.5, 0)"), std::string::npos) << refusal(1);
  EXPECT_EQ(refusal(2), "");
}

TEST(Displacements, a_body_that_is_not_held_in_floating_point_is_named) {
  scene::Scene<2> scene;
  scene.blocks = {tests::block("slab", 0, 1, 0, 1, 2, 2)};
  scene.bodies = {{"slab", scene::isotropic<2>(1, 0.4999999999999999, scene::Plane::strain)}};
  scene.boundary = {{"slab.left", tests::fixed(0, 0)}};
  const auto result = solve(tests::problem(scene), 2);
  EXPECT_EQ(result.termination, contact::Termination::not_definite);
  EXPECT_NE(result.reason.find("'slab'"), std::string::npos) << result.reason;
}

TEST(ContactRows, inner_rows_bound_a_polynomial_between_the_nodes) {
  // A gap that is closed at the ends of one facet and negative between: nodes alone would see no contact.
  scene::Scene<2> scene;
  scene.blocks = {tests::block("b", 0, 1, 0, 1, 1, 1)};
  scene.bodies = {{"b", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
  scene.contact = {{"b.bottom", "rigid", scene::enclosed<2>([](const auto& x) { return -x[0] * (1 - x[0]); }), ""}};
  scene.boundary = {{"b.top", tests::fixed(0, 0)}};
  const auto problem = tests::problem(scene);
  for (const int degree : {1, 2, 3, 4}) {
    const auto result = solve(problem, degree);
    ASSERT_EQ(result.termination, contact::Termination::solved) << result.reason;
    const auto& facet = problem.mesh.boundary[problem.contact[0].first];
    const double a = result.displacement.vertex[facet.vertices[0]][1],
                 b = result.displacement.vertex[facet.vertices[1]][1];
    std::vector<double> offset;
    for (const auto& w : scene::offsets_on_facet(problem.mesh, result.displacement, problem.contact[0].first))
      offset.push_back(w[1]);
    for (const double s : {0.0, 0.1, 0.3, 0.5, 0.8, 1.0}) {
      const double u = (1 - s) * a + s * b + scene::value_on_segment(offset, s);
      EXPECT_GE(u, s * (1 - s) - 1e-12) << "degree " << degree << " at " << s;  // −u ≤ g
    }
  }
}

}  // namespace
}  // namespace bracket::primal
