// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace bracket::scene {

/// What is to be said of the lines that slide or touch, one line each: edges that were taken for one straight line
/// though they are turned by more than the rounding of doubles, and parts that turn at their vertices (by less than the
/// 20 degrees of a corner), with the largest angle and how far an arc would bulge beyond its chords: a polygon in
/// contact has a polygon's pressure. Parts that are declared as arcs are not told.
std::vector<std::string> notes_on_lines(const Scene<2>& scene, const Problem<2>& problem);
/// In space: parts that slide or touch and turn at edges, by less than 20 degrees, with the largest angle.
std::vector<std::string> notes_on_lines(const Scene<3>& scene, const Problem<3>& problem);

}  // namespace bracket::scene
