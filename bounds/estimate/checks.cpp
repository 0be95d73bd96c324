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
    for (const auto& e : strain_at_vertices(problem.mesh, displacement, static_cast<int>(c))) raise(strain, e.norm());
  return strain * problem.length_scale + largest_given(problem);
}

template <int dim>
double penetration(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                   const std::vector<ContactState>& states) {
  double worst = 0;
  for (const auto& state : states) {
    const auto& [g0, g1, middle] = state.gap_left;
    for (const double coefficient : {g0, g1, 2 * middle - g0 / 2 - g1 / 2}) raise(worst, -coefficient);
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support != Support::fixed && data.support != Support::sliding) continue;
    const auto u = on_facet(problem.mesh, displacement, static_cast<int>(f));
    const Vector<dim>& n = data.normal;
    const auto& d = data.displacement;
    const auto& s = data.normal_displacement;
    for (int i = 0; i < 3; ++i) {
      if (data.support == Support::fixed)
        raise(worst, (u[i] - (i < 2 ? d[i] : Vector<dim>((d[0] + d[1]) / 2))).norm());
      else
        raise(worst, std::abs(u[i].dot(n) - (i < 2 ? s[i] : (s[0] + s[1]) / 2)));
    }
  }
  return worst;
}

/// The corners of part k of a cell, relative to the cell's centroid. They are made of differences of vertices, which
/// are exact: far from the origin the centroid itself would be rounded by more than small cells bear.
std::array<Vector<2>, 3> part(const scene::Mesh<2>& mesh, int cell, int k) {
  const auto [a, b] = scene::positions(mesh, scene::facet_vertices(mesh, cell, k));
  const Vector<2>& c = mesh.vertices[mesh.cells[cell][k]];
  return {((a - b) + (a - c)) / 3, ((b - a) + (b - c)) / 3, Vector<2>::Zero()};
}

/// |div λ + F| times the cell's diameter on each part, and the jumps of the traction between the parts.
double equilibrium(const scene::Problem<2>& problem, const scene::Stress<2>& stress, int cell) {
  constexpr int dim = 2;
  const auto& mesh = problem.mesh;
  double worst = 0;
  for (int k = 0; k < 3; ++k) {
    const auto x = part(mesh, cell, k);
    const Vector<dim>&a = x[0], &b = x[1];
    const auto corners = scene::stress_of_part(stress, cell, k);
    const Voigt<dim> along_a = corners[0] - corners[2], along_b = corners[1] - corners[2];
    // Gradient of a linear field from its slopes along a and b.
    const double det = a[0] * b[1] - a[1] * b[0];
    const Voigt<dim> dx = (b[1] * along_a - a[1] * along_b) / det, dy = (a[0] * along_b - b[0] * along_a) / det;
    const Vector<dim> divergence(dx[0] + dy[2], dx[2] + dy[1]);
    const double diameter = std::max({a.norm(), b.norm(), (a - b).norm()});
    raise(worst, (divergence + problem.bodies[mesh.cell_body[cell]].force).norm() * diameter);
    // Corner 1 of part k and corner 0 of part k+1 are the same vertex; corner 2 is the centroid of both.
    const Vector<dim> n = scene::area_vector<dim>({x[2], b}).normalized();
    const auto next = scene::stress_of_part(stress, cell, (k + 1) % 3);
    raise(worst, scene::traction<dim>(corners[1] - next[0], n).norm());
    raise(worst, scene::traction<dim>(corners[2] - next[2], n).norm());
  }
  return worst;
}

/// λn at the vertices of every facet, from each of its cells, in the order of their numbers; and, of the two sides of a
/// contact, the first facet's.
template <int dim> double interface_jump(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress) {
  const auto& mesh = problem.mesh;
  const auto zero = scene::at_vertices<dim>(Vector<dim>(Vector<dim>::Zero()));
  std::vector<std::array<Vector<dim>, dim>> sum(scene::n_facets(mesh), zero);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int k = 0; k <= dim; ++k) {
      const int cell = static_cast<int>(c);
      const auto vertices = scene::facet_vertices(mesh, cell, k);
      const Vector<dim> n = scene::area_vector<dim>(scene::positions(mesh, vertices)).normalized();
      const auto corners = scene::stress_of_part(stress, cell, k);
      for (int i = 0; i < dim; ++i) {
        const auto place = std::count_if(vertices.begin(), vertices.end(), [&](int v) { return v < vertices[i]; });
        sum[scene::cell_facets(mesh, cell)[k]][place] += scene::traction<dim>(corners[i], n);
      }
    }
  for (const auto& facet : mesh.boundary) sum[scene::cell_facets(mesh, facet.cell)[facet.local]] = zero;
  double worst = 0;
  for (const auto& jumps : sum)
    for (const auto& jump : jumps) raise(worst, jump.norm());
  for (const auto& pair : problem.contact) {
    if (pair.second < 0) continue;
    const auto first = tractions(mesh, stress, pair.first), second = tractions(mesh, stress, pair.second);
    const double longer = scene::length(mesh, pair.second) / scene::length(mesh, pair.first);  // forces are opposite
    for (int i = 0; i < 2; ++i) raise(worst, (first[i] + longer * second[1 - i]).norm());
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
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support == Support::fixed) continue;
    const auto t = tractions(problem.mesh, stress, static_cast<int>(f));
    const Vector<dim>& n = data.normal;
    const auto given = scene::load(problem, static_cast<int>(f));
    const double length = scene::length(problem.mesh, static_cast<int>(f));
    for (int i = 0; i < dim; ++i) {
      if (data.support == Support::traction)
        raise(worst.traction, (t[i] - given[i] / length).norm());
      else
        raise(worst.traction, (t[i] - t[i].dot(n) * n).norm());
      if (data.support == Support::contact) raise(worst.tension, t[i].dot(n));
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
           {"interface jump", interface_jump, "tractions are equal on both sides of every edge"},
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

}  // namespace bracket::bounds
