// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/problem/law.h"

#include <algorithm>

#include "scene/bernstein.h"

namespace bracket::scene {

// Gauss–Seidel on the coefficients, each held at its bound from below: the energy falls with every step.
std::vector<double> shortening(const std::array<double, 2>& modulus, const std::vector<double>& c) {
  if (std::ranges::all_of(c, [](double one) { return one <= 0; })) return std::vector<double>(c.size(), 0);
  if (std::ranges::all_of(c, [](double one) { return one >= 0; })) return c;
  const int degree = static_cast<int>(c.size()) - 1;
  const auto mass = [&](int i, int k) {
    double mean = 0;
    for (int end = 0; end < 2; ++end) mean += number<double>(bernstein_mass(2 * degree, i + k, 1, end)) * modulus[end];
    return share<double>(mean, binomial(degree, i) * binomial(degree, k), binomial(2 * degree, i + k));
  };
  std::vector<double> s;
  for (const double one : c) s.push_back(std::max(one, 0.0));
  constexpr int sweeps = 8;
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (int i = 0; i <= degree; ++i) {
      double others = 0;
      for (int k = 0; k <= degree; ++k)
        if (k != i) others += mass(i, k) * s[k];
      s[i] = std::max(c[i], -others / mass(i, i));
    }
  return s;
}

}  // namespace bracket::scene
