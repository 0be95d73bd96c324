// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/arithmetic.h"
#include "bounds/certificate/space/admissible_displacement.h"
#include "bounds/certificate/space/elastic_form.h"
#include "scene/parallel.h"

/// The energy of displacements: real numbers that `Number` encloses or holds exactly.
namespace bracket::bounds::space {

template <class Number> struct FieldEnergy {
  Number strain;  ///< ½ A(v,v)
  Number total;   ///< L(v)
};

/// What is to be added to the plain values of all nodes.
template <class Number> std::vector<Vector3<Number>> shifts(const Supports& supports, const PlainField& field) {
  std::vector<Vector3<Number>> result;
  result.reserve(field.node.size());
  for (std::size_t k = 0; k < field.node.size(); ++k)
    result.push_back(shift<Number>(supports, field, static_cast<int>(k)));
  return result;
}

/// The value at a node.
template <class Number>
Vector3<Number> at_node(const PlainField& field, const std::vector<Vector3<Number>>& shifts, int node) {
  return vector3<Number>(field.node[node]) + shifts[node];
}

/// A cell in what is asked of displacements.
template <class Number> struct DisplacedCell {
  scene::BlockGeometry<3, Number> geometry;
  std::array<Vector3<Number>, 4> from_first;  ///< u at the corners less that at the first
  std::array<Vector3<Number>, 6> offset{};    ///< as Simplex<3>::edges
};
template <class Number>
DisplacedCell<Number> displaced_cell(const scene::Problem<3>& problem, const PlainField& field,
                                     const std::vector<Vector3<Number>>& shifts, int cell) {
  const auto& mesh = problem.mesh;
  const auto& v = mesh.cells[cell];
  DisplacedCell<Number> result{cell_geometry(corners<Number>(problem, cell)), {}};
  for (int j = 1; j < 4; ++j)
    result.from_first[j] = between<Number>(field.node[v[0]], field.node[v[j]]) + (shifts[v[j]] - shifts[v[0]]);
  for (int e = 0; e < 6 && field.degree > 1; ++e)
    result.offset[e] = at_node(field, shifts, node_of_edge(mesh, mesh.cell_edges[cell][e]));
  return result;
}

/// The strain at the corners of a cell, linear between: shear twice, in the order of Simplex<3>::voigt.
template <class Number>
std::array<std::array<Number, 6>, 4> cell_strain(const DisplacedCell<Number>& cell, int degree) {
  const auto& G = cell.geometry.gradient;
  const auto add = [&](std::array<Number, 6>& strain, const Vector3<Number>& slope, int k) {
    for (int c = 0; c < 6; ++c) {
      const auto [i, j] = scene::Simplex<3>::voigt[c];
      strain[c] += i == j ? Number(slope[i] * G[k][i]) : Number(slope[i] * G[k][j] + slope[j] * G[k][i]);
    }
  };
  std::array<Number, 6> linear;
  linear.fill(Number(0));
  for (int j = 1; j < 4; ++j) add(linear, cell.from_first[j], j);
  std::array<std::array<Number, 6>, 4> strain = {linear, linear, linear, linear};
  for (int e = 0; e < 6 && degree > 1; ++e) {  // of 2 w φ_a φ_b
    const auto& [a, b] = scene::Simplex<3>::edges[e];
    const Vector3<Number> doubled = cell.offset[e] + cell.offset[e];
    add(strain[a], doubled, b);
    add(strain[b], doubled, a);
  }
  return strain;
}

/// ∫ F·u over a cell.
template <class Number>
Number cell_work(const scene::Problem<3>& problem, const PlainField& field, const std::vector<Vector3<Number>>& shifts,
                 const DisplacedCell<Number>& at, const Vector3<Number>& force, int cell) {
  Vector3<Number> linear{}, beside{};  // four times its mean, and ten times that of what is beside
  for (const int v : problem.mesh.cells[cell]) linear = linear + at_node(field, shifts, v);
  for (const auto& w : at.offset) beside = beside + w;
  const Vector3<Number> mean = (Number(1) / Number(4)) * linear + (Number(1) / Number(10)) * beside;
  return at.geometry.scaled_volume / Number(6) * dot(force, mean);
}

/// ∫ T·u over a facet. \param load density times area at the vertices
template <class Number>
Number facet_work(const scene::Mesh<3>& mesh, const PlainField& field, const std::vector<Vector3<Number>>& shifts,
                  int facet, const FacetVectors<Number>& load) {
  const auto nodes = nodes_of_facet(mesh, facet);
  FacetVectors<Number> u;
  for (int i = 0; i < 3; ++i) u[i] = at_node(field, shifts, nodes[i]);
  Number work = mean_product(load, u);
  if (field.degree == 1) return work;
  const auto moments = bernstein_moments<Number>(load);
  for (int k = 3; k < 6; ++k) work += dot(moments[k], at_node(field, shifts, nodes[k]));
  return work;
}

/// L of the field that `field` stands for [HH81 §1].
/// \param corrections as corrected() has them   \tparam Sum with add() and value()
template <class Number, class Sum>
FieldEnergy<Number> field_energy(const scene::Problem<3>& problem, const Supports& supports, const PlainField& field,
                                 const std::vector<Corrected<Number>>& corrections) {
  const auto& mesh = problem.mesh;
  const auto all = shifts<Number>(supports, field);
  const auto forms = elastic_forms<Number>(problem);
  const auto of_cells = [&](int begin, int end) {
    check_arithmetic();
    Sum of_strain, of_force;
    for (int cell = begin; cell < end; ++cell) {
      const int body = mesh.cell_body[cell];
      const auto at = displaced_cell(problem, field, all, cell);
      const auto energy = [&](const std::array<Number, 6>& e) { return forms[body].strain_energy(e); };
      const auto strain = cell_strain(at, field.degree);
      of_strain.add(at.geometry.scaled_volume / Number(6) *
                    (field.degree == 1 ? energy(strain[0]) : mean_of_squares<Number>(energy, strain)));
      if (has_force(problem, body))
        of_force.add(cell_work(problem, field, all, at, body_force<Number>(problem, body), cell));
    }
    return std::array<Number, 2>{of_strain.value(), of_force.value()};
  };
  Sum strain, work;
  using Parts = std::array<Number, 2>;
  for (const auto& [of_strain, of_force] : scene::of_chunks<Parts>(static_cast<int>(mesh.cells.size()), of_cells)) {
    strain.add(of_strain);
    work.add(of_force);
  }
  for (int facet = 0; facet < static_cast<int>(problem.facets.size()); ++facet)
    if (carries_load(problem, corrections, facet))
      work.add(facet_work<Number>(mesh, field, all, facet, prescribed_load(problem, corrections, facet)));
  for (const auto& pair : problem.contact)
    if (problem.perturbed.by)
      work.add(
          Number(problem.perturbed.loads) *
          bernstein_product(opening_load<Number>(problem, pair), approach_on<Number>(problem, supports, field, pair)));
  const Number half_a = strain.value();
  return {half_a, half_a - work.value()};
}

/// κ = ∫ p (g − r(v)), g the upper gap. \param along_normal Loads::along_normal
template <class Number, class Sum>
Number contact_work(const scene::Problem<3>& problem, const Supports& supports, const PlainField& field,
                    const std::vector<std::array<Number, 3>>& along_normal) {
  Sum sum;
  for (const auto& pair : problem.contact) {
    if (pair.law.two_sided) continue;  // r = g
    const auto r = approach_on<Number>(problem, supports, field, pair);
    auto left = gap_paid<Number>(problem, supports, pair);
    for (int k = 0; k < 6; ++k) left[k] -= r[k];
    sum.add(bernstein_product(along_normal[pair.first], left));
  }
  return sum.value();
}

}  // namespace bracket::bounds::space
