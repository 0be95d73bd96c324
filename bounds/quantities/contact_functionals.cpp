// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/quantities/line.h"
#include "bounds/quantities/parts.h"
#include "bounds/quantities/weights.h"
#include "scene/text.h"

namespace bracket::bounds {

using scene::Enclosure;
using scene::Perturbation;
using scene::Problem;
using scene::Quantity;

namespace {

template <int dim> using LinearWeights = std::vector<std::array<double, std::size_t{dim}>>;

template <int dim> FacetWeights<dim> quadratics(const LinearWeights<dim>& weights) {
  FacetWeights<dim> result;
  for (const auto& weight : weights) result.push_back(quadratic<dim>(weight));
  return result;
}

/// 1, and at the first sides' vertices where that cannot be 0.
template <int dim> LinearWeights<dim> whole_weights(const Problem<dim>& first, int pair) {
  const auto held = held_corners(first);
  std::vector<char> zero(first.mesh.vertices.size(), 0);
  const auto& boundary = first.mesh.boundary;
  for (std::size_t j = 0; j < held.size(); ++j)
    for (int i = 0; i < dim && first.contact[j].pair == pair; ++i)
      if (held[j][i]) zero[boundary[first.contact[j].first].vertices[i]] = 1;
  LinearWeights<dim> whole(first.contact.size(), scene::at_vertices<dim>(0.0));
  for (std::size_t j = 0; j < whole.size(); ++j)
    for (int i = 0; i < dim && first.contact[j].pair == pair; ++i)
      whole[j][i] = zero[boundary[first.contact[j].first].vertices[i]] ? 0 : 1;
  return whole;
}

/// Planar.
ContactWeights<2> stretch_weights(const Problem<2>& first, const Quantity<2>& quantity, int pair, bool two_sided) {
  if (two_sided)
    refuse(quantity,
           "a stretch of it has no bounds where the sides cannot lift off, for pressures of either sign do not add up "
           "one way; expected the whole contact, or a weight");
  const ContactLine line =
      open_line(first, pair, quantity.of, fmt::format("quantity '{}': a stretch needs", quantity.name), quantity.where);
  const StretchWeights stretch = stretch_weights(first, line, *quantity.stretch, quantity.where);
  return {quadratics<2>(stretch.below), quadratics<2>(stretch.above), false,
          Enclosure(quantity.stretch->to) - Enclosure(quantity.stretch->from)};
}

template <int dim>
ContactWeights<dim> contact_weights(const scene::Scene<dim>& scene, const Problem<dim>& first,
                                    const Quantity<dim>& quantity) {
  const int pair = pair_named(scene, quantity.of, quantity.where);
  if (quantity.weight) return given_weights(first, quantity, pair);
  if constexpr (dim == 2)
    if (quantity.stretch) return stretch_weights(first, quantity, pair, scene::is_two_sided(scene.contact[pair]));
  const LinearWeights<dim> whole = whole_weights(first, pair);
  ContactWeights<dim> weights;
  weights.below = weights.above = quadratics<dim>(whole);
  for (std::size_t j = 0; j < whole.size(); ++j) {
    if (first.contact[j].pair != pair) continue;
    double sum = 0;
    for (const double w : whole[j]) sum += w;
    weights.weighted = weights.weighted || sum < dim;
    weights.size += facet_size(first, first.contact[j].first) * Enclosure(sum) / Enclosure(dim);
  }
  return weights;
}

template <int dim> FacetWeights<dim> negated(FacetWeights<dim> weights) {
  for (auto& weight : weights)
    for (double& w : weight) w = 0.0 - w;
  return weights;
}

template <int dim> bool is_non_negative(const FacetWeights<dim>& weights) {
  return std::ranges::all_of(
      weights, [](const auto& weight) { return std::ranges::all_of(weight, [](double w) { return w >= 0; }); });
}

}  // namespace

template <int dim>
Functionals<dim> contact_work_functionals(const Problem<dim>& problem,
                                          const std::vector<scene::FacetQuadratic<dim>>& below,
                                          const std::vector<scene::FacetQuadratic<dim>>& above) {
  const auto with = [&](const FacetWeights<dim>& weight) {
    Perturbation<dim> perturbation = scene::no_perturbation(problem);
    for (std::size_t j = 0; j < weight.size(); ++j) perturbation.contact[j].gap = weight[j];
    return std::make_shared<const Perturbation<dim>>(std::move(perturbation));
  };
  Functionals<dim> result;
  result.below = with(above);
  result.above = below == above ? result.below : with(below);
  return result;
}

template <int dim>
Functionals<dim> contact_force(const scene::Scene<dim>& scene, const Problem<dim>& first,
                               const Quantity<dim>& quantity) {
  ContactWeights<dim> weights = contact_weights(scene, first, quantity);
  const bool two_sided = scene::is_two_sided(scene.contact[pair_named(scene, quantity.of, quantity.where)]);
  if (two_sided) weights.above = weights.below;  // p has either sign: the weight is what it was rounded to
  Functionals<dim> result = contact_work_functionals(first, negated<dim>(weights.above), negated<dim>(weights.below));
  result.non_negative = is_non_negative<dim>(weights.below) && !two_sided;
  result.weighted = weights.weighted;
  return result;
}

namespace {

/// A linear weight that is nowhere above a quadratic one, which is linear itself but for rounding: of its Bernstein
/// coefficients none is larger.
template <int dim>
scene::FacetQuadratic<dim> linear_below(const scene::FacetQuadratic<dim>& weight, const Quantity<dim>& quantity) {
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  double size = 0;
  for (const double w : weight) size = std::max(size, std::abs(w));
  bool above = false;
  for (int e = 0; e < static_cast<int>(scene::Simplex<dim - 1>::edges.size()); ++e) {
    const auto& [i, k] = scene::Simplex<dim - 1>::edges[e];
    const double a = weight[vertex_place<dim>(i)], b = weight[vertex_place<dim>(k)], own = weight[edge_place<dim>(e)];
    if (std::abs(own - (a + b) / 2) > rounding * size)
      refuse(quantity,
             fmt::format("the weight of an opening must be linear on each {} of the first mesh", facet_name<dim>));
    // Twice the mean is sum + error, exactly; what is taken off is not lost in rounding.
    const auto [sum, error] = scene::exact_sum(a, b);
    const scene::Real middle = 2 * scene::Real(own);
    above = above || sum > middle || (sum == middle && error > 0);
  }
  std::array<double, dim> linear;
  for (int i = 0; i < dim; ++i) linear[i] = weight[vertex_place<dim>(i)];
  scene::FacetQuadratic<dim> below = quadratic<dim>(linear);
  for (double& w : below) w -= above ? rounding * size : 0;
  return below;
}
template <int dim> FacetWeights<dim> linear_below(FacetWeights<dim> weights, const Quantity<dim>& quantity) {
  for (auto& weight : weights) weight = linear_below(weight, quantity);
  return weights;
}

}  // namespace

template <int dim>
Functionals<dim> opening(const scene::Scene<dim>& scene, const Problem<dim>& problem, const Quantity<dim>& quantity) {
  const Problem<dim>& first = scene::first_of(problem);
  const auto& pair = scene.contact[pair_named(scene, quantity.of, quantity.where)];
  if (pair.law == scene::Law::bilateral || (pair.law == scene::Law::tresca && !pair.lifts_off))
    refuse(quantity, "the sides of this contact keep together: they open nowhere");
  ContactWeights<dim> weights = contact_weights(scene, first, quantity);
  weights.below = linear_below(std::move(weights.below), quantity);
  weights.above = negated<dim>(linear_below(negated<dim>(std::move(weights.above)), quantity));
  const auto with = [&](const FacetWeights<dim>& weight) {
    Perturbation<dim> perturbation = scene::no_perturbation(first);
    for (std::size_t j = 0; j < weight.size(); ++j)
      for (int i = 0; i < dim; ++i) perturbation.contact[j].opening[i] = 0.0 - weight[j][vertex_place<dim>(i)];
    return std::make_shared<const Perturbation<dim>>(std::move(perturbation));
  };
  Functionals<dim> result;
  result.below = with(weights.below);
  result.above = weights.above == weights.below ? result.below : with(weights.above);
  result.offset_below = weighted_gap(problem, weights.below, false);
  result.offset_above = weighted_gap(problem, weights.above, true);
  if (!quantity.weight) result.scale = weights.size;
  result.non_negative = is_non_negative<dim>(weights.below) && pair.law != scene::Law::winkler;
  result.weighted = weights.weighted;
  return result;
}

template <int dim> int pair_named(const scene::Scene<dim>& scene, const std::string& name, const std::string& where) {
  std::vector<std::string> known;
  std::vector<int> found;
  for (std::size_t i = 0; i < scene.contact.size(); ++i) {
    const auto& pair = scene.contact[i];
    if (pair.name.empty())
      known.insert(known.end(), pair.first.parts.begin(), pair.first.parts.end());
    else
      known.push_back(pair.name);
    if (pair.name == name || (pair.name.empty() && scene::contains(pair.first, name)))
      found.push_back(static_cast<int>(i));
  }
  if (found.size() == 1) return found[0];
  const std::string why = found.empty() ? "there is no contact '" + name + "'; " + scene::suggestion(name, known)
                                        : "several contacts have the first side '" + name + "'; give them names";
  scene::fail(scene::Status::input, where, why);
}

#define INSTANTIATE(dim)                                                                                        \
  template Functionals<dim> contact_work_functionals(const Problem<dim>&,                                       \
                                                     const std::vector<scene::FacetQuadratic<dim>>&,            \
                                                     const std::vector<scene::FacetQuadratic<dim>>&);           \
  template Functionals<dim> contact_force(const scene::Scene<dim>&, const Problem<dim>&, const Quantity<dim>&); \
  template Functionals<dim> opening(const scene::Scene<dim>&, const Problem<dim>&, const Quantity<dim>&);       \
  template int pair_named(const scene::Scene<dim>&, const std::string&, const std::string&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::bounds
