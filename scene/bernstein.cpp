// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/bernstein.h"

namespace bracket::scene {

template <> const std::vector<std::array<int, 3>>& bernstein_indices<2>(int degree) {
  static const auto of_degrees = [] {
    std::array<std::vector<std::array<int, 3>>, 7> result;
    for (int n = 0; n < static_cast<int>(result.size()); ++n)
      for (int i2 = 0; i2 <= n; ++i2)
        for (int i1 = 0; i1 + i2 <= n; ++i1) result[n].push_back({n - i1 - i2, i1, i2});
    return result;
  }();
  return of_degrees.at(degree);
}

template <> const std::vector<std::array<int, 4>>& bernstein_indices<3>(int degree) {
  static const auto of_degrees = [] {
    std::array<std::vector<std::array<int, 4>>, 3> result;
    for (int n = 0; n < static_cast<int>(result.size()); ++n)
      for (int i3 = 0; i3 <= n; ++i3)
        for (const auto& i : bernstein_indices<2>(n - i3)) result[n].push_back({i[0], i[1], i[2], i3});
    return result;
  }();
  return of_degrees.at(degree);
}

}  // namespace bracket::scene
