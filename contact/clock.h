// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace bracket {

/// Wall clock.
class Clock {
 public:
  /// Seconds since it was made or last lapped.
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
  /// The same, and begins anew.
  double lap() {
    const double passed = seconds();
    *this = Clock();
    return passed;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace bracket
