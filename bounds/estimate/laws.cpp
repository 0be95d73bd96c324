// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "bounds/estimate/on_mesh.h"
#include "scene/problem/law.h"

namespace bracket::bounds {

using scene::ContactFacet;
using scene::ContactFacetOf;
using scene::Vector;

template <int dim>
std::vector<double> plain_shear(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress,
                                const ContactFacetOf<dim>& pair) {
  return along<dim>(contact_tractions(problem, stress, pair), -scene::tangent(problem.facets[pair.first].normal));
}

template <>
std::vector<double> jump(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                         const ContactFacet& pair, const Vector<2>& direction) {
  const auto& mesh = problem.mesh;
  const auto& [a, b] = mesh.boundary[pair.first].vertices;
  std::array<Vector<2>, 2> ends = {displacement.vertex[a], displacement.vertex[b]};
  auto offset = scene::offsets_on_facet(mesh, displacement, pair.first);
  if (pair.second >= 0) {
    const auto& [over_b, over_a] = mesh.boundary[pair.second].vertices;  // the second side runs the other way
    ends[0] -= displacement.vertex[over_a];
    ends[1] -= displacement.vertex[over_b];
    const auto other = scene::offsets_on_facet(mesh, displacement, pair.second);
    for (std::size_t k = 0; k < offset.size(); ++k) offset[k] -= other[other.size() - 1 - k];
  }
  std::vector<double> result = along<2>(offset, direction);
  for (int k = 0; k <= displacement.degree; ++k)
    result[k] +=
        scene::linear_coefficient<double>(ends[0].dot(direction), ends[1].dot(direction), displacement.degree, k);
  return scene::raised_to<double>(2, result);
}

template <int dim>
std::vector<double> rubbing(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                            const ContactFacet& pair) {
  auto slip = jump<dim>(problem, displacement, pair, scene::tangent(problem.facets[pair.first].normal));
  const auto unseen = scene::raised_to<double>(static_cast<int>(slip.size()) - 1,
                                               std::vector<double>(pair.slip.begin(), pair.slip.end()));
  for (std::size_t k = 0; k < slip.size(); ++k) slip[k] -= unseen[k];
  return slip;
}

template <int dim>
ShearAndSlip shear_and_slip(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                            const scene::Stress<dim>& stress, const ContactFacetOf<dim>& pair) {
  return {plain_shear(problem, stress, pair),
          jump<dim>(problem, displacement, pair, scene::tangent(problem.facets[pair.first].normal))};
}

namespace {

double mean_of_size(const std::vector<double>& slip, const std::array<double, 2>& weight, int halvings) {
  const bool mixed = std::ranges::any_of(slip, [](double c) { return c < 0; }) &&
                     std::ranges::any_of(slip, [](double c) { return c > 0; });
  if (!mixed || halvings == 0) {
    std::vector<double> size;
    for (const double c : slip) size.push_back(std::abs(c));
    return scene::bernstein_product(size, std::vector<double>{weight[0], weight[1]});
  }
  const auto [left, right] = scene::halves(slip);
  const double middle = 0.5 * (weight[0] + weight[1]);
  return 0.5 * (mean_of_size(left, {weight[0], middle}, halvings - 1) +
                mean_of_size(right, {middle, weight[1]}, halvings - 1));
}

}  // namespace

double mean_of_size(const std::vector<double>& slip, const std::array<double, 2>& weight) {
  return mean_of_size(slip, weight, scene::halvings_of_slip);
}

template <int dim>
std::vector<double> springs_shortened(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                                      const ContactFacetOf<dim>& pair) {
  std::vector<double> c = jump(problem, displacement, pair, problem.facets[pair.first].normal);
  const auto gap =
      scene::raised_to<double>(displacement.degree, std::vector<double>(pair.lower.begin(), pair.lower.end()));
  for (std::size_t k = 0; k < c.size(); ++k) c[k] -= gap[k];
  return pair.law.two_sided ? c : scene::shortening({pair.law.modulus[0], pair.law.modulus[1]}, c);
}

template <int dim>
double law_energy(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                  const ContactFacetOf<dim>& pair) {
  const double length = scene::length(problem.mesh, pair.first);
  double energy = 0;
  if (has_springs(pair.law)) {
    const auto& [k0, k1] = pair.law.modulus;
    const std::vector<double> s = springs_shortened(problem, displacement, pair);
    energy +=
        0.5 * length * scene::bernstein_product(scene::bernstein_times<double>(s, s), std::vector<double>{k0, k1});
  }
  if (has_friction(pair.law)) energy += length * mean_of_size(rubbing(problem, displacement, pair), pair.law.friction);
  return energy;
}

template <int dim>
double law_complementary_energy(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress,
                                const ContactFacetOf<dim>& pair) {
  const double length = scene::length(problem.mesh, pair.first);
  if (has_friction(pair.law))
    return length * scene::bernstein_product(plain_shear(problem, stress, pair),
                                             std::vector<double>(pair.slip.begin(), pair.slip.end()));
  if (!has_springs(pair.law)) return 0;
  const auto p = plain_pressure(problem, stress, pair);
  const auto c = scene::compliance_on<double>(pair.law.modulus[0], pair.law.modulus[1]);
  return 0.5 * length *
         scene::bernstein_product(scene::bernstein_times<double>(p, p), std::vector<double>(c.begin(), c.end()));
}

template <int dim> std::vector<char> with_friction(const scene::Problem<dim>& problem) {
  std::vector<char> result(problem.facets.size(), 0);
  for (const ContactFacetOf<dim>& pair : problem.contact) {
    if (!has_friction(pair.law)) continue;
    result[pair.first] = 1;
    if (pair.second >= 0) result[pair.second] = 1;
  }
  return result;
}

template std::vector<double> plain_shear(const scene::Problem<2>&, const scene::Stress<2>&, const ContactFacet&);
template std::vector<double> rubbing(const scene::Problem<2>&, const scene::Displacement<2>&, const ContactFacet&);
template ShearAndSlip shear_and_slip(const scene::Problem<2>&, const scene::Displacement<2>&, const scene::Stress<2>&,
                                     const ContactFacet&);
template std::vector<double> springs_shortened(const scene::Problem<2>&, const scene::Displacement<2>&,
                                               const ContactFacet&);
template double law_energy(const scene::Problem<2>&, const scene::Displacement<2>&, const ContactFacet&);
template double law_complementary_energy(const scene::Problem<2>&, const scene::Stress<2>&, const ContactFacet&);
template std::vector<char> with_friction(const scene::Problem<2>&);
template std::vector<char> with_friction(const scene::Problem<3>&);

}  // namespace bracket::bounds
