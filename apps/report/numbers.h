// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

/// Numbers as reports print them.
namespace bracket::apps {

/// A bound with two digits, never below the number that it stands for.
std::string rounded_up(double bound);
std::string rounded_up_exponent(double bound);  ///< as 1.2e-03

/// A bound of a ratio in percent, rounded up; "unknown" if it is not finite.
std::string percent(double ratio);

}  // namespace bracket::apps
