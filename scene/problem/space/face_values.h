// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: functions fixed on a face by few values, as scene/problem/projection.h does on edges. All throw Error
// (input), at `where`, if the function is not finite at a point where it is needed.
#pragma once

#include "scene/problem/projection.h"
#include "scene/problem/space/face.h"

namespace bracket::scene {

/// L2 projection on linear functions, by composite quadrature on parts that are small where an enclosed function is not
/// smooth. A function that is linear for sure, or to rounding, is taken as its values at the corners, one that is
/// constant inside as that constant, exactly; so jumps may lie at sides.
FacetValues<3> project(const Function<3>& given, const Face& face, const std::string& where);

/// The linear function with the given values at the corners.
FacetValues<3> interpolate_linear(const Function<3>& given, const Face& face, const std::string& where);

/// The quadratic function with the given values at the corners and the midpoints of the sides: its Bernstein
/// coefficients. The error is that at points.
FacetValues<6> interpolate_quadratic(const Function<3>& given, const Face& face, const std::string& where);

}  // namespace bracket::scene
