// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/quantities/weights.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "bounds/certificate/space/approach.h"
#include "bounds/certificate/space/geometry.h"
#include "bounds/quantities/parts.h"
#include "scene/problem/space/face_gap.h"
#include "scene/text.h"

namespace bracket::bounds {

using scene::Enclosure;
using scene::Problem;
using scene::Quantity;
using scene::Vector;

namespace {

/// What the facets of each pair have at the nodes of its first side, as `joined` makes one of two.
template <class Join>
std::map<std::array<int, 2>, double> at_nodes(const Problem<3>& first, const FacetWeights<3>& weights,
                                              const Join& joined) {
  std::map<std::array<int, 2>, double> result;
  for (std::size_t j = 0; j < first.contact.size(); ++j) {
    const auto nodes = space::nodes_of_facet(first.mesh, first.contact[j].first);
    for (int k = 0; k < 6; ++k) {
      const auto [known, is_new] = result.insert({{first.contact[j].pair, nodes[k]}, weights[j][k]});
      if (!is_new) known->second = joined(known->second, weights[j][k]);
    }
  }
  return result;
}
double larger(double a, double b) { return std::max(a, b); }
double smaller(double a, double b) { return std::min(a, b); }

Vector<3> place_of(const scene::Mesh<3>& mesh, int node) {
  const auto vertices = static_cast<int>(mesh.vertices.size());
  if (node < vertices) return mesh.vertices[node];
  const auto& [a, b] = mesh.edges[node - vertices];
  return (mesh.vertices[a] + mesh.vertices[b]) / 2;
}

}  // namespace

ContactWeights<3> given_weights(const Problem<3>& first, const Quantity<3>& quantity, int pair) {
  ContactWeights<3> weights;
  weights.below.assign(first.contact.size(), {});
  weights.above = weights.below;
  if (!quantity.weight.is_enclosed()) refuse(quantity, "its weight must be a number or an expression");
  for (std::size_t j = 0; j < first.contact.size(); ++j) {
    if (first.contact[j].pair != pair) continue;
    const scene::Face face = scene::positions(first.mesh, first.mesh.boundary[first.contact[j].first].vertices);
    const auto bounds = scene::quadratic_gap(quantity.weight, face);
    if (!bounds)
      refuse(quantity,
             fmt::format("its weight is not one quadratic on the face of the first mesh with the corners {}, {}, {}",
                         scene::point(face[0]), scene::point(face[1]), scene::point(face[2])));
    weights.below[j] = bounds->lower;
    weights.above[j] = bounds->upper;
  }
  const auto least = at_nodes(first, weights.above, smaller);
  for (const auto& [at, value] : at_nodes(first, weights.below, larger))
    if (value > least.at(at))
      refuse(quantity, fmt::format("its weight jumps at {}: a jump has no finite energy",
                                   scene::point(place_of(first.mesh, at[1]))));
  weights.below = continuous(first, std::move(weights.below), false);
  weights.above = continuous(first, std::move(weights.above), true);
  return weights;
}

FacetWeights<3> continuous(const Problem<3>& first, FacetWeights<3> weights, bool above) {
  const auto joined = at_nodes(first, weights, above ? larger : smaller);
  for (std::size_t j = 0; j < weights.size(); ++j) {
    const auto nodes = space::nodes_of_facet(first.mesh, first.contact[j].first);
    for (int k = 0; k < 6; ++k) weights[j][k] = joined.at({first.contact[j].pair, nodes[k]});
  }
  return weights;
}

scene::Enclosure weighted_gap(const Problem<3>& problem, const FacetWeights<3>& weights, bool upper) {
  const std::vector<int> contact_of = scene::contacts_by_first(scene::first_of(problem));
  scene::LongSum sum;
  for (const auto& pair : problem.contact) {
    const scene::Piece<2> piece = scene::piece_of_facet(problem, pair.first);
    const auto& w = weights[contact_of[piece.of]];
    const std::array<double, 3> at_vertices = {w[0], w[1], w[2]};
    if (std::ranges::all_of(at_vertices, [](double one) { return one == 0; })) continue;
    const Enclosure area = facet_size(scene::first_of(problem), piece.of) * space::fraction<Enclosure>(piece);
    for (int i = 0; i < 3; ++i) {
      std::array<Enclosure, 3> hat = {};
      hat[i] = space::given_at<Enclosure>(at_vertices, piece.corner[i]);
      // Of a weight whose sign rounding hides the worse of both.
      const Enclosure by_upper = space::bernstein_product(hat, space::numbers<Enclosure>(pair.upper));
      const Enclosure by_lower = space::bernstein_product(hat, space::numbers<Enclosure>(pair.lower));
      const bool positive = scene::certainly_non_negative(hat[i]), negative = scene::certainly_non_negative(-hat[i]);
      const bool take_upper = positive || negative ? positive == upper
                              : upper              ? scene::upper(by_upper) >= scene::upper(by_lower)
                                                   : scene::lower(by_upper) <= scene::lower(by_lower);
      sum.add(area * (take_upper ? by_upper : by_lower));
    }
  }
  return sum.value();
}

}  // namespace bracket::bounds
