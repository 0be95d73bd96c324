// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "scene/jet.h"

/// Formulas in x and y, in space in z as well. From the loosest to the tightest: `c ? a : b`, `||`, `&&`, comparisons,
/// `+ -`, `* /`, signs,
/// `^`, which groups from the right; the others group from the left. So −2^2 is −4, as in muParser, whose language
/// this is: 0 is false, every other value true.
namespace bracket::scene {

/// One step of a formula's evaluation on a stack.
struct Step {
  enum class Kind {
    number,
    x,
    y,
    z,
    negate,
    add,
    subtract,
    multiply,
    divide,
    power,
    less,
    at_most,
    more,
    at_least,
    equal,
    unequal,
    both,
    either,
    choose,
    function,  ///< of one argument: entry `index` of the table
    atan2,
    sum,
    mean,
    min,
    max  ///< of `count` arguments
  };
  Kind kind;
  double number = 0;
  int index = 0;
  int count = 0;
};

/// \throw std::string, what is wrong: not one formula, an unknown name, an assignment, nested deeper than 200
/// \param dim 2: a z is an unknown name
std::vector<Step> parse_formula(const std::string& text, int dim = 2);

double evaluate(const std::vector<Step>& formula, double x, double y, double z = 0);
Jet evaluate(const std::vector<Step>& formula, const Jet& x, const Jet& y, const Jet& z = Jet(0));

}  // namespace bracket::scene
