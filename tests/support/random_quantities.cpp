// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/random_quantities.h"

#include <fmt/format.h>

#include <cmath>

#include "bounds/bounds.h"
#include "tests/support/random_grid.h"
#include "tests/support/random_laws.h"

namespace bracket::tests {
namespace {

using scene::QuantityKind;

std::size_t index(Random& random, std::size_t size) {
  return std::min(static_cast<std::size_t>(random.uniform(0, 1) * static_cast<double>(size)), size - 1);
}

scene::Quantity<2> random_quantity(Random& random, const RandomScene& of, int number) {
  scene::Quantity<2> quantity;
  quantity.name = fmt::format("q{}", number);
  quantity.kind = static_cast<QuantityKind>(index(random, 8));
  const bool of_contact = quantity.kind == QuantityKind::force || quantity.kind == QuantityKind::opening;
  const bool of_body = quantity.kind == QuantityKind::body || quantity.kind == QuantityKind::stress;
  if (of_contact && !of.scene.contact.empty()) {
    const auto& pair = of.scene.contact[index(random, of.scene.contact.size())];
    quantity.of = pair.first.parts.front();
    if (random.chance(0.3)) {
      const double c = random.uniform(-1, 1);
      const double a = random.uniform(-1, 1);
      const double b = random.uniform(-1, 1);
      quantity.weight = scene::enclosed<2>([=](const auto& x) { return c + a * x[0] + b * x[1]; });
    } else if (random.chance(0.3)) {
      const double from = random.uniform(0, 0.5);
      quantity.stretch = scene::LineStretch{from, from + random.uniform(0.1, 1)};
    }
  } else if (of_body) {
    quantity.of = of.mesh.bodies[index(random, of.mesh.bodies.size())];
  } else if (quantity.kind != QuantityKind::energy) {
    quantity.of = of.mesh.parts[index(random, of.mesh.parts.size())];
  }
  const bool directed = quantity.kind == QuantityKind::displacement || quantity.kind == QuantityKind::body ||
                        quantity.kind == QuantityKind::reaction;
  if (directed && (quantity.kind == QuantityKind::body || random.chance(0.7)))
    quantity.direction = random.pick<Vector<2>>({{1, 0}, {0, 1}, {1, -2}, {0.6, 0.8}});
  quantity.component = static_cast<scene::StressComponent>(index(random, 4));
  return quantity;
}

void judge_end(const bounds::Outcome<2>& outcome, int degree, QuantitiesVerdict& verdict) {
  if (outcome.reason.find("fault of this program") != std::string::npos)
    verdict.faults.push_back(fmt::format("degree {}: {}", degree, outcome.reason));
  if (outcome.guarantee == "none") return;
  for (const auto& interval : outcome.quantities) {
    for (const auto& level : interval.levels)
      if (!(level.lower <= level.upper))
        verdict.faults.push_back(fmt::format("{}, degree {}, {} cells: [{}, {}]", interval.name, degree, level.cells,
                                             level.lower, level.upper));
    const int ends = std::isfinite(interval.lower) + std::isfinite(interval.upper);
    verdict.both_ends += ends == 2;
    verdict.one_end += ends == 1;
  }
}

}  // namespace

QuantitiesVerdict judge_random_quantities(std::uint64_t seed, bool laws) {
  const RandomScene of = laws ? random_laws(seed) : random_scene(seed);
  Random random(seed ^ 0x5bd1e995);
  QuantitiesVerdict verdict;
  verdict.text = of.text;
  scene::Scene<2> scene = of.scene;
  scene.refine = {.strategy = scene::Strategy::uniform, .max_levels = 3, .all_levels = true};
  std::vector<scene::Quantity<2>> asked;
  for (int i = 0, n = 1 + static_cast<int>(index(random, 3)); i < n; ++i)
    asked.push_back(random_quantity(random, of, i));
  for (const auto& pair : of.scene.contact) {
    if (pair.law != scene::Law::tresca) continue;
    for (const QuantityKind kind : {QuantityKind::force, QuantityKind::slip}) {
      scene::Quantity<2> own;
      own.name = fmt::format("q{}", asked.size());
      own.kind = kind;
      own.of = pair.first.parts.front();
      if (kind == QuantityKind::force) own.of_force = scene::ForceComponent::shear;
      asked.push_back(std::move(own));
    }
  }
  for (const auto& one : asked) {  // each alone, so that one that is refused spoils no other
    scene.quantities = {one};
    verdict.text += fmt::format("  {}: {} of '{}'\n", one.name, name(one.kind), one.of);
    std::vector<std::pair<double, double>> found;
    for (const int degree : {1, 2}) {
      scene.solve.degree = degree;
      try {
        const auto outcome = bounds::run(scene, scene::fix_data(scene, of.mesh));
        if (degree == 2) ++verdict.asked;
        judge_end(outcome, degree, verdict);
        if (outcome.guarantee != "none")
          for (const auto& interval : outcome.quantities) found.emplace_back(interval.lower, interval.upper);
      } catch (const scene::Error&) {
        if (degree == 2) ++verdict.refused;
      } catch (const std::exception& error) {
        verdict.faults.push_back(fmt::format("{}, degree {}: {}", one.name, degree, error.what()));
      }
    }
    if (found.size() == 2 && (found[0].first > found[1].second || found[1].first > found[0].second))
      verdict.faults.push_back(fmt::format("{}: the degrees exclude each other: [{}, {}] and [{}, {}]", one.name,
                                           found[0].first, found[0].second, found[1].first, found[1].second));
  }
  return verdict;
}

}  // namespace bracket::tests
