// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "bounds/quantities/parts.h"

namespace bracket::bounds {

using scene::Enclosure;
using scene::Perturbation;
using scene::Problem;
using scene::Quantity;
using scene::Support;
using scene::Vector;

namespace {

/// Whether a support can be moved by e although another boundary facet begins where it ends.
bool goes_on(const scene::FacetData<2>& part, const scene::FacetData<2>& beside, const Vector<2>& e) {
  const Vector<2>& n = beside.normal;
  const bool across = e[0] * n[0] == 0 && e[1] * n[1] == 0;  // exactly
  if (beside.support == Support::traction) return true;
  if (beside.support == Support::fixed) return false;
  if (part.support == Support::fixed) return across;
  return n != part.normal && n != -part.normal;
}

}  // namespace

Functionals<2> reaction(const Problem<2>& first, const Quantity<2>& quantity) {
  const auto& mesh = first.mesh;
  const std::vector<int> facets = facets_of(first, quantity);
  std::vector<char> own(mesh.boundary.size(), 0);
  for (const int f : facets) {
    own[f] = 1;
    const Support support = first.facets[f].support;
    if (support != Support::fixed && support != Support::sliding)
      refuse(quantity, fmt::format("'{}' has no reaction: it is neither fixed nor sliding", quantity.of));
    if (support == Support::fixed && !quantity.direction && scene::normal(mesh, f) != scene::normal(mesh, facets[0]) &&
        first.facets[f].normal != first.facets[facets[0]].normal)
      refuse(quantity, fmt::format("the facets of '{}' have different normals; give a direction", quantity.of));
  }
  const auto direction = [&](int f) {
    return quantity.direction.value_or(first.facets[first.facets[f].support == Support::fixed ? facets[0] : f].normal);
  };
  std::vector<double> weight(mesh.vertices.size(), 1);
  for (std::size_t g = 0; g < mesh.boundary.size(); ++g) {
    if (own[g]) continue;
    for (const int f : facets)
      for (const int v : mesh.boundary[f].vertices)
        if (std::ranges::count(mesh.boundary[g].vertices, v) > 0 &&
            !goes_on(first.facets[f], first.facets[g], direction(f)))
          weight[v] = 0;
  }
  Perturbation<2> perturbation = scene::no_perturbation(first);
  bool any = false, weighted = false;
  for (const int f : facets)
    for (int i = 0; i < 2; ++i) {
      const double w = weight[mesh.boundary[f].vertices[i]];
      perturbation.facets[f].displacement[i] = plain(w * direction(f));
      any = any || w != 0;
      weighted = weighted || w == 0;
    }
  if (!any)
    refuse(quantity,
           fmt::format("'{}' is one edge between supports: no weight that falls to zero at both ends is left; "
                       "take a finer first mesh",
                       quantity.of));
  const Enclosure scale = quantity.direction ? size(*quantity.direction) : Enclosure(1);
  Functionals<2> result = linear(std::move(perturbation), scale);
  result.weighted = weighted;
  return result;
}

}  // namespace bracket::bounds
