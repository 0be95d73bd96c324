// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <span>

#include "scene/toml/formula.h"
#include "scene/toml/functions.h"

namespace bracket::scene {

const std::array<Named, 21> functions = {{{"sin", std::sin, sin},
                                          {"cos", std::cos, cos},
                                          {"tan", std::tan, tan},
                                          {"asin", std::asin, asin},
                                          {"acos", std::acos, acos},
                                          {"atan", std::atan, atan},
                                          {"sinh", std::sinh, sinh},
                                          {"cosh", std::cosh, cosh},
                                          {"tanh", std::tanh, tanh},
                                          {"asinh", std::asinh, asinh},
                                          {"acosh", std::acosh, acosh},
                                          {"atanh", std::atanh, atanh},
                                          {"log2", std::log2, log2},
                                          {"log10", std::log10, log10},
                                          {"log", std::log, log},
                                          {"ln", std::log, log},
                                          {"exp", std::exp, exp},
                                          {"sqrt", std::sqrt, sqrt},
                                          {"abs", [](double v) { return v >= 0 ? v : -v; }, abs},
                                          {"sign", [](double v) { return v < 0   ? -1.0
                                                                         : v > 0 ? 1.0
                                                                                 : 0.0; }, sign},
                                          {"rint", [](double v) { return std::floor(v + 0.5); }, round}}};

namespace {

using Kind = Step::Kind;

double apply(const Named& function, double x) { return function.at(x); }
Jet apply(const Named& function, const Jet& x) { return function.over(x); }

double truth(bool holds) { return holds ? 1 : 0; }
const Jet& truth(const Jet& holds) { return holds; }

double both(double a, double b) { return truth(a != 0 && b != 0); }
double either(double a, double b) { return truth(a != 0 || b != 0); }
double min(double a, double b) { return std::min(a, b); }
double max(double a, double b) { return std::max(a, b); }

template <class Number> Number of_two(Kind kind, const Number& a, const Number& b) {
  using std::atan2, std::pow;
  switch (kind) {
    case Kind::add: return a + b;
    case Kind::subtract: return a - b;
    case Kind::multiply: return a * b;
    case Kind::divide: return a / b;
    case Kind::power: return pow(a, b);
    case Kind::less: return truth(a < b);
    case Kind::at_most: return truth(a <= b);
    case Kind::more: return truth(a > b);
    case Kind::at_least: return truth(a >= b);
    case Kind::equal: return truth(a == b);
    case Kind::unequal: return truth(a != b);
    case Kind::both: return both(a, b);
    case Kind::either: return either(a, b);
    default: return atan2(a, b);
  }
}

template <class Number> Number of_list(Kind kind, std::span<const Number> list) {
  Number result = list[0];
  for (const Number& next : list.subspan(1))
    result = kind == Kind::min ? min(result, next) : kind == Kind::max ? max(result, next) : Number(result + next);
  return kind == Kind::mean ? Number(result / Number(static_cast<double>(list.size()))) : result;
}

Jet chosen(const Jet& condition, const Jet& yes, const Jet& no) { return choose(condition, yes, no); }
double chosen(double condition, double yes, double no) { return choose(condition != 0, yes, no); }

template <class Number>
Number value_of(const std::vector<Step>& formula, const Number& x, const Number& y, const Number& z) {
  std::vector<Number> stack;
  stack.reserve(16);
  const auto replace = [&](std::size_t count, Number value) {
    stack.resize(stack.size() - count + 1);
    stack.back() = value;
  };
  for (const Step& step : formula) {
    const std::size_t size = stack.size();
    switch (step.kind) {
      case Kind::number: stack.push_back(step.number); break;
      case Kind::x: stack.push_back(x); break;
      case Kind::y: stack.push_back(y); break;
      case Kind::z: stack.push_back(z); break;
      case Kind::negate: stack.back() = -stack.back(); break;
      case Kind::function: stack.back() = apply(functions[step.index], stack.back()); break;
      case Kind::choose: replace(3, chosen(stack[size - 3], stack[size - 2], stack[size - 1])); break;
      case Kind::sum:
      case Kind::mean:
      case Kind::min:
      case Kind::max: replace(step.count, of_list<Number>(step.kind, std::span(stack).last(step.count))); break;
      default: replace(2, of_two(step.kind, stack[size - 2], stack[size - 1]));
    }
  }
  return stack.back();
}

}  // namespace

double evaluate(const std::vector<Step>& formula, double x, double y, double z) { return value_of(formula, x, y, z); }
Jet evaluate(const std::vector<Step>& formula, const Jet& x, const Jet& y, const Jet& z) {
  return value_of(formula, x, y, z);
}

}  // namespace bracket::scene
