// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/scene/inputs.h"
#include "tests/scene/refine_cases.h"

namespace bracket::scene {
namespace {

using namespace test;

/// The angles of a cell, ascending.
std::array<double, 3> angles(const Mesh<2>& mesh, int cell) {
  std::array<double, 3> result;
  for (int k = 0; k < 3; ++k) {
    const Vector<2>& x = mesh.vertices[mesh.cells[cell][k]];
    const Vector<2> a = mesh.vertices[mesh.cells[cell][(k + 1) % 3]] - x;
    const Vector<2> b = mesh.vertices[mesh.cells[cell][(k + 2) % 3]] - x;
    result[k] = std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b));
  }
  std::sort(result.begin(), result.end());
  return result;
}

// Newest-vertex bisection makes at most four shapes out of each coarse cell. If its longest edge is cut first, no
// angle falls below half of its smallest.
TEST(Refine, ShapesStayBounded) {
  std::mt19937 random(4);
  for (auto& [name, problem] : refine_cases()) {
    SCOPED_TRACE(name);
    const Mesh<2> coarse = problem.mesh;
    std::vector<int> ancestor(coarse.cells.size());
    std::iota(ancestor.begin(), ancestor.end(), 0);
    while (problem.mesh.cells.size() < 10000) {
      Refined<2> refined = refine(problem, some(problem.mesh, random, 10));
      for (int& cell : refined.cell_parent) cell = ancestor[cell];
      ancestor = std::move(refined.cell_parent);
      problem = std::move(refined.problem);
    }
    std::vector<std::vector<std::array<double, 3>>> shapes(coarse.cells.size());
    for (std::size_t i = 0; i < problem.mesh.cells.size(); ++i) {
      const std::array<double, 3> own = angles(problem.mesh, static_cast<int>(i));
      const auto same = [&](const std::array<double, 3>& shape) {
        return std::abs(shape[0] - own[0]) + std::abs(shape[2] - own[2]) < 1e-8;
      };
      auto& known = shapes[ancestor[i]];
      if (std::none_of(known.begin(), known.end(), same)) known.push_back(own);
      if (name == "any refinement edges") continue;
      EXPECT_GE(own[0], 0.5 * angles(coarse, ancestor[i])[0] - 1e-8);
    }
    for (const auto& known : shapes) EXPECT_LE(known.size(), 4u);
  }
}

TEST(Refine, CutsTheLongestEdgeFirst) {
  for (const auto& [name, problem] : refine_cases()) {
    if (name == "any refinement edges") continue;
    const Mesh<2>& mesh = problem.mesh;
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
      const auto edge_length = [&](int edge) {
        return (mesh.vertices[mesh.edges[edge][1]] - mesh.vertices[mesh.edges[edge][0]]).norm();
      };
      const int cut = mesh.cell_edges[cell][mesh.refinement_edge[cell]];
      for (const int edge : mesh.cell_edges[cell]) EXPECT_LE(edge_length(edge), edge_length(cut));
    }
  }
}

/// The last vertex of body 0: on contact sides, and a corner of all three blocks where there are three.
int contact_corner(const Mesh<2>& mesh) {
  int last = 0;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    if (mesh.cell_body[cell] == 0) last = std::max(last, std::ranges::max(mesh.cells[cell]));
  }
  return last;
}

std::vector<char> cells_at(const Mesh<2>& mesh, int vertex) {
  std::vector<char> marked;
  for (const auto& cell : mesh.cells) marked.push_back(std::ranges::find(cell, vertex) != cell.end());
  return marked;
}

// About a vertex that is refined again and again the mesh becomes self-similar: the number of cells that a round adds
// does not grow. Conformity, also across contact, then costs a fixed number of cells per marked one.
TEST(Refine, ClosureStaysLocal) {
  for (auto& [name, problem] : refine_cases()) {
    if (name == "far") continue;  // rounding stops it before
    SCOPED_TRACE(name);
    const int corner = contact_corner(problem.mesh);
    std::size_t most = 0;
    for (int round = 0; round < 36; ++round) {
      const std::size_t before = problem.mesh.cells.size();
      problem = refine(problem, cells_at(problem.mesh, corner)).problem;
      const std::size_t added = problem.mesh.cells.size() - before;
      if (round < 6) {
        most = std::max(most, added);
      } else {
        ASSERT_LE(added, most) << round;
      }
    }
    expect_conforming(problem.mesh);
  }
}

// Where coordinates have no more digits, refining ends with a message and not with cells that are turned over.
TEST(Refine, EndsWhereRoundingDoes) {
  const auto moved = [](const Vector<2>& x) { return Vector<2>(x[0] + 0.1, x[1] + 0.7); };
  Problem<2> problem = three_blocks("moved", moved).problem;
  const int corner = contact_corner(problem.mesh);
  std::optional<Error> error;
  int rounds = 0;
  for (; !error && rounds < 100 && problem.mesh.cells.size() < 10000; ++rounds) {
    error = error_of([&] { problem = refine(problem, cells_at(problem.mesh, corner)).problem; });
    expect_conforming(problem.mesh);
  }
  ASSERT_TRUE(error.has_value());
  EXPECT_GE(rounds, 40);  // of the 53 bits a few go into the coarse cells and the shape
  EXPECT_EQ(error->status(), Status::budget);
  EXPECT_NE(std::string(error->what()).find("(2.1, 1.7)"), std::string::npos) << error->what();
}

}  // namespace
}  // namespace bracket::scene
