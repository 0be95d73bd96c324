// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "scene/types.h"

/// The two fields, as plain values: whoever has them, from whatever solver, can have them certified.
namespace bracket::scene {

/// A continuous displacement field, linear (degree 1) or quadratic (degree 2) on each cell.
template <int dim> struct Displacement {
  int degree = 2;
  std::vector<Vector<dim>> vertex;  ///< at Mesh::vertices
  std::vector<Vector<dim>> edge;    ///< at the midpoints of Mesh::edges; empty for degree 1
};

/// A stress field, linear on the three parts of each cell, which meet at its centroid. Part k holds the edge opposite
/// to vertex k; its corners are vertex k+1, vertex k+2 (mod 3) and the centroid.
template <int dim> struct Stress {
  std::vector<std::array<Voigt<dim>, 9>> cell;  ///< [3 k + corner] of each cell
};

}  // namespace bracket::scene
