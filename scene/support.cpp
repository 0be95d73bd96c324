// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/support.h"

#include <fmt/format.h>

#include <cmath>

#include "scene/text.h"

namespace bracket::scene {

std::vector<FacetData<2>> with_agreement(const Mesh<2>& mesh, std::vector<FacetData<2>> facets,
                                         const std::vector<const Condition<2>*>& conditions, double largest) {
  const double tolerance = 1e-9 * largest;
  const auto prescribes = [&](int facet) {
    return facets[facet].support == Support::fixed || facets[facet].support == Support::sliding;
  };
  std::vector<int> arriving(mesh.vertices.size(), -1);  // each boundary vertex has one facet that ends, one that begins
  for (std::size_t facet = 0; facet < facets.size(); ++facet) {
    arriving[mesh.boundary[facet].vertices[1]] = static_cast<int>(facet);
  }
  for (std::size_t begins = 0; begins < facets.size(); ++begins) {
    const int vertex = mesh.boundary[begins].vertices[0];
    const int leaving = static_cast<int>(begins);
    const int ends = arriving[vertex];
    if (!prescribes(leaving) || !prescribes(ends)) continue;
    FacetData<2>& out = facets[leaving];
    FacetData<2>& in = facets[ends];
    double difference = 0;
    if (in.support == Support::fixed && out.support == Support::fixed) {
      difference = (out.displacement[0] - in.displacement[1]).norm();
      out.displacement[0] = in.displacement[1];
    } else if (in.support == Support::fixed) {
      const double value = out.normal.dot(in.displacement[1]);
      difference = std::abs(out.normal_displacement[0] - value);
      out.normal_displacement[0] = value;
    } else if (out.support == Support::fixed) {
      const double value = in.normal.dot(out.displacement[0]);
      difference = std::abs(in.normal_displacement[1] - value);
      in.normal_displacement[1] = value;
    } else if (in.normal == out.normal || in.normal == -out.normal) {
      const double value = (in.normal == out.normal ? 1 : -1) * in.normal_displacement[1];
      difference = std::abs(out.normal_displacement[0] - value);
      out.normal_displacement[0] = value;
    }
    if (difference <= tolerance) continue;
    const int part_in = mesh.boundary[ends].part, part_out = mesh.boundary[leaving].part;
    fail(Status::input, conditions[part_out]->where,
         fmt::format("the displacements prescribed on '{}' and '{}' contradict each other at {}: they differ by {:.3g}",
                     mesh.parts[part_in], mesh.parts[part_out], point(mesh.vertices[vertex]), difference));
  }
  return facets;
}

}  // namespace bracket::scene
