// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "bounds/bounds.h"
#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/bounds/certificate/judge.h"
#include "tests/bounds/certificate/noise.h"
#include "tests/support/scenes.h"

namespace bracket::bounds {
namespace {

using scene::Vector;

/// Scenes whose boundary facets have rational lengths where they carry tractions, along axes or after map().
struct Case {
  std::string name;
  scene::Scene<2> scene;
  bool inclined = false;
  double disturb = 0;  ///< how far inner vertices are moved
};

/// A block that nothing but a wall holds in the middle of its load, and that only the data balance sideways.
scene::Scene<2> on_a_wall() {
  scene::Scene<2> s;
  s.blocks = {tests::block("block", -1, 1, 0, 1, 3, 2)};
  s.bodies = {{"block", scene::isotropic<2>(3, 0.45, scene::Plane::strain)}};
  s.bodies.at("block").force = {0, -0.3};
  s.contact = {{"block.bottom", "rigid", tests::constant(0), ""}};
  s.boundary = {{"block.top", tests::pressure([](const auto& x) { return 1 - 0.7 * x[0]; })}};
  return s;
}

/// Full anisotropy, sliding along two sides, squeezed by an interference.
scene::Scene<2> interference() {
  scene::Scene<2> s = tests::two_bodies(0, 2, 1, 0.5, 3, 1);
  scene::Elasticity<2> stiffness;
  stiffness << 4, 1.3, 0.7, 1.3, 2, -0.4, 0.7, -0.4, 1.1;
  s.bodies = {{"lower", scene::anisotropic<2>(stiffness)},
              {"upper", scene::isotropic<2>(1e3, 0.4999, scene::Plane::strain)}};
  s.boundary = {
      {"lower.bottom", tests::sliding(0.01)}, {"lower.left", tests::sliding(-0.02)}, {"upper.top", tests::fixed(0, 0)}};
  s.contact[0].gap = [](const auto& x) { return -0.07 + 0.03 * x[0]; };
  return s;
}

scene::Scene<2> negative_poisson() {
  scene::Scene<2> s = tests::two_blocks(2);
  s.plane = scene::Plane::stress;
  s.bodies = {{"lower", scene::isotropic<2>(1, -0.9, s.plane)}, {"upper", scene::isotropic<2>(1e-6, 0.5, s.plane)}};
  return s;
}

/// Two bodies whose common end is carried away and turned: their displacements are prescribed where the contact ends.
scene::Scene<2> turned_end() {
  scene::Scene<2> s = tests::two_blocks(2);
  const scene::Condition<2> turn = {
      tests::ConditionKind::fixed,
      {[](const auto& x) { return 0.1 - 0.01 * x[1]; }, [](const auto& x) { return 0.3 + 0.01 * x[0]; }},
      ""};
  s.boundary = {{"lower.left", turn}, {"upper.left", turn}, {"upper.top", tests::pressure(tests::constant(0.1))}};
  return s;
}

/// A block whose prescribed end just touches the wall.
scene::Scene<2> touching_end(double down) {
  scene::Scene<2> s;
  s.blocks = {tests::block("block", 0, 1, 0, 1, 2, 2)};
  s.bodies = {{"block", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
  s.boundary = {{"block.left", tests::fixed(0.5 * down, -down)}, {"block.top", tests::pressure(tests::constant(0.1))}};
  s.contact = {{"block.bottom", "rigid", tests::constant(down), ""}};
  return s;
}

std::vector<Case> cases() {
  std::vector<Case> result = {{"everything", tests::everything(2, 2, 2)},
                              {"on_a_wall", on_a_wall()},
                              {"interference", interference()},
                              {"negative_poisson", negative_poisson()},
                              {"lift_off", tests::two_blocks(2)},
                              {"linear_pressure", tests::linear_pressure({}, 3, 2)},
                              {"nearly_incompressible", tests::linear_pressure({.poisson = 0.4999}, 2, 2)},
                              {"contrast", tests::linear_pressure({.young_lower = 1e6}, 2, 2)},
                              {"patch", tests::patch(1e6, 0, 0.01, 2)},
                              {"turned_end", turned_end()},
                              {"touching_end", touching_end(0.1)},
                              {"touching_at_rest", touching_end(0)},
                              {"nothing_held", tests::smooth(2)}};
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

/// Turned by the angle of the triangle 3-4-5 and stretched by 5/4. Coordinates that are multiples of a power of two
/// stay so, and sides along axes become sides of rational length.
Vector<2> map(const Vector<2>& x) { return {x[0] - 0.75 * x[1], 0.75 * x[0] + x[1]}; }

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
  return balanced(scene::fix_data(c.scene, mesh), 2);
}

/// Judges the certificates of all degrees on all cases.
template <class Check> void for_all_cases(const Check& check) {
  for (const Case& c : cases())
    for (const int degree : {1, 2, 3, 4}) {
      SCOPED_TRACE(c.name + ", degree " + std::to_string(degree));
      const auto problem = problem_of(c);
      const auto displacements = primal::solve(problem, degree);
      const auto stresses = dual::solve(problem, scene::stress_degree(degree));
      ASSERT_EQ(displacements.termination, contact::Termination::solved) << displacements.reason;
      ASSERT_EQ(stresses.termination, contact::Termination::solved) << stresses.reason;
      const Certificate certificate = certify(problem, displacements.displacement, stresses.stress);
      ASSERT_TRUE(certificate.valid) << certificate.reason;
      check(problem, certificate, judged(problem, displacements.displacement, stresses.stress));
    }
}

/// Strain energy: L, were there no loads.
Exact strain_energy(scene::Problem<2> problem, const ExactDisplacement& displacement) {
  for (auto& body : problem.bodies) body.force.setZero();
  for (auto& facet : problem.facets) {
    facet.traction = {Vector<2>::Zero(), Vector<2>::Zero()};
    facet.pressure = {0, 0};
  }
  return potential_energy(problem, displacement, {});
}

TEST(Certificate, fields_are_admissible_exactly) {
  for_all_cases([](const scene::Problem<2>& problem, const Certificate&, const Judged& exact) {
    EXPECT_EQ(faults(problem, exact.displacement), std::vector<std::string>{});
    EXPECT_EQ(faults(problem, exact.stress), std::vector<std::string>{});
    const auto supports = vertex_supports(problem);
    for (const auto& pair : problem.contact)
      for (const Exact& r : penetration<Exact>(problem, supports, exact.field, pair)) EXPECT_LE(r, Exact(0));
  });
}

TEST(Certificate, energies_are_those_of_the_fields_exactly) {
  for_all_cases([](const scene::Problem<2>& problem, const Certificate&, const Judged& exact) {
    const auto supports = vertex_supports(problem);
    const Exact l = potential_energy(problem, exact.displacement, exact.stress.added);
    const Exact s = complementary_energy(problem, exact.stress, exact.displacement);
    EXPECT_EQ((field_energy<Exact, RationalSum>(problem, supports, exact.field, exact.stress.added).total), l);
    EXPECT_EQ((stress_energy<Exact, RationalSum>(problem, exact.loads)), s);
    EXPECT_EQ(l + s, distance(problem, exact.stress, exact.displacement));
  });
}

TEST(Certificate, contains_the_exact_energies_and_is_narrow) {
  for_all_cases([](const scene::Problem<2>& problem, const Certificate& certificate, const Judged& exact) {
    const Exact l = potential_energy(problem, exact.displacement, exact.stress.added);
    const Exact s = complementary_energy(problem, exact.stress, exact.displacement);
    EXPECT_LE(certificate.lower, certificate.upper);
    EXPECT_LE(Exact(certificate.lower), -s);
    EXPECT_GE(Exact(certificate.upper), l);
    const double size = std::max(std::abs(certificate.lower), std::abs(certificate.upper));
    // Stresses are second differences of what is integrated twice: six of nineteen digits may go.
    EXPECT_LE(rounded(-s - Exact(certificate.lower)), 1e-12 * size);
    EXPECT_LE(rounded(Exact(certificate.upper) - l), 1e-12 * size);
    const Exact strain = strain_energy(problem, exact.displacement);
    EXPECT_LE(Exact(certificate.strain_energy), strain);
    EXPECT_NEAR(certificate.strain_energy, rounded(strain), 1e-13 * rounded(strain));
  });
}

TEST(Certificate, nothing_penetrates_however_little) {
  // Along the wall as nearly as doubles can: some vertices go into it by less than the enclosures can tell from zero.
  Case c = {"touching_at_rest", touching_end(0), true};
  c.scene.blocks = {tests::block("block", 0, 1, 0, 1, 16, 1)};
  const auto problem = problem_of(c);
  const auto supports = vertex_supports(problem);
  const Vector<2>& d = problem.facets[problem.contact[0].first].normal;
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> along(-1, 1);
  for (int trial = 0; trial < 500; ++trial) {
    scene::Displacement<2> u{1, std::vector<Vector<2>>(problem.mesh.vertices.size()), {}};
    for (Vector<2>& value : u.vertex) {
      value[0] = along(generator);
      value[1] = static_cast<double>(-static_cast<long double>(value[0]) * d[0] / d[1]);
    }
    const auto admissible = admissible_field(problem, u, supports);
    ASSERT_TRUE(admissible.field) << admissible.reason;
    for (const auto& pair : problem.contact)
      for (const Exact& r : penetration<Exact>(problem, supports, *admissible.field, pair)) ASSERT_LE(r, Exact(0));
  }
}

/// Two bodies and a wall in any direction, their shape, materials, supports, weights and gaps by chance; no tractions,
/// so that no length is needed.
scene::Problem<2> random_problem(std::mt19937& generator) {
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(generator);
  };
  const auto one_of = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(generator); };
  scene::Scene<2> s = tests::two_bodies(0, 1, uniform(0.1, 1), uniform(0.1, 1), 1 + one_of(3), 1 + one_of(2));
  if (one_of(2) == 0) s.plane = scene::Plane::stress;
  for (const std::string name : {"lower", "upper"}) {
    const double young = std::pow(10, uniform(-3, 3));
    scene::Body<2> body = scene::isotropic<2>(young, uniform(-0.5, 0.49999), s.plane);
    if (one_of(3) == 0) {
      const scene::Elasticity<2> root = scene::Elasticity<2>::NullaryExpr([&] { return uniform(-1, 1); });
      const scene::Elasticity<2> definite = root * root.transpose() + scene::Elasticity<2>::Identity();
      body.material = scene::anisotropic<2>(definite.selfadjointView<Eigen::Upper>());
    }
    body.force = {uniform(-1, 1), name == "upper" ? uniform(-2, 0) : uniform(-1, 1)};
    s.bodies.emplace(name, body);
    for (const std::string side : {"left", "right"}) switch (one_of(4)) {
        case 0: s.boundary[name + "." + side] = tests::fixed(0.1, 0.1); break;
        case 1: s.boundary[name + "." + side] = tests::sliding(side == "left" ? -0.1 : 0.1 * one_of(2)); break;
        default: break;
      }
  }
  if (one_of(3) == 0) s.boundary["upper.top"] = tests::fixed(0.1, 0.1);
  if (one_of(2) == 0)
    s.boundary["lower.bottom"] = tests::fixed(0.1, 0.1);
  else
    s.contact.push_back({"lower.bottom", "rigid", tests::constant(uniform(0.3, 0.4)), ""});
  const double bend = uniform(-0.1, 0.2);
  s.contact[0].gap = scene::enclosed<2>([bend](const auto& x) { return bend * x[0] * x[0] + 0.2 * std::abs(bend); });
  auto mesh = scene::build_mesh(s);
  const double stretch = uniform(0.3, 1), shear = uniform(-0.5, 0.5);
  const Eigen::Rotation2Dd turn(one_of(3) == 0 ? 0 : uniform(0, 6));
  for (Vector<2>& x : mesh.vertices) x = turn * Vector<2>(x[0] + shear * x[1], stretch * x[1]);
  return scene::fix_data(s, mesh);
}

TEST(Certificate, holds_exactly_on_random_scenes) {
  constexpr int scenes = 40;
  int certified = 0;
  for (int seed = 0; seed < scenes; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 generator(seed);
    const int degree = 1 + seed % 4;
    scene::Problem<2> problem;
    try {
      problem = balanced(random_problem(generator), degree);
    } catch (const scene::Error&) {
      continue;  // supports that contradict each other, or bodies that nothing holds
    }
    const auto displacements = primal::solve(problem, degree);
    const auto stresses = dual::solve(problem, scene::stress_degree(degree));
    if (displacements.termination != contact::Termination::solved ||
        stresses.termination != contact::Termination::solved)
      continue;
    const double noise = seed % 3 == 0 ? 1e-3 : 0;
    const auto u = tests::noisy(displacements.displacement, 1, noise, generator);
    const auto stress = tests::noisy(stresses.stress, 1, noise, generator);
    const Certificate certificate = certify(problem, u, stress);
    ASSERT_TRUE(certificate.valid) << certificate.reason;
    ++certified;
    expect_holds_exactly(problem, certificate, judged(problem, u, stress));
  }
  EXPECT_GT(3 * certified, scenes);
}

}  // namespace
}  // namespace bracket::bounds
