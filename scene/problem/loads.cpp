// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "scene/problem/perturbation.h"
#include "scene/problem/problem.h"
#include "scene/problem/space/face.h"
#include "scene/problem/stretch.h"

namespace bracket::scene {

template <int dim> bool is_loaded(const FacetData<dim>& data) {
  const auto acts = [](const Vector<dim>& load) { return !load.isZero(0); };
  return data.support != Support::fixed &&
         (std::any_of(data.traction.begin(), data.traction.end(), acts) ||
          std::any_of(data.correction.begin(), data.correction.end(), acts) ||
          std::any_of(data.pressure.begin(), data.pressure.end(), [](double p) { return p != 0; }) ||
          degree_of_load(data) > 1);
}

template <int dim> int degree_of_load(const FacetData<dim>& data) {
  const auto acts = [&](int k) { return !data.higher_traction[k].isZero(0) || data.higher_pressure[k] != 0; };
  return acts(1) ? 3 : acts(0) ? 2 : 1;
}

template <int dim> Vector<dim> traction_at(const FacetData<dim>& data, double t) {
  return value_at(EdgeCubic<Vector<dim>>{data.traction, data.higher_traction}, t);
}
template <int dim> double pressure_at(const FacetData<dim>& data, double t) {
  return value_at(EdgeCubic<double>{data.pressure, data.higher_pressure}, t);
}

namespace {

/// The share that a piece is of its facet, exactly.
double share(const std::array<std::array<double, 1>, 2>& corner) { return corner[1][0] - corner[0][0]; }
double share(const FacePart& corner) { return share_of_face(corner); }

/// A facet's own outward area vector: of the first mesh's facet, as far from the origin rounding turns small ones.
template <int dim> Vector<dim> outward(const Problem<dim>& problem, int facet) {
  const auto [of, corner] = piece_of_facet(problem, facet);
  const Mesh<dim>& first = first_of(problem).mesh;
  return share(corner) * area_vector<dim>(positions(first, first.boundary[of].vertices));
}

}  // namespace

template <int dim> std::array<Vector<dim>, std::size_t{dim}> load(const Problem<dim>& problem, int facet) {
  const FacetData<dim>& data = problem.facets[facet];
  const Vector<dim> outward = scene::outward(problem, facet);
  std::array<Vector<dim>, dim> result;
  for (int i = 0; i < dim; ++i)
    result[i] = outward.norm() * data.traction[i] - data.pressure[i] * outward + data.correction[i];
  return result;
}

template <int dim> std::array<Vector<dim>, 2> higher_load(const Problem<dim>& problem, int facet) {
  const FacetData<dim>& data = problem.facets[facet];
  const Vector<dim> outward = scene::outward(problem, facet);
  std::array<Vector<dim>, 2> result;
  for (int k = 0; k < 2; ++k) result[k] = outward.norm() * data.higher_traction[k] - data.higher_pressure[k] * outward;
  return result;
}

template <int dim> int degree_of_loads(const Problem<dim>& problem) {
  int degree = 1;
  for (const FacetData<dim>& data : first_of(problem).facets)
    if (data.support == Support::traction) degree = std::max(degree, degree_of_load(data));
  if (problem.perturbed.by)
    for (const auto& added : problem.perturbed.by->facets) degree = std::max(degree, degree_of_load<dim>(added));
  return degree;
}

template bool is_loaded(const FacetData<2>&);
template bool is_loaded(const FacetData<3>&);
template int degree_of_load(const FacetData<3>&);
template int degree_of_load(const FacetData<2>&);
template Vector<2> traction_at(const FacetData<2>&, double);
template double pressure_at(const FacetData<2>&, double);
template std::array<Vector<2>, 2> load(const Problem<2>&, int);
template std::array<Vector<3>, 3> load(const Problem<3>&, int);
template std::array<Vector<2>, 2> higher_load(const Problem<2>&, int);
template std::array<Vector<3>, 2> higher_load(const Problem<3>&, int);
template int degree_of_loads(const Problem<2>&);

}  // namespace bracket::scene
