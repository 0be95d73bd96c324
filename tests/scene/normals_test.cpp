// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/problem/normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "tests/scene/refine_cases.h"

namespace bracket::scene {
namespace {

using namespace test;

constexpr double grid = 1e-8;  // coordinates of files are rounded to this

Vector<2> rounded(const Vector<2>& x) { return (x / grid).array().round() * grid; }

Vector<2> turned(const Vector<2>& x, double angle) {
  return {std::cos(angle) * x[0] - std::sin(angle) * x[1], std::sin(angle) * x[0] + std::cos(angle) * x[1]};
}

double cross(const Vector<2>& a, const Vector<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

std::set<std::pair<double, double>> distinct(const std::vector<Vector<2>>& normals) {
  std::set<std::pair<double, double>> result;
  for (const Vector<2>& n : normals) result.insert({n[0], n[1]});
  return result;
}

std::vector<Vector<2>> normals_of(const Problem<2>& problem) {
  std::vector<Vector<2>> normals;
  for (const auto& data : problem.facets) normals.push_back(data.normal);
  return normals;
}

/// An open polygon as boundary facets of a mesh without cells.
Mesh<2> polygon(const std::vector<Vector<2>>& vertices) {
  Mesh<2> mesh;
  mesh.vertices = vertices;
  for (int i = 0; i + 1 < static_cast<int>(vertices.size()); ++i) mesh.boundary.push_back({{i, i + 1}, 0, 0, i, -1});
  return mesh;
}

// Three rectangles with six sides each way: rounding makes some fifty directions of two, also about the angle at which
// the sorted angles begin anew.
TEST(Normals, OfTurnedRectanglesAreTwoUpToSign) {
  for (const double angle : {0.5, 1.3, -2.4, 1e-7, -1e-7, std::numbers::pi / 2 + 1e-7, 3 * std::numbers::pi / 4}) {
    const Problem<2> problem =
        three_blocks("turned", [&](const Vector<2>& x) { return rounded(turned(x, angle)); }).problem;
    const std::vector<Vector<2>> normals = normals_of(problem);
    const auto directions = distinct(normals);
    EXPECT_EQ(directions.size(), 4u) << angle;
    for (const auto& [x, y] : directions) EXPECT_TRUE(directions.contains({-x, -y})) << angle;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const int facet = static_cast<int>(i);
      EXPECT_NEAR(normals[i].norm(), 1, 1e-15);
      // Both ends of the shortest facet, ¼ long, and of the one that stands for it: grid/√2 each.
      EXPECT_LE((normals[i] - normal(problem.mesh, facet)).norm(), 4 * grid / std::sqrt(2) / 0.25);
    }
    int pairs = 0;
    for (const ContactFacet& pair : problem.contact) {
      if (pair.second == -1) continue;
      ++pairs;
      EXPECT_EQ(normals[pair.first], -normals[pair.second]);
    }
    EXPECT_GT(pairs, 0);
  }
}

TEST(Normals, AreAtRightAnglesToTheChordOfAChain) {
  // So pressure along them balances that on the rest of the contour, however the nodes between were rounded.
  for (const double units : {1e8, 1e9}) {
    Scene<2> scene;
    scene.blocks = {{"b", {{{0, 1}, {0, 1}}}, {32, 32}, ""}};
    Mesh<2> mesh = build_mesh(scene);
    for (Vector<2>& x : mesh.vertices) x = (turned(x, 0.5) * units).array().round() / units;
    std::vector<char> bottom(mesh.boundary.size(), 0);
    Vector<2> force = Vector<2>::Zero();
    double size = 0;
    for (std::size_t f = 0; f < bottom.size(); ++f) bottom[f] = mesh.parts[mesh.boundary[f].part] == "b.bottom";
    const std::vector<Vector<2>> normals = shared_normals(mesh, bottom);
    for (std::size_t f = 0; f < bottom.size(); ++f) {
      const int facet = static_cast<int>(f);
      if (!bottom[f]) force -= length(mesh, facet) * normal(mesh, facet);
      size += length(mesh, facet);
    }
    for (std::size_t f = 0; f < bottom.size(); ++f) {
      if (!bottom[f]) continue;
      EXPECT_LE(std::abs(cross(force, normals[f])), 64 * std::numeric_limits<double>::epsilon() * size) << units;
    }
  }
}

TEST(Normals, OfAPolygonKeepItsCorners) {
  for (const int n : {3, 7, 64, 1000}) {
    std::vector<Vector<2>> vertices;
    for (int i = 0; i <= n; ++i) vertices.push_back(rounded(turned({1, 0}, 2 * std::numbers::pi * (i % n) / n)));
    const Mesh<2> mesh = polygon(vertices);
    const std::vector<Vector<2>> normals = shared_normals(mesh);
    const double rounding = 4 * grid / std::sqrt(2) / length(mesh, 0);
    for (int i = 0; i < n; ++i) {
      EXPECT_NEAR(cross(normals[i], normals[(i + 1) % n]), std::sin(2 * std::numbers::pi / n), 2 * rounding) << n;
      if (n % 2 == 0) {
        EXPECT_EQ(normals[i], -normals[(i + n / 2) % n]) << n;
      }
    }
  }
}

TEST(Normals, BendByMoreThanRoundingOnly) {
  const auto bent = [](double angle) { return shared_normals(polygon({{-1, 0.3}, {0, 0}, turned({1, -0.3}, angle)})); };
  EXPECT_EQ(bent(9e-7)[0], bent(9e-7)[1]);
  EXPECT_NEAR(cross(bent(2e-6)[0], bent(2e-6)[1]), 2e-6, 1e-15);
}

// Sides of 3e-3 that turn by 3e-7 rad each: the arc is none of its chords, yet the two halves of a side are one line,
// however the coordinates are rounded (their units in the last place are 2e-12).
TEST(Normals, OfAFineArcStayItsOwn) {
  const double radius = 1e4, step = 3e-7;
  std::vector<Vector<2>> vertices = {turned({0, -radius}, 0.2)};
  for (int i = 1; i <= 200; ++i) {
    const Vector<2> next = turned({0, -radius}, 0.2 + i * step);
    vertices.push_back(0.5 * (vertices.back() + next));
    vertices.push_back(next);
  }
  const Mesh<2> mesh = polygon(vertices);
  const std::vector<Vector<2>> normals = shared_normals(mesh);
  int unlike = 0;
  for (int i = 0; i < 200; ++i) {
    EXPECT_EQ(normals[2 * i], normals[2 * i + 1]);
    unlike += normal(mesh, 2 * i) != normal(mesh, 2 * i + 1);
    if (i == 0) continue;
    EXPECT_NEAR(cross(normals[2 * i - 1], normals[2 * i]), step, 8 * 2e-12 / 1.5e-3);
  }
  EXPECT_GT(unlike, 100);
}

}  // namespace
}  // namespace bracket::scene
