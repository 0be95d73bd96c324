// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "tests/support/random_functionals.h"

/// bracket_random_functionals FIRST LAST: judges a hundred pairs of fields for the functional of each of these seeds.
/// Exit status 1 if a bound was on the wrong side.
int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: bracket_random_functionals FIRST LAST\n");
    return 2;
  }
  const std::uint64_t first = std::strtoull(argv[1], nullptr, 10), last = std::strtoull(argv[2], nullptr, 10);
  int pairs = 0, failed = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    const auto verdict = bracket::tests::judge_random_functionals(seed);
    pairs += verdict.pairs;
    failed += static_cast<int>(verdict.faults.size());
    least = std::min(least, verdict.least);
    for (const std::string& fault : verdict.faults) fmt::print("FAULT {}\n", fault);
    std::fflush(stdout);
  }
  fmt::print("{} pairs, {} faults; the sharpest bound was {:.1e} off\n", pairs, failed, least);
  return failed == 0 ? 0 : 1;
}
