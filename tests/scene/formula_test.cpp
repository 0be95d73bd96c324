// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/toml/formula.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bracket::scene {
namespace {

double value(const std::string& formula, double x = 0, double y = 0) { return evaluate(parse_formula(formula), x, y); }

std::string reason(const std::string& formula) {
  try {
    parse_formula(formula);
  } catch (const std::string& why) {
    return why;
  }
  return "";
}

TEST(Formula, OperatorsBindAsInMuParser) {
  EXPECT_EQ(value("-2^2"), -4);
  EXPECT_EQ(value("2^3^2"), 512);
  EXPECT_EQ(value("2^-2^2"), 1.0 / 16);
  EXPECT_EQ(value("2^-1*4"), 2);
  EXPECT_EQ(value("2*-3^2"), -18);
  EXPECT_EQ(value("8/4/2 - 1 - 1"), -1);
  EXPECT_EQ(value("2--2"), 4);
  EXPECT_EQ(value("1 + 2 * 3 < 7 == 0"), 1);
  EXPECT_EQ(value("3 < 2 < 1"), 1);
  EXPECT_EQ(value("1 || 1 && 0"), 1);
  EXPECT_EQ(value("0 ? 1 : 0 ? 2 : 3"), 3);
  EXPECT_EQ(value("1 ? 1 ? 2 : 3 : 4"), 2);
  EXPECT_EQ(value("1 + 1 ? 2 : 3"), 2);
  EXPECT_EQ(value("x <= y ? x != y : -x", 1, 2), 1);
}

TEST(Formula, FunctionsAndNumbersAreThoseOfMuParser) {
  EXPECT_EQ(value("1.e1 + .5 + 2e-1"), 10 + .5 + .2);
  EXPECT_EQ(value("1e-400"), 0);
  EXPECT_EQ(value("rint(2.5) + 10 * rint(-2.5)"), -17);
  EXPECT_EQ(value("sign(-3) + sign(0) + 10 * abs(-2)"), 19);
  EXPECT_EQ(value("min(3, 1, 2) + 10 * max(1, 3, 2) + 100 * sum(1, 2) + 1000 * avg(1, 2)"), 1831);
  EXPECT_EQ(value("atan2(1, -1)"), std::atan2(1, -1));
  EXPECT_EQ(value("log(x) - ln(x) + log10(1000) + log2(8)", 7), 6);
  EXPECT_EQ(value("sin(pi * x) + e^y", 0.5, 1), 1 + std::numbers::e);
  EXPECT_EQ(value("3 && 0.25"), 1);  // muParser cuts constants here to whole numbers
  EXPECT_TRUE(std::isnan(value("sqrt(-1)")));
}

TEST(Formula, WhatIsNoFormulaIsNamed) {
  const std::vector<std::array<std::string, 2>> cases = {{"", "empty"},
                                                         {"  ", "empty"},
                                                         {"sinn(x)", "did you mean 'sin'"},
                                                         {"z", "unknown name 'z'"},
                                                         {"1, 2", "list"},
                                                         {"(1, 2)", "list"},
                                                         {"1 +", "a value is expected at its end"},
                                                         {"* 2", "before '* 2'"},
                                                         {"--1", "two signs"},
                                                         {"(1", "')' is expected"},
                                                         {"1)", "without its '('"},
                                                         {"1 ? 2", "':'"},
                                                         {"1 : 2", "without its '?'"},
                                                         {"sin", "'(' is expected after sin"},
                                                         {"sin()", "a value"},
                                                         {"sin(1, 2)", "sin has 1 argument, given 2"},
                                                         {"atan2(1)", "atan2 has 2 arguments, given 1"},
                                                         {"2x", "operator is expected before 'x'"},
                                                         {"x y", "operator is expected before 'y'"},
                                                         {"!x", "before '!x'"},
                                                         {"1e400", "too large"},
                                                         {"x % 2", "before '% 2'"},
                                                         {std::string(1000, '('), "nested too deeply"}};
  for (const auto& [formula, named] : cases)
    EXPECT_NE(reason(formula).find(named), std::string::npos) << formula << ": " << reason(formula);
}

}  // namespace
}  // namespace bracket::scene
