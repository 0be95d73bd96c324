// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "scene/mesh/topology.h"
#include "tests/scene/space/boxes.h"

namespace bracket::scene {
namespace {

using namespace test;

Mesh<3> two_boxes() {
  Scene<3> scene;
  scene.blocks = {{"a", {{{0, 3}, {-1, 1}, {2, 2.5}}}, {3, 2, 1}, ""},
                  {"b", {{{10, 10.7}, {0, 0.1}, {0, 1}}}, {2, 1, 3}, ""}};
  return build_mesh(scene);
}

/// What holds for every mesh, whatever it came from.
void expect_sound_in_space(const Mesh<3>& mesh) {
  ASSERT_EQ(mesh.cell_edges.size(), mesh.cells.size());
  ASSERT_EQ(mesh.facet_numbers.size(), mesh.cells.size());
  EXPECT_TRUE(std::is_sorted(mesh.edges.begin(), mesh.edges.end()));
  std::vector<std::vector<std::array<int, 3>>> at_facet(n_facets(mesh));
  std::vector<double> content(mesh.components.size(), 0);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int cell = static_cast<int>(c);
    EXPECT_GT(volume(mesh, cell), 0);
    content[mesh.cell_component[c]] += volume(mesh, cell);
    for (int e = 0; e < 6; ++e) {
      const auto& [i, k] = Simplex<3>::edges[e];
      const auto [lower, upper] = std::minmax(mesh.cells[c][i], mesh.cells[c][k]);
      EXPECT_EQ(mesh.edges[mesh.cell_edges[c][e]], (std::array{lower, upper}));
    }
    for (int k = 0; k < 4; ++k) at_facet[cell_facets(mesh, cell)[k]].push_back(facet_vertices(mesh, cell, k));
  }
  std::size_t on_boundary = 0;
  for (const auto& seen : at_facet) {
    ASSERT_TRUE(seen.size() == 1 || seen.size() == 2);
    on_boundary += seen.size() == 1;
    EXPECT_TRUE(std::is_permutation(seen.front().begin(), seen.front().end(), seen.back().begin()));
  }
  EXPECT_EQ(on_boundary, mesh.boundary.size());
  std::vector<Vector<3>> closed(mesh.components.size(), Vector<3>::Zero());
  std::vector<double> flux(mesh.components.size(), 0);  // ∫ x·n = 3 |Ω|: fails if normals point inwards
  std::array<int, 3> last = {-1, -1, -1};
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    const auto& facet = mesh.boundary[f];
    EXPECT_EQ(facet.edge, -1);
    EXPECT_EQ(facet.vertices, facet_vertices(mesh, facet.cell, facet.local));
    std::array<int, 3> sorted = facet.vertices;
    std::ranges::sort(sorted);
    EXPECT_LT(last, sorted);
    last = sorted;
    const auto edges = facet_edges(mesh, facet);
    for (int e = 0; e < 3; ++e) {
      const auto& [i, k] = Simplex<2>::edges[e];
      const auto [lower, upper] = std::minmax(facet.vertices[i], facet.vertices[k]);
      EXPECT_EQ(mesh.edges[edges[e]], (std::array{lower, upper}));
    }
    const int of = mesh.cell_component[facet.cell];
    const Vector<3> outward = normal(mesh, static_cast<int>(f)) * length(mesh, static_cast<int>(f));
    closed[of] += outward;
    flux[of] += mesh.vertices[facet.vertices[0]].dot(outward);
  }
  for (std::size_t of = 0; of < closed.size(); ++of) {
    EXPECT_LE(closed[of].norm(), 1e-12);
    EXPECT_NEAR(flux[of], 3 * content[of], 1e-11);
  }
}

std::ptrdiff_t euler(const Mesh<3>& mesh) {
  const auto count = [](const auto& list) { return static_cast<std::ptrdiff_t>(list.size()); };
  return count(mesh.vertices) - count(mesh.edges) + mesh.facet_count - count(mesh.cells);
}

