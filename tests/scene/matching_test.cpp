// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tests/scene/inputs.h"

namespace bracket::scene {
namespace {

using namespace test;

/// A disc of n sectors in a ring of n sectors, in contact along the polygon of radius 1; the ring's inner nodes are off
/// by `offset` radially and begin `shift` nodes later, so that neither order nor orientation match by chance.
Scene<2> disc_in_ring(const Folder& folder, int n, double offset, int shift) {
  GmshContent content;
  content.names = "1 1 \"disc\"\n1 2 \"hole\"\n1 3 \"rim\"\n2 1 \"inside\"\n2 2 \"outside\"\n";
  const auto node = [&](double radius, int i) {
    const double angle = 2 * std::numbers::pi * (i % n) / n;
    content.nodes.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  };
  node(0, 0);
  for (int i = 0; i < n; ++i) node(1, i);
  for (int i = 0; i < n; ++i) node(1 + offset, i + shift);
  for (int i = 0; i < n; ++i) node(2, i + shift);
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    const int inner = 1 + n, outer = 1 + 2 * n;
    content.triangles.push_back({1, {0, 1 + i, 1 + next}});
    content.triangles.push_back({2, {inner + i, outer + i, outer + next}});
    content.triangles.push_back({2, {inner + i, outer + next, inner + next}});
    content.lines.push_back({1, {1 + i, 1 + next}});
    content.lines.push_back({2, {inner + next, inner + i}});
    content.lines.push_back({3, {outer + i, outer + next}});
  }
  Scene<2> scene;
  scene.mesh_file = folder.write("disc.msh", gmsh_2(content));
  scene.bodies = {{"inside", isotropic<2>(1, 0, Plane::strain)}, {"outside", isotropic<2>(1, 0, Plane::strain)}};
  scene.contact = {{"hole", "disc", constant(0), "here"}};
  return scene;
}

/// What the contract says of contact facets.
void expect_matched(const Problem<2>& problem) {
  for (const ContactFacet& pair : problem.contact) {
    const auto& first = problem.mesh.boundary[pair.first].vertices;
    const auto& second = problem.mesh.boundary[pair.second].vertices;
    EXPECT_EQ(problem.mesh.vertices[first[0]], problem.mesh.vertices[second[1]]);
    EXPECT_EQ(problem.mesh.vertices[first[1]], problem.mesh.vertices[second[0]]);
    EXPECT_EQ(problem.facets[pair.first].normal, -problem.facets[pair.second].normal);
  }
}

TEST(Matching, FindsTheSidesOfAPolygonInAnyOrder) {
  const Folder folder;
  for (const int n : {3, 7, 64}) {
    for (const double offset : {0.0, 1e-11, -1e-10, 7e-8}) {
      const Scene<2> scene = disc_in_ring(folder, n, offset, n / 2);
      const Mesh<2> before = build_mesh(scene);
      const Problem<2> problem = fix_data(scene, before);
      ASSERT_EQ(problem.contact.size(), static_cast<std::size_t>(n));
      expect_matched(problem);
      const auto moved = [](const std::string& note) { return note.find("moved by up to") != std::string::npos; };
      EXPECT_EQ(std::ranges::count_if(problem.mesh.notes, moved), offset == 0 ? 0 : 1);
      const auto turns = [](const std::string& note) { return note.find("'hole' slides or touches and turns") == 0; };
      EXPECT_EQ(std::ranges::count_if(problem.mesh.notes, turns), n == 64 ? 1 : 0);  // not a corner of 20 degrees
      for (const ContactFacet& pair : problem.contact) {  // the first side stays where it was
        for (const int vertex : problem.mesh.boundary[pair.first].vertices) {
          EXPECT_EQ(problem.mesh.vertices[vertex], before.vertices[vertex]);
        }
      }
    }
  }
}

TEST(Matching, StandsGradedMeshes) {
  // Edges of length 2^-k on both sides of y = 0, down to a millionth of the first.
  const Folder folder;
  GmshContent content;
  content.names = "1 1 \"up\"\n1 2 \"down\"\n2 1 \"lower\"\n2 2 \"upper\"\n";
  const int n = 20;
  for (const double apex : {-1.0, 1.0}) {
    const int first = static_cast<int>(content.nodes.size());
    for (int k = 0; k <= n; ++k) content.nodes.push_back({std::exp2(-k), 0});
    content.nodes.push_back({0, apex});
    const int group = apex < 0 ? 1 : 2;
    for (int k = 0; k < n; ++k) {
      content.triangles.push_back({group, {first + k, first + k + 1, first + n + 1}});
      content.lines.push_back({group, {first + k, first + k + 1}});
    }
  }
  Scene<2> scene;
  scene.mesh_file = folder.write("graded.msh", gmsh_4(content));
  scene.bodies = {{"lower", isotropic<2>(1, 0, Plane::strain)}, {"upper", isotropic<2>(1, 0, Plane::strain)}};
  scene.contact = {{"up", "down", constant(0), "here"}};
  const Problem<2> problem = fix_data(scene, build_mesh(scene));
  EXPECT_EQ(problem.contact.size(), static_cast<std::size_t>(n));
  expect_matched(problem);
}

// Four blocks meet in one point, each in contact with two others: all four vertices there get the same coordinates.
TEST(Matching, AVertexMayBeInSeveralPairs) {
  Scene<2> scene;
  const double off = 3e-10;
  scene.blocks = {{"sw", {{{0, 1}, {0, 1}}}, {2, 2}, ""},
                  {"se", {{{1 + off, 2}, {0, 1 + off}}}, {2, 2}, ""},
                  {"ne", {{{1 - off, 2}, {1 - off, 2}}}, {2, 2}, ""},
                  {"nw", {{{0, 1 + 2 * off}, {1 + 2 * off, 2}}}, {2, 2}, ""}};
  for (const char* body : {"sw", "se", "ne", "nw"}) scene.bodies.emplace(body, isotropic<2>(1, 0, Plane::strain));
  scene.contact = {{"sw.right", "se.left", constant(0), ""},
                   {"ne.bottom", "se.top", constant(0), ""},
                   {"nw.right", "ne.left", constant(0), ""},
                   {"nw.bottom", "sw.top", constant(0), ""}};
  const Problem<2> problem = fix_data(scene, build_mesh(scene));
  EXPECT_EQ(problem.contact.size(), 8u);
  expect_matched(problem);
  std::vector<Vector<2>> middle;
  for (const Vector<2>& vertex : problem.mesh.vertices) {
    if ((vertex - Vector<2>(1, 1)).norm() < 1e-3) middle.push_back(vertex);
  }
  ASSERT_EQ(middle.size(), 4u);
  for (const Vector<2>& vertex : middle) EXPECT_EQ(vertex, middle[0]);
}

TEST(Matching, ARigidWallTakesAllFacetsOfItsPart) {
  Scene<2> scene = stacked(3, {});
  scene.contact = {{"a.bottom", "rigid", constant(0.5), ""}};
  const Problem<2> problem = fix_data(scene, build_mesh(scene));
  ASSERT_EQ(problem.contact.size(), 3u);
  for (const ContactFacet& facet : problem.contact) {
    EXPECT_EQ(facet.second, -1);
    EXPECT_EQ(facet.lower, (std::array{0.5, 0.5, 0.5}));
    EXPECT_EQ(problem.facets[facet.first].support, Support::contact);
    EXPECT_EQ(problem.facets[facet.first].normal, Vector<2>(0, -1));
  }
}

void expect_unmatched(const Scene<2>& scene, const std::vector<std::string>& named) {
  const auto error = error_of([&] { fix_data(scene, build_mesh(scene)); });
  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->status(), Status::mesh);
  const std::string line = error->what();
  EXPECT_EQ(line.find("here: "), 0u) << line;
  for (const std::string& part : named) EXPECT_NE(line.find(part), std::string::npos) << line;
}

