// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Gaps and jumps that the first mesh cannot have: the interval and what is told of the data hold the energy.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bounds/bounds.h"
#include "scene/quadrature.h"
#include "tests/laws/pairs.h"

namespace bracket::tests {
namespace {

using scene::Law;
using scene::Scene;
using scene::Vector;

constexpr double young = 3, poisson = 0.3, shear = young / (2 * (1 + poisson)), down = 0.5;

/// u = ∇(e^x sin(y + ½)) is in equilibrium without forces, for any ν: its divergence is zero.
template <class X> auto first(const X& x) {
  using std::exp, std::sin;
  return exp(x[0]) * sin(x[1] + down);
}
template <class X> auto second(const X& x) {
  using std::cos, std::exp;
  return exp(x[0]) * cos(x[1] + down);
}

/// Half a unit square on a wall with which it keeps, by a jump, that displacement at its bottom; σ = 2 μ ∇u beside.
Scene<2> pulled(double bound, int n) {
  Scene<2> s;
  s.blocks = {block("b", 0, 1, 0, 1, n, n)};
  s.bodies = {{"b", scene::isotropic<2>(young, poisson, scene::Plane::strain)}};
  const auto xx = [](double factor) {
    return scene::enclosed<2>([factor](const auto& x) { return factor * 2 * shear * first(x); });
  };
  const auto xy = [](double factor) {
    return scene::enclosed<2>([factor](const auto& x) { return factor * 2 * shear * second(x); });
  };
  s.boundary = {
      {"b.left", traction(xx(-1), xy(-1))}, {"b.right", traction(xx(1), xy(1))}, {"b.top", traction(xy(1), xx(-1))}};
  s.contact = {{"b.bottom", "rigid", {}, ""}};
  s = with_law(s, {"", Law::tresca, constant(bound), false});
  s.contact[0].jump = {scene::enclosed<2>([](const auto& x) { return first(x); }),
                       scene::enclosed<2>([](const auto& x) { return second(x); })};
  s.refine = {.strategy = scene::Strategy::none};
  return s;
}

/// L(u) = ½ ∫_bottom σn·u − ½ ∫_others P·u, by Gauss's rule, to rounding: the integrands are entire.
double energy_of_pulled() {
  double sum = 0;
  const auto add = [&](double sign, auto place, const Vector<2>& n) {
    for (int panel = 0; panel < 8; ++panel)
      for (const auto& [x, weight] : scene::gauss_points<5>()) {
        const Vector<2> at = place((panel + (1 + x) / 2) / 8), u(first(at), second(at));
        const Vector<2> t = 2 * shear * Vector<2>(n[0] * u[0] + n[1] * u[1], n[0] * u[1] - n[1] * u[0]);
        sum += sign * weight / 2 / 8 * 0.5 * t.dot(u);
      }
  };
  add(1, [](double t) { return Vector<2>(t, 0); }, {0, -1});
  add(-1, [](double t) { return Vector<2>(t, 1); }, {0, 1});
  add(-1, [](double t) { return Vector<2>(0, t); }, {-1, 0});
  add(-1, [](double t) { return Vector<2>(1, t); }, {1, 0});
  return sum;
}

// Friction of 1e3 holds all that there is: the jump prescribes the displacement.
TEST(LawsAsWritten, AJumpThatIsNoQuadratic) {
  const double exact = energy_of_pulled();
  for (const int degree : {1, 2, 3}) {
    double before = 0;
    for (const int n : {2, 4, 8}) {
      Scene<2> s = pulled(1e3, n);
      s.solve.degree = degree;
      const auto outcome = bounds::run(s);
      SCOPED_TRACE(testing::Message() << "degree " << degree << ", " << n << " edges " << outcome.reason);
      ASSERT_EQ(outcome.guarantee, "rounding-safe");
      const double told = outcome.levels[0].oscillation_energy;
      EXPECT_LE(outcome.lower - told, exact);
      EXPECT_GE(outcome.upper + told, exact);
      EXPECT_GT(told, 0);
      if (before > 0) {
        EXPECT_LE(told, before / (degree == 1 ? 3 : 6));
      }
      before = told;
    }
  }
}

// Two blocks that an interference keeps apart, with a kink inside of an edge: the intervals of two first meshes meet
// after what is told of each, which falls.
TEST(LawsAsWritten, AGapWithAKink) {
  const auto kink = scene::enclosed<2>([](const auto& x) {
    using std::abs;
    return 0.01 * abs(x[0] - std::numbers::inv_pi) - 0.02;
  });
  for (const int degree : {1, 2}) {
    const auto run = [&](int n) {
      Scene<2> s = two_blocks(n);
      s = with_law(s, {"", Law::bilateral});
      s.contact[0].gap = kink;
      s.solve.degree = degree;
      s.refine = {.strategy = scene::Strategy::adaptive, .max_levels = 4};
      s.refine.target = 0.5;
      return bounds::run(s);
    };
    const auto coarse = run(4), fine = run(32);
    const double of_coarse = coarse.levels[0].oscillation_energy, of_fine = fine.levels[0].oscillation_energy;
    EXPECT_GT(of_fine, 0);
    EXPECT_LE(of_fine, of_coarse / 4);
    EXPECT_LE(std::max(coarse.lower - of_coarse, fine.lower - of_fine),
              std::min(coarse.upper + of_coarse, fine.upper + of_fine))
        << degree;
  }
}

// What the target asks for is resolved by a finer first mesh, and a note says so.
TEST(LawsAsWritten, TheFirstMeshIsRefinedForAGap) {
  Scene<2> s = pulled(1e3, 2);
  s.refine = {.strategy = scene::Strategy::adaptive, .target = 0.02};
  const auto outcome = bounds::run(s);
  // A tenth of target² ‖u_h‖²_A / 2, with what two meshes differ in.
  EXPECT_LE(outcome.levels[0].oscillation_energy, 1.01 * 0.1 * 0.02 * 0.02 * outcome.levels[0].plain.strain);
  EXPECT_LE(outcome.lower - outcome.levels[0].oscillation_energy, energy_of_pulled());
  EXPECT_GE(outcome.upper + outcome.levels[0].oscillation_energy, energy_of_pulled());
  ASSERT_FALSE(outcome.problem.mesh.notes.empty());
  EXPECT_NE(outcome.problem.mesh.notes.back().find("for the data of"), std::string::npos)
      << outcome.problem.mesh.notes.back();
}

}  // namespace
}  // namespace bracket::tests
