// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "apps/report/report.h"

/// Quantities as they are told.
namespace bracket::apps {

/// The decimal numbers with their last digits at one place between which an interval is enclosed, so that they widen it
/// by no more than a tenth, or are its bounds to the last bit. \pre finite, lower ≤ upper
struct Decimals {
  std::string lower, upper;
};
Decimals enclosed_in_decimals(double lower, double upper);

/// One line for each quantity that was asked for by name: its interval, and half its width by its size; or what is
/// missing.
std::string quantity_lines(const Report& report);

/// What one quantity is, without its name: "in [412.31, 412.38]   ± 0.008 %".
std::string told(const bounds::QuantityInterval& interval, const std::string& units);

}  // namespace bracket::apps
