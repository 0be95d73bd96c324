// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/bernstein.h"

namespace bracket::scene {

const std::vector<std::array<int, 3>>& bernstein_indices(int degree) {
  static const auto of_degrees = [] {
    std::array<std::vector<std::array<int, 3>>, 7> result;
    for (int n = 0; n < static_cast<int>(result.size()); ++n)
      for (int i2 = 0; i2 <= n; ++i2)
        for (int i1 = 0; i1 + i2 <= n; ++i1) result[n].push_back({n - i1 - i2, i1, i2});
    return result;
  }();
  return of_degrees.at(degree);
}

}  // namespace bracket::scene
