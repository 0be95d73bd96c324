// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace bracket::bounds {

/// What this thread's arithmetic lacks of what enclosures need, in one line; empty: nothing. Round to nearest, denormal
/// numbers kept, extended precision not cut short, products and sums not contracted: all can be changed at run time, by
/// whoever shares the process.
std::string arithmetic_fault();

/// The certificate works on threads that others made, and may have changed.
struct ArithmeticFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// \throw ArithmeticFault where there is an arithmetic_fault()
void check_arithmetic();

}  // namespace bracket::bounds
