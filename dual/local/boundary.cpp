// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/local/boundary.h"

namespace bracket::dual {

using scene::Problem;
using scene::Support;
using scene::Vector;

template <int dim>
std::vector<FacetVector<dim>> given_loads(const Problem<dim>& problem, const Facets<dim>& facets,
                                          const std::vector<std::array<double, std::size_t{dim}>>& pressure) {
  std::vector<FacetVector<dim>> given(facets.facet.size(), FacetVector<dim>::Zero());
  const auto& boundary = problem.mesh.boundary;
  const auto number = [&](int f) { return number_of(problem.mesh, f); };
  const auto load_at = [&](int f, int k) {  // at the facet's own vertex k
    return given[number(f)].template segment<dim>(dim * slot(facets, number(f), boundary[f].vertices[k]));
  };
  for (std::size_t f = 0; f < boundary.size(); ++f) {
    if (!scene::is_loaded(problem.facets[f])) continue;
    const auto of_vertices = scene::load(problem, static_cast<int>(f));
    for (int k = 0; k < dim; ++k) load_at(static_cast<int>(f), k) = of_vertices[k];
  }
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const auto& pair = problem.contact[j];
    const double size = scene::area_vector<dim>(scene::positions(problem.mesh, boundary[pair.first].vertices)).norm();
    for (int k = 0; k < dim; ++k) {
      const Vector<dim> load = pressure[j][k] * size * problem.facets[pair.first].normal;
      load_at(pair.first, k) -= load;
      if (pair.second >= 0) load_at(pair.second, pair.meets[k]) += load;
    }
  }
  return given;
}

template <int dim>
std::vector<FacetVector<dim>> prescribed_moments(const Problem<dim>& problem, const Facets<dim>& facets) {
  std::vector<FacetVector<dim>> moments(facets.facet.size(), FacetVector<dim>::Zero());
  const auto& boundary = problem.mesh.boundary;
  const Eigen::Matrix<double, dim, dim> masses = hat_masses<dim>();
  for (std::size_t f = 0; f < boundary.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support != Support::fixed && data.support != Support::sliding) continue;
    const int number = number_of(problem.mesh, static_cast<int>(f));
    for (int k = 0; k < dim; ++k) {
      const Vector<dim> u = data.support == Support::fixed
                                ? data.displacement[k]
                                : Vector<dim>(data.normal_displacement[k] / data.normal.squaredNorm() * data.normal);
      const int at = slot(facets, number, boundary[f].vertices[k]);
      for (int j = 0; j < dim; ++j) moments[number].template segment<dim>(dim * j) += masses(j, at) * u;
    }
  }
  return moments;
}

#define INSTANTIATE(dim)                                                                                             \
  template std::vector<FacetVector<dim>> given_loads<dim>(const Problem<dim>&, const Facets<dim>&,                   \
                                                          const std::vector<std::array<double, std::size_t{dim}>>&); \
  template std::vector<FacetVector<dim>> prescribed_moments(const Problem<dim>&, const Facets<dim>&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::dual
