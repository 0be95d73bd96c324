// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <stdexcept>

#include "primal/approach.h"
#include "primal/factorised.h"
#include "primal/matched_pressure.h"
#include "scene/problem/law.h"

namespace bracket::primal {

namespace {

using scene::ContactFacetOf;
using scene::Problem;
using scene::Simplex;
using scene::Vector;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// r against the hat function of vertex i of a contact facet, by its area: Σ_k ∫ φ_i B_k r_k, at most as for g.
template <int dim> Row moment(const Approach<dim>& approach, int facet, int i) {
  const Problem<dim>& problem = approach.problem;
  const ContactFacetOf<dim>& pair = problem.contact[facet];
  const double area = scene::length(problem.mesh, pair.first);
  const auto mean = [&](int degree, int k) { return scene::number<double>(scene::hat_mean<dim>(degree, k, i)); };
  Row row{{}, 0, 0, facet, least_pressure(pair)};
  for (int k = 0; k < scene::n_on_facet<dim>(2); ++k) {  // S pays for the upper gap
    const double gap = pair.law.two_sided ? gap_coefficient(pair, k) : pair.upper[k];
    row.bound += area * mean(2, k) * gap;
    row.size += area * mean(2, k) * std::abs(gap);
  }
  const int degree = spring_degree(approach.nodes.degree);
  for (int k = 0; k < scene::n_on_facet<dim>(degree); ++k)
    approach.add_coefficient(row, pair, k, problem.facets[pair.first].normal, area * mean(degree, k));
  return row;
}

/// Where contact facets meet: a vertex of the plane, an edge of space, on both sides; and the vertices of the first
/// facet there.
template <int dim> struct Place {
  int facet;
  std::array<int, std::size_t{dim} - 1> vertices;
};
template <int dim> std::map<std::pair<int, int>, std::vector<Place<dim>>> places(const Approach<dim>& approach) {
  std::map<std::pair<int, int>, std::vector<Place<dim>>> result;
  const auto& contact = approach.problem.contact;
  for (std::size_t j = 0; j < contact.size(); ++j)
    for (int k = 0; k < dim; ++k) {
      if constexpr (dim == 2) result[approach.vertices(contact[j], k)].push_back({static_cast<int>(j), {k}});
      if constexpr (dim == 3)
        result[approach.edges(contact[j], k)].push_back({static_cast<int>(j), Simplex<2>::edges[k]});
    }
  return result;
}

/// γ c h² ∫ [p]² at each of them, c = (C⁻¹)₁₁ of the sides, h a facet's height: displacements of degree 2 do not see
/// pressures that jump to and fro. Not across a ridge, where the pressure may jump.
template <int dim> Eigen::SparseMatrix<double> jumps(const Approach<dim>& approach) {
  constexpr double gamma = 0.1, ridge = 0.8;
  const Problem<dim>& problem = approach.problem;
  const auto& mesh = problem.mesh;
  const auto compliance = [&](const ContactFacetOf<dim>& pair) {
    double sum = 0;
    for (const int side : {pair.first, pair.second})
      if (side >= 0) sum += body_of(problem, mesh.boundary[side].cell).material.compliance()(0, 0);
    return sum;
  };
  Triplets entries;
  for (const auto& [at, of] : places(approach))
    for (std::size_t a = 0; a < of.size(); ++a)
      for (std::size_t b = a + 1; b < of.size(); ++b) {
        const auto &one = problem.contact[of[a].facet], &other = problem.contact[of[b].facet];
        if (problem.facets[one.first].normal.dot(problem.facets[other.first].normal) <= ridge) continue;
        const auto &of_one = mesh.boundary[one.first].vertices, &of_other = mesh.boundary[other.first].vertices;
        const double area = std::min(scene::length(mesh, one.first), scene::length(mesh, other.first));
        double size = 1, height = area;
        if constexpr (dim == 3) {
          size = (mesh.vertices[of_one[of[a].vertices[0]]] - mesh.vertices[of_one[of[a].vertices[1]]]).norm();
          height = 2 * area / size;
        }
        const double factor = gamma * (compliance(one) + compliance(other)) / 2 * height * height * size;
        std::array<std::array<int, 2>, dim - 1> unknowns;  // at each vertex, on either facet
        for (int v = 0; v < dim - 1; ++v)
          for (const int i : of[b].vertices)
            if (of_other[i] == of_one[of[a].vertices[v]])
              unknowns[v] = {dim * of[a].facet + of[a].vertices[v], dim * of[b].facet + i};
        for (int v = 0; v < dim - 1; ++v)
          for (int w = 0; w < dim - 1; ++w) {
            const double mass = dim == 2 ? 1.0 : Simplex<1>::hat_mass(v, w) / 6.0;
            for (int s = 0; s < 2; ++s)
              for (int t = 0; t < 2; ++t)
                entries.emplace_back(unknowns[v][s], unknowns[w][t], (s == t ? 1 : -1) * factor * mass);
          }
      }
  const auto m = static_cast<Eigen::Index>(dim * problem.contact.size());
  Eigen::SparseMatrix<double> result(m, m);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace

template <int dim> struct PressureSolver<dim>::Rows {
  std::shared_ptr<const typename Solver<dim>::Factorised> of;
  contact::Bodies bodies;
};

template <int dim> PressureSolver<dim>::PressureSolver(const Solver<dim>& displacements, const Problem<dim>& problem) {
  const auto& of = displacements.factorised_;
  const Nodes<dim> nodes = of->own_nodes(problem);
  const Approach<dim> approach{nodes, problem};
  const auto m = static_cast<Eigen::Index>(dim * problem.contact.size());
  std::vector<Triplets> entries(nodes.body_nodes.size());
  for (Eigen::Index i = 0; i < m; ++i) {
    const int row = static_cast<int>(i);
    for (const auto& entry : moment(approach, row / dim, row % dim).entries)
      entries[entry.body].emplace_back(row, entry.unknown, entry.coefficient);
  }
  std::vector<Eigen::SparseMatrix<double>> rows;
  for (std::size_t b = 0; b < entries.size(); ++b) {
    rows.emplace_back(m, nodes.body_nodes[b].back());
    rows.back().setFromTriplets(entries[b].begin(), entries[b].end());
    rows.back().prune([](auto, auto, double value) { return value != 0; });  // at the tip of a crack both sides are one
  }
  rows_ = std::make_shared<const Rows>(Rows{of, of->bodies.with_rows(std::move(rows), jumps(approach))});
}

template <int dim>
PressureResult<dim> PressureSolver<dim>::solve(const Problem<dim>& problem, const std::vector<char>& closed) const {
  const auto& of = *rows_->of;
  const Nodes<dim> nodes = of.own_nodes(problem);
  const Approach<dim> approach{nodes, problem};
  const auto m = static_cast<Eigen::Index>(dim * problem.contact.size());
  if (m != rows_->bodies.rows().front().rows())
    throw std::invalid_argument("primal::PressureSolver: the problem has other contact than the one it was made for");
  contact::Limits limits{Eigen::VectorXd(m), Eigen::VectorXd(m)};
  Eigen::VectorXd bounds(m);
  std::vector<char> guess;
  for (Eigen::Index i = 0; i < m; ++i) {
    if (!closed.empty()) guess.push_back((closed[i / dim] & scene::touches) != 0);
    const Row row = moment(approach, static_cast<int>(i) / dim, static_cast<int>(i) % dim);
    bounds[i] = row.bound;
    limits.lower[i] = row.lower;
    limits.upper[i] = row.upper;
  }
  const contact::Solution solution = rows_->bodies.solve(of.forces(problem, nodes), bounds, guess, limits);
  PressureResult<dim> result;
  result.termination = solution.termination;
  result.reason = contact::reason(solution, "pressures", problem.mesh.components,
                                  "none that is linear on each facet of the contact balances the loads",
                                  "the gaps and the prescribed displacements contradict each other");
  if (solution.termination != contact::Termination::solved) return result;
  result.displacement = recover(problem.mesh, nodes, solution.displacement);
  result.pressure.resize(problem.contact.size());
  for (Eigen::Index i = 0; i < m; ++i) result.pressure[i / dim][i % dim] = solution.pressure[i];
  return result;
}

template <int dim>
PressureResult<dim> Solver<dim>::solve_with_pressure(const Problem<dim>& problem,
                                                     const std::vector<char>& closed) const {
  return PressureSolver<dim>(*this, problem).solve(problem, closed);
}

template <int dim>
MatchedPressure<dim> matched_pressure(const Problem<dim>& problem, const Nodes<dim>& nodes, const ContactForces& forces,
                                      const std::vector<char>& closed) {
  const Approach<dim> approach{nodes, problem};
  const auto m = static_cast<Eigen::Index>(dim * problem.contact.size());
  const std::size_t n_bodies = nodes.body_nodes.size();
  MatchedPressure<dim> result;
  for (std::size_t b = 0; b < n_bodies; ++b) result.force.push_back(Eigen::VectorXd::Zero(nodes.body_nodes[b].back()));
  if (m == 0) return result;
  std::vector<Row> rows;
  std::vector<std::vector<int>> place;  // of each body's unknowns among those that contact touches, −1: it does not
  for (std::size_t b = 0; b < n_bodies; ++b) place.emplace_back(nodes.body_nodes[b].back(), -1);
  int n = 0;
  for (Eigen::Index i = 0; i < m; ++i) {
    rows.push_back(moment(approach, static_cast<int>(i) / dim, static_cast<int>(i) % dim));
    for (const auto& entry : rows.back().entries)
      if (int& at = place[entry.body][entry.unknown]; at < 0) at = n++;
  }
  int motions = 0;
  for (const Eigen::MatrixXd& rigid : forces.rigid) motions += static_cast<int>(rigid.cols());
  // One body of springs between the contact and rigid bodies, whose free motions are unknowns of their own.
  contact::System springs;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(n + motions);
  Triplets stiffness, entries;
  springs.rigid = Eigen::MatrixXd::Zero(n + motions, motions);
  springs.rigid.bottomRows(motions).setIdentity();
  for (int i = 0; i <= n + motions; ++i) springs.nodes.push_back(i);
  std::vector<int> first_motion;
  for (std::size_t b = 0; b < n_bodies; ++b) {
    first_motion.push_back(b == 0 ? n : first_motion.back() + static_cast<int>(forces.rigid[b - 1].cols()));
    load.segment(first_motion[b], forces.rigid[b].cols()) = forces.rigid[b].transpose() * forces.load[b];
    for (std::size_t u = 0; u < place[b].size(); ++u) {
      if (place[b][u] < 0) continue;
      const auto unknown = static_cast<Eigen::Index>(u);
      stiffness.emplace_back(place[b][u], place[b][u], forces.stiffness[b][unknown]);
      load[place[b][u]] = forces.force[b][unknown];
    }
  }
  contact::Limits limits{Eigen::VectorXd(m), Eigen::VectorXd(m)};
  std::vector<char> guess;
  Eigen::VectorXd left(m);  // of the gap
  for (Eigen::Index i = 0; i < m; ++i) {
    for (const auto& [body, unknown, coefficient] : rows[i].entries) {
      entries.emplace_back(static_cast<int>(i), place[body][unknown], coefficient);
      for (Eigen::Index k = 0; k < forces.rigid[body].cols(); ++k)
        entries.emplace_back(static_cast<int>(i), first_motion[body] + static_cast<int>(k),
                             coefficient * forces.rigid[body](unknown, k));
    }
    left[i] = rows[i].bound;
    for (const auto& [body, unknown, coefficient] : rows[i].entries)
      left[i] -= coefficient * forces.displacement[body][unknown];
    limits.lower[i] = rows[i].lower;
    limits.upper[i] = rows[i].upper;
    if (!closed.empty()) guess.push_back((closed[i / dim] & scene::touches) != 0);
  }
  // They are pinned, as all of them are a motion; so that stiffness serves as a pivot alone.
  for (int i = n; i < n + motions; ++i) stiffness.emplace_back(i, i, 1);
  springs.stiffness.resize(n + motions, n + motions);
  springs.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
  springs.rows.resize(m, n + motions);
  springs.rows.setFromTriplets(entries.begin(), entries.end());
  springs.rows.prune([](auto, auto, double value) { return value != 0; });
  std::vector<Eigen::SparseMatrix<double>> of_springs = {springs.rows};
  std::vector<contact::System> systems;
  systems.push_back(std::move(springs));
  const contact::Solution solution = contact::Bodies(std::move(systems), true)
                                         .with_rows(std::move(of_springs), jumps(approach))
                                         .solve({load}, left, guess, limits);
  result.termination = solution.termination;
  if (solution.termination != contact::Termination::solved) return result;
  result.pressure.resize(problem.contact.size());
  for (Eigen::Index i = 0; i < m; ++i) {
    result.pressure[i / dim][i % dim] = solution.pressure[i];
    for (const auto& [body, unknown, coefficient] : rows[i].entries)
      result.force[body][unknown] += coefficient * solution.pressure[i];
  }
  return result;
}

template MatchedPressure<3> matched_pressure(const Problem<3>&, const Nodes<3>&, const ContactForces&,
                                             const std::vector<char>&);
template struct PressureResult<2>;
template struct PressureResult<3>;
template class PressureSolver<2>;
template class PressureSolver<3>;
template PressureResult<2> Solver<2>::solve_with_pressure(const Problem<2>&, const std::vector<char>&) const;
template PressureResult<3> Solver<3>::solve_with_pressure(const Problem<3>&, const std::vector<char>&) const;

}  // namespace bracket::primal
