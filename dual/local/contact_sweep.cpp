// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/local/contact_sweep.h"

#include <limits>

#include "dual/local/contact_step.h"
#include "dual/local/pressed.h"
#include "scene/bernstein.h"

namespace bracket::dual {

namespace {

using scene::Problem;

/// ∫ ψ_k g⁺ over a contact facet, k one of the first facet's vertices.
template <int dim> double gap_moment(const scene::Mesh<dim>& mesh, const scene::ContactFacetOf<dim>& pair, int k) {
  const double size = scene::area_vector<dim>(scene::positions(mesh, mesh.boundary[pair.first].vertices)).norm();
  double sum = 0;
  for (std::size_t i = 0; i < pair.upper.size(); ++i) {
    if constexpr (dim == 2) {
      sum += scene::number<double>(scene::bernstein_mass(1, k, 2, static_cast<int>(i))) * pair.upper[i];
    } else {  // of vertices 1/10, 1/30; of edges that end at the vertex 1/15, the other 1/30
      const bool own = i < 3 ? static_cast<int>(i) == k : static_cast<int>(i) - 3 != k;
      sum += (i < 3 ? (own ? 3 : 1) : (own ? 2 : 1)) / 30.0 * pair.upper[i];
    }
  }
  return size * sum;
}

/// Gives the pressures at a vertex, and the loads on its stars, their least S.
template <int dim> void press(Loads<dim>& loads, const Pressed<dim>& pressed, const Systems<dim>& systems) {
  const Problem<dim>& problem = loads.problem();
  const auto n = static_cast<Eigen::Index>(pressed.units.size());
  std::vector<StarData<dim>> data;
  std::vector<typename StarSystem<dim>::Solution> at_rest;  // by the pressures as they are
  for (std::size_t t = 0; t < systems.size(); ++t) {
    data.push_back(loads.as_they_are(systems[t]));
    at_rest.push_back(systems[t].solve(data[t]));
  }
  SmallProblem small{pressed.form, Eigen::VectorXd(n), pressed.motion, Eigen::VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& unit = pressed.units[i];
    const auto& pair = problem.contact[unit.contact];
    small.least[i] =
        pair.law.two_sided ? -std::numeric_limits<double>::infinity() : -loads.pressure()[unit.contact][unit.vertex];
    small.slope[i] = gap_moment(problem.mesh, pair, unit.vertex);
    for (const auto& [t, spoke, load] : unit.on) small.slope[i] += load.dot(at_rest[t].displacement[spoke]);
  }
  const Eigen::VectorXd change = descend(small, 8 * static_cast<int>(n));
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& unit = pressed.units[i];
    loads.add_pressure(unit.contact, unit.vertex, change[i]);
    for (const auto& [t, spoke, load] : unit.on) data[t].sum[spoke] += change[i] * load;
  }
  for (std::size_t t = 0; t < data.size(); ++t) loads.add(systems[t].star(), systems[t].solve(data[t]).loads);
}

}  // namespace

template <int dim>
void contact_sweep(const std::vector<Star<dim>>& stars, const Energies<dim>& energy,
                   const std::vector<std::unique_ptr<Loads<dim>>>& loads) {
  const Problem<dim>& any = loads.front()->problem();
  const auto contacts = contacts_by_vertex(any);
  for (std::size_t v = 0; v < contacts.size(); ++v) {
    if (contacts[v].empty()) continue;
    Pressed<dim> pressed = pressed_at(any, loads.front()->facets(), stars, static_cast<int>(v), contacts[v]);
    Systems<dim> systems;
    for (const int star : pressed.stars) systems.emplace_back(stars[star], energy);
    pressed = with_forms(std::move(pressed), stars, systems);
    for (const auto& one : loads) press(*one, pressed, systems);
  }
}

#define INSTANTIATE(dim)                                                           \
  template void contact_sweep(const std::vector<Star<dim>>&, const Energies<dim>&, \
                              const std::vector<std::unique_ptr<Loads<dim>>>&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::dual
