// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: gaps between quadratics (docs/theory.md §2).
#pragma once

#include <optional>

#include "scene/problem/problem.h"
#include "scene/problem/space/face.h"

namespace bracket::scene {

struct FaceGapBounds {
  FacetQuadratic<3> lower, upper;
};

/// The gap on a face if it is one quadratic there for sure. The two then differ by the rounding of the coefficients
/// only. \pre gap.is_enclosed()
std::optional<FaceGapBounds> quadratic_gap(const Function<3>& gap, const Face& face);

/// The values that the gap can have just inside of a corner of the face.
Interval gap_at_corner(const Function<3>& gap, const Face& face, int corner);

/// Quadratics between which the gap lies on a part of the face: where it is smooth they are exact at the corners and
/// differ by the third power of the part; else they are its least and its largest value.
/// \throw Error (input), at `where`, if the gap has no values or no bounds there
FaceGapBounds enclosed_gap(const GivenGap<3>& given, const Face& face, const FacePart& part);

/// A contact of the first mesh on a piece of its first facet: its quadratic, the lower gap rounded down, the upper one
/// up, or its function enclosed anew. `meets` is left as it is.
/// \param contact index into first.contact   \param one, other the facets' numbers on the refined mesh
ContactFacetOf<3> on_piece(const Problem<3>& first, int contact, int one, int other, const Piece<2>& piece);

}  // namespace bracket::scene
