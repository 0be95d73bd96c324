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

template <int dim> Function<dim> parse_expression(const std::string& formula, const std::string& where) {
  const auto refuse = [&] [[noreturn]] (const std::string& reason) {
    fail(Status::input, where, fmt::format("in the expression \"{}\": {}", formula, reason));
  };
  if (assigns(formula)) refuse("'=' assigns; compare with '=='");
  try {
    const auto steps = std::make_shared<const std::vector<Step>>(parse_formula(formula, dim));
    const auto of = [steps](const auto& x) {
      if constexpr (dim == 2)
        return evaluate(*steps, x[0], x[1]);
      else
        return evaluate(*steps, x[0], x[1], x[2]);
    };
    return {[of](const Vector<dim>& x) -> double { return of(x); },
            [of](const typename Function<dim>::Range& x) -> Jet { return of(x); }};
  } catch (const std::string& reason) {
    refuse(reason);
  }
}

template Function<2> parse_expression<2>(const std::string&, const std::string&);
template Function<3> parse_expression<3>(const std::string&, const std::string&);

}  // namespace bracket::scene
