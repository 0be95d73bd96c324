// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "scene/mesh/angles.h"
#include "tests/scene/inputs.h"

namespace bracket::scene {
namespace {

using namespace test;

/// A block on one or two others, apart by `gap`, of which the sides are cut in different numbers of edges.
struct Blocks {
  std::array<double, 2> above = {0, 1};
  int edges_above = 4, edges_below = 6;
  double gap = 0;
};
Scene<2> blocks(const Blocks& of) {
  Scene<2> scene;
  const int rows_above = std::max(1, of.edges_above / 2), rows_below = std::max(1, of.edges_below / 2);
  scene.blocks = {{"lower", {{{0, 1}, {-0.5, 0}}}, {of.edges_below, rows_below}, ""},
                  {"upper", {{of.above, {of.gap, of.gap + 0.5}}}, {of.edges_above, rows_above}, ""}};
  for (const char* body : {"lower", "upper"}) scene.bodies.emplace(body, isotropic<2>(1, 0, Plane::strain));
  scene.contact = {{"upper.bottom", "lower.top", std::nullopt, "here"}};
  return scene;
}

Mesh<2> turned(Mesh<2> mesh, double angle, const Vector<2>& shift) {
  for (Vector<2>& x : mesh.vertices) x = Eigen::Rotation2Dd(angle) * x + shift;
  return mesh;
}

std::vector<double> areas(const Mesh<2>& mesh) {
  std::vector<double> result(mesh.bodies.size(), 0);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) result[mesh.cell_body[c]] += volume(mesh, static_cast<int>(c));
  return result;
}

/// The ends of each pair face each other along d, at the distance that its gap says; all pairs together are as long as
/// the overlap; bodies are as large as before; angles are at least 10 degrees.
void expect_cut_alike(const Mesh<2>& before, const Problem<2>& problem, double overlap, double gap, double size) {
  const Mesh<2>& mesh = problem.mesh;
  double length_first = 0, length_second = 0;
  for (const ContactFacet& pair : problem.contact) {
    const auto one = positions(mesh, mesh.boundary[pair.first].vertices);
    const auto other = positions(mesh, mesh.boundary[pair.second].vertices);
    const Vector<2>& d = problem.facets[pair.first].normal;
    EXPECT_EQ(problem.facets[pair.second].normal, -d);
    for (int i = 0; i < 2; ++i) {
      const Vector<2> between = other[1 - i] - one[i];
      EXPECT_NEAR(cross(between, d), 0, 1e-13 * size);
      EXPECT_NEAR(between.dot(d), gap, 1e-13 * size);
      EXPECT_NEAR(problem.contact[0].lower[i], gap, 1e-13 * size);
    }
    length_first += length(mesh, pair.first);
    length_second += length(mesh, pair.second);
  }
  EXPECT_NEAR(length_first, overlap, 1e-13 * size);
  EXPECT_NEAR(length_second, overlap, 1e-13 * size);
  const auto was = areas(before), is = areas(mesh);
  for (std::size_t b = 0; b < was.size(); ++b) EXPECT_NEAR(is[b], was[b], 1e-13 * size);
  EXPECT_GE(quality(mesh).smallest_angle, 10);
}

TEST(CutAlike, SidesOfAnyNumbersOfEdges) {
  for (const auto& [above, below] : {std::pair(4, 6), {6, 4}, {3, 7}, {67, 4}, {4, 67}, {1, 1}, {31, 32}})
    for (const double gap : {0.0, 0.01, 30.0})
      for (const double angle : {0.0, 37.0}) {
        SCOPED_TRACE(testing::Message() << above << " on " << below << ", gap " << gap << ", turned " << angle);
        Scene<2> scene = blocks({{0, 1}, above, below, gap});
        const Mesh<2> mesh = turned(build_mesh(scene), radians(angle), {3, -2});
        expect_cut_alike(mesh, fix_data(scene, mesh), 1, gap, 40);
      }
}

// What hurts: ends that all but meet, so that facets must become small there, and sides that hardly overlap.
TEST(CutAlike, RandomOverhangs) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-0.9, 0.9), small(-5, -1);
  for (int trial = 0; trial < 60; ++trial) {
    const double left = trial % 3 == 0 ? std::pow(10, small(random)) : place(random);
    const double right = trial % 3 == 1 ? 1 - std::pow(10, small(random)) : left + 0.5 + std::abs(place(random));
    if (!(right > left + 0.1)) continue;
    const int above = 1 + static_cast<int>(random() % 9), below = 1 + static_cast<int>(random() % 9);
    const double overlap = std::min(right, 1.0) - std::max(left, 0.0);
    if (overlap <= 0) continue;
    SCOPED_TRACE(testing::Message() << trial << ": " << above << " on " << below << ", from " << left << " to "
                                    << right);
    // Squares, so that the angles are those of the cuts.
    Scene<2> scene = blocks({{left, right}, above, below, trial % 2 == 0 ? 0.0 : 0.1});
    const double above_height = std::max(1.0, std::round(0.5 / ((right - left) / above))) * (right - left) / above;
    scene.blocks[1].range[1][1] = scene.blocks[1].range[1][0] + above_height;
    scene.blocks[1].cells[1] = static_cast<int>(std::lround(above_height * above / (right - left)));
    scene.blocks[0].range[1][0] = -1;
    scene.blocks[0].cells[1] = below;
    const Mesh<2> mesh = turned(build_mesh(scene), trial, {0, 0});
    expect_cut_alike(mesh, fix_data(scene, mesh), overlap, trial % 2 == 0 ? 0.0 : 0.1, 4);
  }
}

