// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/space/exact_rank.h"

#include <algorithm>

namespace bracket::bounds::space {

int rank(std::vector<Row> rows) {
  int found = 0;
  const std::size_t columns = rows.empty() ? 0 : rows[0].size();
  for (std::size_t column = 0; column < columns; ++column) {
    const auto begin = rows.begin() + found;
    const auto pivot = std::find_if(begin, rows.end(), [&](const Row& row) { return !row[column].is_zero(); });
    if (pivot == rows.end()) continue;
    std::iter_swap(begin, pivot);
    for (auto row = begin + 1; row != rows.end(); ++row) {
      if ((*row)[column].is_zero()) continue;
      const Rational factor = (*row)[column] / (*begin)[column];
      for (std::size_t k = column; k < columns; ++k) (*row)[k] -= factor * (*begin)[k];
    }
    ++found;
  }
  return found;
}

}  // namespace bracket::bounds::space
