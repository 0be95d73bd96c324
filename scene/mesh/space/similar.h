// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: the shapes that bisection makes of a tetrahedron.
#pragma once

#include <span>

#include "scene/mesh/space/marks.h"

namespace bracket::scene {

/// Of a cell K that bisection makes of K₀, up to similarity: (|K| / |K₀|)^(-2/3) Σ |e|² over its edges is
/// q00 |e₁|² + q11 |e₂|² + q22 |e₃|² + 2 (q01 e₁·e₂ + q02 e₁·e₃ + q12 e₂·e₃), e_i the edge of K₀ from vertex 0 to i.
struct SimilarCells {
  double q00, q11, q22, q01, q02, q12;
};

/// Of all that is made of a cell that has these marks and no flag, that one included. \pre it has a refinement edge
std::span<const SimilarCells> similar_cells(const FacetMarks& marks);

/// All marks of a cell that has a refinement edge.
std::span<const FacetMarks> all_marks();

}  // namespace bracket::scene
