// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar; space/weights.cpp has the twins of space.
#include "bounds/quantities/weights.h"

#include <fmt/format.h>

#include "bounds/certificate/admissible_displacement.h"
#include "bounds/quantities/line.h"
#include "bounds/quantities/parts.h"
#include "scene/problem/gap.h"
#include "scene/text.h"

namespace bracket::bounds {

using scene::Problem;
using scene::Quantity;

namespace {

void check_continuous(const Problem<2>& first, const Quantity<2>& quantity, int pair,
                      const ContactWeights<2>& weights) {
  for (const ContactLine& line : contact_lines(first, pair))
    for (std::size_t i = line.closed ? 0 : 1; i < line.contact.size(); ++i) {
      const int one = line.contact[(i == 0 ? line.contact.size() : i) - 1], next = line.contact[i];
      if (weights.below[one][0] == weights.below[next][2] && weights.above[one][0] == weights.above[next][2]) continue;
      const int v = first.mesh.boundary[first.contact[one].first].vertices[0];
      refuse(quantity,
             fmt::format("its weight jumps at {}: a jump has no finite energy", scene::point(first.mesh.vertices[v])));
    }
}

}  // namespace

ContactWeights<2> given_weights(const Problem<2>& first, const Quantity<2>& quantity, int pair) {
  ContactWeights<2> weights;
  weights.below.assign(first.contact.size(), {0, 0, 0});
  weights.above = weights.below;
  if (!quantity.weight.is_enclosed()) refuse(quantity, "its weight must be a number or an expression");
  for (std::size_t j = 0; j < first.contact.size(); ++j) {
    if (first.contact[j].pair != pair) continue;
    const auto [a, b] = scene::positions(first.mesh, first.mesh.boundary[first.contact[j].first].vertices);
    const auto bounds = scene::quadratic_gap(quantity.weight, a, b);
    if (!bounds)
      refuse(quantity, fmt::format("its weight is not one quadratic on the edge of the first mesh from {} to {}",
                                   scene::point(a), scene::point(b)));
    weights.below[j] = bounds->lower;
    weights.above[j] = bounds->upper;
  }
  check_continuous(first, quantity, pair, weights);
  return weights;
}

FacetWeights<2> continuous(const Problem<2>&, FacetWeights<2> weights, bool) { return weights; }

Enclosure weighted_gap(const Problem<2>& problem, const FacetWeights<2>& weight, bool upper) {
  const std::vector<int> contact_of = scene::contacts_by_first(scene::first_of(problem));
  LongSum sum;
  for (const auto& pair : problem.contact) {
    const auto [of, corner] = scene::piece_of_facet(problem, pair.first);
    const auto& [a, middle, b] = weight[contact_of[of]];
    if (a == 0 && b == 0) continue;
    const auto e = along<Enclosure>(problem, pair.first);
    const Enclosure length = root(dot(e, e));
    for (int i = 0; i < 2; ++i) {
      std::array<Enclosure, 2> hat = {Enclosure(0), Enclosure(0)};
      hat[i] = between_ends(Enclosure(a), Enclosure(b), corner[i][0]);
      const auto& gap = (hat[i].middle >= 0) == upper ? pair.upper : pair.lower;
      sum.add(length *
              scene::bernstein_product(std::vector<Enclosure>(hat.begin(), hat.end()), gap_on<Enclosure>(gap, 2)));
    }
  }
  return sum.value();
}

}  // namespace bracket::bounds
