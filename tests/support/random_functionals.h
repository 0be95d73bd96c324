// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bracket::tests {

/// What was found of random pairs of fields of one functional.
struct FunctionalsVerdict {
  std::vector<std::string> faults;
  int pairs = 0;     ///< that were certified
  double least = 0;  ///< distance of a bound from the value, by the value's size: how sharp the best was
};

/// Inequality (U) of docs/theory.md §10.1: a scene, a functional J whose value a fine mesh has put between bounds, and
/// a hundred pairs of fields on a coarse one, solutions of the problem perturbed by this and that and mixtures of them,
/// with noise; each, moved into the admissible sets, bounds J from above or below with a random f. A fault is a bound
/// on the wrong side of the interval.
FunctionalsVerdict judge_random_functionals(std::uint64_t seed);

}  // namespace bracket::tests
