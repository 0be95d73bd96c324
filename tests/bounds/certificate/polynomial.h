// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <map>

#include "tests/bounds/certificate/rational.h"

namespace bracket::bounds {

/// A polynomial in the barycentric coordinates of a triangle (3 variables) or a segment (2), all terms of one degree:
/// their sum is 1, so that any degree can be raised.
class Polynomial {
 public:
  explicit Polynomial(int variables = 3) : variables_(variables) {}

  static Polynomial constant(int variables, const Exact& value) {
    Polynomial result(variables);
    result.terms_[{0, 0, 0}] = value;
    return result;
  }
  /// \param values at the corners
  static Polynomial linear(const std::vector<Exact>& values) {
    Polynomial result(static_cast<int>(values.size()));
    result.degree_ = 1;
    for (std::size_t k = 0; k < values.size(); ++k) {
      std::array<int, 3> powers = {0, 0, 0};
      powers[k] = 1;
      result.terms_[powers] = values[k];
    }
    return result;
  }
  static Polynomial monomial(int variables, const std::array<int, 3>& powers, const Exact& factor) {
    Polynomial result(variables);
    result.degree_ = powers[0] + powers[1] + powers[2];
    result.terms_[powers] = factor;
    return result;
  }

  int degree() const { return degree_; }
  bool is_zero() const {
    return std::ranges::all_of(terms_, [](const auto& term) { return bounds::is_zero(term.second); });
  }

  Polynomial raised(int degree) const {
    Polynomial result = *this;
    while (result.degree_ < degree) {
      Polynomial next(variables_);
      next.degree_ = result.degree_ + 1;
      for (const auto& [powers, factor] : result.terms_)
        for (int k = 0; k < variables_; ++k) {
          std::array<int, 3> more = powers;
          ++more[k];
          next.terms_[more] += factor;
        }
      result = next;
    }
    return result;
  }

  friend Polynomial operator+(const Polynomial& a, const Polynomial& b) {
    const int degree = std::max(a.degree_, b.degree_);
    Polynomial result = a.raised(degree);
    result.degree_ = degree;
    for (const auto& [powers, factor] : b.raised(degree).terms_) result.terms_[powers] += factor;
    return result;
  }
  friend Polynomial operator*(const Exact& s, Polynomial a) {
    for (auto& term : a.terms_) term.second = s * term.second;
    return a;
  }
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + Exact(-1) * b; }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial result(a.variables_);
    result.degree_ = a.degree_ + b.degree_;
    for (const auto& [p, x] : a.terms_)
      for (const auto& [q, y] : b.terms_) result.terms_[{p[0] + q[0], p[1] + q[1], p[2] + q[2]}] += x * y;
    return result;
  }

  /// By one coordinate, as if they were independent.
  Polynomial derivative(int k) const {
    Polynomial result(variables_);
    result.degree_ = std::max(0, degree_ - 1);
    for (const auto& [powers, factor] : terms_) {
      if (powers[k] == 0) continue;
      std::array<int, 3> less = powers;
      --less[k];
      result.terms_[less] += Exact(powers[k]) * factor;
    }
    return result;
  }

  /// The mean: of a monomial d! ∏ powers! / (degree + d)!.
  Exact mean() const {
    Exact sum;
    for (const auto& [powers, factor] : terms_)
      sum += factor * factorial(powers[0]) * factorial(powers[1]) * factorial(powers[2]);
    return sum * factorial(variables_ - 1) / factorial(degree_ + variables_ - 1);
  }

  /// Whether some Bernstein coefficient is > 0.
  bool has_positive() const {
    return std::ranges::any_of(terms_, [](const auto& term) { return term.second > Exact(0); });
  }
  /// By the sizes of its coefficients: not less than the size of the polynomial.
  Polynomial with_sizes() const {
    Polynomial result = *this;
    for (auto& term : result.terms_)
      if (term.second < Exact(0)) term.second = -term.second;
    return result;
  }
  /// One of the halves of a segment, in its own two coordinates.
  Polynomial half_of_segment(int which) const {
    const Exact half = Exact(1) / Exact(2);
    Polynomial result(2);
    // Coordinate k runs from its value at one end of the half to that at the other.
    const std::array<Polynomial, 2> coordinates = {
        linear({which == 0 ? Exact(1) : half, which == 0 ? half : Exact(0)}),
        linear({which == 0 ? Exact(0) : half, which == 0 ? half : Exact(1)})};
    for (const auto& [powers, factor] : terms_) {
      Polynomial product = constant(2, factor);
      for (int k = 0; k < 2; ++k)
        for (int i = 0; i < powers[k]; ++i) product = product * coordinates[k];
      result = result + product;
    }
    return result;
  }

  /// Whether all Bernstein coefficients are ≤ 0: then so is the polynomial.
  bool is_not_positive() const {
    return std::ranges::all_of(terms_, [](const auto& term) { return !(term.second > Exact(0)); });
  }

  /// On the side from corner i to corner j, in its own two coordinates.
  Polynomial on_side(int i, int j) const {
    Polynomial result(2);
    result.degree_ = degree_;
    for (const auto& [powers, factor] : terms_)
      if (powers[3 - i - j] == 0) result.terms_[{powers[i], powers[j], 0}] += factor;
    return result;
  }
  Polynomial reversed() const {
    Polynomial result(2);
    result.degree_ = degree_;
    for (const auto& [powers, factor] : terms_) result.terms_[{powers[1], powers[0], 0}] = factor;
    return result;
  }

  /// The value at an end of a segment.
  Exact at_end(int end) const {
    std::array<int, 3> powers = {0, 0, 0};
    powers[end] = degree_;
    const auto found = terms_.find(powers);
    return found == terms_.end() ? Exact() : found->second;
  }

  /// With its coordinates as functions of others.
  Polynomial of(const std::array<Polynomial, 3>& coordinates) const {
    Polynomial result(3);
    for (const auto& [powers, factor] : terms_) {
      Polynomial product = constant(3, factor);
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < powers[k]; ++i) product = product * coordinates[k];
      result = result + product;
    }
    return result;
  }

 private:
  static Exact factorial(int n) {
    Rational result = 1;
    for (int i = 2; i <= n; ++i) result *= i;
    return Exact(result);
  }

  int variables_;
  int degree_ = 0;
  std::map<std::array<int, 3>, Exact> terms_;
};

inline bool is_zero(const Polynomial& p) { return p.is_zero(); }

}  // namespace bracket::bounds
