// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/random_laws.h"

#include <fmt/format.h>

#include "tests/support/random_grid.h"

namespace bracket::tests {

RandomScene random_laws(std::uint64_t seed) {
  RandomScene made = random_scene(seed);
  Random random(seed + 77);
  double young = 0;  // of the softest body
  for (const auto& [name, body] : made.scene.bodies) {
    const double own = body.material.stiffness().norm();
    young = young == 0 ? own : std::min(young, own);
  }
  double size = 0;
  for (const auto& x : made.mesh.vertices) size = std::max(size, (x - made.mesh.vertices[0]).norm());
  for (auto& pair : made.scene.contact) {
    pair.law = random.pick<scene::Law>({scene::Law::frictionless, scene::Law::bilateral, scene::Law::winkler,
                                        scene::Law::winkler, scene::Law::tresca, scene::Law::tresca});
    const double factor = random.pick<double>({0, 1e-6, 1e-4, 1e-3, 1e-2, 1, 1e4});
    const double slope = random.pick<double>({0, 0, 0.4 / size});
    const double value = pair.law == scene::Law::winkler ? std::max(factor, 1e-8) * young / size : factor * young;
    const Vector<2> x0 = made.mesh.vertices[0];
    const auto linear = scene::enclosed<2>([=](const auto& x) { return value * (1 + slope * (x[0] - x0[0])); });
    if (pair.law == scene::Law::winkler || pair.law == scene::Law::tresca) {
      pair.value = slope == 0 ? scene::Function<2>(value) : linear;
      pair.lifts_off = random.chance(0.6);
    }
    if (is_two_sided(pair)) pair.gap = scene::Function<2>(0.0);
    made.text +=
        fmt::format("law of {}: {} {} {} {}\n", name(pair.first), name(pair.law), value, slope, pair.lifts_off);
  }
  return made;
}

}  // namespace bracket::tests
