// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/problem/problem.h"

namespace bracket::bounds {

/// How many independent rigid motions of the bodies (three a body, all bodies side by side) meet neither a support nor
/// a contact pair that carries or is two-sided: exactly, for the directions of the data as the doubles that they are.
/// Of such a pair friction acts along the tangent, too. A facet of Γ_0 or Γ_K acts along its direction at two points:
/// two bodies that it joins do not turn against each other, and move against each other at right angles to it only.
/// What is left are the turns of bodies that hang together and on nothing else, and translations. \param carrying of
/// each contact pair, as Problem::carries
int unheld_motions(const scene::Problem<2>& problem, const std::vector<char>& carrying);

}  // namespace bracket::bounds
