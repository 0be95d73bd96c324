// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "bounds/bounds.h"

/// Numbers as reports print them.
namespace bracket::apps {

/// A bound with two digits, never below the number that it stands for.
std::string rounded_up(double bound);
std::string rounded_up_exponent(double bound);  ///< as 1.2e-03

/// A bound of a ratio in percent, rounded up; "unknown" if it is not finite.
std::string percent(double ratio);

/// What a formulation spends its time on, in this order.
inline constexpr std::array<const char*, 5> phase_names = {"assemble", "order", "factorise", "contact", "recover"};
using Phases = std::array<double, 5>;  ///< seconds
Phases primal_phases(const bounds::Level& level);
Phases dual_phases(const bounds::Level& level);

/// Seconds of several levels, added up.
struct Spent {
  double mesh = 0, primal = 0, dual = 0, estimate = 0, certify = 0;
  Phases primal_phases{}, dual_phases{};
};
Spent spent(const std::vector<bounds::Level>& levels);

}  // namespace bracket::apps
