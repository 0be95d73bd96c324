// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/quantities/functional.h"

#include <fmt/format.h>

#include <algorithm>

#include "bounds/quantities/parts.h"
#include "scene/text.h"

namespace bracket::bounds {

using scene::Enclosure;
using scene::Perturbation;
using scene::Problem;
using scene::Quantity;

[[noreturn]] void refuse(const Quantity<2>& quantity, const std::string& why) {
  scene::fail(scene::Status::input, quantity.where, fmt::format("quantity '{}': {}", quantity.name, why));
}

Functionals<2> linear(Perturbation<2> perturbation, const Enclosure& scale, const Enclosure& offset) {
  Functionals<2> result;
  result.above = result.below = std::make_shared<const Perturbation<2>>(std::move(perturbation));
  result.offset_above = result.offset_below = offset;
  result.scale = scale;
  return result;
}

std::vector<int> facets_of(const Problem<2>& first, const Quantity<2>& quantity) {
  const auto& mesh = first.mesh;
  const auto part = std::find(mesh.parts.begin(), mesh.parts.end(), quantity.of);
  if (part == mesh.parts.end())
    refuse(quantity, fmt::format("the mesh has no boundary part '{}'; {}", quantity.of,
                                 scene::suggestion(quantity.of, mesh.parts)));
  std::vector<int> facets;
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
    if (mesh.boundary[f].part == part - mesh.parts.begin()) facets.push_back(static_cast<int>(f));
  if (facets.empty()) refuse(quantity, fmt::format("the boundary part '{}' has no edges", quantity.of));
  return facets;
}

int body_named(const Problem<2>& first, const Quantity<2>& quantity) {
  const auto& bodies = first.mesh.bodies;
  const auto body = std::find(bodies.begin(), bodies.end(), quantity.of);
  if (body == bodies.end())
    refuse(quantity, fmt::format("there is no body '{}'; {}", quantity.of, scene::suggestion(quantity.of, bodies)));
  return static_cast<int>(body - bodies.begin());
}

Enclosure facet_length(const Problem<2>& first, int facet) {
  const auto e = whole_facet<Enclosure>(first.mesh, facet);
  return root(dot(e, e));
}

Enclosure body_area(const Problem<2>& first, int body) {
  LongSum area;
  for (std::size_t c = 0; c < first.mesh.cells.size(); ++c)
    if (first.mesh.cell_body[c] == body)
      area.add(doubled_area(corners<Enclosure>(first, static_cast<int>(c))) / Enclosure(2));
  return area.value();
}

template <int dim>
Functionals<dim> functionals(const scene::Scene<dim>& scene, const scene::Problem<dim>& problem,
                             const scene::Quantity<dim>& quantity) {
  static_assert(dim == 2);
  const Problem<dim>& first = scene::first_of(problem);
  switch (quantity.kind) {
    case scene::QuantityKind::displacement: return mean_displacement(first, quantity);
    case scene::QuantityKind::body: return body_displacement(first, quantity);
    case scene::QuantityKind::rotation: return rotation(first, quantity);
    case scene::QuantityKind::force:
      return is_pressing_force(quantity) ? contact_force(scene, first, quantity) : shear_force(scene, first, quantity);
    case scene::QuantityKind::slip: return mean_slip(scene, first, quantity);
    case scene::QuantityKind::opening: return opening(scene, problem, quantity);
    case scene::QuantityKind::reaction: return reaction(first, quantity);
    case scene::QuantityKind::stress: return mean_stress(first, quantity);
    case scene::QuantityKind::energy: break;
  }
  return half_of_data(first, quantity);
}

template Functionals<2> functionals(const scene::Scene<2>&, const scene::Problem<2>&, const scene::Quantity<2>&);

}  // namespace bracket::bounds
