// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/rows.h"

#include <limits>

namespace bracket::dual {

using scene::ContactFacet;
using scene::Problem;

template <int dim> std::vector<RowOf> contact_rows(const Problem<dim>& problem, int degree, Shear shear) {
  std::vector<RowOf> rows;
  for (const bool slip : {false, true})
    for (std::size_t j = 0; j < problem.contact.size(); ++j) {
      const scene::FacetLaw& law = problem.contact[j].law;
      const bool cone = shear == Shear::by_pressure && law.coulomb > 0;
      for (int i = 0; i <= degree && (!slip || has_friction(law)); ++i) {
        RowOf row{static_cast<int>(j), i, slip, slip ? 0.0 : 1.0, slip ? 1.0 : 0.0};
        if (cone) row = {row.facet, i, slip, 0.5 / law.coulomb, slip ? -0.5 : 0.5};
        rows.push_back(row);
      }
    }
  return rows;
}

template <int dim>
void set_contact_rows(const Problem<dim>& problem, const Layout& layout, const std::vector<RowOf>& rows,
                      std::vector<contact::System>& bodies) {
  const auto& mesh = problem.mesh;
  const int degree = layout.degree;
  std::vector<std::vector<Eigen::Triplet<double>>> entries(bodies.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const ContactFacet& pair = problem.contact[rows[r].facet];
    const double length = scene::length(mesh, pair.first);
    for (const int side : {pair.first, pair.second}) {
      if (side < 0) continue;
      const auto& facet = mesh.boundary[side];
      const Edge& edge = layout.edges[facet.edge];
      const int begin = facet.vertices[side == pair.first ? 0 : 1];  // where the first facet begins
      for (int i = 0; i <= degree; ++i) {
        const int place = 2 * along_edge(mesh, degree, facet.edge, begin, i);
        const double mean = scene::number<double>(scene::bernstein_mass(degree, rows[r].i, degree, i));
        for (const auto& [weight, k] : {std::pair(rows[r].of_approach, 0), {rows[r].of_slip, 1}})
          if (weight != 0)
            entries[mesh.cell_component[facet.cell]].emplace_back(static_cast<int>(r), edge.unknown[place + k],
                                                                  weight * length * mean);
      }
    }
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    bodies[b].rows.resize(static_cast<int>(rows.size()), bodies[b].nodes.back());
    bodies[b].rows.setFromTriplets(entries[b].begin(), entries[b].end());
  }
}

// With N = L Lᵀ the matrix of ∫ C B_i B_k on a facet, springs of stiffness one that rows −L act on give way by N p.
template <int dim> void add_springs(const Problem<dim>& problem, int degree, std::vector<contact::System>& bodies) {
  const int n = degree + 1;
  contact::System springs;
  springs.nodes = {0};
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const ContactFacet& pair = problem.contact[j];
    if (!has_springs(pair.law)) continue;
    const auto c = scene::compliance_on<double>(pair.law.modulus[0], pair.law.modulus[1]);
    const double length = scene::length(problem.mesh, pair.first);
    Eigen::MatrixXd mass(n, n);
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) {
        const double factor = static_cast<double>(scene::binomial(degree, i) * scene::binomial(degree, k)) /
                              scene::binomial(2 * degree, i + k);
        double mean = 0;
        for (int a = 0; a < 4; ++a)
          mean += scene::number<double>(scene::bernstein_mass(2 * degree, i + k, 3, a)) * c[a];
        mass(i, k) = length * factor * mean;
      }
    const Eigen::MatrixXd half = mass.llt().matrixL();
    const int begin = springs.nodes.back();
    for (int i = 0; i < n; ++i)
      for (int k = 0; k <= i; ++k) entries.emplace_back(n * static_cast<int>(j) + i, begin + k, -half(i, k));
    springs.nodes.push_back(begin + n);
  }
  const int size = springs.nodes.back();
  if (size == 0) return;
  springs.stiffness.resize(size, size);
  springs.stiffness.setIdentity();
  springs.rows.resize(bodies.front().rows.rows(), size);
  springs.rows.setFromTriplets(entries.begin(), entries.end());
  springs.rigid.resize(size, 0);
  bodies.push_back(std::move(springs));
}

template <int dim> contact::Limits limits(const Problem<dim>& problem, int degree, const std::vector<RowOf>& rows) {
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  contact::Limits limits{Eigen::VectorXd::Zero(rows.size()), Eigen::VectorXd::Constant(rows.size(), unlimited)};
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const scene::FacetLaw& law = problem.contact[rows[r].facet].law;
    if (rows[r].of_approach == 1 && law.two_sided) limits.lower[r] = -unlimited;
    if (rows[r].of_slip != 1) continue;
    limits.upper[r] = scene::linear_coefficient<double>(law.friction[0], law.friction[1], degree, rows[r].i);
    limits.lower[r] = -limits.upper[r];
  }
  return limits;
}

template std::vector<RowOf> contact_rows(const Problem<2>&, int, Shear);
template void set_contact_rows(const Problem<2>&, const Layout&, const std::vector<RowOf>&,
                               std::vector<contact::System>&);
template void add_springs(const Problem<2>&, int, std::vector<contact::System>&);
template contact::Limits limits(const Problem<2>&, int, const std::vector<RowOf>&);

}  // namespace bracket::dual
