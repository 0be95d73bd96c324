// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "scene/problem/space/face_difference.h"
#include "scene/problem/space/face_values.h"
#include "scene/toml/expression.h"
#include "tests/scene/space/boxes.h"

namespace bracket::scene {
namespace {

using namespace test;

Vector<3> resultant(const Problem<3>& problem) {
  Vector<3> sum = Vector<3>::Zero();
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (is_loaded(problem.facets[f]))
      for (const Vector<3>& at : load(problem, static_cast<int>(f))) sum += at / 3;
  return sum;
}

TEST(DataInSpace, OfLinearTractionsAreExact) {
  Scene<3> scene = unit_boxes(2);
  const auto x = enclosed<3>([](const auto& at) { return at[0]; });
  const auto sum = enclosed<3>([](const auto& at) { return at[0] * 0.5 - at[2] * 3 + 1; });
  scene.boundary["upper.top"] = {ConditionKind::traction, {x, sum, 2.0}};
  const Problem<3> problem = fix_data(scene, build_mesh(scene));
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& facet = problem.mesh.boundary[f];
    if (problem.mesh.parts[facet.part] != "upper.top") continue;
    for (int i = 0; i < 3; ++i) {
      const Vector<3>& at = problem.mesh.vertices[facet.vertices[i]];
      EXPECT_EQ(problem.facets[f].traction[i], Vector<3>(at[0], at[0] * 0.5 - at[2] * 3 + 1, 2));
    }
  }
  EXPECT_EQ(problem.oscillation.traction, 0);
  EXPECT_FALSE(problem.sampled);
  EXPECT_LE((resultant(problem) - Vector<3>(0.5, -0.25, 2)).norm(), 1e-15);
}

// What is not linear is projected: force and moments stay, and the difference is bounded.
TEST(DataInSpace, OfOtherTractionsAreProjectedAndTheDifferenceIsBounded) {
  Random random(4);
  const Face face = {{{0.1, 0.2, 0.3}, {1.1, 0.4, 0.2}, {0.5, 1.4, 0.9}}};
  const auto f = enclosed<3>([](const auto& at) {
    using std::sin;
    return sin(at[0] * 2) + at[1] * at[2] * at[2];
  });
  const FacetValues<3> linear = project(f, face, "");
  double least = 1;
  for (int i = 0; i < 3; ++i) least = std::min(least, linear.value[i]);
  std::array<double, 3> moments{};
  double largest = 0;
  constexpr int n = 400;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k + i < n; ++k)
      for (const double third : {1 / 3.0, 2 / 3.0}) {
        if (third > 0.5 && i + k == n - 1) continue;
        const OnFace at = {(i + third) / n, (k + third) / n};
        const double value =
            linear.value[0] + at[0] * (linear.value[1] - linear.value[0]) + at[1] * (linear.value[2] - linear.value[0]);
        const double left = f(place(face, at)) - value;
        largest = std::max(largest, std::abs(left));
        moments[0] += left * (1 - at[0] - at[1]) / n / n;
        moments[1] += left * at[0] / n / n;
        moments[2] += left * at[1] / n / n;
      }
  for (const double moment : moments) EXPECT_LE(std::abs(moment), 1e-5);
  for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(f(face[i]) - linear.value[i]));
  EXPECT_GE(linear.error, largest - 4 * eps);  // what is found at points is rounded
  EXPECT_LE(linear.error, 1.05 * largest);     // parts are quartered until it is
  EXPECT_GE(linear.largest, std::abs(f(face[2])));
}

// On each part not less than the difference and its gradient along the face, and not much more.
TEST(DataInSpace, WhatIsLeftOutIsBoundedPartByPart) {
  Random random(12);
  const std::vector<Function<3>> all = {enclosed<3>([](const auto& at) {
                                          using std::exp;
                                          using std::sin;
                                          return sin(at[0] * 5) + exp(at[1] * at[2]);
                                        }),
                                        parse_expression<3>("x < 0.6 ? y^2 : 1 + z", ""),
                                        parse_expression<3>("1 + 2 * x - y", ""),
                                        Function<3>([](const Vector<3>& at) { return at[0] * at[1]; })};
  for (std::size_t f = 0; f < all.size(); ++f)
    for (int i = 0; i < 5; ++i) {
      Face face;
      for (auto& x : face)
        for (double& c : x) c = uniform(random, 0, 1);
      std::array<double, 6> quadratic;
      for (double& c : quadratic) c = uniform(random, -1, 1);
      double area = 0, mean = 0, bound = 0;
      for (const auto& [part, largest, slope, value] : difference(all[f], face, quadratic)) {
        area += share_of_face(part);
        double most = 0;
        for (const auto& [at, weight] : points_in(part)) {
          const auto left = [&](const OnFace& there) {
            return all[f](place(face, there)) - on_part(quadratic, {there, there, there})[0];
          };
          most = std::max(most, std::abs(left(at)));
          EXPECT_LE(std::abs(all[f](place(face, at))), value * (1 + 1e-12));
          for (const OnFace& to : part) {  // a mean slope
            const OnFace near = {at[0] + 0.01 * (to[0] - at[0]), at[1] + 0.01 * (to[1] - at[1])};
            const double length = (place(face, near) - place(face, at)).norm();
            if (all[f].is_enclosed()) {
              EXPECT_LE(std::abs(left(near) - left(at)), slope * length * (1 + 1e-9) + 1e-14) << f;
            }
          }
        }
        EXPECT_LE(most, largest * (1 + 1e-12) + 1e-15) << f;
        mean += share_of_face(part) * most;
        bound += share_of_face(part) * largest;
      }
      EXPECT_EQ(area, 1);
      EXPECT_LE(bound, 2 * mean + 1e-15) << f;
    }
}

