// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/enclosure.h"

#include <gtest/gtest.h>

#include <random>

#include "bounds/certificate/double_enclosure.h"
#include "bounds/certificate/equilibrate.h"
#include "tests/bounds/certificate/rational.h"

namespace bracket::bounds {
namespace {

using scene::Enclosure;
using scene::exact_sum;
using scene::ExactSum;
using scene::LongSum;
using scene::Real;
namespace rounding = scene::rounding;

Rational least(const Enclosure& x) { return Rational(x.middle) - Rational(x.radius); }
Rational most(const Enclosure& x) { return Rational(x.middle) + Rational(x.radius); }
bool contains(const Enclosure& x, const Rational& value) { return least(x) <= value && value <= most(x); }

/// Real numbers and enclosures of all kinds and magnitudes.
class RandomReals {
 public:
  explicit RandomReals(unsigned seed) : generator_(seed) {}

  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(generator_); }
  bool one_in(int n) { return std::uniform_int_distribution<int>(1, n)(generator_) == 1; }
  /// 10^-e … 10^e, mostly with all digits, sometimes a small whole number.
  Real number(double e) {
    if (one_in(6)) return std::uniform_int_distribution<int>(-3, 3)(generator_);
    const Real digits = 1 + uniform(0, 1) + uniform(0, 1) * 0x1p-53L;
    return (one_in(2) ? 1 : -1) * digits * std::pow(10.0L, uniform(-e, e));
  }
  /// Exact, or with a radius that is tiny, moderate, or larger than the number.
  Enclosure enclosure(double e) {
    const Real middle = number(e);
    if (one_in(3)) return middle;
    return {middle, std::abs(one_in(4) ? number(e) : middle * std::pow(10.0L, uniform(-25, 1)))};
  }
  /// Real numbers within: both ends, the middle and one anywhere.
  std::array<Rational, 4> within(const Enclosure& x) {
    return {Rational(x.middle), least(x), most(x), Rational(x.middle) + Rational(uniform(-1, 1)) * Rational(x.radius)};
  }

