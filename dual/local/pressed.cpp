// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/local/pressed.h"

#include "dual/local/boundary.h"

namespace bracket::dual {

template <int dim>
Pressed<dim> pressed_at(const scene::Problem<dim>& problem, const Facets<dim>& facets,
                        const std::vector<Star<dim>>& stars, int vertex, const std::vector<int>& contacts) {
  const auto& boundary = problem.mesh.boundary;
  Pressed<dim> result;
  const auto place_of = [&](int v) {
    const auto found = std::find(result.stars.begin(), result.stars.end(), v);
    const auto place = static_cast<std::size_t>(found - result.stars.begin());
    if (found == result.stars.end()) result.stars.push_back(v);
    return place;
  };
  for (const int j : contacts) {
    const auto& pair = problem.contact[j];
    const auto& first = boundary[pair.first].vertices;
    const auto place = std::find(first.begin(), first.end(), vertex) - first.begin();
    const double size = scene::area_vector<dim>(scene::positions(problem.mesh, first)).norm();
    for (int k = 0; k < dim; ++k) {
      typename Pressed<dim>::Unit unit{{}, j, k};
      const auto act = [&](int facet, int at_star, int own, double sign) {
        const auto& spokes = stars[at_star].spokes();
        const int number = number_of(problem.mesh, facet);
        FacetVector<dim> load = FacetVector<dim>::Zero();
        load.template segment<dim>(dim * slot(facets, number, boundary[facet].vertices[own])) =
            sign * size * problem.facets[pair.first].normal;
        unit.on.push_back({place_of(at_star),
                           static_cast<int>(std::lower_bound(spokes.begin(), spokes.end(), number) - spokes.begin()),
                           load});
      };
      act(pair.first, vertex, k, -1);
      if (pair.second >= 0) act(pair.second, boundary[pair.second].vertices[pair.meets[place]], pair.meets[k], 1);
      result.units.push_back(std::move(unit));
    }
  }
  return result;
}

template <int dim>
Pressed<dim> with_forms(Pressed<dim> pressed, const std::vector<Star<dim>>& stars, const Systems<dim>& systems) {
  const auto n = static_cast<Eigen::Index>(pressed.units.size());
  std::vector<Eigen::Index> first_motion;
  Eigen::Index motions = 0;
  for (const int v : pressed.stars) {
    first_motion.push_back(motions);
    motions += stars[v].motions().cols();
  }
  Eigen::MatrixXd& form = pressed.form = Eigen::MatrixXd::Zero(n, n);
  pressed.motion = Eigen::MatrixXd::Zero(n, motions);
  for (Eigen::Index i = 0; i < n; ++i)
    for (const auto& [t, spoke, load] : pressed.units[i].on) {
      const Star<dim>& star = stars[pressed.stars[t]];
      Eigen::Matrix<double, scene::Simplex<dim>::n_rigid_motions, 1> wrench = resultants<dim>(star.arms(spoke)) * load;
      wrench.template tail<scene::Simplex<dim>::n_rotations>() /= star.size();
      pressed.motion.row(i).segment(first_motion[t], star.motions().cols()) += wrench.transpose() * star.motions();
      const auto moved = systems[t].moved_by(spoke, load);
      for (Eigen::Index k = 0; k < n; ++k)
        for (const auto& other : pressed.units[k].on)
          if (other.star == t) form(k, i) += other.load.dot(moved[other.spoke]);
    }
  form = (0.5 * (form + form.transpose())).eval();
  return pressed;
}

template <int dim> std::vector<std::vector<int>> contacts_by_vertex(const scene::Problem<dim>& problem) {
  std::vector<std::vector<int>> contacts(problem.mesh.vertices.size());
  for (std::size_t j = 0; j < problem.contact.size(); ++j)
    for (const int v : problem.mesh.boundary[problem.contact[j].first].vertices)
      contacts[v].push_back(static_cast<int>(j));
  return contacts;
}

#define INSTANTIATE(dim)                                                                                               \
  template Pressed<dim> pressed_at(const scene::Problem<dim>&, const Facets<dim>&, const std::vector<Star<dim>>&, int, \
                                   const std::vector<int>&);                                                           \
  template Pressed<dim> with_forms(Pressed<dim>, const std::vector<Star<dim>>&, const Systems<dim>&);                  \
  template std::vector<std::vector<int>> contacts_by_vertex(const scene::Problem<dim>&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::dual
