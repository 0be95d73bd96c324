// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>

#include "dual/dual.h"
#include "primal/primal.h"

/// Fields spoilt on purpose, as no solver would.
namespace bracket::tests {

/// Adds noise of up to `size` times the largest value to every number; keeps `keep` times the field.
template <class Values> Values noisy(Values values, double keep, double size, std::mt19937& generator) {
  double largest = 0;
  for (const auto& value : values) largest = std::max(largest, value.cwiseAbs().maxCoeff());
  std::uniform_real_distribution<double> noise(-size * largest, size * largest);
  for (auto& value : values)
    for (auto& x : value) x = keep * x + noise(generator);
  return values;
}

inline scene::Displacement<2> noisy(scene::Displacement<2> u, double keep, double size, std::mt19937& generator) {
  u.vertex = noisy(std::move(u.vertex), keep, size, generator);
  u.edge = noisy(std::move(u.edge), keep, size, generator);
  u.cell = noisy(std::move(u.cell), keep, size, generator);
  return u;
}

inline scene::Stress<2> noisy(scene::Stress<2> stress, double keep, double size, std::mt19937& generator) {
  std::vector<scene::Voigt<2>> values;
  for (const auto& cell : stress.cell) values.insert(values.end(), cell.begin(), cell.end());
  values = noisy(std::move(values), keep, size, generator);
  auto next = values.begin();
  for (auto& cell : stress.cell)
    for (auto& value : cell) value = *next++;
  return stress;
}

}  // namespace bracket::tests
