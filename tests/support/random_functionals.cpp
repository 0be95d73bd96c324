// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/random_functionals.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "bounds/bounds.h"
#include "bounds/quantities/functional.h"
#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/support/random_grid.h"
#include "tests/support/scenes.h"

namespace bracket::tests {
namespace {

using scene::QuantityKind;

scene::Scene<2> pick_scene(Random& random) {
  switch (static_cast<int>(random.uniform(0, 4))) {
    case 0: return two_blocks(2, random.uniform(0, 0.09));
    case 1: return two_blocks(3);
    case 2: return patch(random.uniform(0.5, 2), random.uniform(0, 0.4), 0.01, 2);
    default: return linear_pressure({.c = random.uniform(-1, 1), .young_lower = random.uniform(0.5, 5)}, 3, 2);
  }
}

scene::Quantity<2> pick_quantity(Random& random) {
  scene::Quantity<2> quantity;
  quantity.name = "q";
  quantity.kind = random.pick<QuantityKind>(
      {QuantityKind::body, QuantityKind::force, QuantityKind::opening, QuantityKind::reaction, QuantityKind::stress});
  quantity.of = quantity.kind == QuantityKind::reaction                                          ? "lower.bottom"
                : quantity.kind == QuantityKind::force || quantity.kind == QuantityKind::opening ? "upper.bottom"
                                                                                                 : "upper";
  quantity.direction = Vector<2>(0, 1);
  if (quantity.kind == QuantityKind::force || quantity.kind == QuantityKind::opening) {
    quantity.direction.reset();
    const double c = random.uniform(-1, 1);
    const double a = random.uniform(-1, 1);
    quantity.weight = scene::enclosed<2>([=](const auto& x) { return c + a * x[0]; });
  }
  if (quantity.kind == QuantityKind::stress) {
    quantity.direction.reset();
    quantity.component = scene::StressComponent::yy;
  }
  return quantity;
}

/// The solutions of the problem with loads a f and kinematics b f, for some a and b.
struct Fields {
  std::vector<scene::Displacement<2>> displacement;
  std::vector<scene::Stress<2>> stress;
};
Fields solutions(const scene::Problem<2>& problem, const std::shared_ptr<const scene::Perturbation<2>>& by, double f) {
  Fields fields;
  for (const double a : {0.0, 1.0, -1.0}) {
    const auto u = primal::solve(scene::perturbed(problem, by, a * f, f), 2);
    const auto lambda = dual::solve(scene::perturbed(problem, by, f, a * f), 1);
    if (u.reason.empty()) fields.displacement.push_back(u.displacement);
    if (lambda.reason.empty()) fields.stress.push_back(lambda.stress);
  }
  return fields;
}

scene::Displacement<2> mixed(Random& random, const std::vector<scene::Displacement<2>>& of, double noise) {
  const double t = random.uniform(0, 1);
  const auto &a = random.pick(of), &b = random.pick(of);
  scene::Displacement<2> result = a;
  const auto value = [&](const Vector<2>& x, const Vector<2>& y) {
    const double dx = random.uniform(-noise, noise);
    return Vector<2>(x + t * (y - x) + Vector<2>(dx, random.uniform(-noise, noise)));
  };
  for (std::size_t i = 0; i < a.vertex.size(); ++i) result.vertex[i] = value(a.vertex[i], b.vertex[i]);
  for (std::size_t i = 0; i < a.edge.size(); ++i) result.edge[i] = value(a.edge[i], b.edge[i]);
  return result;
}
scene::Stress<2> mixed(Random& random, const std::vector<scene::Stress<2>>& of, double noise) {
  const double t = random.uniform(0, 1);
  const auto &a = random.pick(of), &b = random.pick(of);
  scene::Stress<2> result = a;
  for (std::size_t c = 0; c < a.cell.size(); ++c)
    for (std::size_t i = 0; i < a.cell[c].size(); ++i) {
      result.cell[c][i] += t * (b.cell[c][i] - a.cell[c][i]);
      for (int k = 0; k < 3; ++k) result.cell[c][i][k] += random.uniform(-noise, noise);
    }
  return result;
}

}  // namespace

FunctionalsVerdict judge_random_functionals(std::uint64_t seed) {
  Random random(seed);
  scene::Scene<2> scene = pick_scene(random);
  scene.quantities = {pick_quantity(random)};
  scene.refine = {.strategy = scene::Strategy::adaptive, .max_cells = 1500};
  FunctionalsVerdict verdict;
  verdict.least = std::numeric_limits<double>::infinity();
  const auto outcome = bounds::run(scene);
  const auto problem = bounds::balanced(tests::problem(scene), 2);
  const auto functionals = bounds::functionals(scene, problem, scene.quantities[0]);
  if (functionals.below != functionals.above || outcome.quantities.empty()) return verdict;
  // J = scale · q − offset of the fine interval.
  const auto of = [&](double q, const scene::Enclosure& offset) {
    return functionals.scale * scene::Enclosure(q) - offset;
  };
  const double low = scene::lower(of(outcome.quantities[0].lower, functionals.offset_below));
  const double high = scene::upper(of(outcome.quantities[0].upper, functionals.offset_above));
  if (!std::isfinite(low) || !std::isfinite(high)) return verdict;
  for (int group = 0; group < 10; ++group) {
    const double f = (group % 2 == 0 ? 1 : -1) * std::exp2(-std::round(random.uniform(2, 16)));
    const Fields fields = solutions(problem, functionals.above, f);
    if (fields.displacement.empty() || fields.stress.empty()) continue;
    for (int k = 0; k < 10; ++k) {
      const double noise = random.chance(0.5) ? 0 : std::pow(10, random.uniform(-12, -2));
      const auto bound =
          bounds::certify_functional(scene::perturbed(problem, functionals.above, f, f),
                                     mixed(random, fields.displacement, noise), mixed(random, fields.stress, noise));
      if (!bound.valid) continue;
      ++verdict.pairs;
      // f J ≤ above; J is between low and high.
      const double beyond = bound.above / std::abs(f) - (f > 0 ? low : -high);
      verdict.least = std::min(verdict.least, beyond / std::max(std::abs(low), std::abs(high)));
      if (beyond < 0)
        verdict.faults.push_back(fmt::format("seed {}: {} with f = {}: {} against [{}, {}]", seed,
                                             name(scene.quantities[0].kind), f, bound.above / f, low, high));
    }
  }
  return verdict;
}

}  // namespace bracket::tests
