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

Phases phases(const contact::Phases& seconds) {
  return {seconds.assemble, seconds.order, seconds.factorise, seconds.contact, seconds.recover};
}

}  // namespace

std::string rounded_up(double bound) { return fmt::format("{:.2g}", up(bound)); }

std::string rounded_up_exponent(double bound) { return bound == 0 ? "0" : fmt::format("{:.1e}", up(bound)); }

std::string percent(double ratio) {
  if (!std::isfinite(ratio)) return "unknown";  // u_h does not deform: nothing to compare with
  return rounded_up(100 * ratio) + " %";
}

Phases primal_phases(const bounds::Level& level) { return phases(level.primal.seconds); }

Phases dual_phases(const bounds::Level& level) { return phases(level.dual.seconds); }

Spent spent(const std::vector<bounds::Level>& levels) {
  Spent sum;
  for (const bounds::Level& level : levels) {
    sum.mesh += level.seconds.mesh;
    sum.primal += level.seconds.primal;
    sum.dual += level.seconds.dual;
    sum.estimate += level.seconds.estimate;
    sum.certify += level.seconds.certify;
    const Phases primal = primal_phases(level), dual = dual_phases(level);
    for (std::size_t i = 0; i < phase_names.size(); ++i) {
      sum.primal_phases[i] += primal[i];
      sum.dual_phases[i] += dual[i];
    }
  }
  return sum;
}

}  // namespace bracket::apps
