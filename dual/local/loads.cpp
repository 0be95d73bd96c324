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

}  // namespace

template <int dim>
Loads<dim>::Loads(const Facets<dim>& facets, const std::vector<Star<dim>>& stars, const Repair<dim>& repair,
                  const typename LocalSolver<dim>::Start& start)
    : facets_(facets),
      problem_(start.problem),
      pressure_(start.pressure),
      loads_(problem_.mesh.cells.size()),
      prescribed_(prescribed_moments(problem_, facets)),
      lacking_(given_loads(problem_, facets, pressure_)),
      force_(loads_.size()),
      change_(loads_.size(), CellVector<dim>::Zero()),
      done_(loads_.size(), 0) {
  constexpr int one = n_facet_loads<dim>;
  const auto& mesh = problem_.mesh;
  std::vector<LinearStress<dim>> target = smoothed(problem_, stars, start.displacement);
  repair.put_in_balance(problem_, facets, stars, lacking_, target);
  scene::for_each_index(static_cast<int>(loads_.size()), [&](int c) {
    loads_[c] = loads_of(mesh, c, target[c]);
    force_[c] = body_of(problem_, c).force + divergence(mesh, c, target[c]);
  });
  for (std::size_t c = 0; c < loads_.size(); ++c)
    for (int i = 0; i <= dim; ++i)
      lacking_[cell_facets(mesh, static_cast<int>(c))[i]] -= loads_[c].template segment<one>(one * i);
}

template <int dim>
void Loads<dim>::add(const Star<dim>& star, const std::vector<SpokeVector<dim>>& change,
                     std::vector<CellVector<dim>>& loads) {
  for (std::size_t i = 0; i < change.size(); ++i) loads[star.cells()[i]] += on_cell<dim>(star.corner(i), change[i]);
}

template <int dim> void Loads<dim>::hand_out(const StarSystem<dim>& system) {
  const Star<dim>& star = system.star();
  StarData<dim> data(star);
  for (std::size_t i = 0; i < star.cells().size(); ++i) {
    const int c = star.cells()[i];
    ++done_[c];
    data.gradient[i] =
        times<dim>(system.energy(i).loads, star.corner(i), change_[c]) +
        on_spokes<dim>(star.corner(i), system.energy(i).by_body_force * (done_[c] / (dim + 1.0) * force_[c]));
    data.resultant[i] = -share_of<dim>(problem_.mesh, force_[c], c, star.corner(i));
  }
  for (std::size_t f = 0; f < star.spokes().size(); ++f) {
    const int number = star.spokes()[f];
    data.sum[f] = applied<dim>(share_of_vertex<dim>()[slot(facets_, number, star.vertex())], lacking_[number]);
  }
  add(star, system.solve(data).loads, change_);
}

template <int dim> void Loads<dim>::end_handing_out() {
  for (std::size_t c = 0; c < loads_.size(); ++c) loads_[c] += change_[c];
  lacking_ = {};
  force_ = {};
  change_ = {};
  done_ = {};
}

template <int dim> StarData<dim> Loads<dim>::as_they_are(const StarSystem<dim>& system) const {
  const Star<dim>& star = system.star();
  StarData<dim> data(star);
  for (std::size_t i = 0; i < star.cells().size(); ++i) {
    const int c = star.cells()[i];
    data.gradient[i] = times<dim>(system.energy(i).loads, star.corner(i), loads_[c]);
    if (const Vector<dim>& force = body_of(problem_, c).force; !force.isZero(0))
      data.gradient[i] += on_spokes<dim>(star.corner(i), system.energy(i).by_body_force * force);
  }
  for (std::size_t f = 0; f < star.spokes().size(); ++f) data.prescribed[f] = prescribed_[star.spokes()[f]];
  return data;
}

template <int dim> int Loads<dim>::unknowns() const {
  int sum = 0;
  for (const auto& facet : facets_.facet)
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
