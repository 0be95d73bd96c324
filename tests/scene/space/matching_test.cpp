// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/problem/gap.h"
#include "scene/problem/normals.h"
#include "scene/problem/space/face.h"
#include "scene/toml/expression.h"
#include "tests/scene/space/boxes.h"

namespace bracket::scene {
namespace {

using namespace test;

/// What holds of the contact of every problem in space.
void expect_matched_in_space(const Problem<3>& problem) {
  for (const ContactFacetOf<3>& pair : problem.contact) {
    const FacetData<3>& data = problem.facets[pair.first];
    EXPECT_EQ(data.support, Support::contact);
    EXPECT_NEAR(data.normal.norm(), 1, 1e-15);
    EXPECT_GT(data.normal.dot(normal(problem.mesh, pair.first)), pair.second < 0 ? 0.9 : 1 - 1e-9);
    if (pair.second < 0) continue;
    EXPECT_EQ(problem.facets[pair.second].normal, Vector<3>(-data.normal));
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(problem.mesh.vertices[problem.mesh.boundary[pair.first].vertices[i]],
                problem.mesh.vertices[problem.mesh.boundary[pair.second].vertices[pair.meets[i]]]);
  }
}

TEST(MatchingInSpace, PutsNodesOnEachOtherToTheLastBit) {
  Random random(11);
  for (const double apart : {0.0, 1e-9}) {
    const Scene<3> scene = unit_boxes(3);
    Mesh<3> mesh = turned_about(shaken(build_mesh(scene), random, 0.08), random_rotation(random), {2, 3, 4});
    for (Vector<3>& x : mesh.vertices) x += apart * Vector<3>(uniform(random, -1, 1), uniform(random, -1, 1), 0.3);
    const Problem<3> problem = fix_data(scene, mesh);
    ASSERT_EQ(problem.contact.size(), 18u);
    expect_matched_in_space(problem);
    for (const ContactFacetOf<3>& pair : problem.contact) {  // one side, one normal
      EXPECT_EQ(problem.facets[pair.first].normal, problem.facets[problem.contact[0].first].normal);
      EXPECT_EQ(pair.lower, (FacetQuadratic<3>{}));
      EXPECT_EQ(pair.upper, (FacetQuadratic<3>{}));
    }
    EXPECT_EQ(apart > 0, std::ranges::any_of(problem.mesh.notes, [](const std::string& note) {
                return note.find("moved by up to") != std::string::npos;
              }));
  }
}

TEST(MatchingInSpace, TellsTheNearestNodeOfSidesThatDoNotCoincide) {
  Scene<3> scene = unit_boxes(2);
  scene.blocks[1].range[1] = {1.001, 2};
  expect_error([&] { fix_data(scene, build_mesh(scene)); }, Status::mesh,
               {"coincide node by node", "(0, 1, 0)", "(0, 1.001, 0)", "0.001 away"});
  scene = unit_boxes(2);
  scene.blocks[1].cells[0] = 3;
  expect_error([&] { fix_data(scene, build_mesh(scene)); }, Status::mesh, {"coincide node by node", "has no partner"});
  scene = unit_boxes(2);
  scene.contact[0].second = "lower.topp";
  expect_error([&] { fix_data(scene, build_mesh(scene)); }, Status::input, {"did you mean 'lower.top'"});
  // the other diagonal
  scene = unit_boxes(1);
  Mesh<3> mesh = build_mesh(scene);
  for (Vector<3>& x : mesh.vertices)
    if (&x - mesh.vertices.data() >= 8) x[0] = 1 - x[0];
  scene = given(mesh, unit_boxes(1));
  expect_error([&] { fix_data(scene, build_mesh(scene)); }, Status::mesh, {"face by face", "other faces"});
}

TEST(MatchingInSpace, OfWallsAndPlanes) {
  Scene<3> scene = unit_boxes(2);
  scene.contact = {
      {"upper.bottom", "rigid", 0.25, ""},
      {"upper.top", PlaneObstacle{{0, 2.5, 0}, {0.1, -1, 0}}, {}, ""},
      {std::vector<std::string>{"lower.top", "lower.left"}, PlaneObstacle{{0, 1.5, 0}, {0, -3, 0}}, {}, ""}};
  const Problem<3> problem = fix_data(scene, build_mesh(scene));
  ASSERT_EQ(problem.contact.size(), 24u);
  expect_matched_in_space(problem);
  const Vector<3> d = Vector<3>(-0.1, 1, 0).normalized();
  for (const ContactFacetOf<3>& pair : problem.contact) {
    EXPECT_EQ(pair.second, -1);
    const auto x = positions(problem.mesh, problem.mesh.boundary[pair.first].vertices);
    for (int i = 0; i < 6; ++i) {
      const Vector<3> at =
          i < 3 ? x[i] : Vector<3>(0.5 * (x[Simplex<2>::edges[i - 3][0]] + x[Simplex<2>::edges[i - 3][1]]));
      const double expected = pair.pair == 0 ? 0.25 : pair.pair == 1 ? (Vector<3>(0, 2.5, 0) - at).dot(d) : 1.5 - at[1];
      EXPECT_NEAR(pair.lower[i], expected, 1e-15);
      EXPECT_EQ(pair.lower[i], pair.upper[i]);
    }
  }
  EXPECT_TRUE(std::ranges::any_of(problem.mesh.notes, [](const std::string& note) {
    return note.find("8 of 16 faces of 'lower.top, lower.left' lie before a plane") != std::string::npos;
  }));
  scene.contact.resize(1);
  scene.contact[0].second = PlaneObstacle{{0, 0, 0}, {1, 0, 0}};
  expect_error([&] { fix_data(scene, build_mesh(scene)); }, Status::mesh, {"no face of 'upper.bottom'", "a plane"});
}

// Faces of a rotated box have one normal each, exactly opposite ones on opposite sides; a curved side keeps them all.
TEST(NormalsInSpace, AreSharedByFacesOfOnePlane) {
  Random random(2);
  for (int round = 0; round < 5; ++round) {
    Mesh<3> mesh = shaken(build_mesh(unit_boxes(3)), random, 0.1);
    if (round > 0) mesh = turned_about(mesh, random_rotation(random), {100, 20, -3});
    std::map<std::string, Vector<3>> of;
    const std::vector<Vector<3>> normals = shared_normals(mesh, {});
    for (std::size_t f = 0; f < normals.size(); ++f) {
      const std::string part = mesh.parts[mesh.boundary[f].part].substr(6);
      EXPECT_EQ(normals[f], of.try_emplace(part, normals[f]).first->second);
      EXPECT_LE((normals[f] - normal(mesh, static_cast<int>(f))).norm(), 1e-12);
      if (round == 0) {
        EXPECT_EQ((normals[f].array() != 0).count(), 1);
      }
    }
    EXPECT_EQ(of.at("left"), Vector<3>(-of.at("right")));
    EXPECT_EQ(of.at("front"), Vector<3>(-of.at("back")));
  }
  Mesh<3> mesh = build_mesh(unit_boxes(3));
  for (Vector<3>& x : mesh.vertices)
    if (x[1] > 1.9) x[1] += 1e-4 * std::sin(3 * x[0] + x[2]);
  std::set<std::array<double, 3>> of_top;
  const std::vector<Vector<3>> normals = shared_normals(mesh, {});
  for (std::size_t f = 0; f < normals.size(); ++f)
    if (mesh.parts[mesh.boundary[f].part] == "upper.top") of_top.insert({normals[f][0], normals[f][1], normals[f][2]});
  EXPECT_EQ(of_top.size(), 18u);
}

// A wall along y = c x², in strips: the faces turn by the differences of the strips' slopes, most at the flattest.
TEST(NormalsInSpace, TellTheLargestAngleOfCurvedFaces) {
  Scene<3> scene = unit_boxes(4);
  scene.boundary["lower.bottom"] = {ConditionKind::sliding, {0.0}};
  const auto told = [&](double c) {
    Mesh<3> mesh = build_mesh(scene);
    for (Vector<3>& x : mesh.vertices)
      if (x[1] == 0) x[1] = c * x[0] * x[0];
    for (const std::string& note : fix_data(scene, mesh).mesh.notes)
      if (note.find("turns at its edges") != std::string::npos) return note;
    return std::string();
  };
  EXPECT_EQ(told(0), "");
  const double angle = (std::atan(0.2 * 0.75) - std::atan(0.2 * 0.25)) * 180 / std::numbers::pi;
  EXPECT_NE(told(0.2).find("'lower.bottom'"), std::string::npos);
  EXPECT_NE(told(0.2).find(fmt::format("by up to {:.3g} degrees at (0.25, 0.0125, ", angle)), std::string::npos)
      << told(0.2);
}

TEST(RoomInSpace, IsMadeWhereSupportsCloseAGapByRounding) {
  Scene<3> scene = unit_boxes(2);
  scene.boundary["upper.left"] = {ConditionKind::fixed, {0.0, -0.1, 0.0}};
  scene.boundary["lower.left"] = {ConditionKind::fixed, {0.0, 0.2, 0.0}};
  scene.boundary.erase("lower.bottom");
  scene.contact[0].gap = 0.3;  // 0.1 + 0.2 is more than that by rounding
  Problem<3> problem = fix_data(scene, build_mesh(scene));
  int raised = 0;
  for (const ContactFacetOf<3>& pair : problem.contact) {
    const auto x = positions(problem.mesh, problem.mesh.boundary[pair.first].vertices);
    for (int i = 0; i < 6; ++i) {
      const double at = i < 3 ? x[i][0] : 0.5 * (x[Simplex<2>::edges[i - 3][0]][0] + x[Simplex<2>::edges[i - 3][1]][0]);
      EXPECT_EQ(pair.lower[i] > 0.3, at == 0) << i;
      raised += pair.lower[i] > 0.3;
      if (at == 0) {
        EXPECT_GE(static_cast<long double>(pair.lower[i]), static_cast<long double>(0.1) + 0.2);
      }
    }
  }
  EXPECT_GE(raised, 6);
  scene.contact[0].gap = 0.3 - 1e-9;
  problem = fix_data(scene, build_mesh(scene));
  for (const ContactFacetOf<3>& pair : problem.contact)
    for (const double c : pair.lower) EXPECT_EQ(c, 0.3 - 1e-9);
}

TEST(LawsInSpace, GapsOfBilateralSidesAreInterpolated) {
  Scene<3> scene = unit_boxes(2);
  scene.contact[0].law = Law::bilateral;
  for (const char* text : {"0.1*x*z", "0.1*sin(5*x)"})
    for (const int degree : {1, 2}) {
      const Function<3> gap = parse_expression<3>(text, "");
      scene.contact[0].gap = gap;
      scene.solve.degree = degree;
      const Problem<3> problem = fix_data(scene, build_mesh(scene));
      double error = 0, largest = 0;
      for (const ContactFacetOf<3>& pair : problem.contact) {
        EXPECT_TRUE(pair.law.two_sided);
        const Face x = positions(problem.mesh, problem.mesh.boundary[pair.first].vertices);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(pair.lower[i], gap(x[i]), 1e-16);
        for (int e = 0; e < 3; ++e) {
          const auto& [i, k] = Simplex<2>::edges[e];
          const double middle = 0.5 * pair.lower[3 + e] + 0.25 * (pair.lower[i] + pair.lower[k]);
          EXPECT_NEAR(middle, degree == 2 ? gap(0.5 * (x[i] + x[k])) : 0.5 * (gap(x[i]) + gap(x[k])), 1e-16);
        }
        for (int i = 0; i <= 16; ++i)
          for (int k = 0; i + k <= 16; ++k) {
            const std::array<double, 2> at = {i / 16.0, k / 16.0};
            const double value = gap((1 - at[0] - at[1]) * x[0] + at[0] * x[1] + at[1] * x[2]);
            error = std::max(error, std::abs(value - on_part(pair.upper, {at, at, at})[0]));
            largest = std::max(largest, std::abs(value));
          }
        for (const double c : pair.lower) largest = std::max(largest, std::abs(c));
      }
      // What is told is seen at points.
      EXPECT_LE(problem.oscillation.gap * largest, 1.1 * error + 1e-16);
      EXPECT_GE(problem.oscillation.gap * largest, 0.9 * error - 1e-16);
    }
  scene.contact[0].gap = parse_expression<3>("sin(x)", "");
  scene.contact[0].law = Law::frictionless;
  const Problem<3> problem = fix_data(scene, build_mesh(scene));
  EXPECT_FALSE(has_quadratic_gaps(problem));
  for (const ContactFacetOf<3>& pair : problem.contact)
    for (int i = 0; i < 6; ++i) EXPECT_LE(pair.lower[i], pair.upper[i]);
}

TEST(PerturbedInSpace, AddsMultiplesOfItsData) {
  Scene<3> scene = unit_boxes(1);
  scene.boundary["upper.top"] = {ConditionKind::traction, {0.0, -1.0, 0.0}};
  const Problem<3> problem = fix_data(scene, build_mesh(scene));
  auto by = std::make_shared<Perturbation<3>>(no_perturbation(problem));
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    by->facets[f].traction[1] = {{1, 2, 3}, {0, 0, 0}};
    by->facets[f].displacement[2] = {{4, 5, 6}, {0, 0, 0}};
  }
  by->contact[0].opening = {1, 2, 3};
  by->contact[0].gap = {1, 1, 1, 1, 1, 1};
  by->contact[0].first[0] = {{0, -2, 0}, {0, 0, 0}};  // along d: 2
  const Problem<3> moved = perturbed<3>(problem, by, 0.5, 0.25);
  const ContactFacetOf<3>& pair = moved.contact[0];
  const FacetQuadratic<3> expected = {0.75, 0.25, 0.25, 0.25, 0.5, 0.5};
  for (int i = 0; i < 6; ++i) {
    EXPECT_LE(pair.lower[i], expected[i]);
    EXPECT_GE(pair.upper[i], expected[i]);
    EXPECT_NEAR(pair.lower[i], pair.upper[i], 2 * eps);
  }
  const Vector<3>& d = moved.facets[pair.first].normal;
  const auto own = [](int vertex) { return Vector<3>(vertex == 1 ? Vector<3>(0.5, 1, 1.5) : Vector<3>(0, 0, 0)); };
  for (int i = 0; i < 3; ++i) {
    const int across = pair.meets[i];
    EXPECT_EQ(moved.facets[pair.first].traction[i], own(i) + 0.5 * (i + 1) * d);
    EXPECT_EQ(moved.facets[pair.second].traction[across], own(across) - 0.5 * (i + 1) * d);
  }
  EXPECT_EQ(moved.contact[1].lower, problem.contact[1].lower);
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (moved.facets[f].support == Support::fixed) {
      EXPECT_EQ(moved.facets[f].displacement[2], Vector<3>(1, 1.25, 1.5));
    }
    if (moved.facets[f].support == Support::traction) {
      EXPECT_EQ(moved.facets[f].traction[1] - problem.facets[f].traction[1], Vector<3>(0.5, 1, 1.5));
    }
  }
}

}  // namespace
}  // namespace bracket::scene
