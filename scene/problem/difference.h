// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "scene/function.h"
#include "scene/problem/stretch.h"

/// What is left out where a function on an edge is fixed by few values. The parameter s is 0 at the edge's end a and 1
/// at b.
namespace bracket::scene {

/// A stretch of an edge, from `from` to `to`.
struct EdgePanel {
  double from, to;
};

/// Eight panels; where the function is not smooth they are halved towards that, 48 times. One panel, where the function
/// is linear for sure; eight, where it is but sampled.
std::vector<EdgePanel> panels_of(const Function<2>& given, const Vector<2>& a, const Vector<2>& b);

/// On a panel: the difference of a function and a cubic on the edge.
struct Difference {
  EdgePanel panel;
  double largest;  ///< not less than its magnitude; of a sampled function, that at five points
  double slope;    ///< the same of its derivative by s; infinite where that has no bound
  double value;    ///< as `largest`, of the function itself
};
std::vector<Difference> difference(const Function<2>& given, const Vector<2>& a, const Vector<2>& b,
                                   const EdgeCubic<double>& fixed);

/// What rounding does to values of about `largest` on an edge, which differ as the cubic does, and to the points at
/// which they are taken: a difference that is no larger is none.
double rounding_of_values(double largest, const EdgeCubic<double>& fixed, const Vector<2>& a, const Vector<2>& b);

}  // namespace bracket::scene
