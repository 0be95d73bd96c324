// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/random_sides.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "bounds/bounds.h"
#include "tests/support/scenes.h"

namespace bracket::tests {

namespace {

struct Draw {
  std::mt19937_64 random;
  double between(double from, double to) { return from + (to - from) * static_cast<double>(random() >> 11) * 0x1p-53; }
  int whole(int from, int to) { return from + static_cast<int>(random() % static_cast<unsigned>(to - from + 1)); }
  bool chance(double of) { return between(0, 1) < of; }
};

/// The problem, on a mesh that is drawn last; data are constant on each part, so that all meshes carry the same.
scene::Scene<2> scene_of_sides(std::uint64_t seed, int mesh) {
  Draw draw{std::mt19937_64(seed)};
  scene::Scene<2> s;
  const double height = draw.between(0.2, 0.8);
  s.blocks = {block("lower", 0, 1, -height, 0, 1, 1)};
  s.bodies = {{"lower", scene::isotropic<2>(1, draw.between(-0.3, 0.49), scene::Plane::strain)}};
  s.boundary = {{"lower.bottom", fixed(0, 0)}};
  const int uppers = draw.whole(1, 2);
  const bool one_side = draw.chance(0.5);
  const double distance = draw.chance(0.4) ? draw.between(0.001, 2) : 0;
  std::vector<std::string> parts;
  double from = draw.chance(0.3) ? std::pow(10, draw.between(-6, -1)) : draw.between(-0.4, 0.4);
  for (int i = 0; i < uppers; ++i) {
    const std::string name = i == 0 ? "a" : "b";
    const double to = from + draw.between(0.2, 0.6);
    s.blocks.push_back(block(name, from, to, distance, distance + draw.between(0.2, 0.5), 1, 1));
    s.bodies.emplace(name, scene::isotropic<2>(std::pow(10, draw.between(-3, 3)), 0.3, scene::Plane::strain));
    if (draw.chance(0.6)) {
      s.boundary.emplace(name + ".top", fixed(draw.between(-0.01, 0.01), draw.between(-0.05, 0.01)));
    } else {
      s.boundary.emplace(name + (draw.chance(0.5) ? ".left" : ".right"), sliding(0));
      s.boundary.emplace(name + ".top", traction(constant(draw.between(-0.001, 0.001)), constant(-0.01)));
    }
    parts.push_back(name + ".bottom");
    from = to + (draw.chance(0.5) ? 0 : draw.between(0.01, 0.2));
  }
  // A distance would ask for large displacements: mostly the gap is given.
  std::optional<scene::Function<2>> gap;
  if (distance > 0.02 || draw.chance(0.5)) gap = constant(draw.between(-0.01, 0.01));
  if (one_side)
    s.contact.push_back({parts, "lower.top", gap, ""});
  else
    for (const std::string& part : parts) s.contact.push_back({part, "lower.top", gap, ""});
  s.refine.strategy = scene::Strategy::uniform;
  s.refine.max_levels = 2;
  for (int i = 0; i < mesh; ++i) draw.random();
  for (scene::Block<2>& b : s.blocks) {
    b.cells[0] = draw.whole(1, 8);
    const double edge = (b.range[0][1] - b.range[0][0]) / b.cells[0];
    b.cells[1] = std::max(1, static_cast<int>(std::lround((b.range[1][1] - b.range[1][0]) / edge)));
  }
  return s;
}

/// The run, if it ends with bounds.
std::optional<bounds::Outcome<2>> bracketed(const scene::Scene<2>& s) {
  try {
    auto outcome = bounds::run(s);
    if (outcome.guarantee == "rounding-safe") return outcome;
  } catch (const scene::Error&) {  // ill-posed, or sides that do not face each other
  }
  return {};
}

}  // namespace

SidesVerdict judge_random_sides(std::uint64_t seed) {
  SidesVerdict verdict;
  std::vector<bounds::Outcome<2>> outcomes;
  for (int mesh = 0; mesh < 3; ++mesh) {
    const scene::Scene<2> s = scene_of_sides(seed, mesh);
    const auto outcome = bracketed(s);
    if (!outcome) continue;
    ++verdict.bracketed;
    for (const bounds::Level& level : outcome->levels)
      if (level.bracket.lower > level.bracket.upper)
        verdict.faults.push_back(fmt::format("seed {}, mesh {}: bounds cross", seed, mesh));
    for (const auto& other : outcomes)
      if (outcome->lower > other.upper || outcome->upper < other.lower)
        verdict.faults.push_back(fmt::format("seed {}, mesh {}: [{}, {}] and [{}, {}] exclude each other", seed, mesh,
                                             outcome->lower, outcome->upper, other.lower, other.upper));
    outcomes.push_back(*outcome);
    if (mesh > 0 || s.contact.size() > 1) continue;
    scene::Scene<2> swapped = s;
    std::swap(swapped.contact[0].first, swapped.contact[0].second);
    const auto other = bracketed(swapped);
    const double size = std::max(std::abs(outcome->lower), std::abs(outcome->upper));
    if (size < 1e-20) continue;  // nothing is strained: displacements of rounding, 1e-16, squared
    if (!other || std::abs(outcome->lower - other->lower) > 1e-12 * size ||
        std::abs(outcome->upper - other->upper) > 1e-12 * size)
      verdict.faults.push_back(fmt::format("seed {}: [{}, {}], swapped [{}, {}]", seed, outcome->lower, outcome->upper,
                                           other ? other->lower : 0, other ? other->upper : 0));
  }
  return verdict;
}

}  // namespace bracket::tests
