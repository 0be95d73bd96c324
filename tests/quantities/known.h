// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "bounds/bounds.h"

/// Quantities of scenes whose solution is known.
namespace bracket::tests {

template <int dim> struct KnownQuantity {
  scene::Quantity<dim> quantity;
  double value;
  double width;  ///< at most, of the last level
};

template <int dim> std::vector<scene::Quantity<dim>> quantities_of(const std::vector<KnownQuantity<dim>>& known) {
  std::vector<scene::Quantity<dim>> asked;
  for (const auto& one : known) asked.push_back(one.quantity);
  return asked;
}

/// The exact values are in the intervals of all levels of a run that was asked for them in this order.
template <int dim>
void expect_inside(const bounds::Outcome<dim>& outcome, const std::vector<KnownQuantity<dim>>& known,
                   std::size_t levels) {
  ASSERT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
  ASSERT_EQ(outcome.quantities.size(), known.size());
  for (std::size_t i = 0; i < known.size(); ++i) {
    const auto& interval = outcome.quantities[i];
    SCOPED_TRACE(interval.name);
    EXPECT_EQ(interval.reason, "");
    ASSERT_EQ(interval.levels.size(), levels);
    // The exact value is known in doubles only.
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(known[i].value), 1e-3);
    for (const auto& level : interval.levels) {
      EXPECT_LE(level.lower, known[i].value + rounding) << level.cells;
      EXPECT_GE(level.upper, known[i].value - rounding) << level.cells;
    }
    EXPECT_LE(interval.upper - interval.lower, known[i].width);
  }
}

}  // namespace bracket::tests
