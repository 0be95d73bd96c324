// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/deformed.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bounds/bounds.h"

namespace bracket::apps::tests {
namespace {

using scene::Vector;

bounds::Outcome<2> run(const std::string& name, std::vector<std::string> overrides = {}) {
  overrides.insert(overrides.end(), {"refine.strategy=adaptive", "refine.max_levels=2", "refine.target=0"});
  return bounds::run(scene::read_scene<2>(BRACKET_SCENES "/" + name + ".toml", overrides));
}

/// What is drawn between the sides along every contact line is the factor times what is left of the gap, to rounding of
/// what is drawn. \return the largest remaining gap by the length scale
double expect_drawn_gaps(const bounds::Outcome<2>& outcome, double factor) {
  const scene::Problem<2>& problem = outcome.problem;
  const DrawnShape shape = drawn_shape(problem, factor);
  const auto states = bounds::contact_state(problem, outcome.displacement, outcome.stress);
  double size = problem.length_scale, widest = 0;
  for (const Vector<2>& u : outcome.displacement.vertex) size = std::max(size, factor * u.norm());
  for (const Vector<2>& w : shape.shift) size = std::max(size, w.norm());
  EXPECT_FALSE(problem.contact.empty());
  for (std::size_t i = 0; i < problem.contact.size(); ++i) {
    const scene::ContactFacet& contact = problem.contact[i];
    const Vector<2>& d = problem.facets[contact.first].normal;
    for (int k = 0; k <= 10; ++k) {
      const double t = 0.1 * k;
      const Vector<2> one = drawn_on_facet(problem, &outcome.displacement, shape, contact.first, t);
      const Vector<2> other = drawn_opposite(problem, &outcome.displacement, shape, contact, t);
      const double left = scene::value_on_segment(states[i].gap_left, t), drawn = (other - one).dot(d);
      EXPECT_NEAR(drawn, factor * left, 1e-13 * size) << i << " at " << t;
      EXPECT_GE(drawn, -1e-10 * size) << i << " at " << t;  // what the program's checks let pass of penetration
      widest = std::max(widest, left / problem.length_scale);
      // Before: apart by the gap, in each other by the interference.
      const double gap = scene::value_on_segment(std::vector<double>(contact.upper.begin(), contact.upper.end()), t);
      EXPECT_NEAR((drawn_opposite(problem, nullptr, shape, contact, t) -
                   drawn_on_facet(problem, nullptr, shape, contact.first, t))
                      .dot(d),
                  factor * gap, 1e-13 * size);
    }
  }
  return widest;
}

TEST(Deformed, GapsAreMagnifiedAsDisplacementsAre) {
  for (const char* name : {"two_blocks", "hertz", "shrink_fit", "pin_in_lug", "bolted_bracket", "westergaard",
                           "stacked", "example_1", "example_2"}) {
    SCOPED_TRACE(name);
    const bounds::Outcome<2> outcome = run(name);
    const double factor = magnification(outcome.problem, outcome.displacement);
    const double widest = expect_drawn_gaps(outcome, factor);
    EXPECT_LE(factor * widest, 0.25);
    expect_drawn_gaps(outcome, 1);
    expect_drawn_gaps(outcome, 1000);
  }
}

TEST(Deformed, OfEachDegree) {
  for (const char* degree : {"1", "2", "3", "4"})
    expect_drawn_gaps(run("hertz", {std::string("solve.degree=") + degree}), 7);
}

TEST(Deformed, WithoutGapsBodiesKeepTheirShape) {
  const bounds::Outcome<2> outcome = run("two_blocks");
  const DrawnShape shape = drawn_shape(outcome.problem, 20);
  for (const Vector<2>& shift : shape.shift) EXPECT_EQ(shift, Vector<2>(Vector<2>::Zero()));
  for (int cell = 0; cell < static_cast<int>(outcome.problem.mesh.cells.size()); ++cell) {
    const int corner = outcome.problem.mesh.cells[cell][0];
    const Vector<2> drawn = drawn_in_cell(outcome.problem, outcome.displacement, shape, cell, {1, 0, 0});
    EXPECT_LT((drawn - outcome.problem.mesh.vertices[corner] - 20 * outcome.displacement.vertex[corner]).norm(), 1e-13);
  }
}

TEST(Deformed, AnEvenGapMovesABodyThatIsFreeAsAWhole) {
  const bounds::Outcome<2> outcome =
      run("two_blocks", {"contact.0.gap=0.001", "boundary.\"upper.top\".traction=[\"0\",\"-0.1\"]"});
  const scene::Problem<2>& problem = outcome.problem;
  const DrawnShape shape = drawn_shape(problem, 100);
  for (std::size_t cell = 0; cell < problem.mesh.cells.size(); ++cell) {
    const bool upper = problem.mesh.bodies[problem.mesh.cell_body[cell]] == "upper";
    for (const int vertex : problem.mesh.cells[cell])
      EXPECT_LT((shape.shift[vertex] - (upper ? Vector<2>(0, 0.1) : Vector<2>(0, 0))).norm(), 1e-5);
  }
}

TEST(Deformed, SupportsStayWhereTheyAre) {
  const bounds::Outcome<2> outcome = run("shrink_fit");
  const scene::Problem<2>& problem = outcome.problem;
  const DrawnShape shape = drawn_shape(problem, 300);
  double largest = 0;
  for (std::size_t facet = 0; facet < problem.facets.size(); ++facet)
    for (const int vertex : problem.mesh.boundary[facet].vertices) {
      largest = std::max(largest, shape.shift[vertex].norm());
      if (problem.facets[facet].support == scene::Support::sliding) {
        EXPECT_NEAR(shape.shift[vertex].dot(problem.facets[facet].normal), 0, 1e-9);
      }
    }
  EXPECT_NEAR(largest, 300 * 0.02, 0.1);  // the bush is drawn larger by its interference
}

}  // namespace
}  // namespace bracket::apps::tests
