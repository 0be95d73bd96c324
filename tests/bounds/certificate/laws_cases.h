// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/bounds/certificate/cases.h"

/// Contact laws for the judge in rational arithmetic.
namespace bracket::bounds::of_laws {

using scene::Law;

struct GivenLaw {
  std::string name;
  Law law;
  std::optional<scene::Function<2>> value = {};
  bool lifts_off = true;
  bool jumps = false;
};

/// Of numbers so short that pieces of facets have them without rounding.
inline std::vector<GivenLaw> laws() {
  const auto linear = [](double a, double b) {
    return scene::enclosed<2>([a, b](const auto& x) { return a + b * x[0]; });
  };
  return {{"bilateral", Law::bilateral},
          {"springs", Law::winkler, tests::constant(2)},
          {"linear springs", Law::winkler, linear(4, 0.5)},
          {"springs that pull", Law::winkler, linear(4, 0.5), false},
          {"friction", Law::tresca, tests::constant(1.0 / 64)},
          {"linear friction", Law::tresca, linear(0.125, 1.0 / 32)},
          {"friction without lift-off", Law::tresca, tests::constant(1.0 / 64), false},
          {"friction with a jump", Law::tresca, tests::constant(1.0 / 64), false, true},
          {"bilateral with a jump", Law::bilateral, {}, true, true}};
}

/// A jump that is quadratic, of short numbers, in place of the gap.
inline void set_jump(scene::ContactPair<2>& pair) {
  pair.gap.reset();
  pair.jump = {scene::enclosed<2>([](const auto& x) { return 1.0 / 32 + x[0] * x[0] / 64; }),
               scene::enclosed<2>([](const auto& x) { return x[0] / 128 - 1.0 / 64; })};
}

inline scene::Scene<2> with_law(scene::Scene<2> scene, const GivenLaw& law) {
  for (auto& pair : scene.contact) {
    pair.law = law.law;
    pair.value = law.value;
    pair.lifts_off = law.lifts_off;
    if (law.jumps) set_jump(pair);
  }
  return scene;
}

struct Fields {
  scene::Displacement<2> displacement;
  scene::Stress<2> stress;
};
/// Whatever the solvers end with.   \throw scene::Error where no displacement of the degree keeps a gap
inline Fields solved(const scene::Problem<2>& problem, int degree) {
  return {primal::solve(problem, degree).displacement, dual::solve(problem, scene::stress_degree(degree)).stress};
}

inline scene::Problem<2> refined(const scene::Problem<2>& first) {
  std::vector<char> marked(first.mesh.cells.size(), 0);
  marked.front() = marked.back() = 1;
  return scene::refine(first, marked).problem;
}

inline GivenLaw law_named(const std::string& name) {
  const auto all = laws();
  return *std::ranges::find(all, name, &GivenLaw::name);
}

/// Two blocks with a law of their own, refined; the sides are pressed and pulled, sheared both ways.
inline scene::Problem<2> two_blocks(const GivenLaw& law, bool fine = true) {
  tests::Case c = {"two_blocks", with_law(tests::two_blocks(2), law)};
  const auto first = tests::problem_of(c);
  return fine ? refined(first) : first;
}

}  // namespace bracket::bounds::of_laws
