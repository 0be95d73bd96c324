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

template <int dim> [[noreturn]] void refuse(const Quantity<dim>& quantity, const std::string& why) {
  scene::fail(scene::Status::input, quantity.where, fmt::format("quantity '{}': {}", quantity.name, why));
}

template <int dim>
Functionals<dim> linear(Perturbation<dim> perturbation, const Enclosure& scale, const Enclosure& offset) {
  Functionals<dim> result;
  result.above = result.below = std::make_shared<const Perturbation<dim>>(std::move(perturbation));
  result.offset_above = result.offset_below = offset;
  result.scale = scale;
  return result;
}

template <int dim> std::vector<int> facets_of(const Problem<dim>& first, const Quantity<dim>& quantity) {
  const auto& mesh = first.mesh;
  const auto part = std::find(mesh.parts.begin(), mesh.parts.end(), quantity.of);
  if (part == mesh.parts.end())
    refuse(quantity, fmt::format("the mesh has no boundary part '{}'; {}", quantity.of,
                                 scene::suggestion(quantity.of, mesh.parts)));
  std::vector<int> facets;
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
    if (mesh.boundary[f].part == part - mesh.parts.begin()) facets.push_back(static_cast<int>(f));
  if (facets.empty()) refuse(quantity, fmt::format("the boundary part '{}' has no {}s", quantity.of, facet_name<dim>));
  return facets;
}

template <int dim> int body_named(const Problem<dim>& first, const Quantity<dim>& quantity) {
  const auto& bodies = first.mesh.bodies;
  const auto body = std::find(bodies.begin(), bodies.end(), quantity.of);
  if (body == bodies.end())
    refuse(quantity, fmt::format("there is no body '{}'; {}", quantity.of, scene::suggestion(quantity.of, bodies)));
  return static_cast<int>(body - bodies.begin());
}

template <int dim>
Functionals<dim> functionals(const scene::Scene<dim>& scene, const Problem<dim>& problem,
                             const Quantity<dim>& quantity) {
  const Problem<dim>& first = scene::first_of(problem);
  switch (quantity.kind) {
    case scene::QuantityKind::displacement: return mean_displacement(first, quantity);
    case scene::QuantityKind::body: return body_displacement(first, quantity);
    case scene::QuantityKind::rotation: return rotation(first, quantity);
    case scene::QuantityKind::opening: return opening(scene, problem, quantity);
    case scene::QuantityKind::reaction: return reaction(first, quantity);
    case scene::QuantityKind::stress: return mean_stress(first, quantity);
    case scene::QuantityKind::energy: return half_of_data(first, quantity);
    case scene::QuantityKind::force:
      if (is_pressing_force(quantity)) return contact_force(scene, first, quantity);
      if constexpr (dim == 2) return shear_force(scene, first, quantity);
      break;
    case scene::QuantityKind::slip:
      if constexpr (dim == 2) return mean_slip(scene, first, quantity);
      break;
  }
  refuse(quantity, "it is one of the plane");
}

#define INSTANTIATE(dim)                                                                   \
  template void refuse(const Quantity<dim>&, const std::string&);                          \
  template Functionals<dim> linear(Perturbation<dim>, const Enclosure&, const Enclosure&); \
  template std::vector<int> facets_of(const Problem<dim>&, const Quantity<dim>&);          \
  template int body_named(const Problem<dim>&, const Quantity<dim>&);                      \
  template Functionals<dim> functionals(const scene::Scene<dim>&, const Problem<dim>&, const Quantity<dim>&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::bounds