 private:
  std::mt19937 generator_;
};

constexpr int trials = 600;

/// Runs through pairs of enclosures, close to each other and far from it, and all real numbers tried within them.
template <class Check> void for_pairs(double largest_exponent, const Check& check) {
  RandomReals random(1);
  for (int trial = 0; trial < trials; ++trial) {
    const double e = trial % 2 == 0 ? largest_exponent : 1;
    const Enclosure x = random.enclosure(e);
    Enclosure y = random.enclosure(e);
    if (random.one_in(5)) y.middle = -x.middle * (1 + (random.one_in(2) ? 0 : 4 * rounding::half_ulp));
    for (const Rational& a : random.within(x))
      for (const Rational& b : random.within(y)) check(x, y, a, b);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(Enclosure, holds_every_sum_difference_and_product) {
  for_pairs(300, [](const Enclosure& x, const Enclosure& y, const Rational& a, const Rational& b) {
    EXPECT_TRUE(contains(x + y, a + b));
    EXPECT_TRUE(contains(x - y, a - b));
    EXPECT_TRUE(contains(x * y, a * b));
    EXPECT_TRUE(contains(-x, -a));
  });
}

TEST(Enclosure, holds_every_quotient_or_says_that_it_cannot) {
  int refused = 0;
  for_pairs(300, [&](const Enclosure& x, const Enclosure& y, const Rational& a, const Rational& b) {
    const Enclosure quotient = x / y;
    if (b == 0 || contains(y, 0)) {
      EXPECT_FALSE(std::isfinite(quotient.radius));
      ++refused;
    } else if (std::isfinite(quotient.radius)) {
      EXPECT_TRUE(contains(quotient, a / b));
    }
  });
  EXPECT_GT(refused, 0);
}

TEST(Enclosure, holds_quotients_by_what_is_close_to_zero) {
  RandomReals random(2);
  int divided = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const Real middle = random.number(5);
    if (middle == 0) continue;
    ++divided;
    const Enclosure y(middle, std::abs(middle) * (1 - std::pow(2.0L, -random.uniform(1, 62))));
    const Enclosure x = random.enclosure(5), quotient = x / y;
    ASSERT_TRUE(std::isfinite(quotient.radius));
    for (const Rational& a : random.within(x))
      for (const Rational& b : random.within(y)) ASSERT_TRUE(contains(quotient, a / b));
  }
  EXPECT_GT(2 * divided, trials);
}

TEST(Enclosure, holds_every_square_root) {
  RandomReals random(3);
  int positive = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const Real middle = std::abs(random.number(300));
    if (middle == 0) continue;
    ++positive;
    const Enclosure x(middle, random.one_in(3) ? 0 : middle * std::pow(10.0L, random.uniform(-25, 0)));
    const Enclosure y = root(x);
    const Rational low = least(y), high = most(y);
    EXPECT_GT(high, 0);
    EXPECT_GE(high * high, most(x));
    if (low > 0) {
      EXPECT_LE(low * low, least(x));
    }
  }
  EXPECT_GT(2 * positive, trials);
}

TEST(Enclosure, loses_nothing_far_below_the_smallest_double) {
  const Enclosure tiny(std::numeric_limits<Real>::denorm_min()), small(1e-3000L, 1e-3020L);
  EXPECT_TRUE(contains(tiny * tiny, Rational(tiny.middle) * Rational(tiny.middle)));
  EXPECT_TRUE(contains(small * small, most(small) * most(small)));
  EXPECT_TRUE(contains(tiny / Enclosure(3), Rational(tiny.middle) / 3));
}

TEST(Enclosure, chains_of_operations_hold_the_exact_value) {
  RandomReals random(4);
  for (int trial = 0; trial < 300; ++trial) {
    Enclosure x = random.enclosure(10);
    Rational value = random.within(x)[3];
    for (int step = 0; step < 30; ++step) {
      const Enclosure y = random.enclosure(3);
      const Rational other = random.within(y)[3];
      switch (step % 4) {
        case 0:
          x += y;
          value += other;
          break;
        case 1:
          x = x * y;
          value *= other;
          break;
        case 2:
          x -= y;
          value -= other;
          break;
        default:
          if (certainly_non_negative(y) && y.middle > 2 * y.radius) x = x / y, value /= other;
      }
      ASSERT_TRUE(contains(x, value)) << "trial " << trial << ", step " << step;
    }
  }
}

TEST(Enclosure, exact_sums_and_products_with_zero_stay_exact) {
  std::mt19937 generator(5);
  std::uniform_int_distribution<int> whole(-1000000, 1000000);
  Enclosure sum;
  LongSum long_sum;
  long long expected = 0;
  for (int i = 0; i < 1000; ++i) {
    const int term = whole(generator);
    expected += term;
    sum += Enclosure(term) - Enclosure(0.0);
    long_sum.add(Enclosure(term));
  }
  EXPECT_EQ(sum.middle, expected);
  EXPECT_EQ(sum.radius, 0);
  EXPECT_EQ(long_sum.value().middle, expected);
  EXPECT_EQ(long_sum.value().radius, 0);
  EXPECT_TRUE((Enclosure(0.1) - Enclosure(0.1)).is_zero());
  EXPECT_TRUE((Enclosure(3, 1) * Enclosure()).is_zero());
  EXPECT_TRUE((Enclosure() / Enclosure(3, 1)).is_zero());
}

TEST(Enclosure, is_as_narrow_as_its_arithmetic) {
  // One operation: ½ ulp, and half of a thousandth of it for the radius itself.
  const Enclosure third = Enclosure(1) / Enclosure(3);
  EXPECT_LE(third.radius, 1.001L * rounding::half_ulp * third.middle);
  EXPECT_LE((third * Enclosure(0.1)).radius, 2.001L * rounding::half_ulp * third.middle / 10);
  EXPECT_LE(root(Enclosure(2)).radius, 1.001L * rounding::half_ulp * std::sqrt(2.0L));
}

/// In doubles, what an enclosure holds.
DoubleEnclosure in_doubles(const Enclosure& x) {
  const DoubleEnclosure result(x);
  const Enclosure back = result;
  EXPECT_TRUE(contains(back, least(x)) && contains(back, most(x)));
  return result;
}

TEST(DoubleEnclosure, holds_every_sum_difference_product_and_quotient) {
  int divided = 0, refused = 0;
  for_pairs(100, [&](const Enclosure& wide_x, const Enclosure& wide_y, const Rational& a, const Rational& b) {
    const DoubleEnclosure x = in_doubles(wide_x), y = in_doubles(wide_y);
    EXPECT_TRUE(contains(x + y, a + b));
    EXPECT_TRUE(contains(x - y, a - b));
    EXPECT_TRUE(contains(x * y, a * b));
    EXPECT_TRUE(contains(-x, -a));
    const DoubleEnclosure quotient = x / y;
    if (contains(y, 0)) {
      EXPECT_FALSE(std::isfinite(quotient.radius));
      ++refused;
    } else if (std::isfinite(quotient.radius)) {
      EXPECT_TRUE(contains(quotient, a / b));
      ++divided;
    }
  });
  EXPECT_GT(divided, trials);
  EXPECT_GT(refused, 0);
}

TEST(DoubleEnclosure, holds_every_rounding_of_exact_numbers) {
  RandomReals random(10);
  for (int trial = 0; trial < trials; ++trial) {
    const double a =
        static_cast<double>(random.number(trial % 2 == 0 ? 140 : 1)) * (1 + 0x1p-52 * random.uniform(0, 4));
    const double b = static_cast<double>(random.number(1));
    const DoubleEnclosure x(a), y(b);
    ASSERT_TRUE(contains(x + y, Rational(a) + Rational(b)));
    ASSERT_TRUE(contains(x * x, Rational(a) * Rational(a)));
    ASSERT_TRUE(contains(x * y, Rational(a) * Rational(b)));
    if (b != 0) {
      ASSERT_TRUE(contains(x / y, Rational(a) / Rational(b)));
    }
  }
  // The exact halves of two units in the last place.
  const DoubleEnclosure one(1), tie(0x1p-53);
  EXPECT_TRUE(contains(one + tie, 1 + Rational(0x1p-53L)));
  EXPECT_LE((one + tie).radius, 1.001 * 0x1p-53);
}

TEST(DoubleEnclosure, loses_nothing_where_doubles_underflow_and_is_no_number_where_they_overflow) {
  const double tiny = std::numeric_limits<double>::denorm_min(), largest = std::numeric_limits<double>::max();
  const DoubleEnclosure x(tiny), small(1e-200, 1e-215), large(largest);
  EXPECT_TRUE(contains(x * x, Rational(tiny) * Rational(tiny)));
  EXPECT_TRUE(contains(small * small, Rational(1e-200L) * Rational(1e-200L)));
  EXPECT_TRUE(contains(x / DoubleEnclosure(3), Rational(tiny) / 3));
  EXPECT_FALSE(std::isfinite((DoubleEnclosure(1) / x).radius));
  EXPECT_FALSE(std::isfinite((large * large).radius));
  EXPECT_FALSE(std::isfinite((large + large).radius));
  EXPECT_FALSE(std::isfinite(DoubleEnclosure(Enclosure(4e400L)).radius));
  EXPECT_FALSE(std::isfinite(DoubleEnclosure(Enclosure(std::numeric_limits<Real>::quiet_NaN())).radius));
}

TEST(DoubleEnclosure, chains_of_operations_hold_the_exact_value) {
  RandomReals random(11);
  for (int trial = 0; trial < 300; ++trial) {
    const Enclosure first = random.enclosure(10);
    DoubleEnclosure x = in_doubles(first);
    Rational value = random.within(first)[3];
    for (int step = 0; step < 30; ++step) {
      const Enclosure other = random.enclosure(3);
      const Rational own = random.within(other)[3];
      const DoubleEnclosure y = in_doubles(other);
      switch (step % 4) {
        case 0: x += y, value += own; break;
        case 1: x = x * y, value *= own; break;
        case 2: x -= y, value -= own; break;
        default:
          if (std::abs(y.middle) > 2 * y.radius) x = x / y, value /= own;
      }
      ASSERT_TRUE(contains(x, value)) << "trial " << trial << ", step " << step;
    }
  }
}

TEST(LongSum, holds_the_sum_and_does_not_widen_with_the_number_of_terms) {
  for (const int n : {10, 1000, 30000}) {
    RandomReals random(6);
    LongSum sum;
    Rational exact = 0;
    Real size = 0;
    for (int i = 0; i < n; ++i) {
      const Real term = random.uniform(0, 1) + random.uniform(0, 1) * 0x1p-53L;
      sum.add(term);
      exact += Rational(term);
      size += term;
    }
    EXPECT_TRUE(contains(sum.value(), exact));
    EXPECT_LE(sum.value().radius, 2 * rounding::half_ulp * size) << n;  // n·half_ulp/2 if simply added
  }
  RandomReals random(7);  // with radii, all magnitudes and cancellation
  for (int trial = 0; trial < 100; ++trial) {
    LongSum sum;
    Rational exact = 0;
    for (int i = 0; i < 50; ++i) {
      const Enclosure term = random.enclosure(20);
      const Rational value = random.within(term)[i % 4];
      sum.add(term);
      sum.add(-term);
      sum.add(term);
      exact += value;
    }
    EXPECT_TRUE(contains(sum.value(), exact));
  }
}

TEST(Enclosure, rounds_outwards_to_double) {
  RandomReals random(8);
  const auto largest = std::numeric_limits<double>::max();
  for (int trial = 0; trial < trials; ++trial) {
    const Enclosure x = random.enclosure(trial % 2 == 0 ? 300 : 2);
    EXPECT_GE(Rational(upper(x)), most(x));
    EXPECT_LE(Rational(lower(x)), least(x));
    EXPECT_GE(Rational(magnitude(x)), most(x));
    EXPECT_GE(Rational(magnitude(x)), -least(x));
    // no further than two steps of double
    const Real bound = x.middle + x.radius;
    EXPECT_LE(upper(x), bound + 2 * std::abs(bound) * std::numeric_limits<double>::epsilon() + 5e-324L);
    EXPECT_EQ(certainly_non_negative(x), least(x) >= 0);
  }
  EXPECT_EQ(upper(Enclosure(4e400L)), std::numeric_limits<double>::infinity());
  EXPECT_EQ(upper(Enclosure(-4e400L)), -largest);
  EXPECT_GT(upper(Enclosure(1e-3000L)), 0);
}

TEST(Enclosure, what_is_not_a_number_is_never_a_bound) {
  const Real nan = std::numeric_limits<Real>::quiet_NaN(), infinity = std::numeric_limits<Real>::infinity();
  for (const Enclosure& x : {Enclosure(nan), Enclosure(1, nan), Enclosure(infinity) - Enclosure(infinity)}) {
    EXPECT_FALSE(certainly_non_negative(x));
    EXPECT_FALSE(std::isfinite(upper(x + Enclosure(1))));
    EXPECT_FALSE(std::isfinite(lower(x * Enclosure(2))));
  }
  EXPECT_FALSE(std::isfinite(upper(root(Enclosure(-1)))));
  EXPECT_FALSE(std::isfinite(upper(Enclosure(1) / Enclosure())));
}

TEST(Solution, holds_the_solution_of_every_system_within) {
  RandomReals random(9);
  int solved = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t n = 1 + trial % 6;
    const double width = trial % 3 == 0 ? 0 : std::pow(10.0, random.uniform(-20, -4));
    std::vector<std::vector<Enclosure>> a(n, std::vector<Enclosure>(n));
    std::vector<std::vector<Exact>> exact_a(n, std::vector<Exact>(n));
    std::vector<Enclosure> b(n);
    std::vector<Exact> exact_b(n);
    const auto draw = [&](Enclosure& x, Exact& value) {
      x = Enclosure(random.uniform(-1, 1), width);
      value = Exact(random.within(x)[trial % 4]);
    };
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) draw(a[i][j], exact_a[i][j]);
      draw(b[i], exact_b[i]);
    }
    const auto x = solution(a, b);
    if (width < 1e-8) {
      ASSERT_TRUE(x);
    }
    if (!x) continue;
    ++solved;
    const auto exact = solution(exact_a, exact_b);
    ASSERT_TRUE(exact);
    for (std::size_t i = 0; i < n; ++i) EXPECT_TRUE(contains((*x)[i], (*exact)[i].value)) << trial;
  }
  EXPECT_GT(solved, 100);
}

TEST(Solution, refuses_what_may_be_singular) {
  const Enclosure one(1), zero, about_one(1, 0.5);
  const Enclosure nan(std::numeric_limits<Real>::quiet_NaN());
  EXPECT_FALSE(solution({{one, one}, {one, one}}, {one, one}));
  EXPECT_FALSE(solution({{zero, zero}, {zero, zero}}, {zero, zero}));
  EXPECT_FALSE(solution({{about_one, one}, {one, one}}, {one, one}));
  EXPECT_FALSE(solution({{nan, one}, {one, one}}, {zero, zero}));
  EXPECT_FALSE(solution({{one, zero}, {zero, one}}, {nan, one}));
}

}  // namespace
}  // namespace bracket::bounds
