// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/space/corrections.h"

#include "bounds/certificate/space/links.h"

namespace bracket::bounds::space {

PlainLoads assumed_loads(const scene::Problem<3>& first) {
  PlainLoads assumed = no_loads(first, 1);
  for (const auto& pair : first.contact)
    if (!first.carries[pair.pair]) assumed.along_normal[pair.first] = {0, 0, 0};
  return assumed;
}

std::optional<int> vanishing_corrections(const scene::Problem<3>& problem, const std::vector<char>& carrying) {
  const scene::Problem<3>& first = scene::first_of(problem);
  if (first.corrections.empty()) return 0;
  const int unheld = unheld_motions(first, carrying);
  std::vector<char> either = carrying;
  for (std::size_t pair = 0; pair < either.size(); ++pair) either[pair] |= first.carries[pair];
  if (static_cast<int>(first.corrections.size()) < unheld || unheld != unheld_motions(first, either)) return {};
  return unheld;
}

}  // namespace bracket::bounds::space
