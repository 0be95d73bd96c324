// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "bounds/certificate/corrections.h"
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

/// E₀ x by components, exact: E₀ has entries 0, ½ and 1.
TwofoldVector<2> times(scene::StressComponent component, const TwofoldVector<2>& x) {
  const auto on = [&](const Vector<2>& v) -> Vector<2> {
    switch (component) {
      case scene::StressComponent::xx: return {v[0], 0};
      case scene::StressComponent::yy: return {0, v[1]};
      case scene::StressComponent::xy: return {v[1] / 2, v[0] / 2};
      case scene::StressComponent::mean: break;
    }
    return v / 2;
  };
  return {on(x.value), on(x.rest)};
}

}  // namespace

Functionals<2> mean_stress(const Problem<2>& first, const Quantity<2>& quantity) {
  const auto& mesh = first.mesh;
  const int body = body_named(first, quantity);
  int component = -1, anchor = -1;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    if (mesh.cell_body[c] == body) component = mesh.cell_component[c], anchor = mesh.cells[c][0];
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    if ((mesh.cell_component[c] == component) != (mesh.cell_body[c] == body))
      refuse(quantity, fmt::format("body '{}' is not one piece of its own", quantity.of));
  const Vector<2> centre = mesh.vertices[anchor];
  const auto [corrections, reason] = corrected<Enclosure, LongSum>(first);
  if (!reason.empty()) refuse(quantity, reason);

  Perturbation<2> perturbation = scene::no_perturbation(first);
  LongSum known;
  const std::vector<int> by_first = scene::contacts_by_first(first);
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    if (mesh.cell_component[mesh.boundary[f].cell] != component) continue;
    std::array<TwofoldVector<2>, 2> u;
    for (int i = 0; i < 2; ++i)
      u[i] = times(quantity.component, scene::difference<2>(centre, mesh.vertices[mesh.boundary[f].vertices[i]]));
    perturbation.facets[f].displacement = u;
    if (first.facets[f].support == Support::contact && by_first[f] >= 0)
      for (int i = 0; i < 2; ++i) perturbation.contact[by_first[f]].first[i] = u[i];
    if (first.facets[f].support == Support::traction && carries_load(first, corrections, static_cast<int>(f)))
      known.add(linear_product<Enclosure>(prescribed_load(first, corrections, static_cast<int>(f)).linear,  // as E₀x
                                          {vector2<Enclosure>(u[0]), vector2<Enclosure>(u[1])}));
  }
  for (std::size_t j = 0; j < first.contact.size(); ++j)
    if (const int second = first.contact[j].second;
        second >= 0 && mesh.cell_component[mesh.boundary[second].cell] == component)
      for (int i = 0; i < 2; ++i) perturbation.contact[j].second[i] = perturbation.facets[second].displacement[1 - i];
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    if (mesh.cell_body[c] != body || !has_force(first, body)) continue;
    const int cell = static_cast<int>(c);
    const auto x = corners<Enclosure>(first, cell);
    Vector2<Enclosure> sum;  // three times E₀ at the centroid
    for (const int v : mesh.cells[c])
      sum = sum + vector2<Enclosure>(times(quantity.component, scene::difference<2>(centre, mesh.vertices[v])));
    known.add(doubled_area(x) / Enclosure(6) * dot(body_force<Enclosure>(first, body), sum));
  }
  return linear(std::move(perturbation), body_area(first, body), known.value());
}

}  // namespace bracket::bounds
