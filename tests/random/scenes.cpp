// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdlib>
#include <map>

#include "tests/support/interval_faults.h"
#include "tests/support/random_laws.h"

/// bracket_random_scenes FIRST LAST [laws]: judges the random scenes of these seeds, with a law for each contact or
/// without friction, and prints those with a fault, then how often each status occurred. Exit status 1 if there was a
/// fault.
int main(int argc, char** argv) {
  const bool laws = argc == 4 && argv[3] == std::string("laws");
  if (argc != 3 && !laws) {
    fmt::print(stderr, "usage: bracket_random_scenes FIRST LAST [laws]\n");
    return 2;
  }
  const std::uint64_t first = std::strtoull(argv[1], nullptr, 10), last = std::strtoull(argv[2], nullptr, 10);
  std::map<int, int> endings;
  int failed = 0;
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    const auto random = laws ? bracket::tests::random_laws(seed) : bracket::tests::random_scene(seed);
    const auto verdict = bracket::tests::judge(random.scene, random.mesh);
    ++endings[static_cast<int>(verdict.status)];
    if (verdict.faults.empty()) continue;
    ++failed;
    fmt::print("{}", random.text);
    for (const std::string& fault : verdict.faults) fmt::print("  FAULT {}\n", fault);
    std::fflush(stdout);
  }
  for (const auto& [status, count] : endings) fmt::print("status {}: {} scenes\n", status, count);
  fmt::print("{} scenes with faults\n", failed);
  return failed == 0 ? 0 : 1;
}
