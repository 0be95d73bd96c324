// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/report/report.h"

/// What sheet.html and sheet.json say alike.
namespace bracket::apps {

/// How the guaranteed relative error falls.
struct Order {
  double by_cells;  ///< it goes like cells to this power
  double by_size;   ///< and like h to this one, h = 1/√cells the mean size of a cell
};
/// Nothing where three levels do not say, or the error is rounding.
std::optional<Order> order_of(const Report& report);

/// The middle of an interval and how far the exact value can be from it, rounded up; nothing where an end is missing.
struct Uncertain {
  double value;
  double uncertainty;
};
std::optional<Uncertain> uncertain(double lower, double upper);

/// What is said of one thing.
struct Line {
  std::string what, said;
};

/// What is solved: the mathematical model.
std::string model(const Report& report);
/// How it is solved: degrees, meshes, when the run ends.
std::string method(const Report& report);
/// What is certain of the interval, in words.
std::string certainty(const Report& report);
/// What the data and the geometry of the meshes change.
std::vector<Line> costs(const Report& report);
/// What the calculation does not say.
std::vector<Line> outside();

}  // namespace bracket::apps
