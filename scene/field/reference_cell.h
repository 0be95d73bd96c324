// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "scene/types.h"

/// Cells of other programs and the polynomials on them: triangles and quadrilaterals, linear or quadratic, sides
/// straight or curved, nodes in the order of RawField::Cell. Planar.
namespace bracket::scene {

/// The basis functions of a cell's nodes at a point of the reference cell: the triangle (0, 0), (1, 0), (0, 1) or the
/// square (−1, 1)².
struct Basis {
  std::vector<double> value;
  std::vector<Vector<2>> gradient;  ///< by the reference coordinates
};
/// \param corners 3 or 4   \param nodes 3 or 6; 4, 8 or 9
Basis basis_at(int corners, std::size_t nodes, const Vector<2>& reference);

/// The point of the reference cell that lies at x, also a little outside of it; nothing: x is too far away, or the cell
/// is degenerate. \param nodes the places of a cell's nodes
std::optional<Vector<2>> reference_point(int corners, const std::vector<Vector<2>>& nodes, const Vector<2>& x);

/// Whether a point of the reference cell is in it.
bool is_inside(int corners, const Vector<2>& reference);

/// The distance of a point from the sides of a cell.
double distance_from_sides(int corners, const std::vector<Vector<2>>& nodes, const Vector<2>& x);

}  // namespace bracket::scene
