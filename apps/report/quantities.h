// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "apps/report/report.h"

/// Quantities as they are told.
namespace bracket::apps {

/// The decimal numbers with their last digits at one place between which an interval is enclosed, so that they widen it
/// by no more than a tenth, or by their fifteenth digit. \pre finite, lower ≤ upper
struct Decimals {
  std::string lower, upper;
};
Decimals enclosed_in_decimals(double lower, double upper);

/// An interval as people see it, rounded outward: "412.31 … 412.38 N", "at least 3 N", "at most 4 N"; where its ends
/// are one number, that. \param unit with a blank in front, or empty   \pre an end is finite
std::string interval_text(double lower, double upper, const std::string& unit);

/// What a quantity is, without its name: "412.31 … 412.38 N   ± 0.008 %", the latter being half its width by its size;
/// or what is missing. \param quantity index into Outcome::quantities
template <int dim> std::string told(const ReportOf<dim>& report, std::size_t quantity);
/// The same of an energy, in the plane by thickness.
template <int dim> std::string told_energy(const ReportOf<dim>& report, double lower, double upper);

/// The mark of what is guaranteed, the name and what it is, a line for each quantity that was asked for by name.
/// \param columns for the names at least
template <int dim> std::string quantity_lines(const ReportOf<dim>& report, std::size_t columns);

/// A text as a field of CSV.
std::string csv_text(const std::string& text);

}  // namespace bracket::apps
