// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/local/loads.h"

#include "dual/local/boundary.h"
#include "dual/local/target.h"
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
Loads<dim>::Loads(const Problem<dim>& problem, Pressure pressure, const scene::Displacement<dim>& displacement)
    : problem_(problem), facets_(facets_of(problem)), pressure_(std::move(pressure)) {
  const auto& mesh = problem.mesh;
  const Stars stars = stars_of(mesh);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    stars_.emplace_back(problem, facets_, stars, static_cast<int>(v));
  groups_ = groups_apart(mesh, stars_);
  given_ = given_loads(problem, facets_, pressure_);
  target_ = target_stress(problem, facets_, stars_, given_, displacement);
  const int n = static_cast<int>(mesh.cells.size());
  energy_.resize(n);
  loads_.resize(n);
  scene::for_each_index(n, [&](int c) {
    energy_[c] = energy_of(problem, c);
    loads_[c] = loads_of(mesh, c, target_[c]);
  });
  prescribed_ = prescribed_moments(problem, facets_);
}

/// One after the other, but for those that have no cell in common.
template <int dim> template <class Work> void Loads<dim>::for_each_star(const Work& work) {
  constexpr int at_once = 16;  // a star is as much work as some dozens of cells
  for (const std::vector<int>& together : groups_)
    scene::for_each_index(
        static_cast<int>(together.size()), [&](int i) { work(stars_[together[i]]); }, at_once);
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
  for_each_star([&](const Star<dim>& star) {
    StarData<dim> data(star);
    for (std::size_t i = 0; i < star.cells().size(); ++i) {
      const int c = star.cells()[i];
      ++done[c];
      data.gradient[i] = on_spokes<dim>(
          star.corner(i), energy_[c].loads * change[c] + energy_[c].by_body_force * (done[c] / (dim + 1.0) * force[c]));
      data.resultant[i] = -share_of<dim>(mesh, force[c], c, star.corner(i));
    }
    for (std::size_t f = 0; f < star.spokes().size(); ++f) {
      const int number = star.spokes()[f];
      data.sum[f] = applied<dim>(share_of_vertex<dim>()[slot(facets_, number, star.vertex())], lacking[number]);
    }
    add(star, system(star).solve(data).loads, change);
  });
  for (std::size_t c = 0; c < n; ++c) loads_[c] += change[c];
  target_.clear();
}

template <int dim> void Loads<dim>::sweep() {
  for_each_star([&](const Star<dim>& star) { add(star, system(star).solve(as_they_are(star)).loads); });
}

template <int dim> StarData<dim> Loads<dim>::as_they_are(const Star<dim>& star) const {
  StarData<dim> data(star);
  for (std::size_t i = 0; i < star.cells().size(); ++i) {
    const int c = star.cells()[i];
    data.gradient[i] = on_spokes<dim>(
        star.corner(i), energy_[c].loads * loads_[c] + energy_[c].by_body_force * body_of(problem_, c).force);
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
