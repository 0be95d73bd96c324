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
  double by_size;   ///< and like h to this one, h the mean size of a cell: h² or, in space, h³ = 1/cells
};
/// Nothing where three levels do not say, or the error is rounding.
template <int dim> std::optional<Order> order_of(const ReportOf<dim>& report);

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
template <int dim> std::string model(const ReportOf<dim>& report);
/// How it is solved: degrees, meshes, when the run ends.
template <int dim> std::string method(const ReportOf<dim>& report);
/// What is certain of the interval, in words.
template <int dim> std::string certainty(const ReportOf<dim>& report);
/// What the data and the geometry of the meshes change.
template <int dim> std::vector<Line> costs(const ReportOf<dim>& report);
/// What the calculation does not say.
template <int dim> std::vector<Line> outside();

}  // namespace bracket::apps
