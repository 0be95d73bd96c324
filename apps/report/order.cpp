// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/order.h"

#include <algorithm>
#include <cmath>

namespace bracket::apps {

std::vector<Sample> samples_of(const std::vector<bounds::Level>& levels) {
  std::vector<Sample> samples;
  for (const bounds::Level& level : levels) {
    const double error = level.bracket.relative_error_bound;
    if (std::isfinite(error) && error > 0) samples.push_back({static_cast<double>(level.cells), error});
  }
  return samples;
}

double observed_order(const std::vector<Sample>& samples) {
  if (samples.size() < 3) return NAN;  // through two points goes any line
  const std::size_t first =
      samples.size() - std::min(samples.size(), std::max<std::size_t>(2, (samples.size() + 1) / 2));
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = first; i < samples.size(); ++i) {
    const double a = std::log(samples[i].cells), b = std::log(samples[i].error);
    n += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace bracket::apps
