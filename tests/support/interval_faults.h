// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace bracket::tests {

/// What three nested meshes and both degrees made of one scene.
struct Verdict {
  scene::Status status = scene::Status::done;  ///< of degree 2
  std::string reason;
  std::vector<std::string> faults;  ///< of the program, one line each; none: all that must hold does
};

/// Solves a scene on `mesh` and on it with all edges halved, once and twice, with degree 1 and 2, and looks for what
/// cannot be: bounds that cross, intervals of one energy that exclude each other, an upper bound that rises from one
/// space to a larger one by more than the certificates added, an exception that is no scene::Error, a scene refused as
/// malformed, an ending without a line that says why. Energies are compared up to the rounding of coordinates.
Verdict judge(scene::Scene<2> scene, const scene::Mesh<2>& mesh);

}  // namespace bracket::tests
