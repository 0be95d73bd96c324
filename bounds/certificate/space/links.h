// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/problem/problem.h"

namespace bracket::bounds::space {

/// How many independent rigid motions of the bodies (six a body, all bodies side by side) meet neither a support nor a
/// contact pair that carries or is two-sided: exactly, for the directions of the data as the doubles that they are. A
/// facet of Γ_0 or Γ_K acts along its direction d at three points whose projections along d are no line: its loads have
/// all resultants of a force along d and a moment at right angles to d, about whatever point. \pre the sides of
/// contacts coincide \param carrying of each contact pair, as Problem::carries
int unheld_motions(const scene::Problem<3>& problem, const std::vector<char>& carrying);

}  // namespace bracket::bounds::space
