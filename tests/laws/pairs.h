// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/scenes.h"

/// Contact pairs with laws.
namespace bracket::tests {

struct NamedLaw {
  const char* name;
  scene::Law law;
  std::optional<scene::Function<2>> value = {};
  bool lifts_off = true;
};

inline scene::Scene<2> with_law(scene::Scene<2> s, const NamedLaw& law) {
  for (auto& pair : s.contact) {
    pair.law = law.law;
    pair.value = law.value;
    pair.lifts_off = law.lifts_off;
  }
  return s;
}

/// A block without side-strain (ν = 0) on a wall at its bottom, its top moved by (along, −down), with the shear t at
/// its sides.
inline scene::Scene<2> block_on_wall(double young, double along, double down, double t, const NamedLaw& law) {
  scene::Scene<2> s;
  s.blocks = {block("b", 0, 2, 0, 1, 3, 2)};
  s.bodies = {{"b", scene::isotropic<2>(young, 0, scene::Plane::strain)}};
  s.boundary = {{"b.top", fixed(along, -down)},
                {"b.right", traction(constant(0), constant(t))},
                {"b.left", traction(constant(0), constant(-t))}};
  s.contact = {{"b.bottom", "rigid", {}, ""}};
  return with_law(s, law);
}

/// Each law, with values that are constant and linear, for loads and moduli of about one.
inline std::vector<NamedLaw> laws() {
  using scene::Law;
  const auto linear = [](double a, double b) {
    return scene::enclosed<2>([a, b](const auto& x) { return a + b * x[0]; });
  };
  return {{"frictionless", Law::frictionless},
          {"bilateral", Law::bilateral},
          {"winkler", Law::winkler, constant(2)},
          {"winkler linear", Law::winkler, linear(1, 3)},
          {"winkler with tension", Law::winkler, constant(2), false},
          {"winkler linear with tension", Law::winkler, linear(4, -3), false},
          {"tresca", Law::tresca, constant(0.004)},
          {"tresca linear", Law::tresca, linear(0, 0.01)},
          {"tresca without lift-off", Law::tresca, constant(0.004), false}};
}

}  // namespace bracket::tests
