// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/numbers.h"

#include <fmt/format.h>

#include <cmath>

namespace bracket::apps {
namespace {

double up(double bound) {
  if (bound == 0) return 0;
  const double unit = std::pow(10, std::floor(std::log10(bound)) - 1);
  return std::ceil(bound / unit) * unit;
}

}  // namespace

std::string rounded_up(double bound) { return fmt::format("{:.2g}", up(bound)); }

std::string rounded_up_exponent(double bound) { return bound == 0 ? "0" : fmt::format("{:.1e}", up(bound)); }

std::string percent(double ratio) {
  if (!std::isfinite(ratio)) return "unknown";  // u_h does not deform: nothing to compare with
  return rounded_up(100 * ratio) + " %";
}

}  // namespace bracket::apps
