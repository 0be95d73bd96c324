// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "bounds/quantities/parts.h"

namespace bracket::bounds {

using scene::Perturbation;
using scene::Problem;
using scene::Quantity;
using scene::StressComponent;
using scene::TwofoldVector;
using scene::Vector;

namespace {

/// The indices of a component; of the mean none.
std::array<int, 2> indices(StressComponent component) {
  switch (component) {
    case StressComponent::xx: return {0, 0};
    case StressComponent::yy: return {1, 1};
    case StressComponent::xy: return {0, 1};
    case StressComponent::zz: return {2, 2};
    case StressComponent::yz: return {1, 2};
    case StressComponent::xz: return {0, 2};
    case StressComponent::mean: break;
  }
  return {-1, -1};
}

/// E₀ x by components, exact: E₀ has entries 0, ½ and 1; of the mean, `dim` times of it in space.
template <int dim> TwofoldVector<dim> times(StressComponent component, const TwofoldVector<dim>& x) {
  const auto [i, k] = indices(component);
  const auto on = [&](const Vector<dim>& v) -> Vector<dim> {
    if (i < 0) return dim == 2 ? Vector<dim>(v / 2) : v;
    Vector<dim> result = Vector<dim>::Zero();
    result[i] = i == k ? v[i] : v[k] / 2;
    if (i != k) result[k] = v[i] / 2;
    return result;
  };
  return {on(x.value), on(x.rest)};
}

}  // namespace

template <int dim> Functionals<dim> mean_stress(const Problem<dim>& first, const Quantity<dim>& quantity) {
  const auto& mesh = first.mesh;
  const int body = body_named(first, quantity);
  int component = -1, anchor = -1;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    if (mesh.cell_body[c] == body) component = mesh.cell_component[c], anchor = mesh.cells[c][0];
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    if ((mesh.cell_component[c] == component) != (mesh.cell_body[c] == body))
      refuse(quantity, fmt::format("body '{}' is not one piece of its own", quantity.of));
  const Vector<dim> centre = mesh.vertices[anchor];
  const auto displacement = [&](int v) {
    return times<dim>(quantity.component, scene::difference<dim>(centre, mesh.vertices[v]));
  };
  const auto [known, reason] = work_of_data(first, component, displacement);
  if (!reason.empty()) refuse(quantity, reason);

  Perturbation<dim> perturbation = scene::no_perturbation(first);
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
    if (mesh.cell_component[mesh.boundary[f].cell] == component)
      for (int i = 0; i < dim; ++i) perturbation.facets[f].displacement[i] = displacement(mesh.boundary[f].vertices[i]);
  for (std::size_t j = 0; j < first.contact.size(); ++j) {
    const auto& pair = first.contact[j];
    for (int i = 0; i < dim; ++i) {  // nothing on other components
      perturbation.contact[j].first[i] = perturbation.facets[pair.first].displacement[i];
      if (pair.second >= 0)
        perturbation.contact[j].second[i] = perturbation.facets[pair.second].displacement[pair.meets[i]];
    }
  }
  const bool of_trace = dim == 3 && quantity.component == StressComponent::mean;
  const scene::Enclosure volume = body_size(first, body);
  return linear(std::move(perturbation), of_trace ? scene::Enclosure(dim) * volume : volume, known);
}

template Functionals<2> mean_stress(const Problem<2>&, const Quantity<2>&);
template Functionals<3> mean_stress(const Problem<3>&, const Quantity<3>&);

}  // namespace bracket::bounds
