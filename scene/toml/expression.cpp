// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/toml/expression.h"

#include <fmt/format.h>

#include <memory>

#include "scene/text.h"
#include "scene/toml/formula.h"

namespace bracket::scene {

namespace {

/// Whether there is a '=' that is not part of ==, !=, <=, >=: most likely == was meant.
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
  const auto refuse = [&] [[noreturn]] (const std::string& reason) {
    fail(Status::input, where, fmt::format("in the expression \"{}\": {}", formula, reason));
  };
  if (assigns(formula)) refuse("'=' assigns; compare with '=='");
  try {
    const auto steps = std::make_shared<const std::vector<Step>>(parse_formula(formula));
    return {[steps](const Vector<2>& at) { return evaluate(*steps, at[0], at[1]); },
            [steps](const Function<2>::Range& over) { return evaluate(*steps, over[0], over[1]); }};
  } catch (const std::string& reason) {
    refuse(reason);
  }
}

}  // namespace bracket::scene