TEST(Boxes, AreSoundAndFillTheirCuboids) {
  const Mesh<3> mesh = two_boxes();
  expect_sound_in_space(mesh);
  EXPECT_EQ(euler(mesh), 2);  // 1 for each ball
  EXPECT_EQ(mesh.cells.size(), 6u * (3 * 2 * 1 + 2 * 1 * 3));
  double content = 0;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) content += volume(mesh, static_cast<int>(cell));
  EXPECT_NEAR(content, 3 + 0.07, 1e-14);
}

TEST(Boxes, NameTheirSidesAndTheFrontIsWhereZIsLarger) {
  const Mesh<3> mesh = two_boxes();
  ASSERT_EQ(mesh.parts.size(), 12u);
  const std::map<std::string, Vector<3>> outward = {{"left", {-1, 0, 0}}, {"right", {1, 0, 0}}, {"bottom", {0, -1, 0}},
                                                    {"top", {0, 1, 0}},   {"back", {0, 0, -1}}, {"front", {0, 0, 1}}};
  std::map<std::string, double> total;
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
    const auto& facet = mesh.boundary[i];
    ASSERT_NE(facet.part, -1);
    const std::string& part = mesh.parts[facet.part];
    EXPECT_EQ(part.substr(0, 2), mesh.bodies[mesh.cell_body[facet.cell]] + ".");
    EXPECT_EQ(normal(mesh, static_cast<int>(i)), outward.at(part.substr(2))) << part;
    total[part] += length(mesh, static_cast<int>(i));
  }
  EXPECT_NEAR(total["a.left"], 1, 1e-14);
  EXPECT_NEAR(total["a.top"], 1.5, 1e-14);
  EXPECT_NEAR(total["a.front"], 6, 1e-14);
  EXPECT_NEAR(total["b.back"], 0.07, 1e-14);
}

// A plane mesh extruded: the front has the triangles of the plane.
TEST(Boxes, AreCutAsThePlaneIs) {
  Scene<2> flat;
  flat.blocks = {{"a", {{{0, 3}, {0, 2}}}, {3, 4}, ""}};
  Scene<3> scene;
  scene.blocks = {{"a", {{{0, 3}, {0, 2}, {0, 1}}}, {3, 4, 2}, ""}};
  const auto edges_of = [](const auto& mesh, double z) {
    std::set<std::array<double, 4>> edges;
    for (const auto& [a, b] : mesh.edges) {
      const auto &x = mesh.vertices[a], &y = mesh.vertices[b];
      if (x.size() < 3 || (x[x.size() - 1] == z && y[y.size() - 1] == z)) edges.insert({x[0], x[1], y[0], y[1]});
    }
    return edges;
  };
  const auto expected = edges_of(build_mesh(flat), 0);
  const Mesh<3> mesh = build_mesh(scene);
  EXPECT_EQ(edges_of(mesh, 0), expected);
  EXPECT_EQ(edges_of(mesh, 0.5), expected);
  EXPECT_EQ(edges_of(mesh, 1), expected);
}

TEST(Boxes, OfOneBodyAreOnePiece) {
  Scene<3> scene;
  scene.blocks = {{"l", {{{0, 1}, {0, 1}, {0, 1}}}, {2, 2, 1}, ""},
                  {"l", {{{1, 3}, {0, 1}, {0, 1}}}, {3, 2, 1}, "", "foot"},
                  {"l", {{{0, 1}, {1, 2.5}, {0, 1}}}, {2, 3, 1}, ""}};
  const Mesh<3> mesh = build_mesh(scene);
  expect_sound_in_space(mesh);
  EXPECT_EQ(euler(mesh), 1);
  EXPECT_EQ(mesh.components.size(), 1u);
  std::map<std::string, double> areas;
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
    areas[mesh.parts.at(mesh.boundary[f].part)] += length(mesh, static_cast<int>(f));
  EXPECT_NEAR(areas.at("l.left"), 2.5, 1e-14);
  EXPECT_NEAR(areas.at("l.right"), 1.5, 1e-14);
  EXPECT_NEAR(areas.at("l.foot.top"), 2, 1e-14);
  EXPECT_NEAR(areas.at("l.front"), 2.5, 1e-14);

  scene.blocks[2].cells[2] = 2;  // not cut alike
  expect_error([&] { build_mesh(scene); }, Status::input, {"'l'", "whole side"});
}

