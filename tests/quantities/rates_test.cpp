// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/quantities/asked.h"
#include "tests/support/sanitized.h"

// How fast widths fall (docs/theory.md §10.2), on the two blocks of §9.2.
namespace bracket::tests {
namespace {

struct Rate {
  double order = 0;  ///< of the quantity's width in the energy's, over the levels with 100 cells and more
  int cells = 0;     ///< of the level next to 1 700
  double width = 0;  ///< of the quantity on it
};

Rate rate_of(double pull) {
  auto scene = two_blocks(4, pull);
  const auto outcome = outcome_of(scene, {along(quantity(QuantityKind::displacement, "upper.top"), 0, 1)},
                                  {.strategy = scene::Strategy::adaptive, .max_cells = 4500});
  const auto& levels = outcome.quantities.at(0).levels;
  EXPECT_EQ(levels.size(), outcome.levels.size());
  Rate rate;
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double width = levels[i].upper - levels[i].lower;
    if (std::abs(levels[i].cells - 1700) < std::abs(rate.cells - 1700)) {
      rate.cells = levels[i].cells;
      rate.width = width;
    }
    if (levels[i].cells < 100) continue;
    const double a = std::log(outcome.levels[i].bracket.upper - outcome.levels[i].bracket.lower), b = std::log(width);
    n += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  rate.order = (n * xy - x * y) / (n * xx - x * x);
  return rate;
}

using OpenContact = Long;
using QuantityRates = Long;

// A free contact boundary moves: the order is about ⅔ in the energy's width.
TEST_F(QuantityRates, with_lift_off) {
  const Rate rate = rate_of(0.09);
  EXPECT_GE(rate.order, 0.6);
  EXPECT_LE(rate.width * std::pow(rate.cells / 1700.0, 4.0 / 3), 1.2e-4) << rate.cells;
}

// A closed contact does not: the order is that of the energy.
TEST_F(QuantityRates, with_closed_contact) {
  const Rate rate = rate_of(0.02);
  EXPECT_GE(rate.order, 0.95);
  EXPECT_LE(rate.width * std::pow(rate.cells / 1700.0, 2.0), 3e-6) << rate.cells;
}

// Right of the middle the contact is open. By the gap that is left there the force is at most 0.3 % of all, guaranteed.
TEST_F(OpenContact, carries_little) {
  auto force = quantity(QuantityKind::force, "upper.bottom");
  force.stretch = scene::LineStretch{0, 0.5};  // from the right end
  const auto outcome =
      outcome_of(two_blocks(4), {force}, {.strategy = scene::Strategy::adaptive, .bulk = 0.3, .max_cells = 760});
  const auto& last = outcome.quantities.at(0).levels.back();
  EXPECT_LE(last.cells, 760);
  EXPECT_EQ(last.lower, 0);
  EXPECT_LE(last.upper, 0.003 * 0.005);
}

}  // namespace
}  // namespace bracket::tests
