// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/resolve_data.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace bracket::bounds {

namespace {

/// The facets with the largest shares, without which no more than `allowed` is left.
std::vector<int> largest_shares(const std::vector<double>& shares, double allowed) {
  std::vector<int> order(shares.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return shares[a] < shares[b]; });
  double sum = 0;
  std::size_t kept = 0;
  while (kept < order.size() && (sum += shares[order[kept]]) <= allowed) ++kept;
  return {order.begin() + static_cast<std::ptrdiff_t>(kept), order.end()};
}

}  // namespace

template <int dim>
std::optional<Meshed<dim>> with_data_resolved(const scene::Scene<dim>& scene, const Meshed<dim>& meshed,
                                              const Examined<dim>& examined, const Clock& run_clock) {
  constexpr double usual_target = 1e-2, share_of_width = 0.1, share_of_budget = 0.25;
  const scene::Refine& refine = scene.refine;
  if (meshed.changed || !examined.unsolved.empty() || refine.strategy == scene::Strategy::none) return {};
  const double target = refine.target > 0 ? refine.target : usual_target;
  const double allowed = share_of_width * target * target * examined.level.plain.strain;
  if (examined.effect.energy <= allowed || run_clock.seconds() > share_of_budget * refine.max_seconds) return {};
  const auto& mesh = meshed.problem.mesh;
  std::vector<char> marked(mesh.cells.size(), 0);
  std::set<std::string> parts = meshed.resolved;
  for (const int facet : largest_shares(examined.effect.facet, allowed / 2)) {
    marked[mesh.boundary[facet].cell] = 1;
    parts.insert(mesh.parts[mesh.boundary[facet].part]);
  }
  scene::Mesh<dim> finer = scene::finer_mesh(scene, meshed.problem, marked);
  if (static_cast<double>(finer.cells.size()) > share_of_budget * refine.max_cells) return {};
  const int times = meshed.times_resolved + 1;
  finer.notes = meshed.notes;
  finer.notes.push_back(fmt::format("the first mesh was refined {} time{}, to {} cells, for the data of '{}'", times,
                                    times == 1 ? "" : "s", finer.cells.size(), fmt::join(parts, "', '")));
  const Clock clock;
  Meshed<dim> result{.problem = balanced(scene::fix_data(scene, std::move(finer)), scene.solve.degree),
                     .notes = meshed.notes,
                     .times_resolved = times,
                     .resolved = std::move(parts)};
  result.seconds = meshed.seconds + clock.seconds();
  return result;
}

template std::optional<Meshed<2>> with_data_resolved(const scene::Scene<2>&, const Meshed<2>&, const Examined<2>&,
                                                     const Clock&);
template std::optional<Meshed<3>> with_data_resolved(const scene::Scene<3>&, const Meshed<3>&, const Examined<3>&,
                                                     const Clock&);

}  // namespace bracket::bounds
