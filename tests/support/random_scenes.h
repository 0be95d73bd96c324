// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "scene/scene.h"

namespace bracket::tests {

/// A scene with a mesh of its own, and both in words.
struct RandomScene {
  scene::Scene<2> scene;
  scene::Mesh<2> mesh;
  std::string text;
};

/// One to six bodies side by side and on each other: rectangles, quadrilaterals and polygons with re-entrant corners,
/// some far from the origin; isotropic and anisotropic materials with moduli that differ by up to 1e16 and ν from −0.5
/// to 0.4999; supports, loads, weights; contact with each other and with walls, closed, open, with interference and
/// with curved gaps. The scene may well be ill-posed. A seed gives the same scene everywhere.
RandomScene random_scene(std::uint64_t seed);

}  // namespace bracket::tests
