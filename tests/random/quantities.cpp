// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdlib>

#include "tests/support/random_quantities.h"

/// bracket_random_quantities FIRST LAST [laws]: judges random quantities of the random scenes of these seeds, with a
/// law for each contact or without friction, and prints those with a fault, then how many had bounds. Exit status 1 if
/// there was a fault.
int main(int argc, char** argv) {
  const bool laws = argc == 4 && argv[3] == std::string("laws");
  if (argc != 3 && !laws) {
    fmt::print(stderr, "usage: bracket_random_quantities FIRST LAST [laws]\n");
    return 2;
  }
  const std::uint64_t first = std::strtoull(argv[1], nullptr, 10), last = std::strtoull(argv[2], nullptr, 10);
  int failed = 0, asked = 0, refused = 0, both = 0, one = 0;
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    const auto verdict = bracket::tests::judge_random_quantities(seed, laws);
    asked += verdict.asked;
    refused += verdict.refused;
    both += verdict.both_ends;
    one += verdict.one_end;
    if (verdict.faults.empty()) continue;
    ++failed;
    fmt::print("seed {}\n{}", seed, verdict.text);
    for (const std::string& fault : verdict.faults) fmt::print("  FAULT {}\n", fault);
    std::fflush(stdout);
  }
  fmt::print("{} quantities asked, {} refused; intervals of both degrees: {} with two ends, {} with one\n", asked,
             refused, both, one);
  fmt::print("{} scenes with faults\n", failed);
  return failed == 0 ? 0 : 1;
}
