// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/problem/gap.h"

#include <gtest/gtest.h>

#include "scene/problem/space/face_gap.h"
#include "scene/toml/expression.h"
#include "tests/scene/space/boxes.h"

namespace bracket::scene {
namespace {

using namespace test;

const Face tilted = {{{0.1, 0.2, 0.3}, {1.1, 0.4, 0.2}, {0.5, 1.4, 0.9}}};

OnFace random_point(Random& random) {
  const double s = test::uniform(random, 0, 1), t = test::uniform(random, 0, 1);
  return s + t > 1 ? OnFace{1 - s, 1 - t} : OnFace{s, t};
}

/// What the bounds leave between them at most, by their coefficients; expects that the function lies between them at
/// points of the part.
double expect_between(const FaceGapBounds& bounds, const Function<3>& gap, const Face& face, const FacePart& part) {
  Random random(3);
  double size = 0;
  for (const double c : bounds.upper) size = std::max(size, std::abs(c));
  for (int i = 0; i < 300; ++i) {
    const OnFace in_part = random_point(random);
    OnFace at;
    for (int c = 0; c < 2; ++c)
      at[c] = part[0][c] + in_part[0] * (part[1][c] - part[0][c]) + in_part[1] * (part[2][c] - part[0][c]);
    const double value = gap(place(face, at)), rounding = 1e-14 * (size + 1);
    EXPECT_LE(on_part(bounds.lower, {in_part, in_part, in_part})[0], value + rounding);
    EXPECT_GE(on_part(bounds.upper, {in_part, in_part, in_part})[0], value - rounding);
  }
  double width = 0;
  for (int i = 0; i < 6; ++i) width = std::max(width, bounds.upper[i] - bounds.lower[i]);
  return width;
}

TEST(GapInSpace, OfAQuadraticIsExact) {
  for (const char* simple : {"0.01", "x - 1", "0", "3*x - 2*y + 0.5*z"}) {
    const Function<3> gap = parse_expression<3>(simple, "");
    const Face face = {{{0, 0, 0}, {1, 0, 0.5}, {0.25, 2, 0}}};
    const auto bounds = quadratic_gap(gap, face);
    ASSERT_TRUE(bounds.has_value()) << simple;
    EXPECT_EQ(bounds->lower, bounds->upper) << simple;
    for (int i = 0; i < 3; ++i) EXPECT_EQ(bounds->lower[i], gap(face[i]));
  }
  for (const char* formula : {"0.01*(x^2 + z^2)", "x*y - z/3 + 1", "(x - 0.3)*(y + z)"}) {
    const Function<3> gap = parse_expression<3>(formula, "");
    const auto bounds = quadratic_gap(gap, tilted);
    ASSERT_TRUE(bounds.has_value()) << formula;
    EXPECT_LE(expect_between(*bounds, gap, tilted, whole_face), 4 * eps) << formula;
  }
  for (const char* formula : {"x^3", "sin(y)", "abs(x - 0.5)", "x < 0.5 ? 1 : 0"})
    EXPECT_FALSE(quadratic_gap(parse_expression<3>(formula, ""), tilted).has_value()) << formula;
}

// Three quarters of what the second derivatives along a side differ by in the part: side² times its size times f‴.
TEST(GapInSpace, OfOtherFunctionsIsEnclosedToThirdOrder) {
  for (const char* formula :
       {"0.1*(1 - cos(3*x + z))", "sqrt(2 + x*y*z)", "exp(x) - 3*y^3", "1 - sqrt(1 - 0.1*(x^2 + y^2))"}) {
    const Function<3> gap = parse_expression<3>(formula, "");
    double before = 0;
    FacePart part = whole_face;
    for (int level = 0; level < 10; ++level) {
      const FaceGapBounds bounds = enclosed_gap({gap}, tilted, part);
      const double width = expect_between(bounds, gap, tilted, part);
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(bounds.lower[i], gap(place(tilted, part[i])), 1e-14);
      if (level > 6) {
        EXPECT_NEAR(std::log2(before / width), 3, 0.1) << formula << " level " << level;
      }
      before = width;
      for (int i = 0; i < 3; ++i)
        for (int c = 0; c < 2; ++c) part[i][c] = i == 1 ? part[i][c] : 0.5 * (part[i][c] + part[1][c]);
    }
  }
}

TEST(GapInSpace, ThatJumpsOrBendsIsEnclosed) {
  for (const char* formula : {"abs(x - 0.6)", "x + y < 1 ? 0.1 : 0.2", "max(0, x - z)"}) {
    const Function<3> gap = parse_expression<3>(formula, "");
    const FaceGapBounds bounds = enclosed_gap({gap}, tilted, whole_face);
    const double width = expect_between(bounds, gap, tilted, whole_face);
    EXPECT_LE(width, 1);
  }
  expect_error(
      [] {
        enclosed_gap({parse_expression<3>("sqrt(-1 - x)", ""), {}, {}, "there"}, tilted, whole_face);
      },
      Status::input, {"there", "no value"});
}

// A part's quadratic is the whole's, and values on a side do not know whose side it is.
TEST(FaceInSpace, PartsCarryWhatTheWholeDoes) {
  Random random(5);
  std::array<double, 6> c;
  for (double& one : c) one = test::uniform(random, -1, 1);
  const FacePart part = {{{0.25, 0.125}, {0.5, 0.375}, {0.0, 0.75}}};
  const auto on = on_part(c, part);
  for (int i = 0; i < 20; ++i) {
    const OnFace at = random_point(random);
    OnFace whole;
    for (int k = 0; k < 2; ++k)
      whole[k] = part[0][k] + at[0] * (part[1][k] - part[0][k]) + at[1] * (part[2][k] - part[0][k]);
    EXPECT_NEAR(on_part(on, {at, at, at})[0], on_part(c, {whole, whole, whole})[0], 1e-14);
  }
  for (int i = 0; i < 100; ++i) {
    const double a = test::uniform(random, -1, 1), b = test::uniform(random, -1, 1),
                 third = test::uniform(random, -1, 1);
    const double t = static_cast<double>(random() % 1024) / 1024;
    const double value = linear_at(std::array{a, b, third}, {t, 0});
    EXPECT_EQ(value, linear_at(std::array{b, a, third}, {1 - t, 0}));
    EXPECT_EQ(value, linear_at(std::array{third, a, b}, {1 - t, t}));
    EXPECT_EQ(value, linear_at(std::array{b, third, a}, {0, 1 - t}));
    EXPECT_EQ(linear_at(std::array{a, a, a}, {t / 2, t / 4}), a);
  }
  EXPECT_EQ(share_of_face({{{0, 0}, {0.5, 0}, {0, 1}}}), 0.5);
}

}  // namespace
}  // namespace bracket::scene