TEST(Matching, SidesThatDoNotFaceEachOtherAreRefused) {
  Scene<2> scene = stacked(4, {});
  scene.contact[0].where = "here";
  Scene<2> other = scene;
  other.contact[0].second = "b.top";
  expect_unmatched(other, {"'a.top'", "'b.top'", "1 apart"});
  other = scene;
  other.blocks[1].range[1] = {0, 1};  // on top of each other: the sides coincide but run the same way
  other.contact[0].second = "b.top";
  expect_unmatched(other, {"0 apart"});
  other = scene;
  other.blocks[1].range[0] = {3, 4};  // beside each other
  expect_unmatched(other, {"2 apart", "(1, 1)"});
  other = scene;
  other.contact[0].second = "a.top";  // no crack: it has no faces
  expect_unmatched(other, {"'a.top'"});
  other = scene;
  other.contact.push_back({"a.left", "b.bottom", constant(0), "here"});
  expect_unmatched(other, {"'a.left'", "'b.bottom'"});
}

// A facet has one counterpart: two bodies in one place cannot share the other side.
TEST(Matching, NoFacetIsMatchedTwice) {
  const Folder folder;
  GmshContent content = two_squares();
  for (int i = 0; i < 4; ++i) content.nodes.push_back(content.nodes[i]);
  content.triangles.push_back({3, {8, 9, 10}});
  content.triangles.push_back({3, {8, 10, 11}});
  content.lines.push_back({6, {10, 11}});
  Scene<2> scene;
  scene.mesh_file = folder.write("a.msh", gmsh_2(content));
  for (const char* body : {"lower", "upper", "3"}) scene.bodies.emplace(body, isotropic<2>(1, 0, Plane::strain));
  scene.contact = {{"joint below", "joint above", constant(0), "here"}};
  const Problem<2> problem = fix_data(scene, build_mesh(scene));
  EXPECT_EQ(problem.contact.size(), 1u);
  expect_note(problem.mesh, "1 of 2 edges of 'joint below'");
  expect_note(problem.mesh, "'lower' and '3' have 4 nodes at the same places");
}

}  // namespace
}  // namespace bracket::scene
