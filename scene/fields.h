// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "scene/mesh/simplex.h"

/// The two fields, as plain values: whoever has them, from whatever solver, can have them certified.
namespace bracket::scene {

/// A continuous displacement field, linear (degree 1) or quadratic (degree 2) on each cell.
template <int dim> struct Displacement {
  int degree = 2;
  std::vector<Vector<dim>> vertex;  ///< at Mesh::vertices
  std::vector<Vector<dim>> edge;    ///< at the midpoints of Mesh::edges; empty for degree 1
};

/// A stress field, linear on the parts of each cell, which meet at its centroid. Part k holds the facet opposite to
/// vertex k; its corners are the vertices of that, in the order of Simplex::facets, and the centroid.
template <int dim> struct Stress {
  std::vector<std::array<Voigt<dim>, (dim + 1) * (dim + 1)>> cell;  ///< of each cell, at [(dim + 1) part + corner]
};

/// The stress at the corners of one part of a cell.
template <int dim>
std::array<Voigt<dim>, std::size_t{dim} + 1> stress_of_part(const Stress<dim>& stress, int cell, int part) {
  std::array<Voigt<dim>, dim + 1> corners;
  for (int i = 0; i <= dim; ++i) corners[i] = stress.cell[cell][(dim + 1) * part + i];
  return corners;
}

}  // namespace bracket::scene
