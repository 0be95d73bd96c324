// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "scene/toml/expression.h"
#include "tests/scene/inputs.h"

namespace bracket::scene {
namespace {

using namespace test;

/// Whether all that x allows y allows, too.
bool within(const Interval& x, const Interval& y) { return x.is_empty() || (y.lower <= x.lower && x.upper <= y.upper); }

Jet on_axis(const Function<2>& f, double from, double to) { return along<2>(f, {-2, 0.7}, {3, 0.7}, from, to); }
Jet on_axis(const std::string& formula, double from, double to) {
  return on_axis(parse_expression(formula, ""), from, to);
}

const std::vector<std::string>& smooth_formulas() {
  static const std::vector<std::string> all = {"x^2 - 3*x + 1",
                                               "x^5",
                                               "1/(x^2 + 1)",
                                               "sin(3*x)",
                                               "cos(x*y)",
                                               "tan(x/3)",
                                               "asin(x/4)",
                                               "acos(x/4)",
                                               "atan(2*x)",
                                               "atan2(x, y)",
                                               "atan2(y, x)",
                                               "sinh(x)",
                                               "cosh(x)",
                                               "tanh(2*x)",
                                               "asinh(3*x)",
                                               "acosh(x + 4)",
                                               "atanh(x/4)",
                                               "exp(-x*x)",
                                               "ln(x + 3)",
                                               "log2(x + 3)",
                                               "log10(x + 3)",
                                               "sqrt(x + 3)",
                                               "(x + 3)^0.7",
                                               "(x + 3)^-2",
                                               "(x + 3)^x",
                                               "2^x",
                                               "sum(x, sin(x), y)*avg(x, x^2)",
                                               "1.5 - sqrt(16 - x^2)"};
  return all;
}

const std::vector<std::string>& rough_formulas() {
  static const std::vector<std::string> all = {"abs(x)",
                                               "min(x, y, x^2)",
                                               "max(sin(3*x), cos(3*x))",
                                               "x < 0.3 ? x : 2 - x^2",
                                               "sign(x)*x",
                                               "rint(2*x)/2",
                                               "(x > 0.1) + (x >= 0.5 && x < 1.5)",
                                               "x^2 <= 1 || y > 2 ? 1 : -1",
                                               "x == 1 ? 5 : x",
                                               "(x != 0)*x",
                                               "sqrt(x + 2)",
                                               "abs(x)^0.5",
                                               "x < 1 ? 1e3 : 0",
                                               "0*(x < 1)"};
  return all;
}

TEST(Jet, HoldsAllFourCoefficientsAtPointsOfItsRange) {
  Random random(1);
  for (const std::string& formula : smooth_formulas())
    for (int trial = 0; trial < 60; ++trial) {
      double from = uniform(random, 0, 1), to = std::min(1.0, from + std::exp(uniform(random, -12, 0)));
      const Jet range = on_axis(formula, from, to);
      EXPECT_FALSE(range.partial) << formula;
      for (int k = 0; k < 8; ++k) {
        const double at = k == 0 ? from : k == 1 ? to : uniform(random, from, to);
        const Jet point = on_axis(formula, at, at);
        for (int i = 0; i < 4; ++i) {
          EXPECT_FALSE(intersection(point.c[i], range.c[i]).is_empty())
              << formula << " on " << from << " … " << to << ", " << i;
          EXPECT_LE(point.c[i].upper - point.c[i].lower, 1e-12 * (1 + point.c[i].magnitude())) << formula;
        }
      }
    }
}

// Over a range the Taylor polynomial at a point misses by the enclosed coefficient after it: this ties the coefficients
// to each other and to the values, which are those of the C library.
TEST(Jet, ItsCoefficientsAreThoseOfTaylor) {
  Random random(2);
  for (const std::string& formula : smooth_formulas()) {
    const Function<2> f = parse_expression(formula, "");
    for (int trial = 0; trial < 40; ++trial) {
      const double from = uniform(random, 0, 0.98), to = from + std::exp(uniform(random, -8, -4));
      const Jet start = on_axis(f, from, from), range = on_axis(f, from, to);
      const Interval h = Interval(to) - Interval(from);
      for (int order = 1; order <= 3; ++order) {
        Interval end = start.c[0], power = 1;
        for (int i = 1; i < order; ++i) end = end + start.c[i] * (power = power * h);
        end = end + range.c[order] * (power * h);
        const double value = f(Vector<2>((1 - to) * -2 + to * 3, 0.7));
        const double rounding = 1e-13 * (1 + std::abs(value));  // of the point and of the formula, at a slope below 100
        EXPECT_LE(end.lower, value + rounding) << formula << ", " << order;
        EXPECT_GE(end.upper, value - rounding) << formula << ", " << order;
        // And it says something: the remainder is of its order.
        if (order < 3) continue;
        EXPECT_LE(end.upper - end.lower, 1e6 * h.upper * h.upper * h.upper * h.upper + rounding) << formula;
      }
    }
  }
}

TEST(Jet, ValuesOfWhatIsNotSmoothStayEnclosed) {
  Random random(3);
  for (const std::string& formula : rough_formulas()) {
    const Function<2> f = parse_expression(formula, "");
    for (int trial = 0; trial < 200; ++trial) {
      const double from = uniform(random, 0, 1), to = std::min(1.0, from + std::exp(uniform(random, -6, 0)));
      const Interval range = on_axis(f, from, to).value();
      for (int k = 0; k < 10; ++k) {
        const double at = uniform(random, from, to), value = f(Vector<2>((1 - at) * -2 + at * 3, 0.7));
        if (std::isnan(value)) continue;
        EXPECT_LE(range.lower, value + 1e-14) << formula << " at " << at;
        EXPECT_GE(range.upper, value - 1e-14) << formula << " at " << at;
      }
    }
  }
}

TEST(Jet, WhatIsNotSmoothHasUnboundedDerivatives) {
  for (const char* formula :
       {"abs(x)", "sqrt(x + 2)", "x < 1 ? 0 : 1", "x < 1 ? x : 2 - x", "min(x, 1)", "rint(x)", "1/x"})
    for (int i = 1; i < 4; ++i) EXPECT_FALSE(on_axis(formula, 0, 1).c[i].is_bounded()) << formula;
  EXPECT_TRUE(on_axis("0*(x < 1)", 0, 1).is_constant());
  EXPECT_TRUE(on_axis("y < 1 ? y : x", 0, 1).is_constant());
}

// A jump at the end of an edge is none inside of it; one in the last place before the end is.
TEST(Jet, JumpsAtTheEndOfARangeAreNoneInside) {
  const Vector<2> a(0.1, 0.3), b(0.7, 0.3);
  for (const char* formula :
       {"x < 0.7 ? 0 : 1", "x <= 0.7 ? 0 : 1", "x > 0.1 ? 0 : 1", "0.1 >= x", "x == 0.7", "sign(x - 0.7) + 1",
        "x - 0.1 ? 0 : 1", "rint(x + 0.4) - 1", "max(0, x - 0.7)", "2*x < 1.4 && x > 0.1 ? 0 : 1"}) {
    const Jet jet = along<2>(parse_expression(formula, ""), a, b, 0, 1);
    EXPECT_TRUE(jet.value().is_zero() && jet.is_constant()) << formula;
  }
  EXPECT_EQ(along<2>(parse_expression("x < 0.6999999999999999 ? 0 : 1", ""), a, b, 0, 1).value().upper, 1);
  EXPECT_EQ(along<2>(parse_expression("(x - 0.7)^2 > 0 ? 0 : 1", ""), a, b, 0, 1).value().upper, 1);  // not monotone
}

TEST(Jet, QuadraticsHaveNoThirdDerivative) {
  for (const char* formula : {"x^2", "0.37*x*x - x/7 + y^3", "x*(x - pi)/3", "(x - 0.1)^2/2", "sqrt(y)*x^2", "-x + 1"})
    for (const double to : {0.3, 1.0}) EXPECT_TRUE(on_axis(formula, 0.1, to).c[3].is_zero()) << formula;
  EXPECT_FALSE(on_axis("x^3", 0, 1).c[3].is_zero());
}

TEST(Jet, WhatIsNowhereDefinedIsEmpty) {
  EXPECT_TRUE(on_axis("sqrt(x - 4)", 0, 1).value().is_empty());
  EXPECT_TRUE(on_axis("1 + ln(-4 - x^2)", 0, 1).value().is_empty());
  EXPECT_TRUE(on_axis("1/(0*x)", 0, 1).value().is_empty());
  EXPECT_FALSE(on_axis("x < 9 ? x : sqrt(x - 4)", 0, 1).value().is_empty());
  const Jet half = on_axis("sqrt(x)", 0, 1);
  EXPECT_TRUE(half.partial);
  EXPECT_EQ(half.value().lower, 0);
  EXPECT_EQ(on_axis("sqrt(x) < 9 ? 0 : 1", 0, 1).value().upper, 1);  // false where it is not defined
}

// Every operation against exact arithmetic of numbers with few digits.
TEST(Interval, SumsAndProductsOfShortNumbersAreExact) {
  Random random(4);
  for (int trial = 0; trial < 2000; ++trial) {
    const auto number = [&] {
      return Interval(std::ldexp(std::floor(uniform(random, -1e9, 1e9)), static_cast<int>(uniform(random, -30, 30))));
    };
    const Interval x = number(), y = number();
    EXPECT_TRUE((x * y).is_point());
    EXPECT_TRUE(((x * y) / y).is_point());
    EXPECT_TRUE(sqrt(square(x)).is_point());
    EXPECT_FALSE((x / (Interval(3) * y)).is_point() && (x / (Interval(7) * y)).is_point());
    const Interval third = x / 3;
    EXPECT_TRUE(within(x, third + third + third));
    EXPECT_LE((third.upper - third.lower), 8 * std::numeric_limits<Real>::epsilon() * x.magnitude());
  }
}

// A fused multiply–add rounds once, so that its sign is that of the exact difference.
TEST(Interval, RoundedOperationsHoldTheExactValues) {
  Random random(6);
  int rounded = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const auto number = [&] {
      return static_cast<Real>(uniform(random, -1, 1)) * (1 + static_cast<Real>(uniform(random, 0, 1e-9)));
    };
    const Real x = number(), y = number();
    const Interval product = Interval(x) * Interval(y), quotient = Interval(x) / Interval(y),
                   root = sqrt(Interval(std::abs(x)));
    EXPECT_GE(std::fma(x, y, -product.lower), 0);
    EXPECT_LE(std::fma(x, y, -product.upper), 0);
    const Real sign = y > 0 ? 1 : -1;
    EXPECT_LE(sign * std::fma(quotient.lower, y, -x), 0);
    EXPECT_GE(sign * std::fma(quotient.upper, y, -x), 0);
    EXPECT_LE(std::fma(root.lower, root.lower, -std::abs(x)), 0);
    EXPECT_GE(std::fma(root.upper, root.upper, -std::abs(x)), 0);
    for (const Interval& value : {product, quotient, root}) {
      EXPECT_LE(value.upper - value.lower, 4 * std::numeric_limits<Real>::epsilon() * value.magnitude());
      rounded += value.is_point() ? 0 : 1;
    }
    const Interval sum = Interval(x) + Interval(1e-3L * y);
    if (std::abs(x) < 2.1e-3L) continue;  // else x and the sum are so close that their difference is exact
    EXPECT_GE((x - sum.lower) + 1e-3L * y, 0);
    EXPECT_LE((x - sum.upper) + 1e-3L * y, 0);
  }
  EXPECT_GT(rounded, 10000);
}

TEST(Interval, ElementaryFunctionsUndoEachOther) {
  Random random(5);
  for (int trial = 0; trial < 2000; ++trial) {
    const Interval x = uniform(random, 0, 1);
    const std::vector<Interval> same = {exp(log(x)),
                                        log(exp(x)),
                                        sin(asin(x)),
                                        asin(sin(x)),
                                        cos(acos(x)),
                                        acos(cos(x)),
                                        tan(atan(x)),
                                        atan(tan(x)),
                                        sinh(asinh(x)),
                                        asinh(sinh(x)),
                                        acosh(cosh(x)),
                                        tanh(atanh(x)),
                                        atanh(tanh(x)),
                                        square(sqrt(x)),
                                        pow(pow(x, 0.3L), 1 / 0.3L) + Interval(-1e-17L, 1e-17L),
                                        log2(Interval(2) * x) * log(Interval(2)) - log(Interval(2)) + x - log(x)};
    for (std::size_t i = 0; i < same.size(); ++i) {
      EXPECT_TRUE(within(x, same[i])) << i << " at " << static_cast<double>(x.lower);
      EXPECT_LE(same[i].upper - same[i].lower, 1e-9) << i << " at " << static_cast<double>(x.lower);
    }
    const Interval s = square(sin(x)) + square(cos(x));
    EXPECT_TRUE(s.contains(1));
  }
}

}  // namespace
}  // namespace bracket::scene
