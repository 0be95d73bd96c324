// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "bounds/estimate/estimate.h"
#include "scene/offsets.h"
#include "scene/voigt.h"

/// The two fields where the bracket needs them: strains on cells, displacements and tractions on boundary facets.
namespace bracket::bounds {

/// ε(u_h) on a cell, by Bernstein coefficients of the degree of the stresses beside u_h.
template <int dim>
std::vector<scene::Voigt<dim>> strain(const scene::Mesh<dim>& mesh, const scene::Displacement<dim>& displacement,
                                      int cell);

/// u_h on a boundary facet, by Bernstein coefficients from its vertex 0 to its vertex 1.
template <int dim>
std::vector<scene::Vector<dim>> on_facet(const scene::Mesh<dim>& mesh, const scene::Displacement<dim>& displacement,
                                         int facet);

/// λn on a boundary facet, likewise.
template <int dim>
std::vector<scene::Vector<dim>> tractions(const scene::Mesh<dim>& mesh, const scene::Stress<dim>& stress, int facet);

/// What is given linearly on a boundary facet, likewise. \param ends at its vertices
template <class Value> std::vector<Value> coefficients(const std::array<Value, 2>& ends, int degree) {
  std::vector<Value> result;
  for (int k = 0; k <= degree; ++k) result.push_back(scene::linear_coefficient<double>(ends[0], ends[1], degree, k));
  return result;
}
/// The loads on a boundary facet likewise (scene::load()). \pre the degree is not less than theirs
template <int dim> std::vector<scene::Vector<dim>> loads(const scene::Problem<dim>& problem, int facet, int degree) {
  auto result = coefficients(scene::load(problem, facet), degree);
  const auto higher = scene::higher_load(problem, facet);
  for (int k = 2; k <= degree_of_load(problem.facets[facet]); ++k) {
    std::vector<scene::Vector<dim>> own;
    for (int i = 0; i <= k; ++i) own.push_back(double(scene::legendre_coefficient(k, i)) * higher[k - 2]);
    own = scene::raised_to<double>(degree, std::move(own));
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += own[i];
  }
  return result;
}
/// One component of each.
template <int dim>
std::vector<double> along(const std::vector<scene::Vector<dim>>& coefficients, const scene::Vector<dim>& direction) {
  std::vector<double> result;
  for (const auto& value : coefficients) result.push_back(value.dot(direction));
  return result;
}

/// The pressure of λ_h on a contact facet, likewise, as computed: what λ_h n has along d beside the loads of a
/// perturbed problem. The gap identity needs it as it is.
template <int dim>
std::vector<double> plain_pressure(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress,
                                   const scene::ContactFacet& pair);

/// The shear τ of λ_h there, likewise, as computed (scene/problem/law.h).
template <int dim>
std::vector<double> plain_shear(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress,
                                const scene::ContactFacet& pair);

/// (u' − u'')·direction of u_h there, likewise, of degree 2 at least.
template <int dim>
std::vector<double> jump(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                         const scene::ContactFacet& pair, const scene::Vector<dim>& direction);

/// g − r(u_h) there, likewise, g as S pays for it.
template <int dim>
std::vector<double> gap_left(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                             const scene::ContactFacet& pair);

/// What its law adds to the energies on a contact facet (docs/theory.md §11): ½ ∫ k s² + ∫ g_T |v_t| to L(u_h) and
/// ½ ∫ C p² to S(λ_h), as upper bounds of φ and φ* as the certificate has them.
template <int dim>
double law_energy(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                  const scene::ContactFacet& pair);
template <int dim>
double law_complementary_energy(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress,
                                const scene::ContactFacet& pair);

/// What springs are shortened by there, s ≥ r − g, likewise: of springs that pull r − g.
template <int dim>
std::vector<double> springs_shortened(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                                      const scene::ContactFacet& pair);

/// ∫ weight |v|, or more, over a facet's parameter, v by Bernstein coefficients, the weight ≥ 0 linear between its
/// ends: by the coefficients' sizes, on halves as long as signs are mixed (scene::halvings_of_slip).
double mean_of_size(const std::vector<double>& v, const std::array<double, 2>& weight);

/// Of each boundary facet, whether its contact has friction: then its shear is not known beforehand.
template <int dim> std::vector<char> with_friction(const scene::Problem<dim>& problem);

/// Keeps the largest value; a NaN stays.
inline void raise(double& largest, double value) {
  if (value > largest || std::isnan(value)) largest = value;
}

/// The largest displacement of a vertex, and the largest stress at a corner; not a number where one is not.
template <int dim> double largest_at_vertices(const scene::Displacement<dim>& displacement);
template <int dim> double largest_stress(const scene::Stress<dim>& stress);

/// The largest of the prescribed displacements and gaps.
template <int dim> double largest_given(const scene::Problem<dim>& problem);

/// The mean over a triangle of a quadratic form of what has these Bernstein coefficients: exact.
template <class Form, class Values> double mean(const Form& form, const Values& coefficients) {
  using Value = std::remove_cvref_t<decltype(coefficients[0])>;
  return scene::mean_of_squares<double>(form, std::span<const Value>(coefficients));
}

}  // namespace bracket::bounds
