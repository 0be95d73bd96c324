// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/certificate/admissible_displacement.h"
#include "bounds/quantities/line.h"
#include "bounds/quantities/parts.h"
#include "scene/problem/gap.h"
#include "scene/text.h"

namespace bracket::bounds {

using scene::Enclosure;
using scene::Perturbation;
using scene::Problem;
using scene::Quantity;

namespace {

/// Weights by Bernstein coefficients on each contact facet of the first mesh, below and above what is meant.
struct ContactWeights {
  std::vector<std::array<double, 3>> below, above;
  bool weighted = false;
  Enclosure length;  ///< of what they are the indicator of; 0: they are weights of their own
};

std::vector<std::array<double, 3>> quadratic(const LinearWeight& weight) {
  std::vector<std::array<double, 3>> result;
  for (const auto& [a, b] : weight) result.push_back({a, (a + b) / 2, b});
  return result;
}

void check_continuous(const Problem<2>& first, const Quantity<2>& quantity, int pair, const ContactWeights& weights) {
  for (const ContactLine& line : contact_lines(first, pair))
    for (std::size_t i = line.closed ? 0 : 1; i < line.contact.size(); ++i) {
      const int one = line.contact[(i == 0 ? line.contact.size() : i) - 1], next = line.contact[i];
      if (weights.below[one][0] == weights.below[next][2] && weights.above[one][0] == weights.above[next][2]) continue;
      const int v = first.mesh.boundary[first.contact[one].first].vertices[0];
      refuse(quantity,
             fmt::format("its weight jumps at {}: a jump has no finite energy", scene::point(first.mesh.vertices[v])));
    }
}

ContactWeights given_weights(const Problem<2>& first, const Quantity<2>& quantity, int pair) {
  ContactWeights weights;
  weights.below.assign(first.contact.size(), {0, 0, 0});
  weights.above = weights.below;
  if (!quantity.weight.is_enclosed()) refuse(quantity, "its weight must be a number or an expression");
  for (std::size_t j = 0; j < first.contact.size(); ++j) {
    if (first.contact[j].pair != pair) continue;
    const auto [a, b] = scene::positions(first.mesh, first.mesh.boundary[first.contact[j].first].vertices);
    const auto bounds = scene::quadratic_gap(quantity.weight, a, b);
    if (!bounds)
      refuse(quantity, fmt::format("its weight is not one quadratic on the edge of the first mesh from {} to {}",
                                   scene::point(a), scene::point(b)));
    weights.below[j] = bounds->lower;
    weights.above[j] = bounds->upper;
  }
  check_continuous(first, quantity, pair, weights);
  return weights;
}

ContactWeights contact_weights(const scene::Scene<2>& scene, const Problem<2>& first, const Quantity<2>& quantity) {
  const int pair = pair_named(scene, quantity.of, quantity.where);
  if (quantity.weight) return given_weights(first, quantity, pair);
  ContactWeights weights;
  if (quantity.stretch) {
    if (scene::is_two_sided(scene.contact[pair]))
      refuse(
          quantity,
          "a stretch of it has no bounds where the sides cannot lift off, for pressures of either sign do not add up "
          "one way; expected the whole contact, or a weight");
    const ContactLine line = open_line(first, pair, quantity.of,
                                       fmt::format("quantity '{}': a stretch needs", quantity.name), quantity.where);
    const StretchWeights stretch = stretch_weights(first, line, *quantity.stretch, quantity.where);
    weights.below = quadratic(stretch.below);
    weights.above = quadratic(stretch.above);
    weights.length = Enclosure(quantity.stretch->to) - Enclosure(quantity.stretch->from);
  } else {
    const auto held = held_ends(first);
    LinearWeight whole(first.contact.size(), {0, 0});
    for (std::size_t j = 0; j < whole.size(); ++j) {
      if (first.contact[j].pair != pair) continue;
      for (int i = 0; i < 2; ++i) whole[j][i] = held[j][i] ? 0 : 1;
      weights.weighted = weights.weighted || held[j][0] || held[j][1];
      weights.length +=
          facet_length(first, first.contact[j].first) * Enclosure(whole[j][0] + whole[j][1]) / Enclosure(2);
    }
    weights.below = weights.above = quadratic(whole);
  }
  return weights;
}

std::array<double, 3> negated(const std::array<double, 3>& w) { return {0.0 - w[0], 0.0 - w[1], 0.0 - w[2]}; }

bool is_non_negative(const std::vector<std::array<double, 3>>& weight) {
  return std::ranges::all_of(weight, [](const auto& w) { return w[0] >= 0 && w[1] >= 0 && w[2] >= 0; });
}

}  // namespace

Functionals<2> contact_work_functionals(const Problem<2>& problem, const std::vector<std::array<double, 3>>& below,
                                        const std::vector<std::array<double, 3>>& above) {
  const auto with = [&](const std::vector<std::array<double, 3>>& weight) {
    Perturbation<2> perturbation = scene::no_perturbation(problem);
    for (std::size_t j = 0; j < weight.size(); ++j) perturbation.contact[j].gap = weight[j];
    return std::make_shared<const Perturbation<2>>(std::move(perturbation));
  };
  Functionals<2> result;
  result.below = with(above);
  result.above = below == above ? result.below : with(below);
  return result;
}

Functionals<2> contact_force(const scene::Scene<2>& scene, const Problem<2>& first, const Quantity<2>& quantity) {
  const ContactWeights weights = contact_weights(scene, first, quantity);
  const auto negative = [](std::vector<std::array<double, 3>> weight) {
    for (auto& facet : weight) facet = negated(facet);
    return weight;
  };
  Functionals<2> result = contact_work_functionals(first, negative(weights.above), negative(weights.below));
  result.non_negative = is_non_negative(weights.below) &&
                        !scene::is_two_sided(scene.contact[pair_named(scene, quantity.of, quantity.where)]);
  result.weighted = weights.weighted;
  return result;
}

namespace {

/// A linear weight that is nowhere above a quadratic one, which is linear itself but for rounding: of its Bernstein
/// coefficients none is larger.
std::array<double, 3> linear_below(std::array<double, 3> weight, const Quantity<2>& quantity) {
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  const double size = std::max({std::abs(weight[0]), std::abs(weight[1]), std::abs(weight[2])});
  const double mean = (weight[0] + weight[2]) / 2;
  if (std::abs(weight[1] - mean) > rounding * size)
    refuse(quantity, "the weight of an opening must be linear on each edge of the first mesh");
  // Twice the mean is sum + error, exactly; what is taken off is not lost in rounding.
  const auto [sum, error] = scene::exact_sum(weight[0], weight[2]);
  const scene::Real middle = 2 * scene::Real(weight[1]);
  const bool above = sum > middle || (sum == middle && error > 0);
  const double excess = above ? rounding * size : 0;
  return {weight[0] - excess, mean - excess, weight[2] - excess};
}

/// ∫ w g of a weight that is linear on the first mesh's facets, with the lower or the upper gap of the current mesh.
Enclosure weighted_gap(const Problem<2>& problem, const std::vector<std::array<double, 3>>& weight, bool upper) {
  const std::vector<int> contact_of = scene::contacts_by_first(scene::first_of(problem));
  LongSum sum;
  for (const auto& pair : problem.contact) {
    const auto [of, corner] = scene::piece_of_facet(problem, pair.first);
    const auto& [a, middle, b] = weight[contact_of[of]];
    if (a == 0 && b == 0) continue;
    const auto e = along<Enclosure>(problem, pair.first);
    const Enclosure length = root(dot(e, e));
    for (int i = 0; i < 2; ++i) {
      std::array<Enclosure, 2> hat = {Enclosure(0), Enclosure(0)};
      hat[i] = between_ends(Enclosure(a), Enclosure(b), corner[i][0]);
      const auto& gap = (hat[i].middle >= 0) == upper ? pair.upper : pair.lower;
      sum.add(length *
              scene::bernstein_product(std::vector<Enclosure>(hat.begin(), hat.end()), gap_on<Enclosure>(gap, 2)));
    }
  }
  return sum.value();
}

}  // namespace

Functionals<2> opening(const scene::Scene<2>& scene, const Problem<2>& problem, const Quantity<2>& quantity) {
  const Problem<2>& first = scene::first_of(problem);
  const auto& pair = scene.contact[pair_named(scene, quantity.of, quantity.where)];
  if (pair.law == scene::Law::bilateral || (pair.law == scene::Law::tresca && !pair.lifts_off))
    refuse(quantity, "the sides of this contact keep together: they open nowhere");
  ContactWeights weights = contact_weights(scene, first, quantity);
  for (auto& weight : weights.below) weight = linear_below(weight, quantity);
  for (auto& weight : weights.above) weight = negated(linear_below(negated(weight), quantity));
  const auto with = [&](const std::vector<std::array<double, 3>>& weight) {
    Perturbation<2> perturbation = scene::no_perturbation(first);
    for (std::size_t j = 0; j < weight.size(); ++j)
      perturbation.contact[j].opening = {0.0 - weight[j][0], 0.0 - weight[j][2]};
    return std::make_shared<const Perturbation<2>>(std::move(perturbation));
  };
  Functionals<2> result;
  result.below = with(weights.below);
  result.above = weights.above == weights.below ? result.below : with(weights.above);
  result.offset_below = weighted_gap(problem, weights.below, false);
  result.offset_above = weighted_gap(problem, weights.above, true);
  if (!quantity.weight) result.scale = weights.length;
  result.non_negative = is_non_negative(weights.below) && pair.law != scene::Law::winkler;
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

template int pair_named(const scene::Scene<2>&, const std::string&, const std::string&);

}  // namespace bracket::bounds