TEST(DataInSpace, JumpAtEdgesOfTheMeshWithoutAnError) {
  Scene<3> scene = unit_boxes(2);
  for (const char* jump : {"x < 0.5 ? -0.1 : 0.09", "z > 0.5 ? -0.1 : 0.09", "x <= 0.5 && z < 0.5 ? -0.1 : 0.09"}) {
    scene.boundary["upper.top"] = {ConditionKind::traction, {0.0, parse_expression<3>(jump, ""), 0.0}};
    const Problem<3> problem = fix_data(scene, build_mesh(scene));
    EXPECT_EQ(problem.oscillation.traction, 0) << jump;
    for (std::size_t f = 0; f < problem.facets.size(); ++f)
      for (const Vector<3>& t : problem.facets[f].traction) EXPECT_TRUE(t[1] == 0 || t[1] == -0.1 || t[1] == 0.09);
  }
  scene.boundary["upper.top"].value[1] = parse_expression<3>("x < 0.3 ? -0.1 : 0.1", "");
  const Problem<3> inside = fix_data(scene, build_mesh(scene));
  EXPECT_GE(inside.oscillation.traction, 0.5);
  EXPECT_NEAR(resultant(inside)[1], 0.04, 2e-3);
}

TEST(DataInSpace, PressureOnAClosedSurfaceIsInBalance) {
  Random random(7);
  Scene<3> scene = unit_boxes(2);
  scene.contact.clear();
  scene.boundary.clear();
  for (const char* body : {"lower", "upper"})
    for (const char* side : {".left", ".right", ".bottom", ".top", ".back", ".front"})
      scene.boundary[std::string(body) + side] = {ConditionKind::pressure, {3.7}};
  const Mesh<3> mesh = turned_about(shaken(build_mesh(scene), random, 0.1), random_rotation(random), {3, -40, 2});
  const Problem<3> problem = fix_data(scene, mesh);
  EXPECT_LE(resultant(problem).norm(), 1e-12);
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const Vector<3> along = load(problem, static_cast<int>(f))[0];
    EXPECT_LE(
        (along + 3.7 * length(problem.mesh, static_cast<int>(f)) * normal(problem.mesh, static_cast<int>(f))).norm(),
        1e-14);
  }
}

TEST(DataInSpace, PrescribedDisplacementsAgreeAtVertices) {
  Scene<3> scene = unit_boxes(2);
  const auto linear = [](double factor) {
    return enclosed<3>([factor](const auto& at) { return at[0] * factor + 0.1; });
  };
  scene.boundary["lower.bottom"] = {ConditionKind::fixed, {linear(1 / 3.0), 0.1, 0.2}};
  scene.boundary["lower.left"] = {ConditionKind::sliding, {-0.1}};
  scene.boundary["lower.right"] = {ConditionKind::sliding, {linear(1 / 3.0)}};
  const Problem<3> problem = fix_data(scene, build_mesh(scene));
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const FacetData<3>& data = problem.facets[f];
    if (data.support != Support::sliding) continue;
    for (int i = 0; i < 3; ++i) {
      const Vector<3>& x = problem.mesh.vertices[problem.mesh.boundary[f].vertices[i]];
      if (x[1] == 0) {
        EXPECT_EQ(data.normal_displacement[i], data.normal[0] * (x[0] * (1 / 3.0) + 0.1));
      }
    }
  }
  scene.boundary["lower.left"].value[0] = -0.101;
  expect_error([&] { fix_data(scene, build_mesh(scene)); }, Status::input,
               {"'lower.left'", "'lower.bottom'", "contradict", "0.001"});
}

