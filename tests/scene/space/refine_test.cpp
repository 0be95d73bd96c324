// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "scene/mesh/space/tetrahedron.h"
#include "scene/mesh/topology.h"
#include "scene/problem/space/face.h"
#include "scene/toml/expression.h"
#include "tests/scene/space/boxes.h"

namespace bracket::scene {
namespace {

using namespace test;

/// Where a piece of a cell or facet of the first mesh lies.
template <std::size_t n, std::size_t d>
Vector<3> in_first(const std::array<Vector<3>, n>& x, const std::array<double, d>& at) {
  Vector<3> result = x[0];
  for (std::size_t i = 0; i < d; ++i) result += at[i] * (x[i + 1] - x[0]);
  return result;
}

double least_shape(const Mesh<3>& mesh) { return quality(mesh).smallest_shape; }

/// What holds of every refined problem: it is conforming, matched, and made of exact pieces of the first.
void expect_inherited(const Problem<3>& problem) {
  const Mesh<3>& mesh = problem.mesh;
  const Problem<3>& first = first_of(problem);
  std::vector<double> content(first.mesh.cells.size(), 0);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const Piece<3>& piece = problem.origin.cells[c];
    const auto whole = positions(first.mesh, first.mesh.cells[piece.of]);
    for (int k = 0; k < 4; ++k)
      ASSERT_LE((mesh.vertices[mesh.cells[c][k]] - in_first(whole, piece.corner[k])).norm(), 1e-13);
    content[piece.of] += volume(mesh, static_cast<int>(c));
    EXPECT_EQ(mesh.cell_body[c], first.mesh.cell_body[piece.of]);
  }
  for (std::size_t c = 0; c < content.size(); ++c) {
    const double exact = volume(first.mesh, static_cast<int>(c));
    EXPECT_NEAR(content[c], exact, 1e-12 * exact);
  }
  std::vector<double> area(first.facets.size(), 0);  // a hanging node would add to the boundary
  ASSERT_EQ(mesh.boundary.size(), problem.facets.size());
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    const Piece<2>& piece = problem.origin.facets[f];
    const auto whole = positions(first.mesh, first.mesh.boundary[piece.of].vertices);
    for (int k = 0; k < 3; ++k)
      ASSERT_LE((mesh.vertices[mesh.boundary[f].vertices[k]] - in_first(whole, piece.corner[k])).norm(), 1e-13);
    EXPECT_NEAR(share_of_face(piece.corner) * length(first.mesh, piece.of), length(mesh, static_cast<int>(f)), 1e-13);
    area[piece.of] += share_of_face(piece.corner);
    EXPECT_EQ(mesh.boundary[f].part, first.mesh.boundary[piece.of].part);
    EXPECT_EQ(problem.facets[f].normal, first.facets[piece.of].normal);
    EXPECT_EQ(problem.facets[f].support, first.facets[piece.of].support);
  }
  for (const double share : area) EXPECT_EQ(share, 1);
  std::vector<char> in_contact(mesh.boundary.size(), 0);
  for (const ContactFacetOf<3>& pair : problem.contact) {
    in_contact[pair.first] = 1;
    if (pair.second < 0) continue;
    in_contact[pair.second] = 1;
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(mesh.vertices[mesh.boundary[pair.first].vertices[i]],
                mesh.vertices[mesh.boundary[pair.second].vertices[pair.meets[i]]]);
  }
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
    EXPECT_EQ(in_contact[f] != 0, problem.facets[f].support == Support::contact);
}

Scene<3> loaded(int cells) {
  Scene<3> scene = unit_boxes(cells);
  scene.boundary["upper.top"] = {ConditionKind::traction,
                                 {parse_expression<3>("x", ""), parse_expression<3>("z - 1", ""), 2.0}};
  scene.boundary["upper.left"] = {ConditionKind::pressure, {0.1}};
  scene.boundary["lower.bottom"] = {ConditionKind::fixed, {parse_expression<3>("x/3 - z/7", ""), 0.1, 0.0}};
  scene.boundary["lower.left"] = {ConditionKind::fixed,
                                  {parse_expression<3>("-z/7", ""), parse_expression<3>("y/3 + 0.1", ""), 0.0}};
  scene.contact[0].gap = parse_expression<3>("0.01*(x^2 + x*z)", "");
  return scene;
}

/// What bisection of cells at a time leaves, whatever cells they are.
struct Closure {
  double marks = 0, made = 0;
  double least_shape = 1;  ///< by the least of the first mesh
};

/// Refines `levels` times, marking what `choose` says of a cell's centre and the level; expects what is known of AMP.
template <class Choose> Closure refined_again(Problem<3> problem, int levels, const Choose& choose) {
  const Mesh<3> first = problem.mesh;
  Closure closure;
  std::vector<double> known;  // of each first cell, the least shape below
  for (int level = 0; level < levels; ++level) {
    std::vector<char> marked(problem.mesh.cells.size(), 0);
    int finest = -1;
    for (std::size_t c = 0; c < marked.size(); ++c) {
      marked[c] = choose(centre(problem.mesh, static_cast<int>(c)), level);
      closure.marks += marked[c];
      if (marked[c]) finest = std::max(finest, generation(problem, c));
    }
    const Refined<3> refined = refine(problem, marked);
    std::vector<int> pieces(marked.size(), 0);
    for (const int parent : refined.cell_parent) ++pieces[parent];
    for (std::size_t c = 0; c < marked.size(); ++c) EXPECT_LT(marked[c], pieces[c]);
    EXPECT_TRUE(std::ranges::is_sorted(refined.cell_parent));
    for (std::size_t i = 0; i < refined.problem.contact.size(); ++i) {
      const auto& child = refined.problem.contact[i];
      const auto& parent = problem.contact[refined.contact_parent[i]];
      EXPECT_EQ(child.pair, parent.pair);
      EXPECT_EQ(refined.cell_parent[refined.problem.mesh.boundary[child.first].cell],
                problem.mesh.boundary[parent.first].cell);
    }
    // All cells bisected 3 k times conform, so that no closure goes beyond.
    for (std::size_t c = 0; c < refined.cell_parent.size(); ++c) {
      if (pieces[refined.cell_parent[c]] > 1) {
        EXPECT_LE(generation(refined.problem, c), 3 * (finest / 3 + 1));
      }
    }
    closure.made += static_cast<double>(refined.problem.mesh.cells.size() - problem.mesh.cells.size());
    problem = refined.problem;
    expect_inherited(problem);
  }
  closure.least_shape = least_shape(problem.mesh) / least_shape(first);
  return closure;
}

