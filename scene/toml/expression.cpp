// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/toml/expression.h"

#include <fmt/format.h>
#include <muParser.h>

#include <memory>
#include <numbers>

#include "scene/text.h"

namespace bracket::scene {

namespace {

struct Formula {
  mu::Parser parser;
  double x = 0, y = 0;  // the parser holds their addresses: a Formula stays where it was made
};

/// Whether there is a '=' that is not part of ==, !=, <=, >=: muParser would assign, and most likely == was meant.
bool assigns(const std::string& formula) {
  for (std::size_t i = 0; i < formula.size(); ++i) {
    if (formula[i] != '=') continue;
    if (i + 1 < formula.size() && formula[i + 1] == '=') {
      ++i;
    } else if (i == 0 || std::string_view("!<>").find(formula[i - 1]) == std::string_view::npos) {
      return true;
    }
  }
  return false;
}

}  // namespace

Function<2> parse_expression(const std::string& formula, const std::string& where) {
  const auto refuse = [&](const std::string& reason) {
    fail(Status::input, where, fmt::format("in the expression \"{}\": {}", formula, reason));
  };
  if (assigns(formula)) refuse("'=' assigns; compare with '=='");
  auto compiled = std::make_shared<Formula>();
  try {
    compiled->parser.DefineVar("x", &compiled->x);
    compiled->parser.DefineVar("y", &compiled->y);
    compiled->parser.DefineConst("pi", std::numbers::pi);
    compiled->parser.DefineConst("e", std::numbers::e);
    compiled->parser.SetExpr(formula);
    compiled->parser.Eval();  // only this finds unknown names
  } catch (const mu::ParserError& error) {
    refuse(error.GetMsg());
  }
  if (compiled->parser.GetNumResults() != 1) refuse("one value is expected, not a list");
  return [compiled](const Vector<2>& point) {
    compiled->x = point[0];
    compiled->y = point[1];
    return compiled->parser.Eval();
  };
}

}  // namespace bracket::scene
