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

/// The facets of a part that is not fixed.
template <int dim> std::vector<int> movable_facets(const Problem<dim>& first, const Quantity<dim>& quantity) {
  std::vector<int> facets = facets_of(first, quantity);
  if (std::ranges::any_of(facets, [&](int f) { return first.facets[f].support == Support::fixed; }))
    refuse(quantity,
           fmt::format("the displacement of '{}' is prescribed: the part is fixed; ask for a part that is not, "
                       "or for the mean over the body (body = …)",
                       quantity.of));
  return facets;
}

/// Refuses a load that does work, but for rounding, on what a sliding part prescribes alone: the displacement along its
/// normal.
template <int dim>
void refuse_along_support(const Problem<dim>& first, const Quantity<dim>& quantity, const std::vector<int>& facets,
                          const Perturbation<dim>& perturbation) {
  constexpr double rounding = 1e-12;
  const bool is_known = std::ranges::all_of(facets, [&](int f) {
    const Vector<dim>& n = first.facets[f].normal;
    return first.facets[f].support == Support::sliding &&
           std::ranges::all_of(perturbation.facets[f].traction, [&](const TwofoldVector<dim>& t) {
             return (t.value - t.value.dot(n) * n).norm() <= rounding * t.value.norm();
           });
  });
  if (is_known)
    refuse(quantity, fmt::format("what is asked for of '{}' is prescribed: the part slides, and its displacement along "
                                 "its normal is given",
                                 quantity.of));
}

Vector<2> middle(const std::array<Vector<2>, 2>& x) { return x[0] + (x[1] - x[0]) / 2; }
Vector<3> middle(const std::array<Vector<3>, 3>& x) { return (x[0] + x[1] + x[2]) / 3; }

}  // namespace

template <int dim> Functionals<dim> mean_displacement(const Problem<dim>& first, const Quantity<dim>& quantity) {
  Perturbation<dim> perturbation = scene::no_perturbation(first);
  const std::vector<int> facets = movable_facets(first, quantity);
  Enclosure whole;
  for (const int f : facets) {
    whole += facet_size(first, f);
    if (quantity.direction)
      perturbation.facets[f].traction = scene::at_vertices<dim>(plain<dim>(*quantity.direction));
    else
      perturbation.facets[f].pressure = scene::at_vertices<dim>(-1.0);
  }
  refuse_along_support(first, quantity, facets, perturbation);
  return linear(std::move(perturbation), quantity.direction ? whole * size(*quantity.direction) : whole);
}

template <int dim> Functionals<dim> rotation(const Problem<dim>& first, const Quantity<dim>& quantity) {
  const auto& mesh = first.mesh;
  const std::vector<int> facets = movable_facets(first, quantity);
  Vector<dim> sum = Vector<dim>::Zero();
  double whole = 0;
  for (const int f : facets) {
    const auto x = scene::positions(mesh, mesh.boundary[f].vertices);
    const double own = scene::length(mesh, f);
    sum += own * middle(x);
    whole += own;
  }
  const Vector<dim> centre = sum / whole;
  int axis = 0;
  double sense = 1;
  if constexpr (dim == 3) {
    while ((*quantity.direction)[axis] == 0) ++axis;
    sense = (*quantity.direction)[axis] > 0 ? 1 : -1;
  }
  const auto& [i, k] = scene::Simplex<dim>::rotations[axis];
  Perturbation<dim> perturbation = scene::no_perturbation(first);
  Enclosure inertia;
  for (const int f : facets) {
    std::array<TwofoldVector<dim>, dim> arms;  // at right angles to the axis
    for (int v = 0; v < dim; ++v) {
      arms[v] = scene::difference<dim>(centre, mesh.vertices[mesh.boundary[f].vertices[v]]);
      TwofoldVector<dim>& traction = perturbation.facets[f].traction[v];
      for (const auto& [turned, arm] :
           {std::pair(&traction.value, &arms[v].value), std::pair(&traction.rest, &arms[v].rest)}) {
        if constexpr (dim == 3) (*arm)[axis] = 0;
        (*turned)[i] = -sense * (*arm)[k];
        (*turned)[k] = sense * (*arm)[i];
      }
    }
    inertia += facet_size(first, f) * mean_square(arms);
  }
  refuse_along_support(first, quantity, facets, perturbation);
  return linear(std::move(perturbation), inertia);
}

template <int dim> Functionals<dim> body_displacement(const Problem<dim>& first, const Quantity<dim>& quantity) {
  const int body = body_named(first, quantity);
  Perturbation<dim> perturbation = scene::no_perturbation(first);
  perturbation.force[body] = *quantity.direction;
  return linear(std::move(perturbation), body_size(first, body) * size(*quantity.direction));
}

template Functionals<2> mean_displacement(const Problem<2>&, const Quantity<2>&);
template Functionals<3> mean_displacement(const Problem<3>&, const Quantity<3>&);
template Functionals<2> rotation(const Problem<2>&, const Quantity<2>&);
template Functionals<3> rotation(const Problem<3>&, const Quantity<3>&);
template Functionals<2> body_displacement(const Problem<2>&, const Quantity<2>&);
template Functionals<3> body_displacement(const Problem<3>&, const Quantity<3>&);

}  // namespace bracket::bounds
