// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/local/loads.h"

#include "dual/local/boundary.h"
#include "dual/local/smoothed.h"
#include "scene/parallel.h"
#include "scene/voigt.h"

namespace bracket::dual {

namespace {

using scene::Problem;
using scene::Support;
using scene::Vector;

/// The loads of a linear stress on the facets of a cell.
template <int dim> CellVector<dim> loads_of(const scene::Mesh<dim>& mesh, int cell, const LinearStress<dim>& stress) {
  CellVector<dim> loads;
  for (int i = 0; i <= dim; ++i) {
    const Vector<dim> outward = scene::area_vector<dim>(scene::positions(mesh, facet_vertices(mesh, cell, i)));
    const auto corners = sorted_corners<dim>(mesh.cells[cell], i);
    for (int slot = 0; slot < dim; ++slot)
      loads.template segment<dim>(n_facet_loads<dim> * i + dim * slot) =
          scene::traction<dim>(stress[corners[slot]], outward);
  }
  return loads;
}

/// div of a stress linear on a cell.
template <int dim> Vector<dim> divergence(const scene::Mesh<dim>& mesh, int cell, const LinearStress<dim>& stress) {
  const auto G = scene::hat_gradients<dim>(scene::positions(mesh, mesh.cells[cell]));
  Vector<dim> sum = Vector<dim>::Zero();
  for (int j = 0; j <= dim; ++j) sum += scene::traction<dim>(stress[j], G[j]);
  return sum;
}

/// Force and moments about the vertex of ψ_a F on a cell.
template <int dim>
Eigen::Matrix<double, scene::Simplex<dim>::n_rigid_motions, 1> share_of(const scene::Mesh<dim>& mesh,
                                                                        const Vector<dim>& force, int cell,
                                                                        int corner) {
  using Table = scene::Simplex<dim>;
  Eigen::Matrix<double, Table::n_rigid_motions, 1> result;
  const double volume = scene::volume(mesh, cell);
  Vector<dim> arm = Vector<dim>::Zero();
  for (const int v : mesh.cells[cell]) arm += mesh.vertices[v] - mesh.vertices[mesh.cells[cell][corner]];
  arm *= volume / Table::hat_masses_of;
  result.template head<dim>() = volume / (dim + 1) * force;
  for (int r = 0; r < Table::n_rotations; ++r) {
    const auto [i, j] = Table::rotations[r];
    result[dim + r] = arm[i] * force[j] - arm[j] * force[i];
  }
  return result;
}

/// σ*, close to that of a displacement.
template <int dim>
std::vector<LinearStress<dim>> target(const typename LocalSolver<dim>::Frame& frame, const Problem<dim>& problem,
                                      const std::vector<FacetVector<dim>>& given,
                                      const scene::Displacement<dim>& displacement) {
  std::vector<LinearStress<dim>> stress = smoothed(problem, frame.stars, displacement);
  const auto put_in_balance = [&](const Repair<dim>& repair) {
    repair.put_in_balance(problem, frame.facets, frame.stars, given, stress);
  };
  if (frame.repair)
    put_in_balance(*frame.repair);
  else
    put_in_balance(Repair<dim>(problem, frame.stars));
  return stress;
}

}  // namespace

template <int dim>
Loads<dim>::Loads(const Frame& frame, const Problem<dim>& problem, Pressure pressure,
                  const scene::Displacement<dim>& displacement)
    : frame_(frame),
      problem_(problem),
      pressure_(std::move(pressure)),
      given_(given_loads(problem, frame.facets, pressure_)),
      target_(target(frame, problem, given_, displacement)),
      own_(frame.energy.empty() ? energies_of(problem) : std::vector<Energy<dim>>()),
      energy_(frame.energy.empty() ? own_ : frame.energy),
      loads_(problem.mesh.cells.size()),
      prescribed_(prescribed_moments(problem, frame.facets)) {
  scene::for_each_index(static_cast<int>(loads_.size()),
                        [&](int c) { loads_[c] = loads_of(problem.mesh, c, target_[c]); });
}

template <int dim> std::shared_ptr<const StarSystem<dim>> Loads<dim>::system(const Star<dim>& star) const {
  if (frame_.systems.empty()) return std::make_shared<const StarSystem<dim>>(star, energy_);
  return frame_.kept(star);
}

template <int dim>
void Loads<dim>::for_each_pressed(const std::function<void(const Pressed<dim>&, const Systems<dim>&)>& work) const {
  const auto systems = [&](const Pressed<dim>& pressed) {
    Systems<dim> result;
    for (const int v : pressed.stars) result.push_back(system(frame_.stars[v]));
    return result;
  };
  for (const Pressed<dim>& kept : frame_.pressed) work(kept, systems(kept));
  if (!frame_.systems.empty()) return;
  const auto contacts = contacts_by_vertex(problem_);
  for (std::size_t v = 0; v < contacts.size(); ++v) {
    if (contacts[v].empty()) continue;
    Pressed<dim> pressed = pressed_at(problem_, frame_.facets, frame_.stars, static_cast<int>(v), contacts[v]);
    const Systems<dim> own = systems(pressed);
    work(with_forms(std::move(pressed), frame_.stars, own), own);
  }
}

template <int dim>
void Loads<dim>::add(const Star<dim>& star, const std::vector<SpokeVector<dim>>& change,
                     std::vector<CellVector<dim>>& loads) {
  for (std::size_t i = 0; i < change.size(); ++i) loads[star.cells()[i]] += on_cell<dim>(star.corner(i), change[i]);
}

template <int dim> void Loads<dim>::equilibrate() {
  const auto& mesh = problem_.mesh;
  constexpr int one = n_facet_loads<dim>;
  const std::size_t n = mesh.cells.size();
  std::vector<FacetVector<dim>> lacking =
      std::move(given_);              // on facets: what has to be there, less what the target has
  std::vector<Vector<dim>> force(n);  // F + div σ*
  for (std::size_t c = 0; c < n; ++c) {
    const int cell = static_cast<int>(c);
    for (int i = 0; i <= dim; ++i) lacking[cell_facets(mesh, cell)[i]] -= loads_[c].template segment<one>(one * i);
    force[c] = body_of(problem_, cell).force + divergence(mesh, cell, target_[c]);
  }
  std::vector<CellVector<dim>> change(n, CellVector<dim>::Zero());
  std::vector<int> done(n, 0);
  frame_.for_each_star([&](const Star<dim>& star) {
    StarData<dim> data(star);
    for (std::size_t i = 0; i < star.cells().size(); ++i) {
      const int c = star.cells()[i];
      ++done[c];
      data.gradient[i] = times<dim>(energy_[c].loads, star.corner(i), change[c]) +
                         on_spokes<dim>(star.corner(i), energy_[c].by_body_force * (done[c] / (dim + 1.0) * force[c]));
      data.resultant[i] = -share_of<dim>(mesh, force[c], c, star.corner(i));
    }
    for (std::size_t f = 0; f < star.spokes().size(); ++f) {
      const int number = star.spokes()[f];
      data.sum[f] = applied<dim>(share_of_vertex<dim>()[slot(frame_.facets, number, star.vertex())], lacking[number]);
    }
    add(star, system(star)->solve(data).loads, change);
  });
  for (std::size_t c = 0; c < n; ++c) loads_[c] += change[c];
  target_.clear();
}

template <int dim> void Loads<dim>::sweep() {
  frame_.for_each_star([&](const Star<dim>& star) { add(star, system(star)->solve(as_they_are(star)).loads); });
}

template <int dim> StarData<dim> Loads<dim>::as_they_are(const Star<dim>& star) const {
  StarData<dim> data(star);
  for (std::size_t i = 0; i < star.cells().size(); ++i) {
    const int c = star.cells()[i];
    data.gradient[i] = times<dim>(energy_[c].loads, star.corner(i), loads_[c]);
    if (const Vector<dim>& force = body_of(problem_, c).force; !force.isZero(0))
      data.gradient[i] += on_spokes<dim>(star.corner(i), energy_[c].by_body_force * force);
  }
  for (std::size_t f = 0; f < star.spokes().size(); ++f) data.prescribed[f] = prescribed_[star.spokes()[f]];
  return data;
}

template <int dim> int Loads<dim>::unknowns() const {
  int sum = 0;
  for (const auto& facet : frame_.facets.facet)
    sum += facet.boundary < 0 || facet.support == Support::fixed ? n_facet_loads<dim>
           : facet.support == Support::sliding                   ? dim
                                                                 : 0;
  return sum;
}

template <int dim> scene::Stress<dim> Loads<dim>::stress() const {
  const auto& mesh = problem_.mesh;
  scene::Stress<dim> result;
  result.cell.resize(loads_.size());
  scene::for_each_index(static_cast<int>(loads_.size()), [&](int c) {
    const auto block = stress_of<dim>(mesh.cells[c], geometry_of(mesh, c), loads_[c], body_of(problem_, c).force);
    for (const auto& part : block)
      for (const auto& tensor : part) result.cell[c].push_back(Eigen::Map<const scene::Voigt<dim>>(tensor.data()));
  });
  return result;
}

template class Loads<2>;
template class Loads<3>;

}  // namespace bracket::dual
