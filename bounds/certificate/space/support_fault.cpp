// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "bounds/certificate/space/exact_rank.h"
#include "bounds/certificate/space/problem_faults.h"
#include "bounds/certificate/space/supports.h"

namespace bracket::bounds::space {

using scene::Problem;
using scene::Support;
using scene::Vector;

namespace {

/// What a facet of Γ_0 prescribes at a vertex.
struct Known {
  int facet;
  Vector<3> normal;
  double value;
};

/// Whether u·normal = value can be for all, exactly.
bool agree(const std::vector<Known>& known) {
  std::vector<Row> rows, extended;
  for (const Known& one : known) {
    rows.push_back(exact_row(one.normal));
    extended.push_back(rows.back());
    extended.back().push_back(Rational(one.value));
  }
  return rank(std::move(rows)) == rank(std::move(extended));
}

}  // namespace

std::string support_fault(const Problem<3>& first) {
  const auto& mesh = first.mesh;
  const auto clash = [](int one, std::size_t other) {
    return fmt::format("boundary facets {} and {} prescribe different displacements where they meet", one, other);
  };
  const auto fixed = fixed_vertices(first);
  std::vector<std::vector<Known>> known(mesh.vertices.size());
  for (std::size_t f = 0; f < first.facets.size(); ++f) {
    const auto& data = first.facets[f];
    if (data.support == Support::contact && is_loaded(data))
      return fmt::format("boundary facet {} is in contact and loaded", f);
    if (degree_of_load(data) > 1) return fmt::format("boundary facet {} has a load that is not linear", f);
    for (int i = 0; i < 3; ++i) {
      const int vertex = mesh.boundary[f].vertices[i];
      const FacetCorner& held = fixed[vertex];
      if (data.support == Support::fixed && first.facets[held.facet].displacement[held.corner] != data.displacement[i])
        return clash(held.facet, f);
      if (data.support != Support::sliding || held.facet >= 0) continue;
      const double value = data.normal_displacement[i];
      auto& here = known[vertex];
      const auto same = std::ranges::find_if(
          here, [&](const Known& one) { return one.normal == data.normal || one.normal == -data.normal; });
      if (same == here.end()) {
        here.push_back({static_cast<int>(f), data.normal, value});
        if (here.size() > 1 && !agree(here)) return clash(here[0].facet, f);
      } else if (value != (same->normal == data.normal ? same->value : -same->value)) {
        return clash(same->facet, f);
      }
    }
  }
  return "";
}

}  // namespace bracket::bounds::space
