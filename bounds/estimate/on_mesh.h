// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "bounds/estimate/estimate.h"
#include "scene/offsets.h"
#include "scene/on_facet.h"
#include "scene/voigt.h"

/// The two fields where the bracket needs them: strains on cells, displacements and tractions on boundary facets.
namespace bracket::bounds {

/// ε(u_h) on a cell, by Bernstein coefficients of the degree of the stresses beside u_h.
template <int dim>
std::vector<scene::Voigt<dim>> strain(const scene::Mesh<dim>& mesh, const scene::Displacement<dim>& displacement,
                                      int cell);

/// u_h on a boundary facet, by Bernstein coefficients in the order of scene/on_facet.h.
template <int dim>
std::vector<scene::Vector<dim>> on_facet(const scene::Mesh<dim>& mesh, const scene::Displacement<dim>& displacement,
                                         int facet);

/// λn on a boundary facet, likewise.
template <int dim>
std::vector<scene::Vector<dim>> tractions(const scene::Mesh<dim>& mesh, const scene::Stress<dim>& stress, int facet);

/// What is given linearly on a boundary facet, likewise. \param at_vertices of the facet
template <class Value, std::size_t dim>
std::vector<Value> coefficients(const std::array<Value, dim>& at_vertices, int degree) {
  return scene::linear_on_facet<double>(at_vertices, degree);
}
/// The mean over a facet of the product of two functions. \pre in space one of them is linear
template <int dim> double mean_of_product(const std::vector<double>& f, const std::vector<double>& g) {
  if constexpr (dim == 2) return scene::bernstein_product(f, g);
  if (g.size() > dim) return mean_of_product<dim>(g, f);
  std::array<double, dim> linear;
  std::copy(g.begin(), g.end(), linear.begin());
  return scene::mean_with_linear(f, linear);
}
/// Which coefficient of degree n on the second facet of a contact lies on coefficient k on the first; of degree 1 in
/// space.
template <int dim> int opposite(const scene::ContactFacetOf<dim>& pair, int n, int k) {
  return dim == 2 ? n - k : pair.meets[k];
}

/// The loads on a boundary facet likewise (scene::load()). \pre the degree is not less than theirs
template <int dim> std::vector<scene::Vector<dim>> loads(const scene::Problem<dim>& problem, int facet, int degree) {
  auto result = coefficients(scene::load(problem, facet), degree);
  if constexpr (dim == 2) {
    const auto higher = scene::higher_load(problem, facet);
    for (int k = 2; k <= degree_of_load(problem.facets[facet]); ++k) {
      std::vector<scene::Vector<dim>> own;
      for (int i = 0; i <= k; ++i) own.push_back(double(scene::legendre_coefficient(k, i)) * higher[k - 2]);
      own = scene::raised_to<double>(degree, std::move(own));
      for (std::size_t i = 0; i < result.size(); ++i) result[i] += own[i];
    }
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

/// λ_h n on the first side of a contact facet, likewise, beside the loads of a perturbed problem.
template <int dim>
std::vector<scene::Vector<dim>> contact_tractions(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress,
                                                  const scene::ContactFacetOf<dim>& pair);

/// The pressure there, likewise, as computed. The gap identity needs it as it is.
template <int dim>
std::vector<double> plain_pressure(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress,
                                   const scene::ContactFacetOf<dim>& pair);

/// Planar: the shear τ of λ_h there, likewise, as computed (scene/problem/law.h).
template <int dim>
std::vector<double> plain_shear(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress,
                                const scene::ContactFacetOf<dim>& pair);

/// (u' − u'')·direction of u_h there, likewise, of degree 2 at least.
template <int dim>
std::vector<double> jump(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                         const scene::ContactFacetOf<dim>& pair, const scene::Vector<dim>& direction);
template <>
std::vector<double> jump(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                         const scene::ContactFacet& pair, const scene::Vector<2>& direction);
template <>
std::vector<double> jump(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
                         const scene::ContactFacetOf<3>& pair, const scene::Vector<3>& direction);

/// What friction sees of v_t(u_h) there, likewise: all but ContactFacet::slip.
template <int dim>
std::vector<double> rubbing(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                            const scene::ContactFacet& pair);

/// g − r(u_h) there, likewise, g as S pays for it.
template <int dim>
std::vector<double> gap_left(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                             const scene::ContactFacetOf<dim>& pair);

/// Planar: what its law adds to the energies on a contact facet (docs/theory.md §11): ½ ∫ k s² + ∫ g_T |v_t| to L(u_h)
/// and ½ ∫ C p² to S(λ_h), as upper bounds of φ and φ* as the certificate has them.
template <int dim>
double law_energy(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                  const scene::ContactFacetOf<dim>& pair);
template <int dim>
double law_complementary_energy(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress,
                                const scene::ContactFacetOf<dim>& pair);

/// Planar: what springs are shortened by there, s ≥ r − g, likewise: of springs that pull r − g.
template <int dim>
std::vector<double> springs_shortened(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                                      const scene::ContactFacetOf<dim>& pair);

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

/// The mean over a triangle or a tetrahedron of a quadratic form of what has these Bernstein coefficients, in space of
/// degree 0 or 1: exact.
template <int dim, class Form, class Values> double mean(const Form& form, const Values& coefficients) {
  using Value = std::remove_cvref_t<decltype(coefficients[0])>;
  if constexpr (dim == 2) return scene::mean_of_squares<double>(form, std::span<const Value>(coefficients));
  Value sum = coefficients[0];
  if (coefficients.size() == 1) return form(sum);
  double squares = form(sum);
  for (int k = 1; k <= dim; ++k) {
    sum += coefficients[k];
    squares += form(coefficients[k]);
  }
  return (squares + form(sum)) / scene::Simplex<dim>::hat_masses_of;
}

}  // namespace bracket::bounds
