// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Lines as coordinates of few digits leave them, and arcs that are polygons.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "scene/mesh/angles.h"
#include "tests/scene/inputs.h"

namespace bracket::scene {
namespace {

using namespace test;

/// A unit square of n × n cells, turned by 30 degrees, its coordinates with `digits` significant digits.
std::string turned_square(int n, int digits) {
  std::string nodes, elements;
  int count = 0;
  const auto node = [n](int i, int j) { return j * (n + 1) + i + 1; };
  const double c = std::cos(radians(30)), s = std::sin(radians(30));
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = static_cast<double>(i) / n, y = static_cast<double>(j) / n;
      nodes += fmt::format("{} {:.{}g} {:.{}g} 0\n", node(i, j), c * x - s * y, digits, s * x + c * y, digits);
    }
  for (int i = 0; i < n; ++i) elements += fmt::format("{} 1 2 1 1 {} {}\n", ++count, node(i, 0), node(i + 1, 0));
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int corner = node(i, j), opposite = node(i + 1, j + 1);
      elements += fmt::format("{} 2 2 2 1 {} {} {}\n", ++count, corner, node(i + 1, j), opposite);
      elements += fmt::format("{} 2 2 2 1 {} {} {}\n", ++count, corner, opposite, node(i, j + 1));
    }
  return fmt::format(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 1 \"foot\"\n2 2 \"block\"\n$EndPhysicalNames\n"
      "$Nodes\n{}\n{}$EndNodes\n$Elements\n{}\n{}$EndElements\n",
      (n + 1) * (n + 1), nodes, count, elements);
}

Problem<2> on_wall(const std::string& mesh) {
  const Folder folder;
  Scene<2> scene;
  scene.mesh_file = folder.write("block.msh", mesh);
  scene.bodies = {{"block", isotropic<2>(1, 0.3, Plane::strain)}};
  scene.contact = {{"foot", "rigid", std::nullopt, "here"}};
  return fix_data(scene, build_mesh(scene));
}

std::string told(const Problem<2>& problem, const std::string& words) {
  for (const std::string& note : problem.mesh.notes)
    if (note.find(words) != std::string::npos) return note;
  return "";
}

// cases/rounded_slope: six and seven digits are known for what they are, fewer are a polygon that is warned of; a line
// has one direction, to the last bit, or it locks.
TEST(Lines, OfFewDigitsAreStraightOrWarnedOf) {
  for (const int n : {8, 32})
    for (const int digits : {5, 6, 7, 17}) {
      SCOPED_TRACE(testing::Message() << n << " cells, " << digits << " digits");
      const Problem<2> problem = on_wall(turned_square(n, digits));
      std::set<std::pair<double, double>> directions;
      for (const ContactFacet& pair : problem.contact) {
        const Vector<2>& d = problem.facets[pair.first].normal;
        directions.insert({d[0], d[1]});
      }
      if (digits == 5) {
        EXPECT_GT(directions.size(), 1u);
        EXPECT_NE(told(problem, "'foot' slides or touches and turns"), "");
      } else {
        EXPECT_EQ(directions.size(), 1u);
        EXPECT_EQ(told(problem, "turns at its vertices"), "");
        EXPECT_EQ(told(problem, "taken for one line") != "", digits == 6 || (digits == 7 && n == 32));
      }
    }
}

// Where the digits would explain a turn that is meant, coordinates of more digits keep it.
TEST(Lines, ThatBendAreNotStraightened) {
  for (const double bend : {1e-4, 1e-2}) {
    const Folder folder;
    GmshContent content;
    content.names = "1 1 \"foot\"\n2 1 \"block\"\n";
    content.nodes = {{0, 0}, {1, 0}, {2, bend}, {0, 1}, {2, 1.0123456789012}};
    content.triangles = {{1, {0, 1, 3}}, {1, {1, 4, 3}}, {1, {1, 2, 4}}};
    content.lines = {{1, {0, 1}}, {1, {1, 2}}};
    Scene<2> scene;
    scene.mesh_file = folder.write("bent.msh", gmsh_2(content));
    scene.bodies = {{"block", isotropic<2>(1, 0.3, Plane::strain)}};
    scene.contact = {{"foot", "rigid", std::nullopt, "here"}};
    const Problem<2> problem = fix_data(scene, build_mesh(scene));
    ASSERT_EQ(problem.contact.size(), 2u);
    EXPECT_NE(problem.facets[problem.contact[0].first].normal, problem.facets[problem.contact[1].first].normal);
    EXPECT_NE(told(problem, "'foot' slides or touches and turns").find("(1, 0)"), std::string::npos);
  }
}

}  // namespace
}  // namespace bracket::scene
