// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "apps/plots/space/sketch.h"
#include "apps/report/deformed.h"
#include "apps/report/report.h"
#include "apps/report/space/cell_values.h"
#include "bounds/assess.h"

/// Pictures of a run in space, drawn by a writer of our own.
namespace bracket::apps {

/// The deformed surface coloured by the von Mises stress of the mean of both fields, from two sides; the same by the
/// density of the error indicator, unless error_is_rounding(); with a contact that presses a slice through the largest
/// pressure. \pre a guarantee, the run has ended
std::vector<Drawing> space_pictures(const ReportOf<3>& report);

/// Where a displacement from another program is wrong: the surface of its mesh, from two sides, coloured by the density
/// of its squared error. \pre a guarantee
std::vector<Drawing> error_cells_pictures(const scene::Scene<3>& scene, const bounds::AssessmentOf<3>& assessment);

/// Parallel projection along a direction, y upwards.
struct Eye {
  scene::Vector<3> to_eye, right, up;  ///< unit vectors at right angles
  explicit Eye(const scene::Vector<3>& towards);
  scene::Vector<2> project(const scene::Vector<3>& x) const { return {x.dot(right), x.dot(up)}; }
};

/// What colours a face: the value at a point of its cell's part there, by barycentric coordinates.
using FaceColour = std::function<double(const InCell& in_part)>;
using SurfaceColour = std::function<FaceColour(int facet)>;
/// By the von Mises stress of the mean of both fields; by what cells have, by their volume. \pre what is given outlives
/// it
SurfaceColour by_von_mises(const bounds::Outcome<3>& run);
SurfaceColour by_density(const scene::Mesh<3>& mesh, const std::vector<double>& of_cell);

/// The faces of all bodies that are turned to the eye and do not lie on another body, deformed; each cut so that its
/// pieces are flat to the eye and small enough to be drawn from the farthest to the nearest by their middles.
std::vector<Tessera> surface(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
                             const DrawnShapeOf<3>& shape, const Eye& eye, const SurfaceColour& colour);

/// The cells cut by the plane x_axis = `at`, coloured by the von Mises stress; deformed, seen along the axis, so that
/// what moves along it is not seen. Of faces in the plane those of the cells below it, or else above. \param plane the
/// axes to the right and upwards
std::vector<Tessera> slice(const bounds::Outcome<3>& run, const DrawnShapeOf<3>& shape, int axis, double at,
                           const std::array<int, 2>& plane);

}  // namespace bracket::apps
