// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "apps/plots/canvas.h"
#include "apps/report/deformed.h"

/// What holds and loads the bodies, drawn at them, with the names of both.
namespace bracket::apps {

struct Symbols {
  std::vector<Layer> layers;
  std::string labels;       ///< commands that set them
  Eigen::AlignedBox2d box;  ///< what they need
};

/// Hatches where bodies are fixed, rollers where they slide, arrows of tractions and pressures (the largest has a
/// length of 0.1 `size`), names of these parts and of the bodies, and from there the direction of a body force.
Symbols symbols(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement, const DrawnShape& shape,
                double size);

}  // namespace bracket::apps
