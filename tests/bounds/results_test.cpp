// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/results.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "bounds/bounds.h"
#include "dual/dual.h"
#include "tests/support/scenes.h"

namespace bracket::bounds {
namespace {

using scene::Vector;
using scene::Voigt;

double cross(const Vector<2>& a, const Vector<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Two blocks that only one of which is loaded, pulled away from the other: nothing presses.
scene::Scene<2> pulled_apart() {
  auto s = tests::two_bodies(0, 1, 1, 1, 3, 4);
  s.bodies = {{"lower", scene::isotropic<2>(1, 0.3, scene::Plane::strain)},
              {"upper", scene::isotropic<2>(1e3, 0.3, scene::Plane::strain)}};
  s.boundary = {{"lower.left", tests::fixed(0, 0)},
                {"lower.bottom", tests::traction(tests::constant(0), tests::constant(-0.1))},
                {"upper.top", tests::fixed(0, 0)}};
  return s;
}

struct SolvedScene {
  std::string name;
  scene::Problem<2> problem;
  scene::Displacement<2> displacement;
  scene::Stress<2> stress;
};

/// Scenes with every kind of support and load, as they are and far from the origin and turned.
std::vector<SolvedScene> solved_scenes() {
  const std::vector<std::pair<std::string, scene::Scene<2>>> scenes = {{"two blocks", tests::two_blocks(4)},
                                                                       {"everything", tests::everything(3, 4, 2)},
                                                                       {"patch", tests::patch(2, 0.3, 0.1, 2)},
                                                                       {"pressure", tests::linear_pressure({}, 4, 2)},
                                                                       {"apart", pulled_apart()}};
  std::vector<SolvedScene> all;
  for (const auto& [name, s] : scenes)
    for (const double shift : {0.0, 1e6}) {
      if (shift != 0 && name != "two blocks" && name != "pressure" && name != "patch") continue;  // functions of x
      auto mesh = scene::build_mesh(s);
      auto moved = s;
      for (auto& x : mesh.vertices) x = Eigen::Rotation2Dd(shift == 0 ? 0 : 0.5) * x + shift * Vector<2>(1, -1);
      if (shift != 0)
        for (auto& [part, condition] : moved.boundary)
          for (auto& f : condition.value)
            f = [f, shift](const Vector<2>& x) {
              return f(Eigen::Rotation2Dd(-0.5) * Vector<2>(x - shift * Vector<2>(1, -1)));
            };
      const auto outcome = run(moved, scene::fix_data(moved, mesh));
      EXPECT_EQ(outcome.guarantee, shift == 0 ? "rounding-safe" : "discretisation") << name << ": " << outcome.reason;
      all.push_back({name + (shift != 0 ? ", far away" : ""), outcome.problem, outcome.displacement, outcome.stress});
    }
  return all;
}

/// The resultant of body force and of the loads on Γ_τ of a body, and the size of all that adds up to it.
Resultant<2> loads(const scene::Problem<2>& problem, int body, const Vector<2>& about) {
  const auto& mesh = problem.mesh;
  Resultant<2> sum{.about = about};
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    if (mesh.cell_body[c] != body) continue;
    const Vector<2> weight = scene::volume(mesh, static_cast<int>(c)) * problem.bodies[body].force;
    sum.force += weight;
    for (const int v : mesh.cells[c]) sum.moment += cross(mesh.vertices[v] - about, weight) / 3;
  }
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    if (mesh.cell_body[mesh.boundary[f].cell] != body || problem.facets[f].support != scene::Support::traction)
      continue;
    const auto [at0, at1] = scene::load(problem, static_cast<int>(f));
    const Vector<2> a = mesh.vertices[mesh.boundary[f].vertices[0]] - about,
                    b = mesh.vertices[mesh.boundary[f].vertices[1]] - about, middle = (a + b) / 2;
    sum.force += (at0 + at1) / 2;  // Simpson's rule for the moment
    sum.moment += (cross(a, at0) + 4 * cross(middle, (at0 + at1) / 2) + cross(b, at1)) / 6;
  }
  return sum;
}

TEST(Results, reactions_contact_forces_and_loads_are_in_balance) {
  for (const auto& [name, problem, u, stress] : solved_scenes()) {
    const auto& mesh = problem.mesh;
    const Vector<2> about = mesh.vertices[0] + Vector<2>(0.3, 0.7);
    for (int body = 0; body < static_cast<int>(mesh.bodies.size()); ++body) {
      Resultant<2> sum = loads(problem, body, about);
      double force = sum.force.norm(), moment = std::abs(sum.moment);
      const auto add = [&](const Resultant<2>& r, double sign) {
        sum.force += sign * r.force;
        sum.moment += sign * r.moment;
        force += r.force.norm();
        moment += std::abs(r.moment);
      };
      const auto parts_with = [&](scene::Support support, int of) {
        std::set<int> parts;
        for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
          if (problem.facets[f].support == support && mesh.cell_body[mesh.boundary[f].cell] == of)
            parts.insert(mesh.boundary[f].part);
        return parts;
      };
      for (const auto support : {scene::Support::fixed, scene::Support::sliding})
        for (const int part : parts_with(support, body)) add(resultant(problem, stress, mesh.parts[part], about), 1);
      for (int pair = 0; pair <= problem.contact.back().pair; ++pair) {
        const auto facet = std::ranges::find(problem.contact, pair, &scene::ContactFacet::pair);
        const auto body_of = [&](int f) { return f < 0 ? -1 : mesh.cell_body[mesh.boundary[f].cell]; };
        if (body_of(facet->first) == body) add(contact_result(problem, stress, pair, about).resultant, 1);
        if (body_of(facet->second) == body) add(contact_result(problem, stress, pair, about).resultant, -1);
      }
      ASSERT_TRUE(force > 0 || name == "apart") << name;
      EXPECT_LE(sum.force.norm(), 1e-12 * force) << name << ", " << mesh.bodies[body];
      EXPECT_LE(std::abs(sum.moment), 1e-12 * (moment + force)) << name << ", " << mesh.bodies[body];
    }
  }
}

TEST(Results, the_sides_of_a_contact_bear_opposite_forces) {
  for (const auto& [name, problem, u, stress] : solved_scenes()) {
    const auto& pair = problem.contact[0];
    const auto part = [&](int facet) { return problem.mesh.parts[problem.mesh.boundary[facet].part]; };
    const Vector<2> about = problem.mesh.vertices[0];
    const auto contact = contact_result(problem, stress, 0, about).resultant,
               first = resultant(problem, stress, part(pair.first), about),
               second = resultant(problem, stress, part(pair.second), about);
    const double rounding = 1e-12 * (name.starts_with("apart") ? 0.1 : first.force.norm());
    EXPECT_LE((first.force - contact.force).norm(), rounding) << name;
    EXPECT_LE((second.force + contact.force).norm(), rounding) << name;
    EXPECT_LE(std::abs(first.moment - contact.moment), rounding) << name;
    EXPECT_LE(std::abs(second.moment + contact.moment), rounding) << name;
  }
}

// p = p0 (1 − c x) on (−1, 1), exactly in the stress space; d = (0, −1) is the normal of the upper body.
TEST(Results, a_linear_pressure_has_its_resultant) {
  const tests::LinearPressure p{.p0 = 3, .c = 0.5};
  const auto outcome = run(tests::linear_pressure(p, 4, 2));
  const auto contact = contact_result(outcome.problem, outcome.stress, 0, {1, 0});
  EXPECT_LE((contact.resultant.force - Vector<2>(0, 2 * p.p0)).norm(), 1e-12 * p.p0);
  EXPECT_NEAR(contact.resultant.moment, -p.p0 * p.c * 2 / 3 - 2 * p.p0, 1e-12 * p.p0);
  EXPECT_NEAR(contact.largest_pressure, p.p0 * (1 + p.c), 1e-12 * p.p0);
  EXPECT_EQ(contact.at, Vector<2>(-1, 0));
  EXPECT_DOUBLE_EQ(contact.length, 2);
  EXPECT_DOUBLE_EQ(contact.pressed_length, 2);
  EXPECT_THROW(contact_result(outcome.problem, outcome.stress, 1), scene::Error);
  EXPECT_THROW(resultant(outcome.problem, outcome.stress, "uper.top"), scene::Error);
}

// The multipliers of open rows are exactly zero; the stress made from them is so only but for rounding.
TEST(Results, nothing_presses_where_the_contact_is_open) {
  for (const auto& scene : {tests::two_blocks(6), tests::everything(4, 4, 2), pulled_apart()})
    for (const double unit : {1.0, 1e-12, 1e12}) {
      auto problem = balanced(tests::problem(scene), 2);
      for (auto& body : problem.bodies) {
        const auto c = *body.material.constants();
        body.material = scene::isotropic<2>(unit * c.young, c.poisson, c.plane);
        body.force *= unit;
      }
      for (auto& facet : problem.facets)
        for (int end = 0; end < 2; ++end) facet.traction[end] *= unit;
      const auto solved = dual::solve(problem, 1);
      const auto pressure = contact_pressure(problem, solved.stress);
      int open = 0, pressed = 0;
      for (std::size_t j = 0; j < pressure.size(); ++j) {
        const double p0 = pressure[j][0], p1 = pressure[j][1];
        EXPECT_TRUE(p0 >= 0 && p1 >= 0) << p0 << " " << p1;
        if (solved.closed[j]) {
          pressed += p0 > 0 || p1 > 0;
          continue;
        }
        ++open;
        EXPECT_TRUE(p0 == 0 && p1 == 0) << p0 << " " << p1 << ", unit " << unit;
      }
      EXPECT_GT(open, 0);
      EXPECT_EQ(pressed, std::count(solved.closed.begin(), solved.closed.end(), 1)) << unit;
      const auto states = contact_state(problem, run({}, problem).displacement, solved.stress);
      for (std::size_t j = 0; j < pressure.size(); ++j) EXPECT_EQ(states[j].pressure, pressure[j]);
    }
}

/// Quadratic displacements and linear stresses, which the fields' functions are.
Vector<2> quadratic(const Vector<2>& x) {
  return {0.3 + x[0] - 2 * x[1] + x[0] * x[1], -0.1 + 0.5 * x[0] * x[0] - x[1] * x[1]};
}
Voigt<2> strain(const Vector<2>& x) { return {1 + x[1], -2 * x[1], -2 + x[0] + x[0]}; }
Voigt<2> linear(const Vector<2>& x) { return {1 + x[0], x[1] - 3 * x[0], 2 - x[1]}; }

TEST(Results, the_fields_are_found_at_every_point) {
  const auto problem = tests::problem(tests::two_blocks(3));
  const auto& mesh = problem.mesh;
  scene::Displacement<2> u;
  scene::Stress<2> stress;
  for (const auto& x : mesh.vertices) u.vertex.push_back(quadratic(x));
  for (const auto& [a, b] : mesh.edges) u.edge.push_back(quadratic((mesh.vertices[a] + mesh.vertices[b]) / 2));
  for (const auto& cell : mesh.cells) {
    const auto at = [&](int k) -> Vector<2> { return mesh.vertices[cell[k % 3]]; };
    const Vector<2> centroid = (at(0) + at(1) + at(2)) / 3;
    auto& corners = stress.cell.emplace_back(9);
    for (int k = 0; k < 3; ++k) {
      corners[3 * k] = linear(at(k + 1));
      corners[3 * k + 1] = linear(at(k + 2));
      corners[3 * k + 2] = linear(centroid);
    }
  }
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Vector<2>> points = {{0, 0}, {1, 0}, {1, 2}, {0, 1}, {1.0 / 3, 1}, {0.5, 0}, {0.1, 0.1}};
  for (int i = 0; i < 200; ++i) points.push_back({unit(random), 2 * unit(random)});
  for (const auto& x : points) {
    const auto values = values_at(problem, u, stress, x);
    ASSERT_TRUE(values.has_value()) << x.transpose();
    EXPECT_EQ(mesh.cell_body[values->cell], x[1] <= 1 ? 0 : 1) << x.transpose();  // where they touch: the first
    const Voigt<2> sigma = problem.bodies[x[1] <= 1 ? 0 : 1].material.stiffness() * strain(x);
    EXPECT_LE((values->displacement - quadratic(x)).norm(), 1e-14) << x.transpose();
    EXPECT_LE((values->displacement_stress - sigma).norm(), 1e-13 * (1 + sigma.norm())) << x.transpose();
    EXPECT_LE((values->stress - linear(x)).norm(), 1e-14) << x.transpose();
  }
  for (const Vector<2>& x : {Vector<2>(-1e-9, 1), {0.5, 2 + 1e-9}, {0.5, -1e-9}, {3, 3}, {NAN, 0}})
    EXPECT_FALSE(values_at(problem, u, stress, x).has_value()) << x.transpose();
  scene::Displacement<2> linear_u;
  linear_u.degree = 1;
  for (const auto& x : mesh.vertices) linear_u.vertex.push_back({1 - x[1], 2 * x[0] + x[1]});
  const auto values = values_at(problem, linear_u, stress, Vector<2>(0.3, 0.45));
  EXPECT_LE((values->displacement - Vector<2>(0.55, 1.05)).norm(), 1e-15);
}

// A point is rounded like the vertices: none on the boundary is lost, however far from the origin.
TEST(Results, points_of_the_boundary_are_found_far_away) {
  for (const auto& [name, problem, u, stress] : solved_scenes())
    for (const auto& facet : problem.mesh.boundary) {
      const Vector<2>&a = problem.mesh.vertices[facet.vertices[0]], &b = problem.mesh.vertices[facet.vertices[1]];
      for (const double t : {0.0, 0.3, 0.5, 1.0})
        EXPECT_TRUE(values_at(problem, u, stress, Vector<2>(a + t * (b - a))).has_value()) << name;
    }
}

TEST(Results, the_largest_displacement_is_that_of_a_corner) {
  const auto problem = tests::problem(tests::two_blocks(2));
  for (const int degree : {1, 2}) {
    scene::Displacement<2> u;
    u.degree = degree;
    const auto of = [](const Vector<2>& x) { return Vector<2>(x[0], -2 * x[1]); };
    for (const auto& x : problem.mesh.vertices) u.vertex.push_back(of(x));
    for (const auto& [a, b] : problem.mesh.edges)
      if (degree == 2) u.edge.push_back(of((problem.mesh.vertices[a] + problem.mesh.vertices[b]) / 2));
    EXPECT_EQ(largest_displacement(problem, u).at, Vector<2>(1, 2));
    EXPECT_EQ(largest_displacement(problem, u).displacement, Vector<2>(1, -4));
  }
  scene::Displacement<2> bubble;
  bubble.vertex.assign(problem.mesh.vertices.size(), Vector<2>::Zero());
  bubble.edge.assign(problem.mesh.edges.size(), Vector<2>::Zero());
  bubble.edge[5] = {3, 4};
  const auto& [a, b] = problem.mesh.edges[5];
  EXPECT_EQ(largest_displacement(problem, bubble).at, (problem.mesh.vertices[a] + problem.mesh.vertices[b]) / 2);
}

}  // namespace
}  // namespace bracket::bounds