TEST(RefineInSpace, KeepsShapesContactAndData) {
  Random random(17);
  for (int round = 0; round < 8; ++round) {
    const double moved = std::array{0.0, 0.05, 0.1, 0.1}[round / 2];  // cells are ½ long
    Mesh<3> mesh = shaken(build_mesh(unit_boxes(2)), random, moved);
    const bool turned = round >= 4;
    const Eigen::Matrix3d rotation = turned ? random_rotation(random) : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    const Vector<3> by = turned ? Vector<3>(1, 2, 3) : Vector<3>(0, 0, 0);
    Scene<3> scene = loaded(2);
    if (turned) {  // what is written in x, y, z belongs to the mesh as it lies
      scene.boundary["lower.left"] = scene.boundary["lower.bottom"];
      mesh = turned_about(mesh, rotation, by);
    }
    const Problem<3> problem = fix_data(scene, mesh);
    // How many cells are made has no bound but by generations (docs/theory.md §12.5): 6.8 of a mark here, where marks
    // are single cells, of which 3.9 have an edge that is cut anyhow.
    const Closure scattered =
        refined_again(problem, 9, [&](const Vector<3>&, int) { return uniform(random, 0, 1) < 0.1; });
    EXPECT_GE(scattered.least_shape, 0.5) << round;
    const Vector<3> near = rotation * Vector<3>(0.7, 1, 0.3) + by;
    const Closure towards = refined_again(problem, 9, [&](const Vector<3>& centre, int level) {
      return (centre - near).norm() < 0.8 * std::pow(0.75, level);
    });
    EXPECT_GE(towards.least_shape, 0.5) << round;
    EXPECT_LE(towards.made, 6 * towards.marks) << round;
    RecordProperty("made_per_mark", std::to_string(scattered.made / scattered.marks));
  }
}

TEST(RefineInSpace, InheritsDataToRounding) {
  const Scene<3> scene = loaded(2);
  Random random(23);
  Problem<3> problem = fix_data(scene, build_mesh(scene));
  std::vector<Vector<3>> resultants;
  for (int level = 0; level < 6; ++level) {
    Vector<3> sum = Vector<3>::Zero();
    std::map<int, Vector<3>> fixed;  // of vertices
    for (std::size_t f = 0; f < problem.facets.size(); ++f) {
      const FacetData<3>& data = problem.facets[f];
      for (int i = 0; i < 3; ++i) {
        const int vertex = problem.mesh.boundary[f].vertices[i];
        const Vector<3>& x = problem.mesh.vertices[vertex];
        if (is_loaded(data)) sum += load(problem, static_cast<int>(f))[i] / 3;
        if (data.support == Support::fixed) {
          EXPECT_EQ(data.displacement[i], fixed.try_emplace(vertex, data.displacement[i]).first->second);
        }
        if (data.support == Support::traction && !data.traction[i].isZero(0)) {
          EXPECT_LE((data.traction[i] - Vector<3>(x[0], x[2] - 1, 2)).norm(), 1e-15);
        }
      }
    }
    resultants.push_back(sum);
    for (const ContactFacetOf<3>& pair : problem.contact) {
      const auto x = positions(problem.mesh, problem.mesh.boundary[pair.first].vertices);
      for (int i = 0; i < 6; ++i) {
        // the blossom of 0.01 (x² + x z)
        const auto& [a, b] = i < 3 ? std::array{i, i} : Simplex<2>::edges[i - 3];
        const double expected = 0.01 * (x[a][0] * x[b][0] + 0.5 * (x[a][0] * x[b][2] + x[b][0] * x[a][2]));
        EXPECT_LE(pair.lower[i], expected + 4e-18);
        EXPECT_GE(pair.upper[i], expected - 4e-18);
        EXPECT_NEAR(pair.lower[i], pair.upper[i], 1e-17);
      }
    }
    std::vector<char> marked(problem.mesh.cells.size());
    for (char& mark : marked) mark = uniform(random, 0, 1) < 0.3;
    problem = refine(problem, marked).problem;
  }
  for (const Vector<3>& sum : resultants) EXPECT_LE((sum - resultants[0]).norm(), 1e-14);
}

TEST(RefineInSpace, EndsWhereCoordinatesDo) {
  Scene<3> scene = unit_boxes(1);
  Mesh<3> mesh = build_mesh(scene);
  for (Vector<3>& x : mesh.vertices) x += Vector<3>(1e11, 1e11, 1e11);
  Problem<3> problem = fix_data(scene, mesh);
  expect_error(
      [&] {
        for (int level = 0; level < 90; ++level) {
          std::vector<char> marked(problem.mesh.cells.size(), 0);
          marked[0] = 1;
          problem = refine(problem, marked).problem;
        }
      },
      Status::budget, {"cannot be refined any further"});
}

}  // namespace
}  // namespace bracket::scene