TEST(CutAlike, SidesOfSeveralPartsAndSeveralPairsOnOnePart) {
  Scene<2> scene = blocks({});
  scene.blocks[1].range[0] = {0, 0.4};
  scene.blocks.push_back({"other", {{{0.4, 0.9}, {0, 0.3}}}, {5, 3}, ""});
  scene.bodies.emplace("other", isotropic<2>(1, 0, Plane::strain));
  Scene<2> pairs = scene;
  pairs.contact.push_back({"other.bottom", "lower.top", std::nullopt, "here"});
  scene.contact[0].first = std::vector<std::string>{"upper.bottom", "other.bottom"};
  const Problem<2> one = fix_data(scene, build_mesh(scene)), two = fix_data(pairs, build_mesh(pairs));
  ASSERT_EQ(one.contact.size(), two.contact.size());
  EXPECT_EQ(one.mesh.vertices, two.mesh.vertices);
  double length_of[2] = {0, 0};
  for (std::size_t j = 0; j < two.contact.size(); ++j) {
    EXPECT_EQ(one.contact[j].first, two.contact[j].first);
    EXPECT_EQ(one.contact[j].second, two.contact[j].second);
    length_of[two.contact[j].pair] += length(two.mesh, two.contact[j].first);
  }
  EXPECT_NEAR(length_of[0], 0.4, 1e-14);
  EXPECT_NEAR(length_of[1], 0.5, 1e-14);
}

// What matches is taken as it is, to the last bit, and without a word.
TEST(CutAlike, SidesThatMatchAreLeft) {
  const Scene<2> scene = blocks({{0, 1}, 6, 6, 0});
  const Mesh<2> mesh = build_mesh(scene);
  const Problem<2> problem = fix_data(scene, mesh);
  EXPECT_EQ(problem.mesh.vertices, mesh.vertices);
  EXPECT_EQ(problem.mesh.cells, mesh.cells);
  EXPECT_TRUE(problem.mesh.notes.empty());
}

// A polygon in another: vertices face each other along the bisectors, and every edge has its counterpart.
TEST(CutAlike, PolygonsAtADistance) {
  const Folder folder;
  const int n = 16;
  const auto ring = [&](double inside, double outside) {
    GmshContent content;
    content.names = "1 1 \"pin\"\n1 2 \"hole\"\n2 1 \"inner\"\n2 2 \"outer\"\n";
    for (const double radius : {inside, 0.95, 1.0, outside})
      for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        content.nodes.push_back({radius * std::cos(angle), radius * std::sin(angle)});
      }
    for (int i = 0; i < n; ++i) {
      const int next = (i + 1) % n;
      for (const int from : {0, 2 * n}) {
        content.triangles.push_back({from == 0 ? 1 : 2, {from + i, from + n + i, from + n + next}});
        content.triangles.push_back({from == 0 ? 1 : 2, {from + i, from + n + next, from + next}});
      }
      content.lines.push_back({1, {n + i, n + next}});
      content.lines.push_back({2, {2 * n + i, 2 * n + next}});
    }
    return content;
  };
  Scene<2> scene;
  scene.mesh_file = folder.write("rings.msh", gmsh_2(ring(0.6, 1.4)));
  for (const char* body : {"inner", "outer"}) scene.bodies.emplace(body, isotropic<2>(1, 0, Plane::strain));
  scene.contact = {{"pin", "hole", std::nullopt, "here"}};
  const Mesh<2> mesh = build_mesh(scene);
  const Problem<2> problem = fix_data(scene, mesh);
  ASSERT_EQ(problem.contact.size(), static_cast<std::size_t>(n));
  EXPECT_EQ(problem.mesh.cells.size(), mesh.cells.size());
  const double half_turn = std::numbers::pi / n;
  for (const ContactFacet& pair : problem.contact)  // the distance of the chords
    for (const double gap : pair.lower) EXPECT_NEAR(gap, 0.05 * std::cos(half_turn), 1e-14);
}

}  // namespace
}  // namespace bracket::scene
