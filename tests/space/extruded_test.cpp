// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Plane strain between ends that slide is the same problem in both dimensions, for which they share no element: on
// every level the interval in space meets the plane's finest, times the thickness.
#include "tests/space/extruded.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "bounds/bounds.h"
#include "tests/support/sanitized.h"

namespace bracket {
namespace {

/// A scene that comes with the program, its blocks cut so.
scene::Scene<2> plane_scene(const std::string& name, const std::vector<std::array<int, 2>>& cells,
                            const std::vector<std::string>& overrides = {}) {
  scene::Scene<2> plane = scene::read_scene<2>(std::filesystem::path(BRACKET_SCENES) / (name + ".toml"), overrides);
  for (std::size_t i = 0; i < cells.size(); ++i) plane.blocks[i].cells = cells[i];
  plane.quantities.clear();
  return plane;
}

void expect_meets(scene::Scene<2> plane, double thickness, const scene::Refine& refine) {
  scene::Scene<3> space = tests::space::extruded(plane, scene::build_mesh(plane), thickness);
  plane.refine = {scene::Strategy::adaptive, 1e-3, 0.5, tests::sanitized ? 5 : 14, 20000, 600, {}};
  const auto known = bounds::run(plane);
  space.refine = refine;
  const auto found = bounds::run(space);
  ASSERT_EQ(known.guarantee, "rounding-safe") << known.reason;
  ASSERT_EQ(found.guarantee, "rounding-safe") << found.reason;
  EXPECT_EQ(static_cast<int>(found.levels.size()), refine.max_levels);
  for (const bounds::Level& level : found.levels) {
    EXPECT_EQ(level.oscillation_energy, 0);  // the loads are the same
    EXPECT_LE(level.bracket.lower, thickness * known.upper) << level.cells << " cells";
    EXPECT_GE(level.bracket.upper, thickness * known.lower) << level.cells << " cells";
    EXPECT_LE(level.checks.gap_identity, 1e-10) << level.cells << " cells";
  }
}

/// Linear on stretches of one axis, in order.
struct Stretches {
  int axis;
  struct One {
    double from, to, value, end;  ///< the value at `from`, and at `to`
  };
  std::vector<One> all;
  template <class Place> auto operator()(const Place& x) const {
    const auto on = [&](const One& one) {
      return (x[axis] - one.from) * ((one.end - one.value) / (one.to - one.from)) + one.value;
    };
    auto value = on(all.back());
    for (std::size_t i = all.size() - 1; i-- > 0;) value = scene::choose(x[axis] < all[i].to, on(all[i]), value);
    return value;
  }
};

/// With the tractions that fix_data() makes, on parts along the axes.
scene::Scene<2> with_projected_loads(scene::Scene<2> plane) {
  const scene::Problem<2> problem = scene::fix_data(plane, scene::build_mesh(plane));
  for (auto& [name, condition] : plane.boundary) {
    if (condition.kind != scene::ConditionKind::traction) continue;
    std::array<Stretches, 2> along;
    for (std::size_t f = 0; f < problem.facets.size(); ++f) {
      const auto& facet = problem.mesh.boundary[f];
      if (facet.part < 0 || problem.mesh.parts[facet.part] != name) continue;
      const auto x = scene::positions(problem.mesh, facet.vertices);
      const int axis = x[0][0] == x[1][0] ? 1 : 0;
      const int first = x[0][axis] < x[1][axis] ? 0 : 1;
      for (int i = 0; i < 2; ++i) {
        along[i].axis = axis;
        const auto& t = problem.facets[f].traction;
        along[i].all.push_back({x[first][axis], x[1 - first][axis], t[first][i], t[1 - first][i]});
      }
    }
    for (int i = 0; i < 2; ++i) {
      std::ranges::sort(along[i].all, {}, &Stretches::One::from);
      condition.value[i] = scene::enclosed<2>(along[i]);
    }
  }
  return plane;
}

scene::Refine refinement(scene::Strategy strategy, int levels) {
  return {strategy, 0, 0.5, tests::sanitized ? std::min(levels, 3) : levels, 20000, 600, {}};
}

TEST(Extruded, two_blocks_that_lift_off) {
  expect_meets(plane_scene("two_blocks", {{2, 2}, {2, 2}}), 0.5, refinement(scene::Strategy::adaptive, 12));
}

TEST(Extruded, two_blocks_that_stay_closed) {
  const auto closed =
      plane_scene("two_blocks", {{2, 2}, {2, 2}}, {"boundary.\"upper.top\".traction=[\"0\", \"-0.02 - 0.02*x\"]"});
  expect_meets(closed, 0.5, refinement(scene::Strategy::adaptive, 12));
}

// Its loads are no polynomials: both take what the plane's first mesh makes of them.
TEST(Extruded, three_halves) {
  expect_meets(with_projected_loads(plane_scene("three_halves", {{8, 4}})), 0.25,
               refinement(scene::Strategy::adaptive, 8));
}

TEST(Extruded, westergaard) {
  expect_meets(plane_scene("westergaard", {{4, 16}}), 0.125, refinement(scene::Strategy::adaptive, 8));
}

TEST(Extruded, linear_pressure) {
  expect_meets(plane_scene("linear_pressure", {{4, 2}, {4, 1}}), 0.5, refinement(scene::Strategy::uniform, 4));
}

// The prisms over graded triangles are needles: the interval is wide, and one. Sanitizers see the same in squares.
TEST(Extruded, l_shape) {
  if (tests::sanitized) GTEST_SKIP();
  expect_meets(plane_scene("l_shape", {}), 0.5, refinement(scene::Strategy::none, 1));
}

TEST(Extruded, l_shape_of_squares) {
  scene::Scene<2> plane = plane_scene("l_shape", {});
  plane.mesh_file.clear();
  for (const auto& [name, x, y] : {std::tuple("foot", -1, -1), std::tuple("corner", -1, 0), std::tuple("arm", 0, 0)})
    plane.blocks.push_back({"bracket", {{{x * 1.0, x + 1.0}, {y * 1.0, y + 1.0}}}, {2, 2}, "", name});
  plane.boundary = {{"bracket.foot.bottom", plane.boundary.at("foot")},
                    {"bracket.arm.right", plane.boundary.at("arm")}};
  expect_meets(plane, 0.5, refinement(scene::Strategy::adaptive, 12));
}

}  // namespace
}  // namespace bracket
