// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/quantities/line.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace bracket::bounds {
namespace {

scene::Problem<2> on_four_edges() { return tests::problem(tests::linear_pressure({}, 4, 1)); }  // x from −1 to 1

// From the left end as seen from inside of the first body: of an upper one's bottom, from the right.
TEST(ContactLines, begin_at_the_left_as_seen_from_inside) {
  const auto problem = on_four_edges();
  const auto lines = contact_lines(problem, 0);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].closed);
  ASSERT_EQ(lines[0].contact.size(), 4u);
  EXPECT_EQ(lines[0].arc, (std::vector<double>{0, 0.5, 1, 1.5, 2}));
  const auto end = [&](int i) {
    return problem.mesh.vertices[problem.mesh.boundary[problem.contact[lines[0].contact[i]].first].vertices[1]];
  };
  EXPECT_EQ(end(0), scene::Vector<2>(1, 0));
  EXPECT_EQ(end(3), scene::Vector<2>(-0.5, 0));
}

double value(const scene::Problem<2>& problem, const LinearWeight& weight, double x) {
  for (std::size_t j = 0; j < weight.size(); ++j) {
    const auto ends = scene::positions(problem.mesh, problem.mesh.boundary[problem.contact[j].first].vertices);
    const double t = (x - ends[0][0]) / (ends[1][0] - ends[0][0]);
    if (t >= 0 && t <= 1) return weight[j][0] + t * (weight[j][1] - weight[j][0]);
  }
  return 0;
}

// ψ⁻ ≤ 1 on the stretch, 0 elsewhere, ≤ ψ⁺, wherever the stretch begins and ends.
TEST(StretchWeights, enclose_the_stretch) {
  const auto problem = on_four_edges();
  const auto line = contact_lines(problem, 0)[0];
  int made = 0;
  for (const auto& [from, to] : {std::pair(0.0, 2.0), {0.0, 1.0}, {0.5, 1.5}, {0.25, 1.75}, {1.0, 2.0}, {0.0, 1.3}}) {
    const auto [below, above] = stretch_weights(problem, line, {from, to}, "");
    ++made;
    for (double arc = 0.01; arc < 2; arc += 0.02) {
      const double x = 1 - arc, inside = arc > from && arc < to ? 1 : 0;
      EXPECT_LE(value(problem, below, x), inside + 1e-15) << from << " " << to << " " << arc;
      EXPECT_GE(value(problem, above, x), inside - 1e-15) << from << " " << to << " " << arc;
    }
  }
  EXPECT_EQ(made, 6);
  const auto [below, above] = stretch_weights(problem, line, {0, 2}, "");
  EXPECT_EQ(below, above);  // the whole line
}

TEST(StretchWeights, are_refused_off_the_line_and_where_nothing_is_left) {
  const auto problem = on_four_edges();
  const auto line = contact_lines(problem, 0)[0];
  for (const auto& [from, to] : {std::pair(-0.1, 1.0), {1.0, 2.1}, {1.0, 1.0}, {1.5, 0.5}, {0.5, 1.0}, {0.1, 0.4}})
    EXPECT_THROW(stretch_weights(problem, line, {from, to}, ""), scene::Error) << from << " " << to;
}

}  // namespace
}  // namespace bracket::bounds
