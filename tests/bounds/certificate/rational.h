// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <vector>

namespace bracket::bounds {

/// By GMP, which takes a fraction of the time of Boost's own, most of it common divisors, and which no sanitizer slows.
using Rational = boost::multiprecision::mpq_rational;

/// A rational number, with all that the certificate asks of a `Number`; nothing is ever rounded. A class of its own, so
/// that the certificate's templates find the functions below by their argument.
struct Exact {
  Rational value = 0;

  Exact() = default;
  explicit Exact(int x) : value(x) {}
  explicit Exact(double x) : value(x) {}
  explicit Exact(Rational x) : value(std::move(x)) {}
};

inline Exact operator-(const Exact& x) { return Exact(Rational(-x.value)); }
inline Exact operator+(const Exact& x, const Exact& y) { return Exact(Rational(x.value + y.value)); }
inline Exact operator-(const Exact& x, const Exact& y) { return Exact(Rational(x.value - y.value)); }
inline Exact operator*(const Exact& x, const Exact& y) { return Exact(Rational(x.value * y.value)); }
inline Exact operator*(double x, const Exact& y) { return Exact(x) * y; }
/// \throw std::overflow_error for y = 0
inline Exact operator/(const Exact& x, const Exact& y) { return Exact(Rational(x.value / y.value)); }
inline Exact& operator+=(Exact& x, const Exact& y) { return x = x + y; }
inline Exact& operator-=(Exact& x, const Exact& y) { return x = x - y; }
inline bool operator==(const Exact& x, const Exact& y) { return x.value == y.value; }
inline auto operator<=>(const Exact& x, const Exact& y) { return x.value.compare(y.value) <=> 0; }
inline bool is_zero(const Exact& x) { return x.value.is_zero(); }
inline bool certainly_non_negative(const Exact& x) { return x.value >= 0; }
/// The double next to it toward zero.
inline double rounded(const Exact& x) { return x.value.convert_to<double>(); }
/// The least double that is not less.
inline double upper(const Exact& x) {
  const double near = rounded(x);
  return Rational(near) < x.value ? std::nextafter(near, std::numeric_limits<double>::infinity()) : near;
}
inline std::ostream& operator<<(std::ostream& out, const Exact& x) { return out << "about " << rounded(x); }

/// \throw std::domain_error where x is not the square of a rational number
inline Exact root(const Exact& x) {
  if (x.value < 0) throw std::domain_error("root of a negative number");
  const boost::multiprecision::mpz_int over = numerator(x.value), under = denominator(x.value);
  const Rational value(sqrt(over), sqrt(under));
  if (value * value != x.value) throw std::domain_error("the root is irrational");
  return Exact(value);
}

/// A x = b by Gaussian elimination. \return nothing where A is singular
inline std::optional<std::vector<Exact>> solution(std::vector<std::vector<Exact>> a, std::vector<Exact> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && is_zero(a[pivot][k])) ++pivot;
    if (pivot == n) return {};
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || is_zero(a[i][k])) continue;
      const Exact factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = 0; k < n; ++k) b[k] = b[k] / a[k][k];
  return b;
}

struct RationalSum {
  void add(const Exact& term) { sum += term; }
  Exact value() const { return sum; }
  Exact sum;
};

}  // namespace bracket::bounds
