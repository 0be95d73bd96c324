// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/problem/gap.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "scene/toml/expression.h"
#include "tests/scene/inputs.h"

namespace bracket::scene {
namespace {

using namespace test;

double value(const std::array<double, 3>& c, double s) {
  return (1 - s) * ((1 - s) * c[0] + 2 * s * c[1]) + s * s * c[2];
}

const Vector<2> left_end(-1, 0.25), right_end(2, 0.25);
/// Where a parameter of the edge from its left to its right end is.
Vector<2> at(double t) { return (1 - t) * left_end + t * right_end; }

GapBounds enclosed(const std::string& gap, double from = 0, double to = 1) {
  return enclosed_gap({parse_expression(gap, "")}, left_end, right_end, {0, {{{from}, {to}}}});
}

/// A jump, a kink, a root or something smooth, with random numbers.
std::string random_formula(Random& random) {
  const double c = uniform(random, -1, 2), h = std::exp(uniform(random, -5, 7)), k = uniform(random, 0.5, 6);
  const std::array<std::string, 12> forms = {fmt::format("x < {} ? 0 : {}", c, h),
                                             fmt::format("x < {} ? {} : 0.1*x", c, h),
                                             fmt::format("{}*abs(x - {})", h, c),
                                             fmt::format("max(0, {}*(x - {}))", h, c),
                                             fmt::format("min(x^2, {}*(2 - x))", k),
                                             fmt::format("4 - sqrt(16 - (x - {})^2)", c),
                                             fmt::format("sqrt(abs(x - {}))", c),
                                             fmt::format("{}*(1 - cos({}*x))", h, k),
                                             fmt::format("{}*exp(-(x - {})^2*{})", h, c, k),
                                             fmt::format("x^3 - {}*x", k),
                                             fmt::format("rint({}*x)/{}", k, k),
                                             fmt::format("(x > {} && x < {}) * {} + sin({}*x)", c, c + 0.1, h, k)};
  return forms[std::uniform_int_distribution<std::size_t>(0, forms.size() - 1)(random)];
}

TEST(Gap, LiesBetweenItsQuadraticsOnRandomStretches) {
  Random random(1);
  for (int trial = 0; trial < 1500; ++trial) {
    const std::string formula = random_formula(random);
    const Function<2> gap = parse_expression(formula, "");
    const int halvings = std::uniform_int_distribution<int>(0, 12)(random);
    const double width = std::ldexp(1.0, -halvings);
    const double from = width * std::floor(uniform(random, 0, 1) / width), to = from + width;
    const auto [lower, upper] = enclosed_gap({gap}, left_end, right_end, {0, {{{from}, {to}}}});
    double least = 1e300, largest = -1e300;
    std::vector<std::pair<double, double>> samples;
    for (int k = 0; k < 200; ++k) {
      const double s = uniform(random, 0, 1), g = gap(at(from + s * width));
      samples.emplace_back(s, g);
      least = std::min(least, g);
      largest = std::max(largest, g);
    }
    const double rounding = 1e-13 * (1 + std::max(std::abs(least), std::abs(largest)));  // of the formula at points
    for (const auto& [s, g] : samples) {
      EXPECT_LE(value(lower, s), g + rounding) << formula << " at " << s << " of " << from << " … " << to;
      EXPECT_GE(value(upper, s), g - rounding) << formula << " at " << s << " of " << from << " … " << to;
    }
    // Where the least value is at an end, or taken on a stretch, samples know it: nothing lies below.
    const double known = std::min({least, gap(at(from)), gap(at(to))});
    if (formula.find("? 0 :") == std::string::npos) continue;
    for (int k = 0; k <= 100; ++k) EXPECT_GE(value(lower, k / 100.0), std::min(0.0, known) - rounding) << formula;
  }
}

// The first mesh's parabola through (0, 0, 1) would dip to −1/8.
TEST(Gap, ALowerOneIsNotBelowTheLeastValue) {
  for (const char* formula :
       {"x < 0.5 ? 0 : 1", "x < 0.6 ? 0 : 1", "x < 1.99 ? 0 : 1", "x > -0.9 ? 0 : 1000", "abs(x - 0.3)",
        "1 - cos(2*pi*(x + 1))", "1 - cos(2*pi*(x - 0.4))", "2.5 - sqrt(6.25 - (x - 0.1)^2)", "sqrt(x + 1)"})
    for (int halvings = 0; halvings < 9; ++halvings)
      for (int piece = 0; piece < 1 << halvings; ++piece) {
        const double width = std::ldexp(1.0, -halvings);
        const auto lower = enclosed(formula, piece * width, (piece + 1) * width).lower;
        for (int k = 0; k <= 64; ++k)
          ASSERT_GE(value(lower, k / 64.0), -1e-13) << formula << ", " << piece << " of " << halvings;
      }
}

TEST(Gap, JumpsAtEndsOfAnEdgeCostNothing) {
  const auto bounds = enclosed("x < 0.5 ? 1 : 3", 0, 0.5);
  EXPECT_EQ(bounds.lower, (std::array<double, 3>{1, 1, 1}));
  EXPECT_EQ(bounds.upper, bounds.lower);
  EXPECT_EQ(enclosed("x < 0.5 ? 1 : 3", 0.5, 1).lower, (std::array<double, 3>{3, 3, 3}));
  const auto kink = enclosed("abs(x - 0.5)", 0.5, 1);
  EXPECT_EQ(kink.lower[0], 0);
  EXPECT_EQ(kink.upper[2], 1.5);
}

/// The area between the two on all stretches of a length.
double area_between(const std::string& gap, int halvings) {
  double sum = 0;
  const double width = std::ldexp(1.0, -halvings);
  for (int piece = 0; piece < 1 << halvings; ++piece) {
    const auto [lower, upper] = enclosed(gap, piece * width, (piece + 1) * width);
    for (int i = 0; i < 3; ++i) sum += width * (upper[i] - lower[i]) / 3;
  }
  return sum;
}

TEST(Gap, TheBoundsCloseAtTheOrderThatTheFunctionAllows) {
  struct Case {
    const char* formula;
    double order;
  };
  for (const auto& [formula, order] :
       {Case{"sin(2*x)", 3}, Case{"1 - cos(pi*x)", 3}, Case{"exp(x)/(1 + x^2)", 3}, Case{"4 - sqrt(16 - x^2)", 3},
        Case{"abs(x - 0.3)", 2}, Case{"x < 0.3 ? 0 : 1e3", 1}, Case{"max(0, x^2 - 0.3)", 2},
        Case{"sqrt(x + 1)", 1.5}}) {
    const double coarse = area_between(formula, 4), fine = area_between(formula, 8);
    EXPECT_GT(std::log2(coarse / fine) / 4, order - 0.3) << formula << ": " << coarse << ", " << fine;
  }
}

TEST(Gap, QuadraticsAreOneUpToRounding) {
  const auto exact = quadratic_gap(parse_expression("0.5*x^2 - y", ""), left_end, right_end);
  ASSERT_TRUE(exact.has_value());
  EXPECT_EQ(exact->lower, (std::array<double, 3>{0.25, -1.25, 1.75}));
  EXPECT_EQ(exact->upper, exact->lower);
  const auto rounded = quadratic_gap(parse_expression("0.1*x^2 - x/3", ""), left_end, right_end);
  ASSERT_TRUE(rounded.has_value());
  for (int i = 0; i < 3; ++i) EXPECT_LE(rounded->upper[i], std::nextafter(rounded->lower[i], 1e9)) << i;
  EXPECT_FALSE(quadratic_gap(parse_expression("x^3", ""), left_end, right_end).has_value());
  EXPECT_FALSE(quadratic_gap(parse_expression("abs(x)", ""), left_end, right_end).has_value());
}

TEST(Gap, TheLowerOneAdmitsWhatItsEndsMust) {
  const Function<2> step = parse_expression("x < 1 ? 1 : 0", "");
  for (const double at_least : {0.0, 0.4, 1.0}) {
    const GivenGap<2> given{step, {at_least, -1e300}, {0, 0}, ""};
    const auto lower = enclosed_gap(given, left_end, right_end, whole<1>(0)).lower;
    EXPECT_GE(lower[0], at_least);
    for (int k = 0; k <= 100; ++k) EXPECT_LE(value(lower, k / 100.0), k < 67 ? 1 : 0) << at_least;
  }
}

TEST(Gap, WhatHasNoValueOrNoBoundIsRefused) {
  const auto refusal = [](const std::string& gap) {
    const auto error = error_of([&] { enclosed(gap); });
    return error ? std::string(error->what()) : "";
  };
  EXPECT_NE(refusal("sqrt(x)").find("has no value at (-"), std::string::npos) << refusal("sqrt(x)");
  EXPECT_NE(refusal("1/x").find("has no bounds between"), std::string::npos) << refusal("1/x");
}

}  // namespace
}  // namespace bracket::scene
