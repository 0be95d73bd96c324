// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "bounds/estimate/on_mesh.h"

namespace bracket::bounds {

using scene::Support;
using scene::Vector;
using scene::Voigt;

namespace {

/// The size of what deforms: the largest strain over the whole length, the gaps and the prescribed displacements. Rigid
/// motions stay out, so that a body that flies off does not hide how far it penetrates.
template <int dim>
double displacement_scale(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement) {
  double strain = 0;
  for (std::size_t c = 0; c < problem.mesh.cells.size(); ++c)
    for (const auto& e : bounds::strain(problem.mesh, displacement, static_cast<int>(c))) raise(strain, e.norm());
  return strain * problem.length_scale + largest_given(problem);
}

template <int dim>
double penetration(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                   const std::vector<ContactState>& states) {
  double worst = 0;
  for (std::size_t j = 0; j < states.size(); ++j) {
    const scene::FacetLaw& law = problem.contact[j].law;
    for (const double coefficient : states[j].gap_left)
      if (!has_springs(law)) raise(worst, law.two_sided ? std::abs(coefficient) : -coefficient);
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support != Support::fixed && data.support != Support::sliding) continue;
    const auto u = on_facet(problem.mesh, displacement, static_cast<int>(f));
    const auto fixed = coefficients(data.displacement, displacement.degree);
    const auto sliding = coefficients(data.normal_displacement, displacement.degree);
    for (std::size_t k = 0; k < u.size(); ++k)
      raise(worst,
            data.support == Support::fixed ? (u[k] - fixed[k]).norm() : std::abs(u[k].dot(data.normal) - sliding[k]));
  }
  return worst;
}

/// The corners of part k of a cell, relative to the cell's centroid. They are made of differences of vertices, which
/// are exact: far from the origin the centroid itself would be rounded by more than small cells bear.
template <int dim> std::array<Vector<dim>, dim + 1> part(const scene::Mesh<dim>& mesh, int cell, int k) {
  const auto x = scene::positions(mesh, scene::facet_vertices(mesh, cell, k));
  const Vector<dim>& opposite = mesh.vertices[mesh.cells[cell][k]];
  std::array<Vector<dim>, dim + 1> result;
  for (int i = 0; i < dim; ++i) {
    Vector<dim> sum = Vector<dim>::Zero();
    for (int j = 0; j < dim; ++j)
      if (j != i) sum += x[i] - x[j];
    result[i] = (sum + (x[i] - opposite)) / (dim + 1);
  }
  result[dim] = Vector<dim>::Zero();
  return result;
}

/// The largest jump of the traction between part k of a cell and those after it, by coefficients.
double jumps_between_parts(const scene::Mesh<2>& mesh, const scene::Stress<2>& stress, int cell, int k) {
  const int degree = stress.degree;
  double worst = 0;
  // The side from corner 1 of part k to its corner 2 is that from corner 0 to 2 of part k+1.
  const auto x = part(mesh, cell, k);
  const Vector<2> n = scene::area_vector<2>({x[2], x[1]}).normalized();
  const auto own = scene::stress_of_part(stress, cell, k), next = scene::stress_of_part(stress, cell, (k + 1) % 3);
  for (int i = 0; i <= degree; ++i)
    raise(worst, scene::traction<2>(
                     own[scene::bernstein_place(degree, degree - i, i)] - next[scene::bernstein_place(degree, 0, i)], n)
                     .norm());
  return worst;
}
double jumps_between_parts(const scene::Mesh<3>& mesh, const scene::Stress<3>& stress, int cell, int k) {
  constexpr auto& facets = scene::Simplex<3>::facets;
  double worst = 0;
  for (int other = k + 1; other < 4; ++other) {  // they share a face: the two vertices of either facet, the centroid
    const auto own = scene::stress_of_part(stress, cell, k), next = scene::stress_of_part(stress, cell, other);
    const auto x = part(mesh, cell, k);
    std::vector<std::array<int, 2>> shared = {{3, 3}};
    std::vector<Vector<3>> arms;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (facets[k][i] == facets[other][j]) {
          shared.push_back({i, j});
          arms.push_back(x[i]);
        }
    const Vector<3> n = arms[0].cross(arms[1]).normalized();
    for (const auto& [i, j] : shared) raise(worst, scene::traction<3>(own[i] - next[j], n).norm());
  }
  return worst;
}

/// |div λ + F| times the cell's diameter on each part, and the jumps of the traction between the parts, by
/// coefficients.
template <int dim> double equilibrium(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress, int cell) {
  const auto& mesh = problem.mesh;
  const int degree = stress.degree;
  double worst = 0;
  for (int k = 0; k <= dim; ++k) {
    const auto x = part(mesh, cell, k);
    const auto gradient = scene::hat_gradients<dim>(x);
    const auto own = scene::stress_of_part(stress, cell, k);
    double diameter = 0;
    for (int i = 0; i < dim; ++i)
      for (int j = i + 1; j <= dim; ++j) diameter = std::max(diameter, (x[i] - x[j]).norm());
    for (const auto& i : scene::bernstein_indices<dim>(degree - 1)) {
      Vector<dim> divergence = problem.bodies[mesh.cell_body[cell]].force;
      for (int corner = 0; corner <= dim; ++corner) {
        auto above = i;
        ++above[corner];
        divergence += degree * scene::traction<dim>(own[scene::bernstein_place(above)], gradient[corner]);
      }
      raise(worst, divergence.norm() * diameter);
    }
    raise(worst, jumps_between_parts(mesh, stress, cell, k));
  }
  return worst;
}

/// Where coefficient k of a facet is if its vertices are sorted; in space of degree 1.
template <int dim> int sorted_place(const std::array<int, dim>& vertices, int degree, int k) {
  if constexpr (dim == 2) return vertices[0] < vertices[1] ? k : degree - k;
  return static_cast<int>(std::count_if(vertices.begin(), vertices.end(), [&](int v) { return v < vertices[k]; }));
}

/// λn on every facet, from each of its cells, by coefficients with its vertices sorted; and, of the two sides of a
/// contact, the first facet's.
template <int dim> double interface_jump(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress) {
  const auto& mesh = problem.mesh;
  const int n_coefficients = scene::n_on_facet<dim>(stress.degree);
  const std::vector<Vector<dim>> zero(n_coefficients, Vector<dim>::Zero());
  std::vector<std::vector<Vector<dim>>> sum(scene::n_facets(mesh), zero);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int k = 0; k <= dim; ++k) {
      const int cell = static_cast<int>(c);
      const auto vertices = scene::facet_vertices(mesh, cell, k);
      const Vector<dim> n = scene::area_vector<dim>(scene::positions(mesh, vertices)).normalized();
      const auto own = scene::stress_of_part(stress, cell, k);
      for (int i = 0; i < n_coefficients; ++i)
        sum[scene::cell_facets(mesh, cell)[k]][sorted_place<dim>(vertices, stress.degree, i)] +=
            scene::traction<dim>(own[i], n);
    }
  for (const auto& facet : mesh.boundary) sum[scene::cell_facets(mesh, facet.cell)[facet.local]] = zero;
  double worst = 0;
  for (const auto& jumps : sum)
    for (const auto& jump : jumps) raise(worst, jump.norm());
  for (const auto& pair : problem.contact) {
    if (pair.second < 0) continue;
    const auto first = tractions(mesh, stress, pair.first), second = tractions(mesh, stress, pair.second);
    const double longer = scene::length(mesh, pair.second) / scene::length(mesh, pair.first);  // forces are opposite
    for (int i = 0; i < n_coefficients; ++i)
      raise(worst, (first[i] + longer * second[opposite(pair, stress.degree, i)]).norm());
  }
  return worst;
}

