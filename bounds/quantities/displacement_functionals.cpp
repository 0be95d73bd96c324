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
using scene::TwofoldVector;
using scene::Vector;

namespace {

/// The facets of a part whose displacement nothing prescribes, not even in part.
std::vector<int> free_facets(const Problem<2>& first, const Quantity<2>& quantity) {
  std::vector<int> facets = facets_of(first, quantity);
  for (const int f : facets) {
    if (first.facets[f].support == Support::traction) continue;
    const bool touches = first.facets[f].support == Support::contact;
    refuse(quantity, fmt::format("the displacement of '{}' is not free: the part {}; ask for a part that is loaded or "
                                 "free, or for the mean over the body (body = …)",
                                 quantity.of, touches ? "is in contact" : "is supported"));
  }
  return facets;
}

}  // namespace

Functionals<2> mean_displacement(const Problem<2>& first, const Quantity<2>& quantity) {
  Perturbation<2> perturbation = scene::no_perturbation(first);
  Enclosure length;
  for (const int f : free_facets(first, quantity)) {
    length += facet_length(first, f);
    if (quantity.direction)
      perturbation.facets[f].traction = scene::at_vertices<2>(plain(*quantity.direction));
    else
      perturbation.facets[f].pressure = {-1, -1};
  }
  return linear(std::move(perturbation), quantity.direction ? length * size(*quantity.direction) : length);
}

Functionals<2> rotation(const Problem<2>& first, const Quantity<2>& quantity) {
  const auto& mesh = first.mesh;
  const std::vector<int> facets = free_facets(first, quantity);
  Vector<2> sum = Vector<2>::Zero();
  double length = 0;
  for (const int f : facets) {
    const auto [a, b] = scene::positions(mesh, mesh.boundary[f].vertices);
    sum += (b - a).norm() * (a + (b - a) / 2);
    length += (b - a).norm();
  }
  const Vector<2> middle = sum / length;
  Perturbation<2> perturbation = scene::no_perturbation(first);
  Enclosure inertia;
  for (const int f : facets) {
    std::array<Vector2<Enclosure>, 2> arms;
    for (int i = 0; i < 2; ++i) {
      const TwofoldVector<2> arm = scene::difference<2>(middle, mesh.vertices[mesh.boundary[f].vertices[i]]);
      arms[i] = vector2<Enclosure>(arm);
      perturbation.facets[f].traction[i] = {Vector<2>(-arm.value[1], arm.value[0]),
                                            Vector<2>(-arm.rest[1], arm.rest[0])};
    }
    inertia += facet_length(first, f) * linear_product(arms, arms);
  }
  return linear(std::move(perturbation), inertia);
}

Functionals<2> body_displacement(const Problem<2>& first, const Quantity<2>& quantity) {
  const int body = body_named(first, quantity);
  Perturbation<2> perturbation = scene::no_perturbation(first);
  perturbation.force[body] = *quantity.direction;
  return linear(std::move(perturbation), body_area(first, body) * size(*quantity.direction));
}

}  // namespace bracket::bounds
