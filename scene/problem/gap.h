// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/problem/problem.h"

/// Gaps between quadratics (docs/theory.md §2).
namespace bracket::scene {

/// Bernstein coefficients of two quadratics, from vertex 0 of a facet to its vertex 1.
struct GapBounds {
  std::array<double, 3> lower, upper;
};

/// Whether the lower one lies above the upper one somewhere, for sure.
bool cross(const GapBounds& bounds);

/// The gap on the straight edge from a to b if it is one quadratic there for sure, that is, if its third derivative is
/// enclosed by [0, 0]. The two then differ by the rounding of the coefficients only.
/// \pre gap.is_enclosed()
std::optional<GapBounds> quadratic_gap(const Function<2>& gap, const Vector<2>& a, const Vector<2>& b);

/// The values that the gap can have just inside of an end of the edge.
Interval gap_at_end(const Function<2>& gap, const Vector<2>& a, const Vector<2>& b, int end);

/// The best quadratics found between which the gap lies on a stretch of the edge. The lower one is nowhere below the
/// least value of the gap on the stretch, as far as that is known, nor the upper one above the largest; where the
/// gap is smooth they differ by the third power of the stretch and are exact at its ends.
/// \param given.at_least bounds the lower one from below at its ends, if that is possible
/// \throw Error (input), at `where`, if the gap has no values or no bounds there
GapBounds enclosed_gap(const GivenGap<2>& given, const Vector<2>& a, const Vector<2>& b, const Piece<1>& stretch);

/// A contact of the first mesh on a piece of its first facet: its quadratic, the lower gap rounded down, the upper one
/// up, or its function enclosed anew.
/// \param contact index into first.contact   \param one, other the facets' numbers on the refined mesh
ContactFacet on_piece(const Problem<2>& first, int contact, int one, int other, const Piece<1>& piece);

/// Whether each gap is one quadratic on each facet of the first mesh, so that refinement nests the cones of admissible
/// displacements.
template <int dim> bool has_quadratic_gaps(const Problem<dim>& problem);

}  // namespace bracket::scene
