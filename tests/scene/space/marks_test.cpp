// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/mesh/space/marks.h"

#include <gtest/gtest.h>

#include <map>

#include "scene/mesh/space/similar.h"
#include "scene/mesh/space/tetrahedron.h"
#include "scene/problem/refine.h"
#include "tests/scene/space/boxes.h"

namespace bracket::scene {
namespace {

using namespace test;

Problem<3> one_cell(const std::array<Vector<3>, 4>& corners, const FacetMarks& marks) {
  Scene<3> scene;
  scene.given = GivenMesh<3>{{corners.begin(), corners.end()}, {{0, 1, 2, 3}}, {{"b", {0}}}, {}};
  scene.bodies.emplace("b", isotropic<3>(1, 0.3));
  Problem<3> problem = fix_data(scene, build_mesh(scene));
  problem.mesh.marks = {{marks, false}};
  return problem;
}

// [Arnold, Mukherjee & Pouly, SIAM J. Sci. Comput. 22 (2000)]
TEST(MarksInSpace, MakeFewShapesAndHalveEveryEdgeInThreeSteps) {
  const std::array<Vector<3>, 4> generic = {{{0, 0, 0}, {1, 0.1, -0.2}, {0.3, 1.2, 0.1}, {-0.1, 0.4, 0.9}}};
  EXPECT_EQ(all_marks().size(), 51u);
  for (const FacetMarks& marks : all_marks()) {
    EXPECT_LE(similar_cells(marks).size(), 72u);
    Problem<3> problem = one_cell(generic, marks);
    double least = 1;
    for (int goal = 1; goal <= 9; ++goal) {
      for (bool again = true; again;) {
        std::vector<char> marked;
        for (std::size_t c = 0; c < problem.mesh.cells.size(); ++c) marked.push_back(generation(problem, c) < goal);
        again = std::ranges::find(marked, 1) != marked.end();
        if (again) problem = refine(problem, marked).problem;
        least = std::min(least, quality(problem.mesh).smallest_shape);
      }
      if (goal == 3) {
        EXPECT_EQ(problem.mesh.cells.size(), 8u);
        EXPECT_EQ(problem.mesh.vertices.size(), 10u);
      }
      if (goal % 3 == 0) {
        EXPECT_EQ(problem.mesh.cells.size(), std::size_t{1} << goal);
      }
    }
    EXPECT_NEAR(least, least_shape_below(marks, generic), 1e-12);  // all shapes were there
  }
}

// Longest edges alone come to 0.43 of the start here.
TEST(MarksInSpace, AreChosenSoThatShapesStay) {
  Random random(3);
  for (const double moved : {0.05, 0.1, 0.15}) {  // of cells ½ long
    for (int round = 0; round < 20; ++round) {
      const Mesh<3> mesh = shaken(build_mesh(unit_boxes(2)), random, moved);
      std::vector<int> glued(mesh.vertices.size());
      std::map<std::array<double, 3>, int> at;
      for (std::size_t v = 0; v < glued.size(); ++v) {
        const Vector<3>& x = mesh.vertices[v];
        glued[v] = at.try_emplace({x[0], x[1], x[2]}, static_cast<int>(v)).first->second;
      }
      const auto marks = first_marks(mesh, glued);
      double least = 1;
      for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        least = std::min(least, least_shape_below(marks[c].facet, positions(mesh, mesh.cells[c])));
      EXPECT_GE(least, 0.5 * quality(mesh).smallest_shape) << moved << " " << round;
    }
  }
}

// So shapes stay above half of the first ones in many meshes, and cannot in all.
TEST(MarksInSpace, HaveNoChoiceThatKeepsARegularCell) {
  const std::array<Vector<3>, 4> regular = {{{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}}};
  ASSERT_GT(volume<3>(regular), 0);
  double best = 0;
  for (const FacetMarks& marks : all_marks()) best = std::max(best, least_shape_below(marks, regular));
  EXPECT_LT(best, 0.43);
  EXPECT_GT(best, 0.42);
}

}  // namespace
}  // namespace bracket::scene
