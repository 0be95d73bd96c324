// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "scene/types.h"

/// Cells of other programs and the polynomials on them: triangles and quadrilaterals, linear or quadratic, sides
/// straight or curved, nodes in the order of RawField::Cell; in space straight tetrahedra, linear or quadratic.
namespace bracket::scene {

/// The basis functions of a cell's nodes at a point of the reference cell: the triangle (0, 0), (1, 0), (0, 1), the
/// square (−1, 1)² or the tetrahedron of 0 and the unit vectors.
template <int dim> struct Basis {
  std::vector<double> value;
  std::vector<Vector<dim>> gradient;  ///< by the reference coordinates
};
/// \param corners 3 or 4, in space 4   \param nodes 3 or 6; 4, 8 or 9; in space 4 or 10
Basis<2> basis_at(int corners, std::size_t nodes, const Vector<2>& reference);
Basis<3> basis_at(int corners, std::size_t nodes, const Vector<3>& reference);

/// The point of the reference cell that lies at x, also a little outside of it; nothing: x is too far away, or the cell
/// is degenerate. \param nodes the places of a cell's nodes
std::optional<Vector<2>> reference_point(int corners, const std::vector<Vector<2>>& nodes, const Vector<2>& x);
std::optional<Vector<3>> reference_point(int corners, const std::vector<Vector<3>>& nodes, const Vector<3>& x);

/// Whether a point of the reference cell is in it.
bool is_inside(int corners, const Vector<2>& reference);
bool is_inside(int corners, const Vector<3>& reference);

/// The distance of a point from the sides of a cell, in space from its faces.
double distance_from_sides(int corners, const std::vector<Vector<2>>& nodes, const Vector<2>& x);
double distance_from_sides(int corners, const std::vector<Vector<3>>& nodes, const Vector<3>& x);

}  // namespace bracket::scene
