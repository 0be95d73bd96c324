// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "scene/scene.h"

/// Changes of a fixed problem that make it extreme. Each returns the changed problem, with a mesh that can be refined.
namespace bracket::apps {

/// All lengths times `length` (coordinates, displacements, gaps), all stresses times `stress` (moduli, tractions, body
/// forces by length): L(u) is multiplied by stress · length².
/// \pre both > 0; without rounding if they are powers of two
scene::Problem<2> in_units(scene::Problem<2> problem, double length, double stress);

/// Loads, prescribed displacements and gaps times `factor`: so are the displacements, and L(u) by its square.
/// \pre as in_units()
scene::Problem<2> with_loads_times(scene::Problem<2> problem, double factor);

/// The moduli of one body times `factor` > 0.
scene::Problem<2> with_moduli_times(scene::Problem<2> problem, int body, double factor);

/// All isotropic bodies with Poisson's ratio `poisson`, E as it is.
scene::Problem<2> with_poisson(scene::Problem<2> problem, double poisson);

/// Each cell cut in three from an inner point with these barycentric coordinates (the first: of the vertex opposite to
/// its longest edge). Nothing else changes: it is the same problem, L(u) included.
/// \pre all > 0, their sum 1
scene::Problem<2> with_cells_cut(scene::Problem<2> problem, const std::array<double, 3>& point);

/// The scene on its own mesh, flattened: y coordinates times `factor` > 0, data of each point as they were before.
/// \throw scene::Error as fix_data()
scene::Problem<2> flattened(scene::Scene<2> scene, double factor);

/// Where a contact line ends: at vertex `end` (0 or 1) of the first facet of Problem::contact[contact].
struct ContactEnd {
  int contact;
  int end;
};
/// The first end of a contact line; none where all lines close on themselves.
std::optional<ContactEnd> contact_end(const scene::Problem<2>& problem);

/// The contact ends before its line does: of its last edge the share `distance` next to the end is cut off and free,
/// on both sides.
/// \pre 0 < distance < 1
scene::Problem<2> with_end_freed(scene::Problem<2> problem, const ContactEnd& where, double distance);

/// The same problem on a mesh on which the cells at the ends of the contact lines have been refined so many times.
/// \throw scene::Error (budget) as scene::refine()
scene::Problem<2> with_ends_refined(scene::Problem<2> problem, int times);

/// The facets that carry a traction that is not zero.
struct Loading {
  std::vector<int> facets;
  scene::Vector<2> mean;    ///< traction
  scene::Vector<2> centre;  ///< of the facets
  scene::Vector<2> reach;   ///< from the centre to an end of their bounding box, along its longer side
  double moment = 0;        ///< of their part along the mean, by reach: > 0 if they lie on that side of the centre
};
Loading loading(const scene::Problem<2>& problem);

/// A traction, a linear function of position, added on the loaded facets.
scene::Problem<2> with_traction(scene::Problem<2> problem, const Loading& loading,
                                const std::function<scene::Vector<2>(const scene::Vector<2>&)>& added);

}  // namespace bracket::apps
