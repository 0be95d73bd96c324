// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "bounds/bounds.h"

namespace bracket::apps {

/// A point of a curve on logarithmic axes.
struct Sample {
  double cells;
  double error;
};
/// The levels whose guaranteed relative error is a positive number, and it.
std::vector<Sample> samples_of(const std::vector<bounds::Level>& levels);

/// The observed order: the slope of log error by log cells, least squares over the last half of the samples (at least
/// two). NaN where they do not say, as of fewer than three.
double observed_order(const std::vector<Sample>& samples);

}  // namespace bracket::apps
