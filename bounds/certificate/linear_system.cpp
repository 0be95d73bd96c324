// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/linear_system.h"

#include <cmath>
#include <utility>

namespace bracket::bounds {

// Gaussian elimination: zeros stay zeros, so that what does not act on a body stays zero exactly.
std::optional<std::vector<Enclosure>> solution(std::vector<std::vector<Enclosure>> a, std::vector<Enclosure> b) {
  const std::size_t n = b.size();
  const auto certain = [](const Enclosure& x) { return std::abs(x.middle) - x.radius; };  // size, whatever the rounding
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (certain(a[i][k]) > certain(a[pivot][k])) pivot = i;
    if (!(certain(a[pivot][k]) > 0)) return {};
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      if (a[i][k].is_zero()) continue;
      const Enclosure factor = a[i][k] / a[k][k];
      for (std::size_t j = k + 1; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  std::vector<Enclosure> x(n);
  for (std::size_t k = n; k-- > 0;) {
    Enclosure rest = b[k];
    for (std::size_t j = k + 1; j < n; ++j) rest -= a[k][j] * x[j];
    x[k] = rest / a[k][k];
    if (!std::isfinite(magnitude(x[k]))) return {};
  }
  return x;
}

}  // namespace bracket::bounds
