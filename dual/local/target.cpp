// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/local/target.h"

#include <limits>

#include "scene/mesh/dissection.h"
#include "scene/parallel.h"
#include "scene/voigt.h"

namespace bracket::dual {

namespace {

using scene::Problem;
using scene::Vector;

template <int dim> inline constexpr int n_motions = scene::Simplex<dim>::n_rigid_motions;

template <int dim> std::array<Vector<dim>, dim + 1> gradients(const scene::Mesh<dim>& mesh, int cell) {
  return scene::hat_gradients<dim>(scene::positions(mesh, mesh.cells[cell]));
}

/// A compressible material of about the stiffness of another.
template <int dim> scene::Elasticity<dim> tame(const scene::Material<dim>& material) {
  const double young = dim / material.compliance().template topLeftCorner<dim, dim>().trace();
  const double shear = young / 2.6, lame = 1.5 * shear;  // ν = 0.3
  scene::Elasticity<dim> result = scene::Elasticity<dim>::Zero();
  result.template topLeftCorner<dim, dim>().setConstant(lame);
  result.diagonal().template head<dim>().array() += 2 * shear;
  result.diagonal().template tail<scene::n_voigt<dim> - dim>().setConstant(shear);
  return result;
}

/// At each vertex of a cell the strains of ψ_a ρ, ρ the motions of the stars of its vertices a, one after the other.
template <int dim>
std::array<Eigen::MatrixXd, dim + 1> strains(const Problem<dim>& problem, const std::vector<Star<dim>>& stars,
                                             int cell) {
  using Table = scene::Simplex<dim>;
  const auto& vertices = problem.mesh.cells[cell];
  const auto G = gradients<dim>(problem.mesh, cell);
  int n = 0;
  for (const int v : vertices) n += static_cast<int>(stars[v].motions().cols());
  std::array<Eigen::MatrixXd, dim + 1> result;
  for (int k = 0; k <= dim; ++k) {
    result[k].resize(scene::n_voigt<dim>, n);
    int column = 0;
    for (int a = 0; a <= dim; ++a) {
      const Star<dim>& star = stars[vertices[a]];
      const Vector<dim> arm = (problem.mesh.vertices[vertices[k]] - problem.mesh.vertices[vertices[a]]) / star.size();
      Eigen::Matrix<double, scene::n_voigt<dim>, n_motions<dim>> of_unit;
      for (int r = 0; r < n_motions<dim>; ++r) {
        Vector<dim> u = Vector<dim>::Zero();
        if (r < dim) {
          u[r] = 1;
        } else {
          const auto [i, j] = Table::rotations[r - dim];
          u[i] = -arm[j];
          u[j] = arm[i];
        }
        of_unit.col(r) = scene::strain<dim>(u * G[a].transpose());
      }
      const auto motions = star.motions().cols();
      result[k].middleCols(column, motions) = of_unit * star.motions();
      column += static_cast<int>(motions);
    }
  }
  return result;
}

/// What the stress σ̄ lacks of balance with the loads, by the motions of each star.
template <int dim>
std::vector<Eigen::VectorXd> defects(const Problem<dim>& problem, const Facets<dim>& facets,
                                     const std::vector<Star<dim>>& stars, const std::vector<FacetVector<dim>>& given,
                                     const std::vector<LinearStress<dim>>& stress) {
  const auto& mesh = problem.mesh;
  std::vector<Eigen::VectorXd> result(stars.size());
  constexpr double masses_of = scene::Simplex<dim>::hat_masses_of;
  scene::for_each_index(static_cast<int>(stars.size()), [&](int v) {
    using Table = scene::Simplex<dim>;
    const Star<dim>& star = stars[v];
    Eigen::Matrix<double, n_motions<dim>, 1> sum = Eigen::Matrix<double, n_motions<dim>, 1>::Zero();
    const auto add = [&](const Vector<dim>& force, const Vector<dim>& arm) {
      sum.template head<dim>() += force;
      for (int r = 0; r < Table::n_rotations; ++r) {
        const auto [i, j] = Table::rotations[r];
        sum[dim + r] += (arm[i] * force[j] - arm[j] * force[i]) / star.size();
      }
    };
    for (std::size_t i = 0; i < star.cells().size(); ++i) {
      const int c = star.cells()[i], a = star.corner(i);
      const double volume = scene::volume(mesh, c);
      const Vector<dim> G = gradients<dim>(mesh, c)[a];
      const Vector<dim>& force = body_of(problem, c).force;
      Vector<dim> total = Vector<dim>::Zero();
      for (int j = 0; j <= dim; ++j) total += scene::traction<dim>(stress[c][j], G);
      for (int k = 0; k <= dim; ++k) {
        const Vector<dim> arm = mesh.vertices[mesh.cells[c][k]] - mesh.vertices[v];
        const Vector<dim> own = total + scene::traction<dim>(stress[c][k], G);
        add(volume / masses_of * ((k == a ? 2 : 1) * force - own), arm);
      }
    }
    for (const int f : star.spokes()) {
      const auto& facet = facets.facet[f];
      if (facet.boundary < 0 || given[f].isZero(0)) continue;
      std::array<Vector<dim>, dim> x;
      for (int k = 0; k < dim; ++k) x[k] = mesh.vertices[facet.vertices[k]] - mesh.vertices[v];
      Eigen::Matrix<double, n_motions<dim>, 1> wrench =
          resultants<dim>(x) * applied<dim>(share_of_vertex<dim>()[slot(facets, f, v)], given[f]);
      wrench.template tail<n_motions<dim> - dim>() /= star.size();
      sum += wrench;
    }
    result[v] = star.motions().transpose() * sum;
  });
  return result;
}

}  // namespace

template <int dim>
Repair<dim>::Repair(const Problem<dim>& problem, const std::vector<Star<dim>>& stars)
    : node_(stars.size(), -1), component_(stars.size()), offsets_(problem.mesh.components.size(), {0}) {
  const auto& mesh = problem.mesh;
  const int n_cells = static_cast<int>(mesh.cells.size());
  // Vertices are nodes, of each component in their order.
  std::vector<std::vector<int>> cell_nodes(mesh.components.size());
  std::vector<std::vector<std::uint64_t>> paths(mesh.components.size());
  const std::vector<std::uint64_t> all_paths = scene::dissect(mesh);
  for (int c = 0; c < n_cells; ++c) {
    auto& of = offsets_[mesh.cell_component[c]];
    for (const int v : mesh.cells[c]) {
      if (node_[v] < 0) {
        node_[v] = static_cast<int>(of.size()) - 1;
        component_[v] = mesh.cell_component[c];
        of.push_back(of.back() + static_cast<int>(stars[v].motions().cols()));
      }
      cell_nodes[mesh.cell_component[c]].push_back(node_[v]);
    }
    paths[mesh.cell_component[c]].push_back(all_paths[c]);
  }
  for (const auto& body : problem.bodies) material_.push_back(tame<dim>(body.material));

  std::vector<contact::System> systems;
  for (std::size_t b = 0; b < offsets_.size(); ++b) {
    contact::Assembly assembly(offsets_[b], cell_nodes[b], dim + 1);
    for (int c = 0; c < n_cells; ++c) {
      if (mesh.cell_component[c] != static_cast<int>(b)) continue;
      const auto X = strains(problem, stars, c);
      Eigen::MatrixXd sum = X[0];
      for (int k = 1; k <= dim; ++k) sum += X[k];
      const auto& C = material_[mesh.cell_body[c]];
      Eigen::MatrixXd form = sum.transpose() * C * sum;
      for (const auto& of_vertex : X) form += of_vertex.transpose() * C * of_vertex;
      form *= scene::volume(mesh, c) / scene::Simplex<dim>::hat_masses_of;
      assembly.add(unknowns(mesh, c), form);
    }
    contact::System system;
    system.stiffness = assembly.take();
    matrices_.push_back(system.stiffness);
    // Motions of all vertices alike do not strain, nor do rotations of each about itself: what the matrix lacks there
    // is of no account, for the right side is in balance. Refinement takes the shift out.
    constexpr double shift = 1e-9;
    for (int i = 0; i < system.stiffness.cols(); ++i) system.stiffness.coeffRef(i, i) *= 1 + shift;
    system.nodes = offsets_[b];
    system.sequence = contact::elimination(paths[b], cell_nodes[b], static_cast<int>(system.nodes.size()) - 1);
    system.rows.resize(0, system.stiffness.cols());
    system.rigid.resize(system.stiffness.cols(), 0);
    systems.push_back(std::move(system));
  }
  bodies_.emplace(std::move(systems));
}

/// Those of the cell's component, vertex by vertex.
template <int dim> std::vector<int> Repair<dim>::unknowns(const scene::Mesh<dim>& mesh, int cell) const {
  const std::vector<int>& offsets = offsets_[mesh.cell_component[cell]];
  std::vector<int> result;
  for (const int v : mesh.cells[cell])
    for (int i = offsets[node_[v]]; i < offsets[node_[v] + 1]; ++i) result.push_back(i);
  return result;
}

template <int dim>
void Repair<dim>::put_in_balance(const Problem<dim>& problem, const Facets<dim>& facets,
                                 const std::vector<Star<dim>>& stars, const std::vector<FacetVector<dim>>& given,
                                 std::vector<LinearStress<dim>>& stress) const {
  const auto& mesh = problem.mesh;
  const std::vector<Eigen::VectorXd> lacking = defects(problem, facets, stars, given, stress);
  std::vector<Eigen::VectorXd> rights, amounts;
  for (const auto& offsets : offsets_) rights.emplace_back(offsets.back());
  for (std::size_t v = 0; v < stars.size(); ++v)
    if (node_[v] >= 0) rights[component_[v]].segment(offsets_[component_[v]][node_[v]], lacking[v].size()) = lacking[v];
  contact::Solution solution = bodies_->solve(rights, Eigen::VectorXd());
  if (solution.termination != contact::Termination::solved) return;
  for (std::size_t b = 0; b < offsets_.size(); ++b) {
    Eigen::VectorXd& x = amounts.emplace_back(std::move(solution.displacement[b]));
    constexpr int most_refinements = 5;
    const auto matrix = matrices_[b].template selfadjointView<Eigen::Lower>();
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < most_refinements && x.size() > 0; ++step) {
      const Eigen::VectorXd rest = rights[b] - matrix * x;
      if (!(rest.norm() < before / 2)) break;  // rounding
      before = rest.norm();
      x += bodies_->respond(static_cast<int>(b), rest);
    }
  }
  scene::for_each_index(static_cast<int>(mesh.cells.size()), [&](int c) {
    const auto X = strains(problem, stars, c);
    const Eigen::VectorXd own = amounts[mesh.cell_component[c]](unknowns(mesh, c));
    for (int k = 0; k <= dim; ++k) stress[c][k] += material_[mesh.cell_body[c]] * (X[k] * own);
  });
}

template class Repair<2>;
template class Repair<3>;

}  // namespace bracket::dual