TEST(DataInSpace, UnknownNamesAreRefused) {
  Scene<3> scene = unit_boxes(1);
  scene.boundary["upper.tip"] = {ConditionKind::pressure, {1.0}};
  expect_error([&] { fix_data(scene, build_mesh(scene)); }, Status::input, {"'upper.tip'", "did you mean 'upper.top'"});
  scene = unit_boxes(1);
  scene.boundary["upper.top"] = {ConditionKind::traction, {1.0, 2.0}};
  expect_error([&] { fix_data(scene, build_mesh(scene)); }, Status::input, {"must have 3 functions, has 2"});
  scene = unit_boxes(1);
  scene.contact[0].law = Law::winkler;
  scene.contact[0].value = 1.0;
  expect_error([&] { build_mesh(scene); }, Status::input, {"three dimensions know", "winkler"});
  scene = unit_boxes(1);
  scene.contact[0].second = CircleObstacle{{{0, 0}, 1}};
  expect_error([&] { build_mesh(scene); }, Status::input, {"a circle", "plane"});
  scene = unit_boxes(1);
  scene.curves["upper.top"] = {};
  expect_error([&] { build_mesh(scene); }, Status::input, {"arcs of the plane"});
  scene = unit_boxes(1);
  scene.solve.degree = 3;
  expect_error([&] { build_mesh(scene); }, Status::input, {"solve.degree", "1 or 2"});
  scene = unit_boxes(1);
  scene.solve.dual = Dual::hybrid;
  expect_error([&] { build_mesh(scene); }, Status::input, {"solve.dual", "\"local\""});
}

TEST(MaterialInSpace, IsItsOwnInverseAndKeepsPlaneStrain) {
  for (const double nu : {-0.5, 0.0, 0.3, 0.4999}) {
    const Material<3> space = isotropic<3>(210e3, nu);
    const Elasticity<3> unit = space.stiffness() * space.compliance();
    EXPECT_LE((unit - Elasticity<3>::Identity()).cwiseAbs().maxCoeff(), 1e-11);
    const Material<2> plane = isotropic<2>(210e3, nu, Plane::strain);
    const std::array<int, 3> in_plane = {0, 1, 5};
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        EXPECT_DOUBLE_EQ(space.stiffness()(in_plane[i], in_plane[k]), plane.stiffness()(i, k));
    const Material<3> same = anisotropic<3>(space.stiffness());
    EXPECT_LE((same.compliance() - space.compliance()).cwiseAbs().maxCoeff(),
              1e-11 * space.compliance().cwiseAbs().maxCoeff());
  }
  expect_error([] { isotropic<3>(1, 0.5); }, Status::input, {"nu", "(-1, 0.5)"});
  Elasticity<3> indefinite = isotropic<3>(1, 0.3).stiffness();
  indefinite(5, 5) = -1;
  expect_error([&] { anisotropic<3>(indefinite); }, Status::input, {"positive definite"});
}

TEST(MotionsInSpace, OfABlockThatSlidesOnItsBase) {
  Scene<3> scene = unit_boxes(1);
  scene.boundary["lower.bottom"] = {ConditionKind::sliding, {0.0}};
  const Problem<3> problem = fix_data(scene, build_mesh(scene));
  ASSERT_EQ(problem.mesh.components, (std::vector<std::string>{"lower", "upper"}));
  EXPECT_EQ(free_motions(problem, 1).size(), 6u);
  const auto free = free_motions(problem, 0);
  ASSERT_EQ(free.size(), 3u);
  for (const auto& motion : free)
    for (const Vector<3>& x : problem.mesh.vertices)
      if (x[1] == 0) {
        EXPECT_NEAR(displacement(motion, x)[1], 0, 1e-9);
      }
  scene.boundary["lower.left"] = scene.boundary["lower.back"] = {ConditionKind::sliding, {0.0}};
  EXPECT_EQ(free_motions(fix_data(scene, build_mesh(scene)), 0).size(), 0u);
}

TEST(MotionsInSpace, AreDescribed) {
  EXPECT_EQ(describe(RigidMotion<3>{{0, 1, 0}, {}, {5, 5, 5}}), "moving it by (0, 1, 0)");
  EXPECT_EQ(describe(RigidMotion<3>{{0, 0, 0}, {0, 0, 2}, {1, 2, 0}}),
            "turning it about the axis through (1, 2, 0) along (0, 0, 1)");
  // about (3, 0, z): u = ω × (x − p) at the centre (1, 0, 0) is (0, −2, 0)
  EXPECT_EQ(describe(RigidMotion<3>{{0, -2, 0}, {0, 0, 1}, {1, 0, 0}}),
            "turning it about the axis through (3, 0, 0) along (0, 0, 1)");
  EXPECT_NE(describe(RigidMotion<3>{{0, 0, 3}, {0, 0, 2}, {0, 0, 0}}).find("moving it along by 1.5 a radian"),
            std::string::npos);
}

}  // namespace
}  // namespace bracket::scene