struct BoundaryMisfit {
  double traction = 0;
  double tension = 0;
};

template <int dim>
BoundaryMisfit boundary_misfit(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress) {
  BoundaryMisfit worst;
  const std::vector<char> rubs = with_friction(problem);
  std::vector<char> may_pull(problem.facets.size(), 0);
  for (const auto& pair : problem.contact) {
    may_pull[pair.first] = pair.law.two_sided;
    if (pair.second >= 0) may_pull[pair.second] = pair.law.two_sided;
    if constexpr (dim == 2) {
      if (!has_friction(pair.law)) continue;
      const auto shear = plain_shear(problem, stress, pair);
      const auto most = coefficients(pair.law.friction, stress.degree);
      for (std::size_t i = 0; i < shear.size(); ++i) raise(worst.traction, std::abs(shear[i]) - most[i]);
    }
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support == Support::fixed) continue;
    const auto t = tractions(problem.mesh, stress, static_cast<int>(f));
    const Vector<dim>& n = data.normal;
    const auto given = loads(problem, static_cast<int>(f), stress.degree);
    const double length = scene::length(problem.mesh, static_cast<int>(f));
    for (std::size_t i = 0; i < t.size(); ++i) {
      const Vector<dim> beside = t[i] - given[i] / length;
      if (data.support == Support::traction)
        raise(worst.traction, beside.norm());
      else if (!rubs[f])
        raise(worst.traction, (beside - beside.dot(n) * n).norm());
      if (data.support == Support::contact && !may_pull[f]) raise(worst.tension, beside.dot(n));
    }
  }
  return worst;
}

}  // namespace

template <int dim>
Checks admissibility(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                     const scene::Stress<dim>& stress) {
  double equilibrium_misfit = 0;
  for (std::size_t c = 0; c < stress.cell.size(); ++c)
    raise(equilibrium_misfit, equilibrium(problem, stress, static_cast<int>(c)));
  const BoundaryMisfit boundary = boundary_misfit(problem, stress);
  const auto relative = [](double value, double scale) { return value == 0 ? 0 : value / scale; };
  const double u = displacement_scale(problem, displacement), s = largest_stress(stress);
  Checks checks;
  checks.penetration = relative(penetration(problem, displacement, contact_state(problem, displacement, stress)), u);
  checks.equilibrium = relative(equilibrium_misfit, s);
  checks.interface_jump = relative(interface_jump(problem, stress), s);
  checks.boundary_traction = relative(boundary.traction, s);
  checks.tension = relative(boundary.tension, s);
  return checks;
}

std::array<Check, 6> Checks::all() const {
  return {{{"penetration", penetration, "displacements keep supports and contact"},
           {"equilibrium", equilibrium, "stresses balance the body force in every cell"},
           {"interface jump", interface_jump, "tractions are equal on both sides where cells meet"},
           {"boundary traction", boundary_traction, "tractions are the given ones"},
           {"tension", tension, "the contact does not pull"},
           {"gap identity", gap_identity, "the cells' errors add up to the width"}}};
}

Check Checks::worst() const {
  const auto checks = all();
  Check worst = checks[0];
  for (const Check& check : checks)
    if (check.value > worst.value || std::isnan(check.value)) worst = check;
  return worst;
}

bool Checks::passed() const { return worst().value <= tolerance; }

template Checks admissibility(const scene::Problem<2>&, const scene::Displacement<2>&, const scene::Stress<2>&);
template Checks admissibility(const scene::Problem<3>&, const scene::Displacement<3>&, const scene::Stress<3>&);

}  // namespace bracket::bounds
