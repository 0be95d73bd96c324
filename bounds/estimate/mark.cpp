// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include "bounds/estimate/estimate.h"

namespace bracket::bounds {

template <int dim> std::vector<char> mark(const scene::Problem<dim>& problem, const Indicator& indicator, double bulk) {
  const auto& mesh = problem.mesh;
  std::vector<double> share = indicator.cell;
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const int first = problem.contact[j].first, second = problem.contact[j].second;
    const double part = second < 0 ? indicator.contact[j] : indicator.contact[j] / 2;
    share[mesh.boundary[first].cell] += part;
    if (second >= 0) share[mesh.boundary[second].cell] += part;
  }
  std::vector<int> order(share.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return std::pair(-share[a], a) < std::pair(-share[b], b); });

  const double goal = bulk * std::accumulate(share.begin(), share.end(), 0.0);
  std::vector<char> marked(share.size(), 0);
  double sum = 0;
  for (const int cell : order) {
    if (sum >= goal) break;
    marked[cell] = 1;
    sum += share[cell];
  }
  return marked;
}

template std::vector<char> mark(const scene::Problem<2>&, const Indicator&, double);
template std::vector<char> mark(const scene::Problem<3>&, const Indicator&, double);

}  // namespace bracket::bounds
