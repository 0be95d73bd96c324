// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/toml/formula.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "scene/text.h"
#include "scene/toml/functions.h"

namespace bracket::scene {

namespace {

using Kind = Step::Kind;

struct Of {
  const char* name;
  Kind kind;
};
/// Functions of two arguments, and of any number.
constexpr std::array<Of, 5> lists = {
    {{"atan2", Kind::atan2}, {"sum", Kind::sum}, {"avg", Kind::mean}, {"min", Kind::min}, {"max", Kind::max}}};

struct Operator {
  std::string_view sign;
  Kind kind;
  int level;  ///< higher ones bind tighter
};
constexpr std::array<Operator, 12> operators = {{{"||", Kind::either, 1},
                                                 {"&&", Kind::both, 2},
                                                 {"==", Kind::equal, 3},
                                                 {"!=", Kind::unequal, 3},
                                                 {"<=", Kind::at_most, 3},
                                                 {">=", Kind::at_least, 3},
                                                 {"<", Kind::less, 3},
                                                 {">", Kind::more, 3},
                                                 {"+", Kind::add, 4},
                                                 {"-", Kind::subtract, 4},
                                                 {"*", Kind::multiply, 5},
                                                 {"/", Kind::divide, 5}}};

std::vector<std::string> known_names(int dim) {
  std::vector<std::string> names = {"x", "y", "pi", "e"};
  if (dim == 3) names.insert(names.begin() + 2, "z");
  for (const Named& function : functions) names.emplace_back(function.name);
  for (const Of& list : lists) names.emplace_back(list.name);
  return names;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// By recursive descent. Blanks are whatever is not printed.
class Parser {
 public:
  Parser(const std::string& text, int dim) : rest_(text), dim_(dim) {}

  std::vector<Step> formula() {
    if (at_end()) throw std::string("it is empty");
    choice();
    if (begins(",")) throw std::string("one value is expected, not a list");
    if (begins(")")) throw std::string("there is a ')' without its '('");
    if (begins(":")) throw std::string("there is a ':' without its '?'");
    if (!at_end()) throw fmt::format("an operator is expected before '{}'", rest_);
    return std::move(steps_);
  }

 private:
  std::string_view rest_;
  std::vector<Step> steps_;
  int dim_;
  int depth_ = 0;

  bool at_end() {
    while (!rest_.empty() && static_cast<unsigned char>(rest_.front()) <= ' ') rest_.remove_prefix(1);
    return rest_.empty();
  }
  bool begins(std::string_view sign) {
    at_end();
    return rest_.substr(0, sign.size()) == sign;
  }
  bool take(std::string_view sign) {
    if (!begins(sign)) return false;
    rest_.remove_prefix(sign.size());
    return true;
  }
  [[noreturn]] void expected(const char* what) {
    throw at_end() ? fmt::format("{} is expected at its end", what)
                   : fmt::format("{} is expected before '{}'", what, rest_);
  }
  void enter() {
    constexpr int deepest = 200;
    if (++depth_ > deepest) throw std::string("it is nested too deeply");
  }
  void leave() { --depth_; }

  void choice() {
    enter();
    binary(1);
    if (take("?")) {
      choice();
      if (!take(":")) expected("':' and a value for where the condition does not hold");
      choice();
      steps_.push_back({Kind::choose});
    }
    leave();
  }

  void binary(int loosest) {
    signed_power();
    while (true) {
      const auto* next =
          std::find_if(operators.begin(), operators.end(), [&](const Operator& o) { return begins(o.sign); });
      if (next == operators.end() || next->level < loosest) return;
      take(next->sign);
      binary(next->level + 1);
      steps_.push_back({next->kind});
    }
  }

  void signed_power() {
    enter();
    const bool minus = take("-");
    if (minus || take("+")) {
      if (begins("-") || begins("+")) throw std::string("there are two signs in a row; write brackets between them");
    }
    operand();
    if (take("^")) {
      signed_power();
      steps_.push_back({Kind::power});
    }
    if (minus) steps_.push_back({Kind::negate});
    leave();
  }

  void operand() {
    if (at_end()) expected("a value");
    const char first = rest_.front();
    if (take("(")) {
      choice();
      if (begins(",")) throw std::string("a list is expected in the brackets of functions only");
      if (!take(")")) expected("')'");
    } else if (is_digit(first) || first == '.') {
      number();
    } else if (is_letter(first)) {
      name();
    } else {
      expected("a value");
    }
  }

  void number() {
    double value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    const std::string_view digits = rest_.substr(0, end - rest_.data());
    if (error == std::errc::invalid_argument) expected("a value");
    if (error == std::errc::result_out_of_range) value = out_of_range(digits);
    rest_.remove_prefix(digits.size());
    steps_.push_back({Kind::number, value});
  }
  /// A number as small as 1e-400 is 0.
  static double out_of_range(std::string_view digits) {
    const double value = std::strtod(std::string(digits).c_str(), nullptr);
    if (std::isinf(value)) throw fmt::format("the number {} is too large", digits);
    return value;
  }

  void name() {
    std::size_t size = 1;
    while (size < rest_.size() && (is_letter(rest_[size]) || is_digit(rest_[size]))) ++size;
    const std::string own(rest_.substr(0, size));
    rest_.remove_prefix(size);
    if (own == "x") return steps_.push_back({Kind::x});
    if (own == "y") return steps_.push_back({Kind::y});
    if (own == "z" && dim_ == 3) return steps_.push_back({Kind::z});
    if (own == "pi" || own == "_pi") return steps_.push_back({Kind::number, std::numbers::pi});
    if (own == "e" || own == "_e") return steps_.push_back({Kind::number, std::numbers::e});
    const auto is_own = [&](const auto& entry) { return own == entry.name; };
    const auto* function = std::find_if(functions.begin(), functions.end(), is_own);
    const auto* list = std::find_if(lists.begin(), lists.end(), is_own);
    if (function == functions.end() && list == lists.end())
      throw fmt::format("unknown name '{}'; {}", own, suggestion(own, known_names(dim_)));
    const int count = arguments(own);
    if (function != functions.end()) {
      check_count(own, count, 1);
      steps_.push_back({.kind = Kind::function, .index = static_cast<int>(function - functions.begin())});
    } else {
      if (list->kind == Kind::atan2) check_count(own, count, 2);
      steps_.push_back({.kind = list->kind, .count = count});
    }
  }

  static void check_count(const std::string& function, int given, int needed) {
    if (given != needed)
      throw fmt::format("{} has {} argument{}, given {}", function, needed, needed == 1 ? "" : "s", given);
  }

  int arguments(const std::string& function) {
    if (!take("(")) throw fmt::format("'(' is expected after {}", function);
    int count = 0;
    do {
      choice();
      ++count;
    } while (take(","));
    if (!take(")")) expected("')'");
    return count;
  }
};

}  // namespace

std::vector<Step> parse_formula(const std::string& text, int dim) { return Parser(text, dim).formula(); }

}  // namespace bracket::scene
