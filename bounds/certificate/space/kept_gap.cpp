// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/space/kept_gap.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "bounds/certificate/space/exact_rank.h"

namespace bracket::bounds::space {

namespace {

/// What two numbers may differ by, for rounding, where they are meant to agree.
double rounding_of(double size) { return 8 * std::numeric_limits<double>::epsilon() * size; }

double size_of(const scene::Problem<3>& first, const KeptGap& gap) {
  double size = first.length_scale;
  for (const double g : gap.lower) size = std::max(size, std::abs(g));
  return size;
}

bool may_be_linear(const std::array<double, 6>& c, double rounding) {
  for (int e = 0; e < 3; ++e) {
    const auto& [a, b] = scene::Simplex<2>::edges[e];
    if (!(std::abs(c[3 + e] - (c[a] + c[b]) / 2) <= rounding)) return false;
  }
  return true;
}

}  // namespace

KeptGaps kept_gaps(const scene::Problem<3>& problem) {
  const scene::Problem<3>& first = scene::first_of(problem);
  if (std::ranges::none_of(first.contact, [](const auto& pair) { return pair.law.two_sided; })) return {};
  KeptGaps result{scene::contacts_by_first(first), {}, ""};
  for (const auto& pair : first.contact)
    result.kept.push_back({pair.lower, pair.upper, false, first.facets[pair.first].normal});
  // Seen from either side: the nodes that meet, the lower number first, and the direction from that one.
  std::map<std::pair<std::array<int, 2>, std::array<double, 3>>, std::array<int, 2>> met;  // contact and node of it
  for (std::size_t j = 0; j < first.contact.size(); ++j) {
    const auto& pair = first.contact[j];
    if (!pair.law.two_sided) continue;
    const auto nodes = nodes_of_facet(first.mesh, pair.first);
    for (int k = 0; k < 6; ++k) {
      const int one = nodes[k], other = node_across(first.mesh, pair, k);
      const double sign = other >= 0 && other < one ? -1 : 1;
      const scene::Vector<3> d = sign * first.facets[pair.first].normal;
      const std::array<int, 2> both = sign < 0 ? std::array<int, 2>{other, one} : std::array<int, 2>{one, other};
      const auto [known, is_new] = met.insert({{both, {d[0], d[1], d[2]}}, {static_cast<int>(j), k}});
      if (is_new) continue;
      const auto [contact, node] = known->second;
      KeptGap& own = result.kept[j];
      const KeptGap& given = result.kept[contact];
      const double apart =
          std::max(std::abs(own.lower[k] - given.lower[node]), std::abs(own.upper[k] - given.upper[node]));
      if (!(apart <= rounding_of(size_of(first, own)))) {
        const auto& at = first.mesh.vertices[nodes[k % 3]];
        result.fault =
            fmt::format("the gap of sides that keep together jumps at ({:.6g}, {:.6g}, {:.6g})", at[0], at[1], at[2]);
      }
      own.lower[k] = given.lower[node];
      own.upper[k] = given.upper[node];
    }
  }
  // An edge between two facets is linear for both or for none: both see the same numbers.
  bool all = true;
  for (std::size_t j = 0; j < first.contact.size(); ++j)
    if (first.contact[j].law.two_sided)
      all = all && may_be_linear(kept_gap<double>(result.kept[j]), rounding_of(size_of(first, result.kept[j])));
  const auto& [by, loads, kinematics] = problem.perturbed;
  for (std::size_t j = 0; j < first.contact.size(); ++j) {
    KeptGap& gap = result.kept[j];
    gap.is_linear = all;
    if (!by || !first.contact[j].law.two_sided) continue;
    gap.added = by->contact[j];
    gap.factor = kinematics;
    const auto psi = kept_psi<Rational>(gap);
    for (int e = 0; e < 3; ++e) {
      const auto& [a, b] = scene::Simplex<2>::edges[e];
      gap.is_psi_linear = gap.is_psi_linear && psi[3 + e] + psi[3 + e] == psi[a] + psi[b];
    }
  }
  return result;
}

}  // namespace bracket::bounds::space