TEST(Boxes, ThatShareAnEdgeOrACornerAloneAreRefused) {
  Scene<3> scene;
  scene.blocks = {{"b", {{{0, 1}, {0, 1}, {0, 1}}}, {1, 1, 1}, ""}, {"b", {{{1, 2}, {1, 2}, {0, 1}}}, {1, 1, 1}, ""}};
  expect_error([&] { build_mesh(scene); }, Status::mesh, {"falls into pieces"});
  // with a bridge they are one piece, which hangs by an edge beside it
  scene.blocks.push_back({"b", {{{0, 1}, {0, 1}, {1, 2}}}, {1, 1, 1}, ""});
  scene.blocks.push_back({"b", {{{1, 2}, {1, 2}, {1, 2}}}, {1, 1, 1}, ""});
  scene.blocks.push_back({"b", {{{0, 1}, {1, 2}, {1, 2}}}, {1, 1, 1}, ""});
  expect_error([&] { build_mesh(scene); }, Status::mesh, {"'b'", "by an edge only", "(1, 1, 0)", "(1, 1, 1)"});
}

Mesh<3> tetrahedra(std::vector<Vector<3>> vertices, std::vector<std::array<int, 4>> cells) {
  Mesh<3> mesh;
  mesh.vertices = std::move(vertices);
  mesh.cells = std::move(cells);
  mesh.cell_body.assign(mesh.cells.size(), 0);
  mesh.bodies = {"a"};
  return with_topology(std::move(mesh), {}, "here");
}

const std::vector<Vector<3>> unit_corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {-1, -1, -1}};

TEST(TopologyInSpace, TurnsWhatIsInsideOutAndSaysSo) {
  const Mesh<3> mesh = tetrahedra(unit_corners, {{0, 1, 2, 3}, {1, 2, 4, 3}, {0, 1, 2, 5}, {0, 2, 3, 5}});
  expect_sound_in_space(mesh);
  ASSERT_EQ(mesh.notes.size(), 1u);
  EXPECT_NE(mesh.notes[0].find("inside out turned"), std::string::npos) << mesh.notes[0];
}

TEST(TopologyInSpace, RefusesWhatIsNoMesh) {
  expect_error(
      [] {
        tetrahedra({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2, 3}});
      },
      Status::mesh, {"here", "degenerate"});
  expect_error([] { tetrahedra(unit_corners, {{0, 1, 2, 3}, {1, 2, 3, 0}}); }, Status::mesh, {"duplicate cells"});
  expect_error(
      [] {
        tetrahedra({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}}, {{0, 1, 2, 3}, {0, 1, 2, 4}});
      },
      Status::mesh, {"cells overlap", "(0, 1, 0)"});
  expect_error(
      [] {
        tetrahedra({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, -1}},
                   {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}});
      },
      Status::mesh, {"more than two cells meet"});
}

// Two tetrahedra that have a vertex in common, and a ring of others that leads from one to the other.
TEST(TopologyInSpace, RefusesBodiesThatHangByAPoint) {
  Scene<3> scene;
  scene.blocks = {{"b", {{{0, 1}, {0, 1}, {0, 1}}}, {1, 1, 1}, ""},  {"b", {{{1, 2}, {1, 2}, {1, 2}}}, {1, 1, 1}, ""},
                  {"b", {{{0, 1}, {0, 1}, {-1, 0}}}, {1, 1, 1}, ""}, {"b", {{{1, 2}, {0, 1}, {-1, 0}}}, {1, 1, 1}, ""},
                  {"b", {{{2, 3}, {0, 1}, {-1, 0}}}, {1, 1, 1}, ""}, {"b", {{{2, 3}, {1, 2}, {-1, 0}}}, {1, 1, 1}, ""},
                  {"b", {{{2, 3}, {1, 2}, {0, 1}}}, {1, 1, 1}, ""},  {"b", {{{2, 3}, {1, 2}, {1, 2}}}, {1, 1, 1}, ""}};
  expect_error([&] { build_mesh(scene); }, Status::mesh, {"'b'", "by a point only at (1, 1, 1)"});
}

