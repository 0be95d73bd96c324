// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/problem/stretch.h"
#include "scene/scene.h"

/// Given functions, fixed on one facet by few values (docs/theory.md §2). All throw Error (input), at `where`, if the
/// function is not finite at a point where it is needed.
namespace bracket::scene {

template <int n> struct FacetValues {
  std::array<double, n> value;  ///< in the plane at the ends a and b (and, for n = 3, at the midpoint)
  /// Not less than any difference to the given function; if that is sampled, at points; but for stretches so narrow
  /// that rounding of coordinates does not tell their ends apart.
  double error = 0;
  double largest = 0;  ///< not less than its magnitude, at points inside of the facet where that has no bound
};

/// A load: errors as in FacetValues.
struct EdgeLoad {
  EdgeCubic<double> value;
  double error = 0, largest = 0;
};

/// L2 projection on polynomials of a degree n, 1 to 3, by composite quadrature: exact for polynomials of degree 9 − n;
/// on panels that are narrow where an enclosed function is not smooth. What is linear does not depend on n. A function
/// that is linear to rounding is taken as its end values and one that is constant inside as that constant, exactly; so
/// jumps may lie at the ends.
EdgeLoad project(const Function<2>& given, const Vector<2>& a, const Vector<2>& b, int degree,
                 const std::string& where);

/// The linear function with the given end values.
FacetValues<2> interpolate_linear(const Function<2>& given, const Vector<2>& a, const Vector<2>& b,
                                  const std::string& where);

/// The quadratic function with the given values at the ends and the midpoint.
FacetValues<3> interpolate_quadratic(const Function<2>& given, const Vector<2>& a, const Vector<2>& b,
                                     const std::string& where);

}  // namespace bracket::scene
