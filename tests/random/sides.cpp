// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdlib>

#include "tests/support/random_sides.h"

/// bracket_random_sides FIRST LAST: judges the random sides of these seeds and prints their faults, then how many of
/// three meshes each had bounds. Exit status 1 if there was a fault.
int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: bracket_random_sides FIRST LAST\n");
    return 2;
  }
  const std::uint64_t first = std::strtoull(argv[1], nullptr, 10), last = std::strtoull(argv[2], nullptr, 10);
  int failed = 0, bracketed[4] = {0, 0, 0, 0};
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    const auto verdict = bracket::tests::judge_random_sides(seed);
    ++bracketed[verdict.bracketed];
    if (!verdict.faults.empty()) ++failed;
    for (const std::string& fault : verdict.faults) fmt::print("FAULT {}\n", fault);
    std::fflush(stdout);
  }
  for (int meshes = 0; meshes <= 3; ++meshes) fmt::print("{} of 3 meshes with bounds: {}\n", meshes, bracketed[meshes]);
  fmt::print("{} problems with faults\n", failed);
  return failed == 0 ? 0 : 1;
}
