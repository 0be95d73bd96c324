// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "apps/report/deformed.h"
#include "scene/scene.h"

/// In space: values at points of a tetrahedron and of its four parts, which meet at its centroid (scene/fields.h).
/// Points are given by barycentric coordinates.
namespace bracket::apps {

using InCell = std::array<double, 4>;

/// What is linear on a cell or on a part, by its values at the corners.
template <class Values> auto value_in(const InCell& point, const Values& at_corners) {
  return (point[0] * at_corners[0] + point[1] * at_corners[1] + point[2] * at_corners[2] + point[3] * at_corners[3])
      .eval();
}

/// A point of a part, in its cell.
InCell in_cell(int part, const InCell& in_part);

/// The way from a point of a cell to where it is drawn. \param facet the boundary facet that it lies on, −1: none, or
/// what is seen there does not matter
scene::Vector<3> way_drawn(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
                           const DrawnShapeOf<3>& shape, int cell, const InCell& point, int facet);

/// The mean of σ(u_h) and λ_h at a point of a cell's part. \param displacement_stress of the cell
scene::Voigt<3> mean_stress(const std::vector<scene::Voigt<3>>& displacement_stress, const scene::Stress<3>& stress,
                            int cell, int part, const InCell& in_part);

}  // namespace bracket::apps