TEST(QualityInSpace, OfARegularTetrahedron) {
  const Mesh<3> mesh = tetrahedra({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2, 3}});
  const Quality measured = quality(mesh);
  EXPECT_NEAR(measured.smallest_angle, std::acos(1 / 3.0) * 180 / std::numbers::pi, 1e-12);
  EXPECT_NEAR(measured.largest_angle, measured.smallest_angle, 1e-12);
  EXPECT_NEAR(measured.smallest_shape, 1, 1e-15);
  EXPECT_NEAR(measured.largest_area, 8 / 3.0, 1e-15);
  const Quality boxes = quality(two_boxes());
  EXPECT_GT(boxes.smallest_angle, 0);
  EXPECT_NEAR(quality(build_mesh(unit_boxes(1))).smallest_angle, 45, 1e-12);
  EXPECT_NEAR(quality(build_mesh(unit_boxes(1))).largest_angle, 90, 1e-12);
}

TEST(BondsInSpace, MakeOnePiece) {
  Scene<3> scene = unit_boxes(2);
  scene.contact.clear();
  scene.bonds = {{"upper.bottom", "lower.top", "here"}};
  const Mesh<3> mesh = build_mesh(scene);
  expect_sound_in_space(mesh);
  EXPECT_EQ(mesh.components, (std::vector<std::string>{"lower + upper"}));
  EXPECT_EQ(euler(mesh), 1);
  scene.blocks[1].cells[0] = 3;
  expect_error([&] { build_mesh(scene); }, Status::mesh, {"here", "coincide node by node", "has no partner"});
}

TEST(GivenInSpace, IsAsTheBlocksAre) {
  const Mesh<3> blocks = build_mesh(unit_boxes(2));
  const Mesh<3> mesh = build_mesh(given(blocks));
  expect_sound_in_space(mesh);
  EXPECT_EQ(mesh.cells.size(), blocks.cells.size());
  EXPECT_EQ(mesh.edges, blocks.edges);
  ASSERT_EQ(mesh.boundary.size(), blocks.boundary.size());
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
    EXPECT_EQ(mesh.parts[mesh.boundary[f].part], blocks.parts[blocks.boundary[f].part]);
  Scene<3> bad = given(blocks);
  bad.given->cells[3][2] = 4711;
  expect_error([&] { build_mesh(bad); }, Status::mesh, {"the cell 3", "4711"});
}

// Of boxes a : a : 1 cut in six √(2 a² + 1) √(a² + 1) / (a √2), by the largest face's height.
TEST(Boxes, AreAsFlatAsTheirSides) {
  for (const double ratio : {1.0, 5.0, 50.0}) {
    Scene<3> scene;
    scene.blocks = {{"b", {{{0, 2 * ratio}, {0, ratio}, {0, 3}}}, {2, 1, 3}, ""}};
    scene.bodies = {{"b", isotropic<3>(1, 0.3, Plane::strain)}};
    const Mesh<3> mesh = build_mesh(scene);
    const double square = ratio * ratio;
    for (const double one : flatness(mesh))
      EXPECT_NEAR(one, std::sqrt((2 * square + 1) * (square + 1) / (2 * square)), 1e-10 * ratio);
    EXPECT_EQ(mesh.notes.size(), ratio >= 5 ? 1u : 0u);
  }
}

}  // namespace
}  // namespace bracket::scene
